#include "slam/graph/submap_graph.h"

#include <gtest/gtest.h>

#include <cmath>

namespace frontier_pilot {
namespace {

/// Keyframes every metre along x, in submaps of four that overlap by two.
slam::PlacedKeyframe along(std::size_t i, double sigma) {
  slam::PlacedKeyframe placed;
  placed.keyframe.T_local_base = Pose2(static_cast<double>(i), 0.0, 0.0);
  placed.step.drift = Eigen::Vector3d(sigma * sigma, sigma * sigma, 1e-12).asDiagonal();
  const std::size_t younger = i / 2;
  if (younger > 0) placed.places.push_back({younger - 1, Pose2(2.0 * static_cast<double>(younger - 1), 0.0, 0.0)});
  placed.places.push_back({younger, Pose2(2.0 * static_cast<double>(younger), 0.0, 0.0)});
  return placed;
}

slam::SubmapGraph line(std::size_t keyframes, double sigma = 0.1) {
  slam::SubmapGraph graph(slam::SubmapDrift{1e-4, 1e-6});
  for (std::size_t i = 0; i < keyframes; ++i) graph.add(along(i, sigma));
  return graph;
}

TEST(SubmapGraph, PutsEverythingWhereTheLocalMapHasItUntilSomethingIsClosed) {
  const slam::SubmapGraph graph = line(20);
  EXPECT_EQ(graph.submapCount(), 10U);
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_NEAR(graph.T_map_keyframe(i).x, static_cast<double>(i), 1e-9);
  }
  EXPECT_NEAR(graph.T_map_local().position().norm(), 0.0, 1e-9);
  EXPECT_EQ(graph.gap(9, 19), 0U) << "it is in it";
  EXPECT_EQ(graph.gap(9, 0), 9U);
  EXPECT_EQ(graph.gap(0, 19), 8U) << "it is in the last two";
}

TEST(SubmapGraph, BendsSmoothlyFromSubmapToSubmap) {
  slam::SubmapGraph graph = line(20);
  // The last keyframe is seen 2 m to the side of where the local map has it.
  graph.close(0, 9, 19, {Pose2(19.0, 2.0, 0.0), Eigen::Matrix3d::Identity() * 1e-6});
  graph.optimize();
  EXPECT_NEAR(graph.T_map_keyframe(19).y, 2.0, 0.05);
  EXPECT_NEAR(graph.T_map_keyframe(0).y, 0.0, 0.05);
  for (std::size_t i = 1; i < 20; ++i) {
    const double rise = graph.T_map_keyframe(i).y - graph.T_map_keyframe(i - 1).y;
    EXPECT_GT(rise, -0.01);
    EXPECT_LT(rise, 0.3) << "no step between submaps";
  }
  EXPECT_NEAR(graph.T_map_local().y, 2.0, 0.3) << "and the robot goes on from there";
}

TEST(SubmapGraph, KnowsTheLessTheFartherTheWay) {
  const slam::SubmapGraph graph = line(40);
  const auto uncertainty = graph.uncertaintyFrom(19);
  EXPECT_EQ(uncertainty[19].norm(), 0.0);
  for (std::size_t i = 1; i < 19; ++i) EXPECT_GT(uncertainty[i - 1](0, 0), uncertainty[i](0, 0));
  // Two steps of 0.1 m per submap, whose errors are correlated; those of different submaps are independent.
  EXPECT_NEAR(std::sqrt(uncertainty[9](0, 0)), 0.2 * std::sqrt(10.0), 0.01);
}

TEST(SubmapGraph, TakesTheMostCertainWay) {
  slam::SubmapGraph graph = line(40);
  const Eigen::Vector3d variance(1e-4, 1e-4, 1e-8);
  graph.close(0, 19, 39, {Pose2(39.0, 0.0, 0.0), Eigen::Matrix3d(variance.asDiagonal())});
  const auto uncertainty = graph.uncertaintyFrom(19);
  EXPECT_LT(std::sqrt(uncertainty[0](1, 1)), 0.1) << "by the closure, not by the long way round";
  EXPECT_LT(uncertainty[1](0, 0), uncertainty[9](0, 0));
}

TEST(SubmapGraph, SeesFarThingsMoveWhenTheYawIsUncertain) {
  slam::SubmapGraph graph(slam::SubmapDrift{1e-3, 0.01});
  for (std::size_t i = 0; i < 40; ++i) graph.add(along(i, 1e-6));
  const auto uncertainty = graph.uncertaintyFrom(0);
  // Nineteen bends of 0.01 rad, each of which acts from there to the end: sigma^2 = sum (2 k 0.01)^2, k = 1 ... 18.
  double sum = 0.0;
  for (int k = 0; k < 19; ++k) sum += 4.0 * k * k * 1e-4;
  EXPECT_NEAR(std::sqrt(uncertainty[19](1, 1)), std::sqrt(sum), 0.02);
  EXPECT_LT(uncertainty[19](0, 0), 1e-3);
  const auto back = graph.uncertaintyFrom(19);
  EXPECT_NEAR(std::sqrt(back[0](1, 1)), std::sqrt(sum), 0.1) << "seen from the other end likewise";
}

}  // namespace
}  // namespace frontier_pilot
