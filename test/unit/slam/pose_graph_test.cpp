#include "slam/graph/pose_graph.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace frontier_pilot {
namespace {

Eigen::Matrix3d informationOf(double sigma, double sigma_yaw) {
  return Eigen::Vector3d(1.0 / (sigma * sigma), 1.0 / (sigma * sigma), 1.0 / (sigma_yaw * sigma_yaw)).asDiagonal();
}

slam::PoseConstraint between(const std::vector<Pose2>& truth, std::size_t from, std::size_t to, const Pose2& noise = {},
                             bool robust = false) {
  return {from, to, truth[from].inverse() * truth[to] * noise, informationOf(0.02, 0.01), robust};
}

/// A drive around a square block of `side` steps of 1 m, ending where it began.
std::vector<Pose2> aroundTheBlock(int side) {
  std::vector<Pose2> poses = {Pose2()};
  for (int leg = 0; leg < 4; ++leg) {
    for (int i = 0; i < side; ++i) poses.push_back(poses.back() * Pose2(1.0, 0.0, i + 1 == side ? kPi / 2.0 : 0.0));
  }
  return poses;
}

class Noise {
 public:
  Noise(double sigma, double sigma_yaw) : sigma_(sigma), sigma_yaw_(sigma_yaw) {}
  Pose2 pose() { return {sigma_ * normal_(random_), sigma_ * normal_(random_), sigma_yaw_ * normal_(random_)}; }

 private:
  double sigma_, sigma_yaw_;
  std::mt19937 random_{7};
  std::normal_distribution<double> normal_;
};

/// The chain of a drive, dead reckoned: the nodes lie where the noisy steps lead.
slam::PoseGraph chain(const std::vector<Pose2>& truth, Noise noise) {
  slam::PoseGraph graph;
  graph.addNode(truth.front());
  for (std::size_t i = 1; i < truth.size(); ++i) {
    const slam::PoseConstraint step = between(truth, i - 1, i, noise.pose());
    graph.addNode(graph.pose(i - 1) * step.T_from_to);
    graph.addConstraint(step);
  }
  return graph;
}

double worstError(const slam::PoseGraph& graph, const std::vector<Pose2>& truth) {
  double worst = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    worst = std::max(worst, (graph.pose(i).position() - truth[i].position()).norm());
    worst = std::max(worst, std::abs(angleDifference(graph.pose(i).yaw, truth[i].yaw)));
  }
  return worst;
}

TEST(PoseGraph, RecoversAConsistentGraphExactlyFromABadStart) {
  const std::vector<Pose2> truth = aroundTheBlock(10);
  Noise noise(0.5, 0.2);
  slam::PoseGraph graph;
  for (const Pose2& pose : truth) graph.addNode(graph.size() == 0 ? pose : pose * noise.pose());
  for (std::size_t i = 1; i < truth.size(); ++i) graph.addConstraint(between(truth, i - 1, i));
  // Against the order of the nodes as well as along it.
  for (std::size_t i = 7; i < truth.size(); i += 5) graph.addConstraint(between(truth, i, i / 3));
  const slam::PoseGraphReport report = graph.optimize();
  EXPECT_TRUE(report.converged);
  EXPECT_LT(report.cost_after, 1e-9);
  EXPECT_LT(worstError(graph, truth), 1e-6);
}

TEST(PoseGraph, SpreadsTheErrorOfALoopOverItsChain) {
  const std::vector<Pose2> truth = aroundTheBlock(25);
  slam::PoseGraph graph = chain(truth, {0.02, 0.01});
  const double adrift = worstError(graph, truth);
  graph.addConstraint(between(truth, 0, truth.size() - 1));
  graph.optimize();
  EXPECT_LT((graph.pose(truth.size() - 1).position() - truth.back().position()).norm(), 0.05);
  EXPECT_LT(worstError(graph, truth), 0.5 * adrift);
}

TEST(PoseGraph, KeepsItsFirstNodeAndTurnsWithIt) {
  const std::vector<Pose2> truth = aroundTheBlock(8);
  slam::PoseGraph graph = chain(truth, {0.05, 0.02});
  graph.addConstraint(between(truth, 3, truth.size() - 2));
  const Pose2 gauge(30.0, -12.0, 2.5);
  slam::PoseGraph turned;
  for (const Pose2& pose : graph.poses()) turned.addNode(gauge * pose);
  for (const slam::PoseConstraint& constraint : graph.constraints()) turned.addConstraint(constraint);
  const slam::PoseGraphReport plain = graph.optimize();
  const slam::PoseGraphReport elsewhere = turned.optimize();
  EXPECT_TRUE(graph.pose(0) == Pose2());
  EXPECT_TRUE(turned.pose(0) == gauge * Pose2());
  EXPECT_NEAR(plain.cost_after, elsewhere.cost_after, 1e-6 * plain.cost_after);
  for (std::size_t i = 0; i < graph.size(); ++i) {
    const Pose2 difference = (gauge * graph.pose(i)).inverse() * turned.pose(i);
    EXPECT_LT(difference.position().norm() + std::abs(difference.yaw), 1e-5);
  }
}

TEST(PoseGraph, DifferentiatesAsTheDifferenceQuotientDoes) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(-3.0, 3.0);
  constexpr double kStep = 1e-6;
  for (int trial = 0; trial < 50; ++trial) {
    const Pose2 from(anywhere(random), anywhere(random), anywhere(random));
    const Pose2 to(anywhere(random), anywhere(random), anywhere(random));
    // Near what is measured: at half a turn the yaw's error jumps.
    const slam::PoseConstraint constraint{0, 1, from.inverse() * to * Pose2(0.3, 0.2, 0.4),
                                          Eigen::Matrix3d::Identity()};
    const slam::ResidualJacobians exact = slam::residualJacobians(from, to);
    for (int axis = 0; axis < 3; ++axis) {
      const auto nudged = [&](const Pose2& pose, double by) {
        return Pose2(pose.x + (axis == 0 ? by : 0.0), pose.y + (axis == 1 ? by : 0.0),
                     pose.yaw + (axis == 2 ? by : 0.0));
      };
      const Eigen::Vector3d by_from =
          (slam::residual(constraint, nudged(from, kStep), to) - slam::residual(constraint, nudged(from, -kStep), to)) /
          (2 * kStep);
      const Eigen::Vector3d by_to =
          (slam::residual(constraint, from, nudged(to, kStep)) - slam::residual(constraint, from, nudged(to, -kStep))) /
          (2 * kStep);
      EXPECT_LT((by_from - exact.by_from.col(axis)).norm(), 1e-7);
      EXPECT_LT((by_to - exact.by_to.col(axis)).norm(), 1e-7);
    }
  }
}

TEST(PoseGraph, IsNotBentByAFalseClosureAmongTrueOnes) {
  const std::vector<Pose2> truth = aroundTheBlock(25);
  slam::PoseGraph graph = chain(truth, {0.02, 0.01});
  for (std::size_t i = 0; i < 4; ++i) graph.addConstraint(between(truth, i, truth.size() - 1 - i, {}, true));
  slam::PoseGraph honest = graph;
  honest.optimize();
  const slam::PoseConstraint lie{10, 60, Pose2(0.5, 0.0, 0.0), informationOf(0.02, 0.01), true};
  graph.addConstraint(lie);
  graph.optimize();
  EXPECT_LT(worstError(graph, honest.poses()), 0.02);
  EXPECT_GT(graph.chi2(lie), 1e4) << "and whoever looks sees that nothing agrees with it";
}

TEST(PoseGraph, BelievesADoubtfulClosureOfALongLoopThatLooksAbsurdAtFirst) {
  const std::vector<Pose2> truth = aroundTheBlock(50);
  slam::PoseGraph graph = chain(truth, {0.03, 0.02});
  const slam::PoseConstraint closure = between(truth, 0, truth.size() - 1, {}, true);
  graph.addConstraint(closure);
  ASSERT_GT(graph.chi2(closure), 1e4) << "hundreds of standard deviations of the match itself";
  graph.optimize();
  EXPECT_LT(graph.chi2(closure), 1.0);
}

TEST(PoseGraph, LeavesANodeWhereItIsWhenNothingHoldsIt) {
  const std::vector<Pose2> truth = aroundTheBlock(5);
  slam::PoseGraph graph = chain(truth, {0.05, 0.02});
  const std::size_t alone = graph.addNode(Pose2(1.0, 2.0, 3.0));
  graph.addConstraint(between(truth, 0, truth.size() - 1));
  EXPECT_TRUE(graph.optimize().converged);
  EXPECT_TRUE(graph.pose(alone) == Pose2(1.0, 2.0, 3.0));
}

TEST(PoseGraph, HasNothingToDoWithoutConstraintsOrWhenAllIsWell) {
  slam::PoseGraph empty;
  EXPECT_TRUE(empty.optimize().converged);
  const std::vector<Pose2> truth = aroundTheBlock(5);
  slam::PoseGraph exact = chain(truth, {0.0, 0.0});
  EXPECT_TRUE(exact.optimize().converged);
  EXPECT_EQ(exact.optimize().iterations, 1);
}

TEST(PoseGraph, GivesTheSameBitsEachTime) {
  const std::vector<Pose2> truth = aroundTheBlock(30);
  slam::PoseGraph once = chain(truth, {0.03, 0.02});
  for (std::size_t i = 0; i < 20; i += 3) once.addConstraint(between(truth, i, truth.size() - 1 - i, {}, true));
  slam::PoseGraph again = once;
  once.optimize();
  again.optimize();
  for (std::size_t i = 0; i < once.size(); ++i) EXPECT_TRUE(once.pose(i) == again.pose(i));
}

}  // namespace
}  // namespace frontier_pilot
