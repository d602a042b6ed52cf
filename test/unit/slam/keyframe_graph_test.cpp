#include "slam/graph/keyframe_graph.h"

#include <gtest/gtest.h>

#include <cmath>

namespace frontier_pilot {
namespace {

constexpr std::size_t kCount = 20;
constexpr std::size_t kWeak = 13;  // the keyframe to which a weak step leads
constexpr double kTurn = 0.05;     // the error of that step [rad]

Pose2 truth(std::size_t i) { return {static_cast<double>(i), 0.0, 0.0}; }

/// Keyframes every metre along x, in submaps of four that overlap by two; from kWeak on they are bent aside.
slam::SubmapGraph bentLine() {
  slam::SubmapGraph graph;
  std::vector<Pose2> local;
  for (std::size_t i = 0; i < kCount; ++i) {
    const Pose2 bend = i == kWeak ? Pose2(0.0, 0.0, kTurn) : Pose2();
    slam::PlacedKeyframe placed;
    if (i > 0) placed.step.motion = Pose2(1.0, 0.0, 0.0) * bend;
    local.push_back(i == 0 ? Pose2() : local.back() * placed.step.motion);
    placed.keyframe.T_local_base = local.back();
    placed.step.weak = i == kWeak;
    const double sigma = placed.step.weak ? 0.06 : 1e-4;
    placed.step.drift = Eigen::Matrix3d::Identity() * sigma * sigma;
    const std::size_t younger = i / 2;
    if (younger > 0) placed.places.push_back({younger - 1, local[2 * (younger - 1)]});
    placed.places.push_back({younger, local[2 * younger]});
    graph.add(placed);
  }
  return graph;
}

TEST(KeyframeGraph, LeavesEverythingWhereItIsUntilSomethingIsClosed) {
  const slam::SubmapGraph graph = bentLine();
  const std::vector<Pose2> poses = slam::keyframePoses(graph);
  ASSERT_EQ(poses.size(), kCount);
  for (std::size_t i = 0; i < kCount; ++i) {
    EXPECT_NEAR((poses[i].position() - graph.keyframe(i).T_local_base.position()).norm(), 0.0, 1e-6);
  }
}

// [MAP-1]
TEST(KeyframeGraph, PutsTheErrorWhereTheWeakStepIsAlsoWithinASubmap) {
  slam::SubmapGraph graph = bentLine();
  const Eigen::Matrix3d exact = Eigen::Matrix3d::Identity() * 1e-6;
  graph.close(0, graph.submapCount() - 1, kCount - 1, {truth(kCount - 1), exact});
  graph.optimize();
  const std::vector<Pose2> poses = slam::keyframePoses(graph);
  double rigid = 0.0;
  for (std::size_t i = 0; i < kCount; ++i) {
    EXPECT_NEAR(poses[i].y, 0.0, 0.005) << i;
    rigid = std::max(rigid, std::abs(graph.T_map_keyframe(i).y));
  }
  EXPECT_GT(rigid, 0.02) << "rigid submaps cannot do that";
}

TEST(KeyframeGraph, RefersAClosureToTheNearestKeyframeOfItsSubmap) {
  const slam::SubmapGraph graph = bentLine();
  EXPECT_EQ(graph.nearestKeyframe(2, Pose2(-5.0, 0.0, 0.0)), 4U);
  EXPECT_EQ(graph.nearestKeyframe(2, Pose2(2.2, 0.3, 0.0)), 6U);
}

}  // namespace
}  // namespace frontier_pilot
