#include "ros/common/messages/conversions.h"

#include <algorithm>
#include <cmath>

#include "frontier_pilot/core/bounds.h"
#include "ros/common/messages/message_problems.h"

namespace frontier_pilot {

namespace {

/// Stores `what` in `why` unless that is null, and returns std::nullopt for the caller to return.
std::nullopt_t malformed(std::string* why, const std::string& what) {
  if (why != nullptr) *why = what;
  return std::nullopt;
}

/// Nothing unless the norm is 1 within 1 %, which allows for single precision; a quaternion that was never set is zero.
std::optional<Eigen::Quaterniond> toQuaternion(const geometry_msgs::Quaternion& msg) {
  const Eigen::Quaterniond q(msg.w, msg.x, msg.y, msg.z);
  const double norm = q.norm();
  if (!(std::abs(norm - 1.0) < 0.01)) return std::nullopt;  // written so that NaN fails
  return q.normalized();
}

double yawOf(const Eigen::Quaterniond& q) {
  const Eigen::Vector3d x_axis = q * Eigen::Vector3d::UnitX();
  return std::atan2(x_axis.y(), x_axis.x());
}

template <class Position>
std::optional<Pose2> toPose2(const Position& position, const geometry_msgs::Quaternion& rotation, std::string* why) {
  if (const std::string problem = problemOfPlace(position.x, position.y, position.z); !problem.empty()) {
    return malformed(why, problem);
  }
  const auto q = toQuaternion(rotation);
  if (!q) return malformed(why, "quaternion not of unit length");
  return Pose2(position.x, position.y, yawOf(*q));
}

geometry_msgs::Quaternion toQuaternionMsg(double yaw) {
  geometry_msgs::Quaternion msg;
  msg.z = std::sin(yaw / 2.0);
  msg.w = std::cos(yaw / 2.0);
  return msg;
}

template <class Message>
Message stamped(const std::string& frame, Time stamp) {
  Message msg;
  msg.header.frame_id = frame;
  msg.header.stamp = toRosTime(stamp);
  return msg;
}

bool validCells(const std::vector<std::int8_t>& cells) {
  return std::all_of(cells.begin(), cells.end(), [](std::int8_t v) { return v >= kUnknown && v <= kOccupied; });
}

std::size_t area(std::uint32_t width, std::uint32_t height) {
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

}  // namespace

std::optional<Pose2> toPose(const geometry_msgs::Pose& msg, std::string* why) {
  return toPose2(msg.position, msg.orientation, why);
}

std::optional<Pose2> toPose(const geometry_msgs::Transform& msg, std::string* why) {
  return toPose2(msg.translation, msg.rotation, why);
}

std::optional<Eigen::Isometry3d> toIsometry(const geometry_msgs::Transform& msg, std::string* why) {
  const auto& place = msg.translation;
  if (const std::string problem = problemOfPlace(place.x, place.y, place.z); !problem.empty()) {
    return malformed(why, problem);
  }
  const auto q = toQuaternion(msg.rotation);
  if (!q) return malformed(why, "quaternion not of unit length");
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() << msg.translation.x, msg.translation.y, msg.translation.z;
  T.linear() = q->toRotationMatrix();
  return T;
}

geometry_msgs::Pose toPoseMsg(const Pose2& pose) {
  geometry_msgs::Pose msg;
  msg.position.x = pose.x;
  msg.position.y = pose.y;
  msg.orientation = toQuaternionMsg(pose.yaw);
  return msg;
}

geometry_msgs::Transform toTransformMsg(const Pose2& pose) {
  geometry_msgs::Transform msg;
  msg.translation.x = pose.x;
  msg.translation.y = pose.y;
  msg.rotation = toQuaternionMsg(pose.yaw);
  return msg;
}

geometry_msgs::PoseStamped toPoseStampedMsg(const Pose2& pose, const std::string& frame, Time stamp) {
  auto msg = stamped<geometry_msgs::PoseStamped>(frame, stamp);
  msg.pose = toPoseMsg(pose);
  return msg;
}

geometry_msgs::PolygonStamped toPolygonStampedMsg(const std::vector<Vec2>& corners, const std::string& frame,
                                                  Time stamp) {
  auto msg = stamped<geometry_msgs::PolygonStamped>(frame, stamp);
  for (const Vec2& corner : corners) {
    geometry_msgs::Point32 point;
    point.x = static_cast<float>(corner.x());
    point.y = static_cast<float>(corner.y());
    msg.polygon.points.push_back(point);
  }
  return msg;
}

std::optional<double> toCharge(const sensor_msgs::BatteryState& msg, bool& in_percent, std::string* why) {
  constexpr double kMostShare = 1.5;
  const double value = static_cast<double>(msg.percentage);
  if (!std::isfinite(value)) return malformed(why, "percentage is not finite");
  if (value < 0.0 || value > 100.0) return malformed(why, "percentage is not between 0 and 100");
  in_percent = in_percent || value > kMostShare;
  return in_percent ? value / 100.0 : value;
}

std::optional<Twist2> toTwist(const geometry_msgs::Twist& msg, std::string* why) {
  if (!isFinite(msg.linear) || !isFinite(msg.angular)) return malformed(why, "velocity not finite");
  return Twist2{msg.linear.x, msg.angular.z};
}

geometry_msgs::Twist toTwistMsg(const Twist2& twist) {
  geometry_msgs::Twist msg;
  msg.linear.x = twist.linear;
  msg.angular.z = twist.angular;
  return msg;
}

std::optional<MotionSample> toOdometry(const nav_msgs::Odometry& msg, std::string* why) {
  const auto pose = toPose(msg.pose.pose, why);
  if (!pose) return std::nullopt;
  const auto twist = toTwist(msg.twist.twist, why);
  if (!twist) return std::nullopt;
  if (const std::string problem = problemOf(*twist); !problem.empty()) return malformed(why, problem);
  return MotionSample{toTime(msg.header.stamp), *pose, *twist};
}

nav_msgs::Odometry toOdometryMsg(const MotionSample& odometry, const std::string& frame,
                                 const std::string& child_frame) {
  auto msg = stamped<nav_msgs::Odometry>(frame, odometry.stamp);
  msg.child_frame_id = child_frame;
  msg.pose.pose = toPoseMsg(odometry.T_odom_base);
  msg.twist.twist = toTwistMsg(odometry.twist);
  return msg;
}

std::optional<LaserScan2> toLaserScan(const sensor_msgs::LaserScan& msg, const Eigen::Isometry3d& T_base_sensor,
                                      std::string* why) {
  if (const std::string problem = problemOf(msg); !problem.empty()) return malformed(why, problem);
  if (const std::string problem = problemOfMount(T_base_sensor); !problem.empty()) return malformed(why, problem);
  const Eigen::Matrix3d R = T_base_sensor.linear();
  const double uprightness = R(2, 2);  // cosine of the angle between the two z axes
  if (std::abs(uprightness) < std::cos(10.0 * kPi / 180.0)) return malformed(why, "scanner tilted");
  const double turn = uprightness > 0.0 ? 1.0 : -1.0;
  LaserScan2 scan;
  scan.stamp = toTime(msg.header.stamp);
  scan.angle_min = turn * static_cast<double>(msg.angle_min);
  scan.angle_increment = turn * static_cast<double>(msg.angle_increment);
  scan.time_increment = static_cast<double>(msg.time_increment);
  scan.range_min = static_cast<double>(msg.range_min);
  scan.range_max = std::min(static_cast<double>(msg.range_max), bounds::kUsedRange);
  scan.T_base_sensor =
      Pose2(T_base_sensor.translation().x(), T_base_sensor.translation().y(), std::atan2(R(1, 0), R(0, 0)));
  scan.ranges = msg.ranges;
  return scan;
}

sensor_msgs::LaserScan toLaserScanMsg(const LaserScan2& scan, const std::string& frame, double scan_time) {
  auto msg = stamped<sensor_msgs::LaserScan>(frame, scan.stamp);
  msg.angle_min = static_cast<float>(scan.angle_min);
  msg.angle_max = static_cast<float>(scan.angle(scan.ranges.empty() ? 0 : scan.ranges.size() - 1));
  msg.angle_increment = static_cast<float>(scan.angle_increment);
  msg.range_min = static_cast<float>(scan.range_min);
  msg.range_max = static_cast<float>(scan.range_max);
  msg.time_increment = static_cast<float>(scan.time_increment);
  msg.scan_time = static_cast<float>(scan_time);
  msg.ranges = scan.ranges;
  return msg;
}

std::optional<OccupancyGrid> toOccupancyGrid(const nav_msgs::OccupancyGrid& msg, std::string* why) {
  const auto& info = msg.info;
  if (msg.data.empty()) return malformed(why, "map empty");
  if (msg.data.size() != area(info.width, info.height)) {
    return malformed(why, "number of cells does not match the map's size");
  }
  const auto geometry = toGridGeometry(info, why);
  if (!geometry) return std::nullopt;
  if (!validCells(msg.data)) return malformed(why, "cell value outside of -1...100");
  return OccupancyGrid(*geometry, msg.data);
}

std::optional<GridGeometry> toGridGeometry(const nav_msgs::MapMetaData& info, std::string* why) {
  if (const std::string problem = problemOf(info); !problem.empty()) return malformed(why, problem);
  const auto origin = toPose(info.origin, why);
  if (!origin) return std::nullopt;
  if (std::abs(origin->yaw) > 1e-6) return malformed(why, "map rotated");
  GridGeometry geometry;
  geometry.resolution = static_cast<double>(info.resolution);
  geometry.origin = origin->position();
  geometry.width = static_cast<int>(info.width);
  geometry.height = static_cast<int>(info.height);
  return geometry;
}

nav_msgs::MapMetaData toMapMetaDataMsg(const GridGeometry& geometry) {
  nav_msgs::MapMetaData msg;
  msg.resolution = static_cast<float>(geometry.resolution);
  msg.width = static_cast<std::uint32_t>(geometry.width);
  msg.height = static_cast<std::uint32_t>(geometry.height);
  msg.origin = toPoseMsg(Pose2(geometry.origin, 0.0));
  return msg;
}

nav_msgs::OccupancyGrid toOccupancyGridMsg(const OccupancyGrid& grid, const std::string& frame, Time stamp) {
  auto msg = stamped<nav_msgs::OccupancyGrid>(frame, stamp);
  msg.info = toMapMetaDataMsg(grid.geometry());
  msg.info.map_load_time = msg.header.stamp;
  msg.data = grid.cells();
  return msg;
}

std::optional<GridUpdate> toGridUpdate(const map_msgs::OccupancyGridUpdate& msg, std::string* why) {
  if (msg.data.empty()) return malformed(why, "update empty");
  if (msg.x < 0 || msg.y < 0) return malformed(why, "update begins outside of the map");
  if (msg.x + std::int64_t{msg.width} > bounds::kMostSide || msg.y + std::int64_t{msg.height} > bounds::kMostSide) {
    return malformed(why, "update reaches beyond any map");
  }
  if (msg.data.size() != area(msg.width, msg.height)) {
    return malformed(why, "number of cells does not match the update's size");
  }
  if (!validCells(msg.data)) return malformed(why, "cell value outside of -1...100");
  return GridUpdate{{msg.x, msg.y, static_cast<int>(msg.width), static_cast<int>(msg.height)}, msg.data};
}

map_msgs::OccupancyGridUpdate toGridUpdateMsg(const OccupancyGrid& grid, const CellRect& rect, const std::string& frame,
                                              Time stamp) {
  auto msg = stamped<map_msgs::OccupancyGridUpdate>(frame, stamp);
  msg.x = rect.x;
  msg.y = rect.y;
  msg.width = static_cast<std::uint32_t>(rect.width);
  msg.height = static_cast<std::uint32_t>(rect.height);
  msg.data.reserve(area(msg.width, msg.height));
  for (int y = rect.y; y < rect.y + rect.height; ++y) {
    msg.data.insert(msg.data.end(), grid.row(y) + rect.x, grid.row(y) + rect.x + rect.width);
  }
  return msg;
}

std::optional<std::vector<Pose2>> toPath(const nav_msgs::Path& msg, std::string* why) {
  if (msg.poses.size() > bounds::kMostPathPoses) return malformed(why, "too many poses");
  std::vector<Pose2> path;
  path.reserve(msg.poses.size());
  for (const auto& stamped_pose : msg.poses) {
    const auto pose = toPose(stamped_pose.pose, why);
    if (!pose) return std::nullopt;
    path.push_back(*pose);
  }
  return path;
}

nav_msgs::Path toPathMsg(const std::vector<Pose2>& path, const std::string& frame, Time stamp) {
  auto msg = stamped<nav_msgs::Path>(frame, stamp);
  msg.poses.reserve(path.size());
  for (const Pose2& pose : path) msg.poses.push_back(toPoseStampedMsg(pose, frame, stamp));
  return msg;
}

}  // namespace frontier_pilot
