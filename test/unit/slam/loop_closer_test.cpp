#include "slam/back_end/loop_closer.h"

#include <gtest/gtest.h>

#include "support/drives/ring_drive.h"

namespace frontier_pilot::test {
namespace {

/// A lap and a half around a block in a local frame that drifts, with closures sought on the way.
struct Lap {
  explicit Lap(const slam::LoopCloserParameters& parameters = {},
               const slam::PoseGraphParameters& graph_parameters = {})
      : graph(slam::SubmapDrift(), graph_parameters), closer(parameters) {}

  void run() {
    constexpr double kEdge = 18.0;
    DriftingDrive drive(ringPoses(kEdge, 0.4, 1.3), ringWorld(kEdge, true), Pose2(0.003, 0.0, 0.001));
    for (std::size_t i = 0; i < drive.size(); ++i) {
      slam::PlacedKeyframe placed = drive.keyframe(i);
      const surfaces::SurfacePoints points = placed.keyframe.points;
      graph.add(std::move(placed));
      const Pose2 before = graph.T_map_local();
      const std::vector<slam::LoopClosure> found = closer.update(graph, points);
      if (found.empty()) moved_without_closure = moved_without_closure || !(graph.T_map_local() == before);
      closures.insert(closures.end(), found.begin(), found.end());
    }
  }
  std::uint64_t attempts() const {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < slam::kClosureVerdicts; ++i)
      sum += closer.counts()[static_cast<slam::ClosureVerdict>(i)];
    return sum;
  }

  slam::SubmapGraph graph;
  slam::LoopCloser closer;
  std::vector<slam::LoopClosure> closures;
  bool moved_without_closure = false;
};

// [MAP-1]
TEST(LoopCloser, ClosesTheLoopAndCountsEachClosure_MAP_1) {
  Lap lap;
  lap.run();
  EXPECT_FALSE(lap.closures.empty());
  EXPECT_EQ(lap.closer.counts()[slam::ClosureVerdict::kAccepted], lap.closures.size());
  EXPECT_FALSE(lap.moved_without_closure);
  for (const slam::LoopClosure& closure : lap.closures) {
    EXPECT_GE(lap.graph.gap(closure.submap, closure.keyframe), 2U) << "what was just left is no loop";
    EXPECT_GT(closure.keyframe_stamp, closure.reference_stamp);
  }
}

TEST(LoopCloser, LooksForNothingInSubmapsThatAreKnownWellEnough) {
  slam::LoopCloserParameters parameters;
  parameters.known_position = 1e3;
  parameters.known_yaw = 1e3;
  Lap lap(parameters);
  lap.run();
  EXPECT_EQ(lap.attempts(), 0U);
}

TEST(LoopCloser, LooksForNothingBeforeEnoughSubmapsHaveBegun) {
  slam::LoopCloserParameters parameters;
  parameters.min_gap = 1000;
  Lap lap(parameters);
  lap.run();
  EXPECT_EQ(lap.attempts(), 0U);
}

// [MAP-1]
TEST(LoopCloser, BelievesNoKeyframeThatOthersDoNotConfirm_MAP_1) {
  slam::LoopCloserParameters parameters;
  parameters.confirmations = 100;
  parameters.confirm_within = 5;
  Lap lap(parameters);
  lap.run();
  EXPECT_TRUE(lap.closures.empty());
  EXPECT_GT(lap.closer.counts()[slam::ClosureVerdict::kUnconfirmed], 0U);
  EXPECT_FALSE(lap.moved_without_closure);
}

// [MAP-1]
TEST(LoopCloser, PutsTheGraphBackWhenItContradictsTheClosures_MAP_1) {
  slam::PoseGraphParameters graph;
  graph.outlier_chi2 = 1e-9;
  Lap lap({}, graph);
  lap.run();
  EXPECT_TRUE(lap.closures.empty());
  EXPECT_GT(lap.closer.counts()[slam::ClosureVerdict::kDisagrees], 0U);
  EXPECT_FALSE(lap.moved_without_closure);
  for (const slam::PoseConstraint& constraint : lap.graph.graph().constraints()) EXPECT_FALSE(constraint.robust);
}

}  // namespace
}  // namespace frontier_pilot::test
