#include "ros/behavior_server/waiting_scans.h"

#include <gtest/gtest.h>

#include <vector>

namespace frontier_pilot {
namespace {

LaserScan2 scanAt(double seconds) {
  LaserScan2 scan;
  scan.stamp = timeFromSeconds(seconds);
  scan.ranges = {1.0F};
  return scan;
}

/// Poses of which only those from the first to the last one are known, as those of TF.
class KnownPoses {
 public:
  void end(double seconds) { last_ = timeFromSeconds(seconds); }
  std::optional<Pose2> operator()(Time time) const {
    return time >= first_ && time <= last_ ? std::make_optional(Pose2()) : std::nullopt;
  }

 private:
  Time first_ = timeFromSeconds(100.0), last_{};
};

/// The stamps of the scans that are taken [s].
std::vector<double> takenFrom(WaitingScans& scans, const KnownPoses& poses) {
  std::vector<double> stamps;
  scans.take(poses, [&stamps](const LaserScan2& scan, const Pose2&) { stamps.push_back(toSeconds(scan.stamp)); });
  return stamps;
}

// [SPN-3] a scanner with 40 Hz and odometry with 10 Hz, which is known 35 ms after its stamp
TEST(WaitingScans, SPN_3_AreTakenAlthoughMoreOfThemComeBeforeTheNextPose) {
  WaitingScans scans;
  KnownPoses poses;
  std::vector<double> taken;
  for (int ms = 0; ms <= 300; ms += 5) {
    if (ms % 100 == 35) poses.end(100.0 + (ms - 35) / 1000.0);
    if (ms % 25 != 0) continue;
    scans.add(scanAt(100.0 + ms / 1000.0));
    for (const double stamp : takenFrom(scans, poses)) taken.push_back(stamp);
  }
  ASSERT_EQ(taken.size(), 9U) << "up to the pose at 0.2 s";
  for (std::size_t i = 0; i < taken.size(); ++i) EXPECT_NEAR(taken[i], 100.0 + 0.025 * static_cast<double>(i), 1e-6);
}

TEST(WaitingScans, ThoseOfBeforeTheFirstPoseDoNotHoldUpTheLaterOnes) {
  WaitingScans scans;
  KnownPoses poses;
  for (const double stamp : {99.0, 100.0, 101.0}) scans.add(scanAt(stamp));
  EXPECT_TRUE(takenFrom(scans, poses).empty());
  poses.end(100.5);
  EXPECT_EQ(takenFrom(scans, poses), std::vector<double>{100.0});
  poses.end(101.5);
  EXPECT_EQ(takenFrom(scans, poses), std::vector<double>{101.0});
}

TEST(WaitingScans, FLT_1_AreBoundedInNumberWhereNoPoseComes) {  // [FLT-1]
  WaitingScans scans;
  KnownPoses poses;
  for (int i = 0; i < 1000; ++i) scans.add(scanAt(100.0 + i));
  poses.end(5000.0);
  const std::vector<double> taken = takenFrom(scans, poses);
  EXPECT_EQ(taken.size(), WaitingScans::kMost);
  EXPECT_EQ(taken.back(), 1099.0) << "the oldest are given up";
}

}  // namespace
}  // namespace frontier_pilot
