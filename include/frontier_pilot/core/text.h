#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Text from outside (messages, files), decoded character by character.
namespace frontier_pilot {

/// A decoded UTF-8 character: its Unicode code point, and the number of bytes that encode it. 0 bytes: not a character.
struct Character {
  char32_t code = 0;
  std::size_t bytes = 0;
};

/// The character that begins at `at`, which must lie inside of `text`; one of 0 bytes if that is not valid UTF-8.
Character characterAt(std::string_view text, std::size_t at);

/// Whether a character controls a terminal or the layout of text instead of being shown: the control characters of
/// ASCII and Latin-1, line and paragraph separators, and the marks that change the direction of writing. The
/// noncharacters U+xxFFFE and U+xxFFFF count as well.
bool isControl(char32_t code);

/// `text` made safe for logs and diagnostics: control characters and bytes that are not UTF-8 are escaped as in C++,
/// for example `\n`, `\x1b` or `\u2028`, and what exceeds `most` bytes is replaced by " ...". [FLT-1]
std::string printable(std::string_view text, std::size_t most);

/// Whether `name` can be the namespace of a robot, below which its topics, services and frames lie: words of letters,
/// digits and underscores that begin with a letter, with single slashes between them. Two texts that mean the same
/// namespace, such as "a" and "/a", are never both names.
bool isRobotName(std::string_view name);

}  // namespace frontier_pilot
