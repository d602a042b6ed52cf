#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "robot_check/findings.h"
#include "seen_robot.h"

namespace frontier_pilot::robot_check {
namespace {

struct Mistake {
  const char* name;
  std::function<void(SeenRobot&)> make;
  std::vector<const char*> words;  ///< that have to occur in one finding and its advice
  bool can_drive = false;
};

const std::vector<Mistake>& mistakes() {
  static const std::vector<Mistake> kMistakes = {
      {"NoScan", [](SeenRobot& r) { r.topic("/base_scan").publishers.clear(); }, {"nobody publishes /base_scan"}},
      {"ScanUnderAnotherName",
       [](SeenRobot& r) { r.topic("/base_scan").name = "/front/scan"; },
       {"nobody publishes /base_scan", "/front/scan is a sensor_msgs/LaserScan of /lidar", "set scan:=/front/scan"}},
      {"SeveralOtherOdometries",
       [](SeenRobot& r) {
         r.topic("/wheels/odom").name = "/odometry/filtered";
         r.seen.topics.push_back({"/base_pose_ground_truth", "nav_msgs/Odometry", {"/gazebo"}, {}});
       },
       {"nobody publishes /wheels/odom", "/base_pose_ground_truth is a nav_msgs/Odometry of /gazebo",
        "/odometry/filtered is a nav_msgs/Odometry of /base", "set odom:=NAME, the one that is the robot's"}},
      {"AnotherTypeUnderTheNameOfTheScan",
       [](SeenRobot& r) { r.topic("/base_scan").type = "sensor_msgs/PointCloud2"; },
       {"/base_scan is a sensor_msgs/PointCloud2", "pointcloud_to_laserscan"}},
      {"ASilentScanner", [](SeenRobot& r) { r.seen.scan.count = 0; }, {"/base_scan", "nothing arrived in 5.00 s"}},
      {"TwoScannersOnOneTopic",
       [](SeenRobot& r) {
         r.topic("/base_scan").publishers = {"/front", "/rear"};
         r.seen.scan.frames = {"front_laser", "rear_laser"};
       },
       {"several scanners publish /base_scan", "/front, /rear", "laserscan_multi_merger"}},
      {"TwoScannersOnTwoTopics",
       [](SeenRobot& r) {
         r.seen.topics.push_back({"/rear_scan", "sensor_msgs/LaserScan", {"/rear"}, {}});
       },
       {"/rear_scan (/rear)", "laserscan_multi_merger"},
       true},
      {"AScanWithoutAFrame", [](SeenRobot& r) { r.seen.scan.frames = {""}; }, {"frame_id is empty"}},
      {"AScannerThatIsNotInTf",
       [](SeenRobot& r) { r.seen.links.pop_back(); },
       {"the frame laser of /base_scan is not connected to base_link", "static_transform_publisher"}},
      {"AScanInTheFrameOfOdometry",
       [](SeenRobot& r) { r.seen.scan.frames = {"odom"}; },
       {"frame odom", "does not move with the robot"}},
      {"ATiltedScanner",
       [](SeenRobot& r) { r.seen.links[1].T_parent_child.rotate(Eigen::AngleAxisd(1.5, Eigen::Vector3d::UnitX())); },
       {"tilted by 86 deg"}},
      {"AScannerTiltedByElevenDegrees",
       [](SeenRobot& r) { r.seen.links[1].T_parent_child.rotate(Eigen::AngleAxisd(0.19, Eigen::Vector3d::UnitX())); },
       {"tilted by 11 deg"}},
      {"AMountInMillimetres",
       [](SeenRobot& r) {
         r.seen.links[1] = link("base_link", "laser", {172.0, 0.0, 0.0}, 0.2, "/s", true);
       },
       {"by TF the scanner is 172.00 m from the base's origin", "farther than 10.00 m", "in metres?"}},
      {"AScannerThatLooksBack",  // it is turned by 172 degrees
       [](SeenRobot& r) {
         r.seen.scan.last->angle_min = -kPi / 2.0;
         r.seen.scan.last->ranges.resize(180);
       },
       {"/base_scan does not show what is ahead"}},
      {"AScannerUpsideDownThatLooksToTheWrongSide",
       [](SeenRobot& r) {
         r.seen.links[1] = link("base_link", "laser", {}, 0.2, "/s", true);
         r.seen.links[1].T_parent_child.rotate(Eigen::AngleAxisd(kPi, Eigen::Vector3d::UnitX()));
         r.seen.links[1].T_parent_child.rotate(Eigen::AngleAxisd(kPi / 2.0, Eigen::Vector3d::UnitZ()));
         r.seen.scan.last->angle_min = 0.0;
         r.seen.scan.last->ranges.resize(60);
       },
       {"/base_scan does not show what is ahead"}},
      {"AScannerThatIsCoveredAhead",  // it is turned by 172 degrees
       [](SeenRobot& r) {
         std::vector<float>& ranges = r.seen.scan.last->ranges;
         std::fill(ranges.begin(), ranges.begin() + 90, std::nanf(""));
         std::fill(ranges.end() - 90, ranges.end(), std::nanf(""));
       },
       {"/base_scan does not show what is ahead"}},
      {"AShortSightedScanner",
       [](SeenRobot& r) { r.seen.scan.last->range_max = 0.4; },
       {"/base_scan does not show what is ahead", "range_max below 0.5 m"}},
      {"AScannerOutsideOfTheRobot",
       [](SeenRobot& r) {
         r.seen.links[1] = link("base_link", "laser", {0.5, 0.0, 0.0}, 0.2, "/s", true);
       },
       {"outside of the robot's outline", "robot:="},
       true},
      {"AMountThatWasNeverSet",
       [](SeenRobot& r) {
         r.seen.useless_links = {r.seen.links[1]};
         r.seen.useless_links[0].stream.problem = "its quaternion not of unit length";
         r.seen.links.pop_back();
       },
       {"transform base_link -> laser of /state_publisher cannot be used: its quaternion not of unit length"}},
      {"ATransformThatIsNoTransformNowAndThen",
       [](SeenRobot& r) { r.seen.links[0].stream.problem = "not finite"; },
       {"transform odom -> base_link of /base cannot be used: not finite"}},
      {"NoTransformThatCanBeUsed",
       [](SeenRobot& r) { r.seen.useless_links.swap(r.seen.links); },
       {"nobody publishes a transform that can be used"}},
      {"ASlowScanner",
       [](SeenRobot& r) { r.seen.scan.rate = 0.8; },
       {"/base_scan comes at 0.80 Hz", "at least 2.00 Hz"}},
      {"LateScans", [](SeenRobot& r) { r.seen.scan.lag = 0.6; }, {"/base_scan are 0.60 s behind", "/lidar", "chrony"}},
      {"ScansAheadOfTheClock",
       [](SeenRobot& r) { r.seen.scan.lag = -0.3; },
       {"/base_scan are 0.30 s ahead", "/lidar", "chrony"}},
      {"AWrongTimeIncrement",
       [](SeenRobot& r) { r.seen.scan.time_increment = 0.1; },
       {"beams of /base_scan are not credible", "take 36 s", "set robot/scanner/time_increment, to 0.000278"},
       true},
      {"NoTimeIncrementOfAScannerThatRolls",
       [](SeenRobot& r) {
         r.expected.robot.scanner.rolling = true;
         r.seen.scan.time_increment = 0.0;
       },
       {"beams of /base_scan are not credible", "measured at once", "set robot/scanner/time_increment, to 0.000278"},
       true},
      {"ATimeIncrementInAWrongUnitOfAScannerThatRolls",
       [](SeenRobot& r) {
         r.expected.robot.scanner.rolling = true;
         r.seen.scan.time_increment = 1e-3 * 0.1 / 360.0;
       },
       {"beams of /base_scan are not credible", "measured at once"},
       true},
      {"ABlindScanner",
       [](SeenRobot& r) { r.seen.scan.usable_share = 0.0; },
       {"only 0.00 % of the beams of /base_scan measure anything"}},
      {"AMalformedScan",
       [](SeenRobot& r) { r.seen.scan.problem = "angle increment zero or not finite"; },
       {"/base_scan cannot be used: angle increment zero"}},
      {"NoOdometryAtAll",
       [](SeenRobot& r) {
         r.topic("/wheels/odom").publishers.clear();
         r.seen.links.erase(r.seen.links.begin());
       },
       {"nobody publishes /wheels/odom"}},
      {"OdometryUnderAnotherName",
       [](SeenRobot& r) { r.topic("/wheels/odom").name = "/odometry/filtered"; },
       {"/odometry/filtered is a nav_msgs/Odometry of /base", "set odom:=/odometry/filtered"}},
      {"OdometryAsATransformAlone",
       [](SeenRobot& r) { r.topic("/wheels/odom").publishers.clear(); },
       {"as a transform alone", "set odom:=tf"}},
      {"OdometryThatIsNotANumber",
       [](SeenRobot& r) { r.seen.odometry.problem = "position not finite"; },
       {"/wheels/odom cannot be used: position not finite"}},
      {"OdometryWithAStampThatStandsStill",
       [](SeenRobot& r) { r.seen.odometry.stamps_advance = false; },
       {"all messages of /wheels/odom have the same stamp"}},
      {"OdometryInAnotherFrame",
       [](SeenRobot& r) { r.seen.odometry.frames = {"wheels"}; },
       {"/wheels/odom is in the frame 'wheels', not in odom", "set odom_frame:=wheels"}},
      {"LateOdometry", [](SeenRobot& r) { r.seen.odometry.lag = 0.4; }, {"/wheels/odom are 0.40 s behind"}},
      {"ABaseFrameWithAnotherName",
       [](SeenRobot& r) { r.expected.robot.base_frame = "base_footprint"; },
       {"no frame base_footprint; base_link exists: set base_frame:=base_link"}},
      {"FramesWithAPrefix",
       [](SeenRobot& r) {
         r.seen.links[0] = link("tb/odom", "tb/base_link", {}, 0.0, "/base", false);
         r.seen.links[1] = link("tb/base_link", "tb/laser", {}, 0.2, "/s", true);
       },
       {"no frame base_link; tb/base_link exists: set base_frame:=tb/base_link"}},
      {"NoTransformFromOdometryToTheBase",
       [](SeenRobot& r) { r.seen.links[0] = link("odom", "dummy", {}, 0.0, "/base", false); },
       {"there is no transform from odom to base_link"}},
      {"TheOdometryFrameAsTheBase",
       [](SeenRobot& r) { r.expected.robot.base_frame = "odom"; },
       {"odom is not above odom in the tree of frames"}},
      {"FramesThatAreSwapped",
       [](SeenRobot& r) { std::swap(r.expected.robot.base_frame, r.expected.robot.odom_frame); },
       {"base_link is not above odom in the tree of frames"}},
      {"TwoParentsOfTheBase",
       [](SeenRobot& r) { r.seen.links.push_back(link("odom_combined", "base_link", {}, 0.0, "/ekf", false)); },
       {"base_link has several parents: odom (/base), odom_combined (/ekf)"}},
      {"TwoNodesThatPublishOdometrysTransform",
       [](SeenRobot& r) {
         r.seen.links[0].stream.publishers = {"/base", "/ekf"};
       },
       {"several nodes publish the transform odom -> base_link: /base, /ekf"}},
      {"AnotherMapper",
       [](SeenRobot& r) { r.seen.links.push_back(link("map", "odom", {}, 0.0, "/gmapping", false)); },
       {"/gmapping publishes the transform map -> odom", "end that mapper"}},
      {"TwoMaps",
       [](SeenRobot& r) {
         r.topic("/map") = {"/map", "nav_msgs/OccupancyGrid", {"/mapper", "/map_server"}, {}};
       },
       {"several nodes publish /map: /mapper, /map_server"}},
      {"AnotherNodeThatDrives",
       [](SeenRobot& r) { r.topic("/drive").publishers = {"/joystick"}; },
       {"/joystick publishes /drive past the arbiter", "have it publish /cmd_vel_manual:"}},
      {"ABaseThatDoesNotListen",
       [](SeenRobot& r) { r.topic("/drive").subscribers.clear(); },
       {"no base listens to /drive", "start the base's driver"}},
      {"ABaseThatDoesNotListenWhileOurNodesRun",
       [](SeenRobot& r) {
         r.addOwnNodes();
         r.topic("/drive").subscribers = {"/teleop_gui"};
       },
       {"no base listens to /drive", "start the base's driver"}},
      {"ABaseThatListensElsewhere",
       [](SeenRobot& r) { r.topic("/drive").name = "/mobile_base/commands/velocity"; },
       {"no base listens to /drive; /base listens to", "set cmd_vel:=/mobile_base/commands/velocity"}},
      {"AnArbiterOfAnotherRobotIsNoBase",
       [](SeenRobot& r) {
         r.topic("/drive").subscribers.clear();
         r.seen.topics.push_back({"/robot2/cmd_vel_manual", "geometry_msgs/Twist", {}, {"/robot2/arbiter"}});
         r.seen.topics.push_back(
             {"/robot2/arbiter/status", "frontier_pilot/ArbiterStatus", {"/robot2/arbiter"}, {"/robot2/window"}});
       },
       {"no base listens to /drive", "start the base's driver"}},
      {"AMultiplexerWithANameLikeThoseOfOurSources",
       [](SeenRobot& r) {
         r.addOwnNodes();
         r.expected.cmd_vel = "/cmd_vel";
         r.topic("/drive") = {"/cmd_vel_mux/input/navi", "geometry_msgs/Twist", {}, {"/cmd_vel_mux"}};
       },
       {"no base listens to /cmd_vel; /cmd_vel_mux listens to", "set cmd_vel:=/cmd_vel_mux/input/navi"}},
      {"TwoArbiters",
       [](SeenRobot& r) {
         r.topic("/cmd_vel_arbiter/status").publishers = {"/arbiter", "/other_arbiter"};
       },
       {"several arbiters: /arbiter, /other_arbiter"}},
      {"SimulatedTimeWithoutAClock",
       [](SeenRobot& r) { r.seen.use_sim_time = true; },
       {"use_sim_time is true, but nobody publishes /clock", "rosparam set use_sim_time false"}},
      {"AClockThatNobodyFollows",
       [](SeenRobot& r) { r.topic("/clock").publishers = {"/gazebo"}; },
       {"/gazebo publishes /clock, but use_sim_time is not true"}},
      {"ALongWatchdog", [](SeenRobot& r) { r.expected.robot.watchdog = 5.0; }, {"goes on for 5.00 s"}},
  };
  return kMistakes;
}

bool names(const Finding& finding, const std::vector<const char*>& words) {
  const std::string said = finding.text + ": " + finding.advice;
  for (const char* word : words) {
    if (said.find(word) == std::string::npos) return false;
  }
  return finding.mark != Mark::kGood;
}

// [ROB-3]
class SeededMistake : public testing::TestWithParam<Mistake> {};

TEST_P(SeededMistake, IsNamed_ROB_3) {
  SeenRobot robot;
  GetParam().make(robot);
  const Findings findings = judge(robot.seen, robot.expected);
  bool named = false;
  for (const Finding& finding : findings) named = named || names(finding, GetParam().words);
  EXPECT_TRUE(named) << toText(findings);
  EXPECT_EQ(couldDrive(findings), GetParam().can_drive) << toText(findings);
}

INSTANTIATE_TEST_SUITE_P(Robot, SeededMistake, testing::ValuesIn(mistakes()),
                         [](const auto& mistake) { return std::string(mistake.param.name); });

}  // namespace
}  // namespace frontier_pilot::robot_check
