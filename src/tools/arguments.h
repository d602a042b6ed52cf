#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace frontier_pilot::tools {

/// The words of a command line, one after the other; `--option=value` is two words. What is missing or no number throws
/// std::invalid_argument with a text that names the option.
class Arguments {
 public:
  explicit Arguments(const std::vector<std::string>& words);

  bool atEnd() const { return next_ == words_.size(); }
  /// The next word, to be found out whether it is an option.
  const std::string& next();
  static bool isOption(const std::string& word) { return word.rfind("--", 0) == 0; }

  /// The values of the word that `next` gave.
  const std::string& text();
  double number();
  int integer();
  /// `A` or `A-B`: the numbers from A to B.
  std::vector<int> range();

 private:
  std::vector<std::string> words_;
  std::size_t next_ = 0;
  std::string option_;
};

}  // namespace frontier_pilot::tools
