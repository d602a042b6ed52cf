#include "ros/common/maps/run_lengths.h"

#include <algorithm>
#include <array>
#include <utility>

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot {
namespace {

constexpr std::array<std::int8_t, 3> kUsual = {kUnknown, kFree, kOccupied};
constexpr unsigned kOther = 3;       // the value is in a byte of its own
constexpr unsigned kShort = 60;      // lengths up to this one are in the first byte
constexpr std::uint64_t kLong = 61;  // the least length that is not
constexpr unsigned kLengthBits = 6;
constexpr std::uint64_t kMostRun = kLong + 0xFFFFFFFFU;

unsigned codeOf(std::int8_t value) {
  return static_cast<unsigned>(std::find(kUsual.begin(), kUsual.end(), value) - kUsual.begin());
}

/// How many bytes the part of a length that is not in the first byte takes.
unsigned bytesFor(std::uint64_t rest) {
  unsigned count = 1;
  while (count < 4 && rest >> (8 * count) != 0) ++count;
  return count;
}

}  // namespace

void RunWriter::add(const std::int8_t* cells, std::size_t count) {
  const std::int8_t* const end = cells + count;
  while (cells != end) {
    if (length_ == 0) value_ = *cells;
    const std::int8_t* const other = std::find_if(cells, end, [this](std::int8_t cell) { return cell != value_; });
    length_ += static_cast<std::uint64_t>(other - cells);
    cells = other;
    if (cells != end) writeRun();
  }
}

void RunWriter::writeRun() {
  while (length_ > 0) {
    const std::uint64_t length = std::min(length_, kMostRun);
    length_ -= length;
    const unsigned code = codeOf(value_);
    const std::uint64_t rest = length < kLong ? 0 : length - kLong;
    const unsigned more = length < kLong ? 0 : bytesFor(rest);
    const unsigned low = more == 0 ? static_cast<unsigned>(length) - 1 : kShort - 1 + more;
    bytes_.push_back(static_cast<std::uint8_t>((code << kLengthBits) | low));
    if (code == kOther) bytes_.push_back(static_cast<std::uint8_t>(value_));
    for (unsigned i = 0; i < more; ++i) bytes_.push_back(static_cast<std::uint8_t>(rest >> (8 * i)));
  }
}

std::vector<std::uint8_t> RunWriter::take() {
  writeRun();
  return std::exchange(bytes_, {});
}

bool RunReader::nextRun() {
  if (next_ == bytes_.size()) return false;
  const unsigned first = bytes_[next_++];
  const unsigned code = first >> kLengthBits;
  const unsigned low = first & ((1U << kLengthBits) - 1);
  const unsigned more = low < kShort ? 0 : low - kShort + 1;
  if (bytes_.size() - next_ < more + (code == kOther ? 1 : 0)) return false;
  value_ = code == kOther ? static_cast<std::int8_t>(bytes_[next_++]) : kUsual[code];
  if (value_ < kUnknown || value_ > kOccupied) return false;
  std::uint64_t rest = 0;
  for (unsigned i = 0; i < more; ++i) rest |= static_cast<std::uint64_t>(bytes_[next_++]) << (8 * i);
  length_ = more == 0 ? low + 1 : kLong + rest;
  return true;
}

bool RunReader::read(std::int8_t* out, std::size_t count) {
  while (count > 0) {
    if (length_ == 0 && !nextRun()) return false;
    const std::size_t now = std::min<std::size_t>(length_, count);
    out = std::fill_n(out, now, value_);
    length_ -= now;
    count -= now;
  }
  return true;
}

std::optional<std::size_t> countCells(const std::vector<std::uint8_t>& bytes, std::size_t most) {
  RunReader reader(bytes);
  std::uint64_t cells = 0;
  while (reader.next_ < bytes.size()) {
    if (!reader.nextRun()) return std::nullopt;
    cells += reader.length_;
    if (cells > most) return std::nullopt;
  }
  return cells;
}

}  // namespace frontier_pilot
