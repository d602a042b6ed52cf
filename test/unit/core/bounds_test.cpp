#include "frontier_pilot/core/bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <random>

#include "frontier_pilot/core/grid.h"

/// The arithmetic that what comes from outside is checked with, by itself: a message may hold any number. [FLT-1]
namespace frontier_pilot {
namespace {

constexpr int kLeast = std::numeric_limits<int>::min();
constexpr int kMost = std::numeric_limits<int>::max();

/// Numbers that an int holds, most of them near where arithmetic goes wrong.
class Ints {
 public:
  int next() {
    constexpr std::array<int, 12> kEdges = {0,     1,         -1,        2,          kLeast,  kLeast + 1,
                                            kMost, kMost - 1, kMost / 2, kLeast / 2, 1 << 30, 46341};
    const auto draw = random_();
    if (draw % 4 == 0) return static_cast<int>(random_());
    if (draw % 4 == 1) return static_cast<int>(random_() % 20) - 10;
    return kEdges[random_() % kEdges.size()];
  }
  CellRect rect() { return {next(), next(), next(), next()}; }
  Cell cell() { return {next(), next()}; }

 private:
  std::mt19937 random_{7};
};

/// Cells along one axis, without the limits of an int: [low, high).
struct Cells {
  std::int64_t low, high;
  bool has(std::int64_t cell) const { return cell >= low && cell < high; }
};
Cells alongX(const CellRect& r) { return {r.x, std::int64_t{r.x} + r.width}; }
Cells alongY(const CellRect& r) { return {r.y, std::int64_t{r.y} + r.height}; }

bool has(const CellRect& r, Cell c) { return alongX(r).has(c.x) && alongY(r).has(c.y); }

/// Corners of a block, its neighbours and cells far away.
std::array<Cell, 5> cellsAbout(const CellRect& r, Ints& ints) {
  const auto cut = [](std::int64_t v) { return static_cast<int>(std::clamp<std::int64_t>(v, kLeast, kMost)); };
  return {Cell{r.x, r.y}, Cell{cut(alongX(r).high - 1), cut(alongY(r).high - 1)},
          Cell{cut(alongX(r).high), cut(alongY(r).high)}, Cell{cut(alongX(r).low - 1), r.y}, ints.cell()};
}

constexpr int kTimes = 200000;

TEST(CellRect, FLT_1_ContainsWhatLiesBetweenItsSidesWhateverTheNumbers) {  // [FLT-1]
  Ints ints;
  for (int i = 0; i < kTimes; ++i) {
    const CellRect rect = ints.rect();
    for (const Cell c : cellsAbout(rect, ints)) ASSERT_EQ(rect.contains(c), has(rect, c)) << c.x << ", " << c.y;
  }
}

TEST(CellRect, FLT_1_TheIntersectionHoldsWhatBothHoldWhateverTheNumbers) {  // [FLT-1]
  EXPECT_TRUE((CellRect{kMost, 0, 1, 1}.intersection({0, 0, 5, 4}).empty()));
  EXPECT_TRUE((CellRect{0, kMost, 1, kMost}.intersection({0, 0, 5, 4}).empty()));
  Ints ints;
  for (int i = 0; i < kTimes; ++i) {
    const CellRect a = ints.rect();
    const CellRect b = ints.rect();
    const CellRect both = a.intersection(b);
    ASSERT_EQ(both, b.intersection(a));
    for (const CellRect& rect : {a, b, both}) {
      for (const Cell c : cellsAbout(rect, ints)) ASSERT_EQ(has(both, c), has(a, c) && has(b, c)) << c.x << ", " << c.y;
    }
  }
}

TEST(CellRect, FLT_1_ABlockInsideOfTheMapIsItsOwnIntersectionAndNoOtherIs) {  // [FLT-1]
  const CellRect map{0, 0, 5, 4};
  Ints ints;
  for (int i = 0; i < kTimes; ++i) {
    const CellRect block = ints.rect();
    const bool inside = !block.empty() && alongX(block).low >= 0 && alongX(block).high <= 5 && alongY(block).low >= 0 &&
                        alongY(block).high <= 4;
    ASSERT_EQ(!block.empty() && block.intersection(map) == block, inside);
  }
}

TEST(CellRect, FLT_1_TheUnionHoldsBothAsFarAsAnIntReaches) {  // [FLT-1]
  Ints ints;
  for (int i = 0; i < kTimes; ++i) {
    const CellRect a = ints.rect();
    const CellRect b = ints.rect();
    CellRect all = a;
    all.include(b);
    if (b.empty()) {
      ASSERT_EQ(all, a);
      continue;
    }
    if (a.empty()) {
      ASSERT_EQ(all, b);
      continue;
    }
    const std::int64_t left = std::min(a.x, b.x);
    const std::int64_t right = std::max(alongX(a).high, alongX(b).high);
    ASSERT_EQ(all.x, left);
    ASSERT_EQ(all.width, std::min<std::int64_t>(right - left, kMost));
  }
}

TEST(CellRect, FLT_1_GrowingStopsWhereAnIntEnds) {  // [FLT-1]
  EXPECT_EQ((CellRect{3, 4, 5, 6}.grown(2)), (CellRect{1, 2, 9, 10}));
  EXPECT_EQ((CellRect{3, 4, 5, 6}.grown(-2)), (CellRect{5, 6, 1, 2}));
  EXPECT_EQ((CellRect{kLeast, 0, 1, 1}.grown(1)), (CellRect{kLeast, -1, 2, 3}));
  Ints ints;
  for (int i = 0; i < kTimes; ++i) {
    const CellRect rect = ints.rect();
    const int margin = std::max(0, ints.next());
    const CellRect grown = rect.grown(margin);
    ASSERT_EQ(grown.x, std::max<std::int64_t>(std::int64_t{rect.x} - margin, kLeast));
    if (rect.empty()) continue;
    for (const Cell c : {Cell{rect.x, rect.y}, ints.cell()}) {
      const bool near = Cells{alongX(rect).low - margin, alongX(rect).high + margin}.has(c.x) &&
                        Cells{alongY(rect).low - margin, alongY(rect).high + margin}.has(c.y);
      // A side is as long as an int holds, from the low end.
      const bool reached = std::int64_t{c.x} - grown.x < kMost && std::int64_t{c.y} - grown.y < kMost;
      ASSERT_EQ(has(grown, c), near && reached) << c.x << ", " << c.y;
    }
  }
}

TEST(Bounds, FLT_1_NothingThatIsNoNumberIsWithinThem) {  // [FLT-1]
  using Limits = std::numeric_limits<double>;
  for (const double value : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(), 1e300, -1e300, 1e7}) {
    EXPECT_FALSE(bounds::isWithin(value, bounds::kMostCoordinate)) << value;
  }
  for (const double value : {0.0, -0.0, Limits::denorm_min(), -Limits::denorm_min(), 1e6, -1e6}) {
    EXPECT_TRUE(bounds::isWithin(value, bounds::kMostCoordinate)) << value;
  }
}

TEST(Bounds, FLT_1_EveryPlaceThatIsAllowedLiesInACellThatAnIntHolds) {  // [FLT-1]
  // Three frames in a row, each at the edge of what is allowed, and a beam on top, at the finest resolution.
  const double farthest = 3.0 * bounds::kMostCoordinate + bounds::kMostMount + bounds::kMostRange;
  EXPECT_LT(farthest / bounds::kLeastResolution, 1e9);
  EXPECT_LT(bounds::kMostAngle / bounds::kLeastAngleIncrement, 1e9);
  EXPECT_GT(2.0 * kPi / static_cast<double>(bounds::kMostRanges), bounds::kLeastAngleIncrement);
}

}  // namespace
}  // namespace frontier_pilot
