// Maps of several robots that grow at the same time. [MUL-1]

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "frontier_pilot/fleet/merged_map.h"
#include "frontier_pilot/grids/growing_grid.h"
#include "sized.h"
#include "support/ascii_world.h"

namespace frontier_pilot {
namespace {

using fleet::FirstSource;
using fleet::MapSnapshot;
using fleet::MergedMap;
using test::sized;
using test::toAscii;

// The maps of several robots change before the first of them is set.
TEST(MergedMap, ASourceThatGrowsWhileAnotherIsDrawnLeavesNothingAtAWrongPlace) {
  OccupancyGrid a(sized(60, 10), kFree);
  OccupancyGrid b(sized(20, 10), kFree);
  for (int y = 0; y < 10; ++y) b[Cell{19, y}] = kOccupied;
  MergedMap merged(FirstSource::kIsEqual);
  merged.setSource(1, a, a.geometry().rect(), {});
  merged.setSource(2, b, b.geometry().rect(), Pose2(0.5, 0.0, 0.0));
  OccupancyGrid grown(sized(30, 10, Vec2(-0.5, 0.0)), kFree);  // ten columns more on the left
  for (int y = 0; y < 10; ++y) grown[Cell{29, y}] = kOccupied;
  b = grown;
  merged.setSource(1, a, a.geometry().rect(), {});
  merged.setSource(2, b, b.geometry().rect(), Pose2(0.5, 0.0, 0.0));
  MergedMap anew(FirstSource::kIsEqual);
  anew.setSource(1, a, a.geometry().rect(), {});
  anew.setSource(2, b, b.geometry().rect(), Pose2(0.5, 0.0, 0.0));
  EXPECT_EQ(toAscii(merged.map()), toAscii(anew.map()));
}

/// A map of 40 x 40 cells that changes here and there, and grows.
class LivingMap {
 public:
  explicit LivingMap(unsigned seed) : random_(seed), map_(sized(40, 40), kUnknown) {}

  /// Returns the box around the cells that have other values; those that are new are not counted.
  CellRect live() {
    if (random_() % 5 == 0) {
      const int left = static_cast<int>(random_() % 20);
      const int up = static_cast<int>(random_() % 20);
      const GridGeometry larger =
          sized(map_.width() + left, map_.height() + up, map_.geometry().origin - 0.05 * Vec2(left, 0.0));
      map_ = grids::resized(map_, larger, {left, 0}, kUnknown);
    }
    CellRect changed;
    for (int blot = 0; blot < 3; ++blot) {
      const CellRect cells =
          CellRect{static_cast<int>(random_() % 60), static_cast<int>(random_() % 60), 5, 3}.intersection(
              map_.geometry().rect());
      const std::int8_t value = std::array<std::int8_t, 3>{kUnknown, kFree, kOccupied}[random_() % 3];
      for (int y = cells.y; y < cells.y + cells.height; ++y) std::fill_n(map_.row(y) + cells.x, cells.width, value);
      changed.include(cells);
    }
    return changed;
  }
  const OccupancyGrid& map() const { return map_; }

 private:
  std::mt19937 random_;
  OccupancyGrid map_;
};

TEST(MapSnapshot, TellsEachCellThatHasChangedAndFewOthers) {
  LivingMap living(3);
  MapSnapshot snapshot;
  EXPECT_EQ(snapshot.take(living.map(), {}).size(), 1U) << "all of the first one is new";
  for (int step = 0; step < 200; ++step) {
    const OccupancyGrid before = snapshot.map();
    const CellRect changed = living.live();
    const std::vector<CellRect> parts = snapshot.take(living.map(), changed);
    ASSERT_EQ(snapshot.map().geometry(), living.map().geometry());
    ASSERT_TRUE(snapshot.map().cells() == living.map().cells()) << "step " << step;
    for (const CellRect& part : parts) ASSERT_TRUE(part.width <= 16 && part.height <= 16);
    if (before.geometry() != snapshot.map().geometry()) continue;
    for (std::size_t i = 0; i < before.size(); ++i) {
      const Cell cell = before.geometry().cell(i);
      const bool told =
          std::any_of(parts.begin(), parts.end(), [cell](const CellRect& part) { return part.contains(cell); });
      ASSERT_TRUE(told || before[i] == snapshot.map()[i]) << "step " << step;
    }
  }
  EXPECT_TRUE(snapshot.take(living.map(), living.map().geometry().rect()).empty());
}

TEST(MergedMap, ToldThePartsThatHaveChangedItIsTheMapAssembledFromScratch) {
  const std::vector<Pose2> poses = {{}, {0.7, -0.3, 0.6}, {-0.5, 0.6, -2.0}};
  std::vector<LivingMap> living = {LivingMap(1), LivingMap(2), LivingMap(3)};
  std::vector<MapSnapshot> snapshots(3);
  MergedMap merged(FirstSource::kIsEqual);
  for (int step = 0; step < 300; ++step) {
    const std::size_t i = static_cast<std::size_t>(step) % 3;
    const CellRect changed = living[i].live();
    const std::vector<CellRect> parts = snapshots[i].take(living[i].map(), changed);
    ASSERT_EQ(merged.setSourceParts(i, snapshots[i].map(), parts, poses[i]), fleet::SourceResult::kTaken);
    if (step < 2) continue;
    MergedMap anew(FirstSource::kIsEqual);
    for (std::size_t k = 0; k < 3; ++k)
      anew.setSource(k, snapshots[k].map(), snapshots[k].map().geometry().rect(), poses[k]);
    ASSERT_EQ(merged.map().geometry(), anew.map().geometry()) << "step " << step;
    ASSERT_TRUE(merged.map().cells() == anew.map().cells()) << "step " << step;
  }
}

// What was drawn without a source, because that had another geometry by then, is drawn again with it.
TEST(MergedMap, ASourceThatHasGrownIsDrawnWhereItWasLeftOut) {
  OccupancyGrid a(sized(20, 10), kUnknown);
  OccupancyGrid b(sized(20, 10), kFree);
  MergedMap merged(FirstSource::kIsEqual);
  merged.setSource(1, a, a.geometry().rect(), {});
  merged.setSource(2, b, b.geometry().rect(), {});
  b = OccupancyGrid(sized(30, 10), kFree);
  merged.setSource(1, a, a.geometry().rect(), {});
  EXPECT_TRUE(isUnknown(merged.map()[Cell{3, 3}]));
  merged.setSourceParts(2, b, {{20, 0, 10, 10}}, {});
  EXPECT_EQ(toAscii(merged.map()), toAscii(b));
}

}  // namespace
}  // namespace frontier_pilot
