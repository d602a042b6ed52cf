// Maps of several robots that grow at the same time. [MUL-1]

#include <gtest/gtest.h>

#include "frontier_pilot/fleet/merged_map.h"
#include "sized.h"
#include "support/ascii_world.h"

namespace frontier_pilot {
namespace {

using fleet::FirstSource;
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

}  // namespace
}  // namespace frontier_pilot
