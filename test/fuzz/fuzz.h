#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

/// What each fuzz target defines: one parser is given `data`, and must answer with a value or with a clear error. It is
/// called by libFuzzer (scripts/fuzz), and by corpus_test.cpp with what is kept in corpus/.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace frontier_pilot::fuzz {

/// Ends the process if a promise of a parser does not hold: libFuzzer then keeps the input.
inline void require(bool holds, const char* promise) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", promise);
  std::abort();
}

inline std::string textOf(const std::uint8_t* data, std::size_t size) {
  return size == 0 ? std::string() : std::string(reinterpret_cast<const char*>(data), size);
}

/// The words of a command line: the lines of the input.
inline std::vector<std::string> wordsOf(const std::uint8_t* data, std::size_t size) {
  std::vector<std::string> words;
  const std::string text = textOf(data, size);
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    words.push_back(text.substr(begin, end - begin).c_str());  // a word ends at the first NUL
    begin = end + 1;
  }
  return words;
}

}  // namespace frontier_pilot::fuzz
