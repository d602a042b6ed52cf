#include "tools/arguments.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace frontier_pilot::tools {
namespace {

constexpr std::int64_t kMostNumbers = 100'000;  // of a range

template <class T>
T parse(const std::string& option, const std::string& word, const char* what) {
  T value{};
  const std::from_chars_result result = std::from_chars(word.data(), word.data() + word.size(), value);
  if (result.ec == std::errc() && result.ptr == word.data() + word.size()) return value;
  throw std::invalid_argument(option + " needs " + what + ", not '" + word + "'");
}

}  // namespace

Arguments::Arguments(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    const std::size_t equals = isOption(word) ? word.find('=') : std::string::npos;
    words_.push_back(word.substr(0, equals));
    if (equals != std::string::npos) words_.push_back(word.substr(equals + 1));
  }
}

const std::string& Arguments::next() { return option_ = words_[next_++]; }

const std::string& Arguments::text() {
  if (atEnd() || words_[next_].empty()) throw std::invalid_argument(option_ + " needs a value");
  return words_[next_++];
}

double Arguments::number() {
  const double value = parse<double>(option_, text(), "a number");
  if (!std::isfinite(value)) throw std::invalid_argument(option_ + " needs a finite number");
  return value;
}

int Arguments::integer() { return parse<int>(option_, text(), "a whole number"); }

std::vector<int> Arguments::range() {
  const std::string& word = text();
  const std::size_t dash = word.find('-', 1);
  const int first = parse<int>(option_, word.substr(0, dash), "A or A-B");
  const int last = dash == std::string::npos ? first : parse<int>(option_, word.substr(dash + 1), "A or A-B");
  if (last < first)
    throw std::invalid_argument(option_ + ": " + word + " is empty, the second number is the smaller one");
  const std::int64_t count = std::int64_t{last} - first + 1;
  if (count > kMostNumbers) throw std::invalid_argument(option_ + ": " + word + " is more than 100000 numbers");
  std::vector<int> numbers;
  for (std::int64_t i = first; i <= last; ++i) numbers.push_back(static_cast<int>(i));
  return numbers;
}

}  // namespace frontier_pilot::tools
