#pragma once

#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace frontier_pilot::logs {

/// Longest line that is read [bytes]: several times that of the densest scan.
constexpr std::size_t kMostLineBytes = 4'000'000;

/// Reads a line without its end, like std::getline, but not on once it is longer than `kMostLineBytes`. Returns whether
/// there was one.
bool readLine(std::istream& file, std::string& line);

/// Reads a text file line by line and word by word, and reports errors with the file and the line.
class TextReader {
 public:
  /// Words are separated by any of `separators`, several of which in a row count as one. `name` is the file's name.
  TextReader(std::istream& file, std::string name, const char* separators)
      : file_(file), name_(std::move(name)), separators_(separators) {}

  /// Advances to the next line that is not empty and does not begin with '#'. False at the end of the file.
  bool nextLine();
  bool atEnd() const { return next_ == words_.size(); }
  std::size_t wordsLeft() const { return words_.size() - next_; }
  /// The next word of the line. `what` names the expected value in an error message.
  std::string_view word(const char* what);
  double number(const char* what);
  std::size_t count(const char* what);
  void skip(std::size_t words, const char* what);

  /// To be told how much memory is taken by what is kept of the line. Fails once that is too much of all lines
  /// together.
  void keep(std::size_t bytes);

  /// Throws a LogError with the file, the line and `problem`.
  [[noreturn]] void fail(const std::string& problem) const;

 private:
  void split();

  std::istream& file_;
  std::string name_;
  const char* separators_;
  std::size_t line_number_ = 0;
  std::size_t kept_ = 0;  ///< [bytes]
  std::string line_;
  std::vector<std::string_view> words_;
  std::size_t next_ = 0;
};

}  // namespace frontier_pilot::logs
