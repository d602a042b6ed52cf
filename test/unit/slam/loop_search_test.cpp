#include "slam/back_end/loop_search.h"

#include <gtest/gtest.h>

#include "support/drives/ring_drive.h"
#include "support/drives/tracked_drive.h"

namespace frontier_pilot {
namespace {

// [MAP-1]
TEST(LoopSearch, SeesASubmapAsItIsThoughItHasGrownSinceItWasLookedAt_MAP_1) {
  test::DriftingDrive drive({{2.0, 2.0, 0.0}, {8.5, 6.5, 0.0}}, test::rooms(), Pose2());
  slam::SubmapGraph graph;
  graph.add(drive.keyframe(0));
  slam::LoopSearch search;
  const surfaces::SurfacePoints points = drive.keyframe(1).keyframe.points;
  const scan_matching::SearchWindow window{0.2, 0.2, 0.1};
  EXPECT_NE(search.find(graph, 0, points, drive.truth(1), window).verdict, slam::ClosureVerdict::kAccepted)
      << "that room has not been seen";
  graph.add(drive.keyframe(1));
  EXPECT_EQ(search.find(graph, 0, points, drive.truth(1), window).verdict, slam::ClosureVerdict::kAccepted);
}

}  // namespace
}  // namespace frontier_pilot
