#include "support/tour/sight.h"

#include <cmath>
#include <limits>

#include "sim/reachable_floor.h"

namespace frontier_pilot::bench {
namespace {

constexpr std::int32_t kNotAsked = std::numeric_limits<std::int32_t>::min();

/// The number of bits that are set, by sums of ever larger groups: there is no instruction for it that every processor
/// of the platform has, and the compiler's function for such processors is slower.
int bitsIn(std::uint64_t word) {
  word -= (word >> 1) & 0x5555555555555555U;
  word = (word & 0x3333333333333333U) + ((word >> 2) & 0x3333333333333333U);
  word = (word + (word >> 4)) & 0x0f0f0f0f0f0f0f0fU;
  return static_cast<int>((word * 0x0101010101010101U) >> 56);
}

}  // namespace

Sight::Sight(const OccupancyGrid& truth, double range) : range_(range), caster_(sim::notFree(truth)) {}

std::vector<Vec2> Sight::directions(double step) const {
  const int count = static_cast<int>(std::ceil(2.0 * kPi * range_ / step));
  std::vector<Vec2> units;
  for (int i = 0; i < count; ++i) units.push_back(direction(2.0 * kPi * (i + 0.5) / count));
  return units;
}

FloorBits::FloorBits(const Grid<std::uint8_t>& floor) : cells_(floor.geometry()) {
  cells_.resolution *= 2.0;
  cells_.width = (cells_.width + 1) / 2;
  cells_.height = (cells_.height + 1) / 2;
  words_per_row_ = (cells_.width + 63) / 64;
  all_.resize(static_cast<std::size_t>(words_per_row_) * static_cast<std::size_t>(cells_.height));
  for (int y = 0; y < cells_.height; ++y) {
    for (int x = 0; x < cells_.width; ++x) {
      const Cell c{2 * x, 2 * y};
      const int parts = floor.get(c, 0) + floor.get({c.x + 1, c.y}, 0) + floor.get({c.x, c.y + 1}, 0) +
                        floor.get({c.x + 1, c.y + 1}, 0);
      if (parts < 2) continue;
      all_[wordOf({x, y})] |= std::uint64_t{1} << (x % 64);
      ++count_;
    }
  }
}

View FloorBits::viewFrom(const Vec2& from, const Sight& sight) const {
  Bits bits(all_.size());
  sight.look(from, cells_.resolution, [&](const Vec2& point) {
    const Cell c = cells_.cellAt(point);
    if (!cells_.contains(c)) return;
    bits[wordOf(c)] |= std::uint64_t{1} << (c.x % 64);
  });
  View view;
  for (std::size_t i = 0; i < bits.size(); ++i) {
    const std::uint64_t asked = bits[i] & all_[i];
    if (asked != 0) view.words.push_back({static_cast<std::uint32_t>(i), asked});
  }
  return view;
}

int common(const View& view, const FloorBits::Bits& bits) {
  int count = 0;
  for (const View::Word& word : view.words) count += bitsIn(word.bits & bits[word.index]);
  return count;
}

void include(const View& view, FloorBits::Bits& bits) {
  for (const View::Word& word : view.words) bits[word.index] |= word.bits;
}

void exclude(const View& view, FloorBits::Bits& bits) {
  for (const View::Word& word : view.words) bits[word.index] &= ~word.bits;
}

int countOf(const FloorBits::Bits& bits) {
  int count = 0;
  for (const std::uint64_t word : bits) count += bitsIn(word);
  return count;
}

SeenFloor::SeenFloor(const Grid<std::uint8_t>& floor, const Sight& sight) : sight_(sight), count_(floor.geometry()) {
  for (std::size_t i = 0; i < floor.size(); ++i) {
    count_[i] = floor[i] != 0 ? 0 : kNotAsked;
    area_ += floor[i] != 0 ? 1 : 0;
  }
}

void SeenFloor::add(const Vec2& place) {
  sight_.look(place, count_.resolution(), [&](const Vec2& point) {
    const Cell c = count_.geometry().cellAt(point);
    if (!count_.contains(c) || count_[c] < 0) return;
    if (count_[c]++ == 0) ++seen_;
  });
}

void SeenFloor::remove(const Vec2& place) {
  sight_.look(place, count_.resolution(), [&](const Vec2& point) {
    const Cell c = count_.geometry().cellAt(point);
    if (!count_.contains(c) || count_[c] < 0) return;
    if (--count_[c] == 0) --seen_;
  });
}

}  // namespace frontier_pilot::bench
