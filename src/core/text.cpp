#include "frontier_pilot/core/text.h"

#include <algorithm>
#include <array>

namespace frontier_pilot {
namespace {

constexpr char32_t kLastCharacter = 0x10FFFF;

struct Range {
  char32_t first, last;
  bool holds(char32_t code) const { return code >= first && code <= last; }
};

constexpr Range kSurrogates{0xD800, 0xDFFF};  // used by UTF-16 only
constexpr std::array kControls{Range{0x00, 0x1F}, Range{0x7F, 0x9F}, Range{0x2028, 0x202E}, Range{0x2066, 0x2069}};

/// How many bytes a character that begins with this byte has; 0 if no character does.
std::size_t lengthFrom(unsigned first) {
  if (first < 0x80) return 1;
  if (first < 0xC0 || first > 0xF4) return 0;
  return first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
}

/// A backslash, `kind`, and `number` in hexadecimal digits.
std::string escaped(char kind, char32_t number, std::size_t digits) {
  std::string text(2 + digits, kind);
  text[0] = '\\';
  for (std::size_t i = text.size(); i > 2; number >>= 4U) text[--i] = "0123456789abcdef"[number & 0xFU];
  return text;
}

std::string escaped(char32_t control) {
  switch (control) {
    case U'\n':
      return "\\n";
    case U'\r':
      return "\\r";
    case U'\t':
      return "\\t";
    default:
      if (control < 0x80) return escaped('x', control, 2);
      return control <= 0xFFFF ? escaped('u', control, 4) : escaped('U', control, 8);
  }
}

}  // namespace

Character characterAt(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned>(static_cast<unsigned char>(text[i])); };
  const std::size_t length = lengthFrom(byte(at));
  if (length == 0 || length > text.size() - at) return {};
  // The first of several bytes: as many ones as there are bytes, then a zero, then the first bits of the code.
  char32_t code = length == 1 ? byte(at) : byte(at) & (0x7FU >> length);
  for (std::size_t i = at + 1; i < at + length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return {};
    code = code << 6U | (byte(i) & 0x3FU);
  }
  constexpr std::array<char32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};  // by bytes: longer encodings are invalid
  if (code < kLeast[length] || code > kLastCharacter || kSurrogates.holds(code)) return {};
  return {code, length};
}

bool isControl(char32_t code) {
  if ((code & 0xFFFEU) == 0xFFFE) return true;
  return std::any_of(kControls.begin(), kControls.end(), [=](const Range& range) { return range.holds(code); });
}

std::string printable(std::string_view text, std::size_t most) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const Character character = characterAt(text, at);
    const std::size_t bytes = std::max<std::size_t>(character.bytes, 1);
    std::string shown(text.substr(at, bytes));
    if (character.bytes == 0) shown = escaped('x', static_cast<unsigned char>(text[at]), 2);
    if (character.bytes != 0 && isControl(character.code)) shown = escaped(character.code);
    if (out.size() + shown.size() > most) return out + " ...";
    out += shown;
    at += bytes;
  }
  return out;
}

bool isRobotName(std::string_view name) {
  const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  char before = '/';
  for (const char c : name) {
    const bool goes_on = isLetter(c) || c == '_' || c == '/' || (c >= '0' && c <= '9');
    if (before == '/' ? !isLetter(c) : !goes_on) return false;
    before = c;
  }
  return before != '/';
}

}  // namespace frontier_pilot
