#include "frontier_pilot/planning/path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace frontier_pilot {
namespace {

/// Two metres ahead, then one to the left.
planning::Path corner() { return planning::Path({{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}}); }

planning::Path randomPath(std::mt19937& random, int points) {
  std::uniform_real_distribution<double> place(-3.0, 3.0);
  std::vector<Vec2> corners;
  for (int i = 0; i < points; ++i) corners.emplace_back(place(random), place(random));
  return planning::Path(corners);
}

TEST(Path, OfNoPointsHasNoLength) {
  const planning::Path path;
  EXPECT_TRUE(path.empty());
  EXPECT_EQ(path.length(), 0.0);
  EXPECT_EQ(path.project({1.0, 1.0}, 0.0, 1.0), 0.0);
  EXPECT_TRUE(path.from(1.0).empty());
  EXPECT_TRUE(path.sampled(0.1).empty());
}

TEST(Path, OfOnePointIsThereWhereverOneAsks) {
  const planning::Path path({{3.0, 4.0}});
  EXPECT_EQ(path.length(), 0.0);
  for (const double s : {-1.0, 0.0, 1.0}) {
    EXPECT_EQ(path.at(s), Vec2(3.0, 4.0));
    EXPECT_EQ(path.from(s).points().size(), 1U);
  }
  EXPECT_EQ(path.project({0.0, 0.0}, 0.0, 1.0), 0.0);
  EXPECT_EQ(path.sampled(0.1).size(), 1U);
}

TEST(Path, DropsPointsThatRepeatTheirPredecessor) {
  const planning::Path path({{0.0, 0.0}, {0.0, 0.0}, {1.0, 0.0}, {1.0, 1e-12}, {0.0, 0.0}});
  ASSERT_EQ(path.points().size(), 3U) << "the same place later on is another point";
  EXPECT_DOUBLE_EQ(path.length(), 2.0);
}

TEST(Path, IsMeasuredAlongItsLength) {
  const planning::Path path = corner();
  EXPECT_DOUBLE_EQ(path.length(), 3.0);
  EXPECT_DOUBLE_EQ(path.arcLength(1), 2.0);
  EXPECT_EQ(path.at(0.5), Vec2(0.5, 0.0));
  EXPECT_EQ(path.at(2.0), Vec2(2.0, 0.0));
  EXPECT_EQ(path.at(2.5), Vec2(2.0, 0.5));
  EXPECT_EQ(path.at(-1.0), Vec2(0.0, 0.0));
  EXPECT_EQ(path.at(9.0), path.goal());
}

TEST(Path, ProjectsOntoTheEarlierOfTwoPlacesThatAreEquallyNear) {
  EXPECT_DOUBLE_EQ(corner().project({1.5, 0.5}, 0.0, 3.0), 1.5);
  const planning::Path there_and_back({{0.0, 0.0}, {2.0, 0.0}, {0.0, 0.0}});
  EXPECT_DOUBLE_EQ(there_and_back.project({0.5, 0.3}, 0.0, 4.0), 0.5);
  EXPECT_DOUBLE_EQ(there_and_back.project({0.5, 0.3}, 2.0, 4.0), 3.5) << "on the way back";
}

TEST(Path, ProjectsOntoThePartThatIsAskedForAndNotBeyond) {
  const planning::Path path = corner();
  EXPECT_DOUBLE_EQ(path.project({0.0, 0.0}, 1.0, 2.5), 1.0);
  EXPECT_DOUBLE_EQ(path.project({2.0, 1.0}, 0.0, 2.5), 2.5);
  EXPECT_DOUBLE_EQ(path.project({2.0, 1.0}, 0.0, 99.0), 3.0);
  EXPECT_DOUBLE_EQ(path.project({0.0, 0.0}, -5.0, -1.0), 0.0);
  EXPECT_DOUBLE_EQ(path.project({0.0, 0.0}, 99.0, 99.0), 3.0);
  EXPECT_DOUBLE_EQ(path.project({2.0, 1.0}, 1.0, 0.5), 1.0) << "an interval the wrong way round is its first point";
}

TEST(Path, HasNoPointNearerThanTheProjectedOne) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-4.0, 4.0);
  for (int round = 0; round < 100; ++round) {
    const planning::Path path = randomPath(random, 2 + round % 6);
    const Vec2 point(place(random), place(random));
    const double nearest = (path.at(path.project(point, 0.0, path.length())) - point).norm();
    for (double s = 0.0; s <= path.length(); s += 0.05) EXPECT_GE((path.at(s) - point).norm(), nearest - 1e-9);
  }
}

TEST(Path, FromAPlaceOnIsTheRestOfIt) {
  std::mt19937 random(4);
  for (int round = 0; round < 50; ++round) {
    const planning::Path path = randomPath(random, 2 + round % 6);
    const double from = path.length() * (round % 11) / 10.0;
    const planning::Path rest = path.from(from);
    ASSERT_NEAR(rest.length(), path.length() - from, 1e-9);
    for (double s = 0.0; s < rest.length(); s += 0.1) ASSERT_LT((rest.at(s) - path.at(from + s)).norm(), 1e-9);
  }
  EXPECT_EQ(corner().from(2.0).points().size(), 2U) << "a corner is not repeated";
  EXPECT_EQ(corner().from(9.0).points().size(), 1U);
}

TEST(Path, SampledIsTheSameLineWithItsCornersAndNoLongSteps) {
  std::mt19937 random(5);
  for (int round = 0; round < 30; ++round) {
    const planning::Path path = randomPath(random, 2 + round % 6);
    const std::vector<Vec2> samples = path.sampled(0.3);
    const planning::Path again(samples);
    ASSERT_NEAR(again.length(), path.length(), 1e-9) << "a corner cut off would make it shorter";
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) ASSERT_LE((samples[i + 1] - samples[i]).norm(), 0.3 + 1e-9);
  }
}

}  // namespace
}  // namespace frontier_pilot
