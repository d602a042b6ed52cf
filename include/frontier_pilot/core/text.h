#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Texts from outside, character by character.
namespace frontier_pilot {

/// A character of UTF-8: its number in Unicode, and the bytes it takes. None where it takes 0 bytes.
struct Character {
  char32_t code = 0;
  std::size_t bytes = 0;
};

/// What begins at `at`, which must lie inside of `text`; none if that is not UTF-8.
Character characterAt(std::string_view text, std::size_t at);

/// Whether a character acts on what shows it, or splits lines, where others are shown: the control characters of ASCII
/// and of Latin 1, the separators of lines and paragraphs, and what turns the direction of writing round. What Unicode
/// says is no character counts as well.
bool isControl(char32_t code);

/// `text` as logs and diagnostics may have it: control characters and what is not UTF-8 as C++ would write them, such
/// as `\n`, `\x1b` or `\u2028`, and " ..." for what is beyond `most` bytes. [FLT-1]
std::string printable(std::string_view text, std::size_t most);

}  // namespace frontier_pilot
