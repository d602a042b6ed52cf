#include "frontier_pilot/scan_matching/correlative_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "frontier_pilot/core/motion.h"
#include "scan_matching/likelihood_grid.h"

namespace frontier_pilot {
namespace {

/// A seeded source of poses and points.
class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  Pose2 pose(double reach, double turn) {
    return {between(-reach, reach), between(-reach, reach), between(-turn, turn)};
  }
  std::vector<Vec2> points(int count, double reach) {
    std::vector<Vec2> result;
    for (int i = 0; i < count; ++i) result.emplace_back(between(-reach, reach), between(-reach, reach));
    return result;
  }

 private:
  std::mt19937 random_;
};

/// `points` as seen from `T_map_base`.
surfaces::SurfacePoints seenFrom(const Pose2& T_map_base, const std::vector<Vec2>& points) {
  surfaces::SurfacePoints result;
  for (const Vec2& point : points) result.push_back({T_map_base.inverse() * point, Vec2::Zero()});
  return result;
}

scan_matching::LikelihoodGrid fieldOf(const std::vector<Vec2>& points, double resolution = 0.05) {
  scan_matching::LikelihoodParameters parameters;
  parameters.resolution = resolution;
  scan_matching::LikelihoodGrid field(parameters);
  field.add(points);
  return field;
}

double meanLikelihood(const scan_matching::LikelihoodGrid& field, const surfaces::SurfacePoints& points,
                      const Pose2& pose) {
  const GridGeometry& geometry = field.grid().geometry();
  double sum = 0.0;
  for (const surfaces::SurfacePoint& point : points) {
    sum += field.grid().get(geometry.cellAt(pose * point.position), 0);
  }
  return sum / (255.0 * static_cast<double>(points.size()));
}

double penaltyAt(const scan_matching::SearchPenalty& penalty, const Pose2& expected, const Pose2& pose) {
  const double moved = (pose.position() - expected.position()).norm() / penalty.sigma_position;
  const double turned = angleDifference(pose.yaw, expected.yaw) / penalty.sigma_yaw;
  return penalty.weight * std::min(penalty.limit * penalty.limit, moved * moved + turned * turned);
}

/// The best rating by looking at every pose of the lattice.
double bestByExhaustion(const scan_matching::LikelihoodGrid& field, const surfaces::SurfacePoints& points,
                        const scan_matching::SearchRequest& request) {
  const double cell = field.parameters().resolution;
  double squares = 0.0;
  for (const surfaces::SurfacePoint& point : points) squares += point.position.squaredNorm();
  const double step = cell / std::sqrt(squares / static_cast<double>(points.size()));
  const auto count = [](double half, double size) { return static_cast<int>(std::ceil(half / size)); };
  double best = -1e9;
  for (int k = -count(request.window.yaw, step); k <= count(request.window.yaw, step); ++k) {
    for (int j = -count(request.window.y, cell); j <= count(request.window.y, cell); ++j) {
      for (int i = -count(request.window.x, cell); i <= count(request.window.x, cell); ++i) {
        const Pose2 pose(request.expected.x + cell * i, request.expected.y + cell * j, request.expected.yaw + step * k);
        const auto& exclusions = request.exclusions;
        const bool excluded = std::any_of(exclusions.begin(), exclusions.end(), [&](const auto& exclusion) {
          return !isJump(exclusion.pose, pose, exclusion.distance, exclusion.angle);
        });
        const double score = meanLikelihood(field, points, pose);
        if (excluded || score < request.min_score) continue;
        best = std::max(best, score - penaltyAt(request.penalty, request.expected, pose));
      }
    }
  }
  return best;
}

TEST(CorrelativeSearch, FindsTheBestPoseOfTheWindowWhateverThePyramid) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    Dice dice(seed);
    const std::vector<Vec2> world = dice.points(30, 3.0);
    const scan_matching::LikelihoodGrid field = fieldOf(world);
    const surfaces::SurfacePoints points = seenFrom(dice.pose(0.3, 3.0), world);
    scan_matching::SearchRequest request;
    request.expected = dice.pose(0.3, 3.0);
    request.window = {dice.between(0.0, 0.6), dice.between(0.0, 0.6), dice.between(0.0, 0.2)};
    request.penalty = {dice.between(0.0, 0.02), 3.0, dice.between(0.05, 0.5), dice.between(0.02, 0.2)};
    if (seed % 3 == 0) request.exclusions = {{dice.pose(0.2, 3.0), 0.2, 3.2}};
    if (seed % 6 == 0) request.exclusions.push_back({dice.pose(0.4, 3.0), 0.1, 3.2});
    const double best = bestByExhaustion(field, points, request);
    for (int top = 0; top <= 5; ++top) {
      const auto found =
          scan_matching::correlativeSearch(scan_matching::MaxPyramid(field.grid(), top), points, request);
      if (best < -1.0) {
        EXPECT_FALSE(found) << "everything is excluded, seed " << seed;
        continue;
      }
      ASSERT_TRUE(found) << "seed " << seed << ", top " << top;
      // A point that falls on a cell's border may be counted to either side.
      EXPECT_NEAR(found->rating, best, 1e-6) << "seed " << seed << ", top " << top;
    }
  }
}

TEST(CorrelativeSearch, FindsWhereTheRobotIsWithinACell) {
  Dice dice(7);
  const std::vector<Vec2> world = dice.points(200, 8.0);
  const scan_matching::MaxPyramid pyramid(fieldOf(world).grid(), 6);
  for (int i = 0; i < 20; ++i) {
    const Pose2 truth = dice.pose(2.0, 3.0);
    scan_matching::SearchRequest request;
    request.expected = truth * dice.pose(2.0, 0.3);
    request.window = {3.0, 3.0, 0.4};
    const auto found = scan_matching::correlativeSearch(pyramid, seenFrom(truth, world), request);
    ASSERT_TRUE(found);
    EXPECT_FALSE(isJump(truth, found->pose, 0.05, 0.01)) << "case " << i;
    EXPECT_FALSE(found->on_border);
    EXPECT_GT(found->score, 0.6);
  }
}

TEST(CorrelativeSearch, LooksInAllDirections) {
  Dice dice(8);
  const std::vector<Vec2> world = dice.points(100, 4.0);
  scan_matching::SearchRequest request;
  request.window = {0.5, 0.5, 4.0};
  const Pose2 truth(0.2, -0.3, 3.0);
  const auto found = scan_matching::correlativeSearch(scan_matching::MaxPyramid(fieldOf(world).grid(), 3),
                                                      seenFrom(truth, world), request);
  ASSERT_TRUE(found);
  EXPECT_FALSE(isJump(truth, found->pose, 0.05, 0.02));
}

TEST(CorrelativeSearch, SaysWhenTheOptimumLiesOnTheBorderOfTheWindow) {
  Dice dice(9);
  const std::vector<Vec2> world = dice.points(200, 4.0);
  scan_matching::SearchRequest request;
  request.window = {0.2, 0.2, 0.1};
  request.expected = {-0.3, 0.0, 0.0};
  const auto found = scan_matching::correlativeSearch(scan_matching::MaxPyramid(fieldOf(world).grid(), 2),
                                                      seenFrom({}, world), request);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->on_border);
}

TEST(CorrelativeSearch, FindsNothingThatScoresTooLittle) {
  Dice dice(10);
  scan_matching::SearchRequest request;
  request.window = {0.3, 0.3, 0.1};
  request.min_score = 0.5;
  const scan_matching::MaxPyramid pyramid(fieldOf(dice.points(50, 4.0)).grid(), 2);
  EXPECT_FALSE(scan_matching::correlativeSearch(pyramid, seenFrom({}, dice.points(50, 4.0)), request));
}

TEST(CorrelativeSearch, FindsNothingWhenItIsStopped) {
  Dice dice(12);
  const std::vector<Vec2> world = dice.points(50, 4.0);
  scan_matching::SearchRequest request;
  request.window = {0.3, 0.3, 0.1};
  for (int top = 0; top <= 3; ++top) {
    const scan_matching::MaxPyramid pyramid(fieldOf(world).grid(), top);
    int asked = 0;
    request.stop = [&asked] { return ++asked > 0; };
    EXPECT_FALSE(scan_matching::correlativeSearch(pyramid, seenFrom({}, world), request));
    EXPECT_EQ(asked, 1);
    request.stop = [] { return false; };
    EXPECT_TRUE(scan_matching::correlativeSearch(pyramid, seenFrom({}, world), request));
  }
}

TEST(CorrelativeSearch, StaysWhereItIsExpectedAmongEquals) {
  // A wall without ends: nothing determines the robot's position along it.
  std::vector<Vec2> wall;
  std::vector<Vec2> seen;
  for (int i = -400; i <= 400; ++i) wall.emplace_back(0.02 * i, 1.0);
  for (int i = -40; i <= 40; ++i) seen.emplace_back(0.05 * i, 1.0);
  scan_matching::SearchRequest request;
  request.expected = {0.013, 0.0, 0.0};
  request.window = {1.0, 0.2, 0.05};
  request.penalty = {0.001, 3.0, 0.05, 0.02};
  const auto found =
      scan_matching::correlativeSearch(scan_matching::MaxPyramid(fieldOf(wall).grid(), 3), seenFrom({}, seen), request);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->pose.x, request.expected.x, 1e-9);
}

TEST(CorrelativeSearch, TellsASecondPeakFromTheFirst) {
  // Two equal rooms: with the first excluded the second one is found.
  Dice dice(11);
  const std::vector<Vec2> room = dice.points(60, 1.0);
  std::vector<Vec2> world = room;
  for (const Vec2& point : room) world.emplace_back(point.x() + 3.0, point.y());
  const scan_matching::MaxPyramid pyramid(fieldOf(world).grid(), 5);
  scan_matching::SearchRequest request;
  request.window = {4.0, 1.0, 0.1};
  const auto first = scan_matching::correlativeSearch(pyramid, seenFrom({}, room), request);
  ASSERT_TRUE(first);
  request.exclusions = {{first->pose, 0.5, 1.0}};
  const auto second = scan_matching::correlativeSearch(pyramid, seenFrom({}, room), request);
  ASSERT_TRUE(second);
  EXPECT_NEAR(std::abs(second->pose.x - first->pose.x), 3.0, 0.051);
  EXPECT_NEAR(second->score, first->score, 0.02);
}

}  // namespace
}  // namespace frontier_pilot
