#include "logs/text_reader.h"

#include <charconv>
#include <cmath>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/text.h"
#include "frontier_pilot/logs/scan_log.h"

namespace frontier_pilot::logs {
namespace {

// The largest number of seconds since the epoch that ros::Time can hold. No other number in a log comes near it.
constexpr double kLargest = 4294967295.0;
/// Words in a line: enough for a scan's ranges, their remissions, and the other fields.
constexpr std::size_t kMostWords = 3 * bounds::kMostRanges;
/// Memory of all that is kept of a file [bytes].
constexpr std::size_t kMostKept = 4'000'000'000;

std::string quoted(std::string_view word) { return "'" + printable(word, bounds::kMostReason) + "'"; }

/// Parses the whole word as a number, regardless of the locale.
template <class T>
bool parse(std::string_view word, T& value) {
  const std::from_chars_result result = std::from_chars(word.data(), word.data() + word.size(), value);
  return result.ec == std::errc() && result.ptr == word.data() + word.size();
}

}  // namespace

bool readLine(std::istream& file, std::string& line) {
  line.clear();
  for (char c = 0; line.size() <= kMostLineBytes && file.get(c);) {
    if (c == '\n') return true;
    line.push_back(c);
  }
  return !line.empty();
}

bool TextReader::nextLine() {
  while (readLine(file_, line_)) {
    ++line_number_;
    if (line_.size() > kMostLineBytes) fail("is longer than " + std::to_string(kMostLineBytes) + " bytes");
    const std::size_t carriage_return = line_.find('\r');
    if (carriage_return != std::string::npos && carriage_return + 1 < line_.size())
      fail("has a carriage return inside: lines must end with LF or CR LF");
    split();
    if (!words_.empty() && words_.front().front() != '#') return true;
  }
  return false;
}

void TextReader::split() {
  words_.clear();
  next_ = 0;
  const std::string_view line(line_);
  std::size_t begin = line.find_first_not_of(separators_);
  while (begin != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(separators_, begin), line.size());
    if (words_.size() == kMostWords) fail("has more than " + std::to_string(kMostWords) + " values");
    words_.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(separators_, end);
  }
}

std::string_view TextReader::word(const char* what) {
  if (atEnd()) fail(std::string("ends where ") + what + " should be");
  return words_[next_++];
}

double TextReader::number(const char* what) {
  const std::string_view text = word(what);
  double value = 0.0;
  if (!parse(text, value) || !std::isfinite(value)) fail(std::string(what) + " is not a number: " + quoted(text));
  if (std::abs(value) > kLargest) fail(std::string(what) + " is too large: " + quoted(text));
  return value;
}

std::size_t TextReader::count(const char* what) {
  const std::string_view text = word(what);
  std::size_t value = 0;
  if (!parse(text, value)) fail(std::string(what) + " is not a whole number: " + quoted(text));
  return value;
}

void TextReader::skip(std::size_t words, const char* what) {
  if (words > wordsLeft()) fail(std::string("ends where ") + what + " should be");
  next_ += words;
}

void TextReader::keep(std::size_t bytes) {
  kept_ += bytes;
  if (kept_ > kMostKept) fail("until here it takes more than 4 GB of memory");
}

void TextReader::fail(const std::string& problem) const {
  throw LogError(name_ + ":" + std::to_string(line_number_) + ": " + problem);
}

}  // namespace frontier_pilot::logs
