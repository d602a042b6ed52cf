#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace frontier_pilot::tools {

/// The words of a command line, one after the other; `--option=value` is split into two words. A value that is missing
/// or not a number throws std::invalid_argument with a text that names the option.
class Arguments {
 public:
  explicit Arguments(const std::vector<std::string>& words);

  bool atEnd() const { return next_ == words_.size(); }
  /// The next word, which may be an option.
  const std::string& next();
  static bool isOption(const std::string& word) { return word.rfind("--", 0) == 0; }

  /// The next value of the option that `next` returned last, as text, number, integer or range.
  const std::string& text();
  double number();
  int integer();
  /// `A` or `A-B`: the numbers from A to B, at most 100000.
  std::vector<int> range();

 private:
  std::vector<std::string> words_;
  std::size_t next_ = 0;
  std::string option_;
};

}  // namespace frontier_pilot::tools
