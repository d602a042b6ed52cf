#include "frontier_pilot/mapping/loop_closer.h"

#include <gtest/gtest.h>

#include "ring_drive.h"

namespace frontier_pilot::test {
namespace {

/// A lap and a half around a block in a local frame that drifts, with closures sought on the way.
struct Lap {
  explicit Lap(const LoopCloserParameters& parameters = {}, const PoseGraphParameters& graph_parameters = {})
      : graph(SubmapDrift(), graph_parameters), closer(parameters) {}

  void run() {
    constexpr double kEdge = 18.0;
    DriftingDrive drive(ringPoses(kEdge, 0.4, 1.3), ringWorld(kEdge, true), Pose2(0.003, 0.0, 0.001));
    for (std::size_t i = 0; i < drive.size(); ++i) {
      PlacedKeyframe placed = drive.keyframe(i);
      const SurfacePoints points = placed.keyframe.points;
      graph.add(std::move(placed));
      const Pose2 before = graph.T_map_local();
      const std::vector<LoopClosure> found = closer.update(graph, points);
      if (found.empty()) moved_without_closure = moved_without_closure || !(graph.T_map_local() == before);
      closures.insert(closures.end(), found.begin(), found.end());
    }
  }
  std::uint64_t attempts() const {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < kClosureVerdicts; ++i) sum += closer.counts()[static_cast<ClosureVerdict>(i)];
    return sum;
  }

  SubmapGraph graph;
  LoopCloser closer;
  std::vector<LoopClosure> closures;
  bool moved_without_closure = false;
};

// [MAP-1]
TEST(LoopCloser, ClosesTheLoopAndCountsEachClosure_MAP_1) {
  Lap lap;
  lap.run();
  EXPECT_FALSE(lap.closures.empty());
  EXPECT_EQ(lap.closer.counts()[ClosureVerdict::kAccepted], lap.closures.size());
  EXPECT_FALSE(lap.moved_without_closure);
  for (const LoopClosure& closure : lap.closures) {
    EXPECT_GE(lap.graph.gap(closure.submap, closure.keyframe), 2U) << "what was just left is no loop";
    EXPECT_GT(closure.keyframe_stamp, closure.submap_stamp);
  }
}

TEST(LoopCloser, LooksForNothingInSubmapsThatAreKnownWellEnough) {
  LoopCloserParameters parameters;
  parameters.known_position = 1e3;
  parameters.known_yaw = 1e3;
  Lap lap(parameters);
  lap.run();
  EXPECT_EQ(lap.attempts(), 0U);
}

TEST(LoopCloser, LooksForNothingBeforeEnoughSubmapsHaveBegun) {
  LoopCloserParameters parameters;
  parameters.min_gap = 1000;
  Lap lap(parameters);
  lap.run();
  EXPECT_EQ(lap.attempts(), 0U);
}

// [MAP-1]
TEST(LoopCloser, BelievesNoKeyframeThatOthersDoNotConfirm_MAP_1) {
  LoopCloserParameters parameters;
  parameters.confirmations = 100;
  parameters.confirm_within = 5;
  Lap lap(parameters);
  lap.run();
  EXPECT_TRUE(lap.closures.empty());
  EXPECT_GT(lap.closer.counts()[ClosureVerdict::kUnconfirmed], 0U);
  EXPECT_FALSE(lap.moved_without_closure);
}

// [MAP-1]
TEST(LoopCloser, PutsTheGraphBackWhenItContradictsTheClosures_MAP_1) {
  PoseGraphParameters graph;
  graph.outlier_chi2 = 1e-9;
  Lap lap({}, graph);
  lap.run();
  EXPECT_TRUE(lap.closures.empty());
  EXPECT_GT(lap.closer.counts()[ClosureVerdict::kDisagrees], 0U);
  EXPECT_FALSE(lap.moved_without_closure);
  for (const PoseConstraint& constraint : lap.graph.graph().constraints()) EXPECT_FALSE(constraint.doubtful);
}

}  // namespace
}  // namespace frontier_pilot::test
