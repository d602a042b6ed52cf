#include "slam/front_end/odometry_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "frontier_pilot/core/motion.h"

namespace frontier_pilot {
namespace {

/// A robot's encoders: systematic errors, and random ones that are those of a metre or radian.
struct Encoders {
  double distance_scale = 1.0;
  double turn_scale = 1.0;
  double drift = 0.0;       ///< turn that is not there [rad/m]
  double shift = 0.0;       ///< sideways motion when turning [m/rad]
  double randomness = 0.0;  ///< standard deviation of both scales for a single motion

  Pose2 measured(const Pose2& actual) {
    const double distance = distance_scale + randomness * noise(random);
    const double turn = turn_scale + randomness * noise(random);
    const Vec2 chord = Rotation2(0.5 * drift * actual.x) * actual.position();
    return {chord.x() * distance, chord.y() - shift * actual.yaw, actual.yaw * turn + drift * actual.x};
  }

  std::mt19937 random{1};
  std::normal_distribution<double> noise{0.0, 1.0};
};

/// Drives a metre straight on or with a turn to either side, again and again.
void drive(slam::OdometryModel& model, Encoders& encoders, int motions) {
  for (int i = 0; i < motions; ++i) {
    const Pose2 actual(i % 4 == 3 ? 0.2 : 1.0, 0.0, 1.0 * (i % 3 - 1));
    model.learn(encoders.measured(actual), actual);
  }
}

TEST(OdometryModel, MAP_1_ChangesNothingBeforeAScanWasMatched) {
  const slam::OdometryModel model;
  const Pose2 motion(0.7, -0.1, 0.4);
  EXPECT_FALSE(isJump(motion, model.corrected(motion), 0.0, 0.0));
  EXPECT_DOUBLE_EQ(model.sigma(Pose2(1.0, 0.0, 0.0)).position, slam::OdometryTrust().distance);
  EXPECT_DOUBLE_EQ(model.sigma(Pose2(0.0, 0.0, 1.0)).yaw, slam::OdometryTrust().yaw_turn);
}

TEST(OdometryModel, MAP_1_RemovesTheErrorsOfScaleAndDriftAndTheShiftOfAScannerThatIsMountedElsewhere) {
  slam::OdometryModel model;
  Encoders encoders{1.05, 0.95, 0.06, 0.04, 0.0};
  drive(model, encoders, 60);
  for (const Pose2& actual : {Pose2(1.0, 0.0, 0.0), Pose2(1.0, 0.0, 0.5), Pose2(0.0, 0.0, -0.6)}) {
    const Pose2 corrected = model.corrected(encoders.measured(actual));
    EXPECT_LT((corrected.position() - actual.position()).norm(), 0.01);
    EXPECT_NEAR(corrected.yaw, actual.yaw, 0.01);
  }
}

TEST(OdometryModel, MAP_1_RemovesADriftFromManyShortMotionsAsFromOneLongMotion) {
  slam::OdometryModel model;
  Encoders encoders{1.0, 1.0, 0.06, 0.0, 0.0};
  drive(model, encoders, 100);
  Pose2 sum;
  for (int i = 0; i < 100; ++i) sum = sum * model.corrected(encoders.measured(Pose2(0.01, 0.0, 0.0)));
  EXPECT_NEAR(sum.y, 0.0, 0.003);
  EXPECT_NEAR(sum.yaw, 0.0, 0.003);
  EXPECT_FALSE(isJump(sum, model.corrected(encoders.measured(Pose2(1.0, 0.0, 0.0))), 0.003, 0.003));
}

TEST(OdometryModel, MAP_1_IsMoreUncertainWithEncodersOf15PercentThanWithThoseOf1Percent) {
  const Pose2 motion(1.0, 0.0, 0.5);
  slam::OdometryModel good;
  Encoders one{1.0, 1.0, 0.0, 0.0, 0.01};
  drive(good, one, 200);
  slam::OdometryModel bad;
  Encoders fifteen{1.0, 1.0, 0.0, 0.0, 0.15};
  drive(bad, fifteen, 200);
  EXPECT_DOUBLE_EQ(good.sigma(motion).position, slam::OdometryModel().sigma(motion).position);
  EXPECT_GT(bad.sigma(motion).position, 1.3 * good.sigma(motion).position);
  EXPECT_GT(bad.sigma(motion).yaw, 1.1 * good.sigma(motion).yaw);
}

TEST(OdometryModel, MAP_1_DoesNotTakeSlipForAPropertyOfTheEncoders) {
  slam::OdometryModel model;
  Encoders encoders;
  drive(model, encoders, 20);
  model.learn(Pose2(1.0, 0.0, 0.0), Pose2(0.1, 0.4, 1.0));
  EXPECT_FALSE(isJump(Pose2(1.0, 0.0, 0.2), model.corrected(Pose2(1.0, 0.0, 0.2)), 0.01, 0.01));
}

}  // namespace
}  // namespace frontier_pilot
