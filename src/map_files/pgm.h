#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace frontier_pilot::map_files {

/// What a PGM image announces in its header: P2 (pixels as text) or P5 (as bytes).
struct PgmHeader {
  bool as_text = false;
  std::uint64_t width = 0;
  std::uint64_t height = 0;
  unsigned white = 0;     ///< the greatest value of a pixel, up to 65535
  std::size_t bytes = 0;  ///< of the header: here the pixels begin
};

/// Nothing if `image` does not begin with the header of a PGM image.
std::optional<PgmHeader> pgmHeader(std::string_view image);

/// Writes the pixels to `grey`, from 0 to 255, row by row from the upper edge: `width` times `height` bytes, which must
/// be checked before. Returns false if some are missing. What comes after them does not matter, as in other programs.
bool readPgm(std::string_view image, const PgmHeader& header, std::uint8_t* grey);

}  // namespace frontier_pilot::map_files
