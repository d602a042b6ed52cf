#include "map_files/pgm.h"

#include <algorithm>
#include <charconv>

namespace frontier_pilot::map_files {
namespace {

constexpr unsigned kMostWhite = 65535;

bool isSpace(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// Reads numbers between white space and comments, which end with their line.
class Words {
 public:
  Words(std::string_view text, std::size_t at) : text_(text), at_(std::min(at, text.size())) {}

  /// The next whole number; nothing if there is none, or something else.
  template <class T>
  std::optional<T> number() {
    const std::size_t before = at_;
    skipSpace();
    if (at_ == before) return std::nullopt;
    T value{};
    const std::from_chars_result result = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (result.ec != std::errc()) return std::nullopt;
    at_ = static_cast<std::size_t>(result.ptr - text_.data());
    return value;
  }
  std::size_t at() const { return at_; }

 private:
  void skipSpace() {
    while (at_ < text_.size() && (isSpace(text_[at_]) || text_[at_] == '#'))
      at_ = text_[at_] == '#' ? std::min(text_.find_first_of("\r\n", at_), text_.size()) : at_ + 1;
  }

  std::string_view text_;
  std::size_t at_;
};

std::uint8_t shade(unsigned value, unsigned white) {
  return static_cast<std::uint8_t>(255U * std::min(value, white) / white);
}

bool readText(std::string_view pixels, const PgmHeader& header, std::uint8_t* grey) {
  Words words(pixels, header.bytes - 1);
  for (std::uint64_t i = 0; i < header.width * header.height; ++i) {
    const auto value = words.number<unsigned>();
    if (!value) return false;
    grey[i] = shade(*value, header.white);
  }
  return true;
}

}  // namespace

std::optional<PgmHeader> pgmHeader(std::string_view image) {
  PgmHeader header;
  header.as_text = image.substr(0, 2) == "P2";
  if (!header.as_text && image.substr(0, 2) != "P5") return std::nullopt;
  Words words(image, 2);
  const auto width = words.number<std::uint64_t>();
  const auto height = words.number<std::uint64_t>();
  const auto white = words.number<unsigned>();
  if (!width || !height || !white || *white < 1 || *white > kMostWhite) return std::nullopt;
  // A single white space comes between the header and the pixels.
  if (*width == 0 || *height == 0 || words.at() == image.size() || !isSpace(image[words.at()])) return std::nullopt;
  header.width = *width;
  header.height = *height;
  header.white = *white;
  header.bytes = words.at() + 1;
  return header;
}

bool readPgm(std::string_view image, const PgmHeader& header, std::uint8_t* grey) {
  if (header.as_text) return readText(image, header, grey);
  const std::size_t bytes_each = header.white > 255 ? 2 : 1;
  const std::string_view pixels = image.substr(header.bytes);
  const std::uint64_t count = header.width * header.height;
  if (pixels.size() / bytes_each < count) return false;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned>(static_cast<unsigned char>(pixels[i])); };
  for (std::size_t i = 0; i < count; ++i) {
    const unsigned value = bytes_each == 1 ? byte(i) : byte(2 * i) << 8U | byte(2 * i + 1);
    grey[i] = shade(value, header.white);
  }
  return true;
}

}  // namespace frontier_pilot::map_files
