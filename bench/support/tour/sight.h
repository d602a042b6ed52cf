#pragma once

#include <cstdint>
#include <vector>

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/grids/ray_casting.h"

namespace frontier_pilot::bench {

/// What is seen from places of a known floor, in all directions up to a range.
class Sight {
 public:
  /// Everything of `truth` that is not free blocks the view. `range` [m].
  Sight(const OccupancyGrid& truth, double range);

  /// `visit(Vec2)` is called with points on all lines of sight from `from`, about `step` [m] apart along each line and
  /// between neighbouring lines. The same points come again in the same order when called again.
  template <class Visit>
  void look(const Vec2& from, double step, Visit visit) const {
    const std::vector<Vec2> units = directions(step);
    std::vector<double> ranges(units.size(), range_);
    caster_.castAll(from, units, ranges);
    for (std::size_t i = 0; i < units.size(); ++i) {
      for (double r = 0.0; r < ranges[i]; r += step) visit(Vec2(from + r * units[i]));
    }
  }

 private:
  std::vector<Vec2> directions(double step) const;

  double range_;
  grids::RayCaster caster_;
};

/// Which cells of a grid are seen from a place: bits, of which only the words that are not zero are stored.
struct View {
  struct Word {
    std::uint32_t index;
    std::uint64_t bits;
  };
  std::vector<Word> words;
};

/// The floor that must be seen, in cells that are twice as large as the map's, and the views of it.
class FloorBits {
 public:
  using Bits = std::vector<std::uint64_t>;

  /// `floor`: non-zero where the map must be seen.
  explicit FloorBits(const Grid<std::uint8_t>& floor);

  View viewFrom(const Vec2& from, const Sight& sight) const;
  /// All cells that must be seen.
  const Bits& all() const { return all_; }
  int count() const { return count_; }

 private:
  /// The index of the word that holds a cell's bit.
  std::size_t wordOf(Cell cell) const {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(words_per_row_) +
           static_cast<std::size_t>(cell.x / 64);
  }

  GridGeometry cells_;
  int words_per_row_;
  Bits all_;
  int count_ = 0;
};

/// How many bits are set in both.
int common(const View& view, const FloorBits::Bits& bits);
/// Sets the bits of `view`, and clears them.
void include(const View& view, FloorBits::Bits& bits);
void exclude(const View& view, FloorBits::Bits& bits);
int countOf(const FloorBits::Bits& bits);

/// Counts how often each cell of a floor is seen while places are added and removed.
class SeenFloor {
 public:
  SeenFloor(const Grid<std::uint8_t>& floor, const Sight& sight);

  void add(const Vec2& place);
  void remove(const Vec2& place);
  /// The share of the floor that is seen from at least one of the places.
  double share() const { return static_cast<double>(seen_) / static_cast<double>(area_); }

 private:
  const Sight& sight_;
  Grid<std::int32_t> count_;  ///< of lines of sight through each cell; negative where nothing must be seen
  int area_ = 0;
  int seen_ = 0;
};

}  // namespace frontier_pilot::bench
