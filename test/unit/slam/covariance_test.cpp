#include "slam/graph/covariance.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <functional>
#include <random>

namespace frontier_pilot {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

class Covariance : public ::testing::Test {
 protected:
  Pose2 randomPose() { return {number_(random_), number_(random_), 3.0 * number_(random_)}; }
  Matrix3d randomCovariance() {
    Matrix3d root;
    for (int i = 0; i < 9; ++i) root(i) = number_(random_);
    return root * root.transpose();
  }
  /// How a pose that is made of `T` moves with `T`, by differences.
  static Matrix3d derivative(const Pose2& T, const std::function<Pose2(const Pose2&)>& made) {
    constexpr double kStep = 1e-6;
    Matrix3d jacobian;
    for (int i = 0; i < 3; ++i) {
      const Vector3d step = kStep * Vector3d::Unit(i);
      const Pose2 high = made(Pose2(T.x + step.x(), T.y + step.y(), T.yaw + step.z()));
      const Pose2 low = made(Pose2(T.x - step.x(), T.y - step.y(), T.yaw - step.z()));
      const Vector3d moved(high.x - low.x, high.y - low.y, angleDifference(high.yaw, low.yaw));
      jacobian.col(i) = moved / (2.0 * kStep);
    }
    return jacobian;
  }

 private:
  std::mt19937 random_{7};
  std::uniform_real_distribution<double> number_{-1.0, 1.0};
};

TEST_F(Covariance, OfNoErrorIsZeroHoweverItIsUsed) {
  const Matrix3d none = slam::diagonalCovariance(0.0, 0.0);
  EXPECT_TRUE(slam::compounded(randomPose(), none, randomPose(), none).isZero());
  EXPECT_TRUE(slam::reversed(none, randomPose()).isZero());
  EXPECT_EQ(slam::positionSigma(none), 0.0);
  EXPECT_EQ(slam::yawSigma(none), 0.0);
}

TEST_F(Covariance, CompoundedIsWhatTheDerivativesOfTheProductSay) {
  for (int round = 0; round < 50; ++round) {
    const Pose2 a = randomPose();
    const Pose2 b = randomPose();
    const Matrix3d of_a = randomCovariance();
    const Matrix3d of_b = randomCovariance();
    const Matrix3d by_a = derivative(a, [&](const Pose2& T) { return T * b; });
    const Matrix3d by_b = derivative(b, [&](const Pose2& T) { return a * T; });
    const Matrix3d expected = by_a * of_a * by_a.transpose() + by_b * of_b * by_b.transpose();
    EXPECT_TRUE(slam::compounded(a, of_a, a * b, of_b).isApprox(expected, 1e-6));
  }
}

TEST_F(Covariance, ReversedIsWhatTheDerivativeOfTheInverseSays) {
  for (int round = 0; round < 50; ++round) {
    const Pose2 a = randomPose();
    const Matrix3d of_a = randomCovariance();
    const Matrix3d by_a = derivative(a, [](const Pose2& T) { return T.inverse(); });
    EXPECT_TRUE(slam::reversed(of_a, a).isApprox(by_a * of_a * by_a.transpose(), 1e-6));
    EXPECT_TRUE(slam::reversed(slam::reversed(of_a, a), a.inverse()).isApprox(of_a, 1e-9)) << "there and back";
  }
}

TEST_F(Covariance, OfAChainDoesNotDependOnWhichLinkIsJoinedFirst) {
  for (int round = 0; round < 50; ++round) {
    const Pose2 a = randomPose();
    const Pose2 b = randomPose();
    const Pose2 c = randomPose();
    const Matrix3d of_a = randomCovariance();
    const Matrix3d of_b = randomCovariance();
    const Matrix3d of_c = randomCovariance();
    const Matrix3d left = slam::compounded(a * b, slam::compounded(a, of_a, a * b, of_b), a * b * c, of_c);
    const Matrix3d right = slam::compounded(a, of_a, a * b * c, slam::compounded(b, of_b, b * c, of_c));
    EXPECT_TRUE(left.isApprox(right, 1e-9));
  }
}

TEST_F(Covariance, AlongTurnedAxesHasItsAxesExchangedByAQuarterTurn) {
  const Matrix3d covariance = Vector3d(4.0, 1.0, 0.5).asDiagonal();
  EXPECT_TRUE(slam::alongAxes(covariance, kPi / 2.0).isApprox(Matrix3d(Vector3d(1.0, 4.0, 0.5).asDiagonal()), 1e-12));
  const Matrix3d any = randomCovariance();
  EXPECT_TRUE(slam::alongAxes(slam::alongAxes(any, 0.7), -0.7).isApprox(any, 1e-12));
}

TEST_F(Covariance, HasAsPositionSigmaTheGreatestOfAnyDirection) {
  EXPECT_DOUBLE_EQ(slam::positionSigma(slam::diagonalCovariance(0.3, 0.1)), 0.3);
  EXPECT_DOUBLE_EQ(slam::yawSigma(slam::diagonalCovariance(0.3, 0.1)), 0.1);
  for (int round = 0; round < 50; ++round) {
    const Matrix3d covariance = randomCovariance();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(Eigen::Matrix2d(covariance.topLeftCorner<2, 2>()));
    EXPECT_NEAR(slam::positionSigma(covariance), std::sqrt(solver.eigenvalues()(1)), 1e-9);
    EXPECT_NEAR(slam::positionSigma(slam::alongAxes(covariance, 1.1)), slam::positionSigma(covariance), 1e-9);
  }
}

}  // namespace
}  // namespace frontier_pilot
