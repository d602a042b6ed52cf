#pragma once

#include <geometry_msgs/PolygonStamped.h>
#include <geometry_msgs/Pose.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Transform.h>
#include <geometry_msgs/Twist.h>
#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>
#include <sensor_msgs/BatteryState.h>
#include <sensor_msgs/LaserScan.h>

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/core/motion.h"
#include "ros/common/clock.h"

/// Conversions between messages and core types. Malformed input becomes std::nullopt, and `why`, if given, says what is
/// wrong with it: missing data is never replaced by a default value. Numbers beyond the bounds of core/bounds.h, which
/// would cause too much memory or work, count as malformed. [FLT-1]
namespace frontier_pilot {

/// Nothing if a coordinate is not finite or out of bounds, or the quaternion is not of unit length. Height, roll and
/// pitch are dropped.
std::optional<Pose2> toPose(const geometry_msgs::Pose& msg, std::string* why = nullptr);
std::optional<Pose2> toPose(const geometry_msgs::Transform& msg, std::string* why = nullptr);
/// The same in three dimensions.
std::optional<Eigen::Isometry3d> toIsometry(const geometry_msgs::Transform& msg, std::string* why = nullptr);
geometry_msgs::Pose toPoseMsg(const Pose2& pose);
geometry_msgs::Transform toTransformMsg(const Pose2& pose);
geometry_msgs::PoseStamped toPoseStampedMsg(const Pose2& pose, const std::string& frame, Time stamp);
geometry_msgs::PolygonStamped toPolygonStampedMsg(const std::vector<Vec2>& corners, const std::string& frame,
                                                  Time stamp);

/// Nothing if any of the six fields is not finite. The axes that a differential drive lacks are dropped. [ARB-5]
std::optional<Twist2> toTwist(const geometry_msgs::Twist& msg, std::string* why = nullptr);
geometry_msgs::Twist toTwistMsg(const Twist2& twist);

/// Nothing if its pose or its twist is malformed.
std::optional<MotionSample> toOdometry(const nav_msgs::Odometry& msg, std::string* why = nullptr);
nav_msgs::Odometry toOdometryMsg(const MotionSample& odometry, const std::string& frame,
                                 const std::string& child_frame);

/// The charge as a share. Drivers disagree about `percentage`: values up to 1.5 are taken as shares (that of a
/// TurtleBot3 is its voltage divided by 11.1 V, which exceeds 1 when it is charged), larger ones up to 100 as percent.
/// After the first of these `in_percent` is true, and then all values are taken as percent: an empty battery's 1.0 is
/// not a full one's. Nothing if it is unmeasured (NaN) or beyond that.
std::optional<double> toCharge(const sensor_msgs::BatteryState& msg, bool& in_percent, std::string* why = nullptr);

/// Nothing if it is empty, an angle or range limit is not finite or out of bounds, the increment is zero, the number of
/// ranges does not match the angles, or the scanner is tilted (its z axis more than 10 degrees off the base's).
/// `T_base_sensor` is the scanner's mount in three dimensions: if it is upside down, the angles are negated.
/// `time_increment` is taken as the driver gives it, which may be wrong or no number: see BeamTiming.
std::optional<LaserScan2> toLaserScan(const sensor_msgs::LaserScan& msg, const Eigen::Isometry3d& T_base_sensor,
                                      std::string* why = nullptr);
/// `scan_time` [s] is the time between two scans.
sensor_msgs::LaserScan toLaserScanMsg(const LaserScan2& scan, const std::string& frame, double scan_time);

/// Nothing if the size or the resolution is out of bounds, or the origin is not finite or is rotated.
std::optional<GridGeometry> toGridGeometry(const nav_msgs::MapMetaData& info, std::string* why = nullptr);
nav_msgs::MapMetaData toMapMetaDataMsg(const GridGeometry& geometry);

/// Nothing if the number of cells does not match the size, the size or the resolution is out of bounds, the origin is
/// not finite or is rotated, or a value lies outside of -1...100.
std::optional<OccupancyGrid> toOccupancyGrid(const nav_msgs::OccupancyGrid& msg, std::string* why = nullptr);
nav_msgs::OccupancyGrid toOccupancyGridMsg(const OccupancyGrid& grid, const std::string& frame, Time stamp);

/// New values of a block of cells.
struct GridUpdate {
  CellRect rect;
  std::vector<std::int8_t> cells;  ///< row by row
};

/// Nothing if it is empty, begins at a negative cell, the number of cells does not match the size, or a value lies
/// outside of -1...100. The caller has to check whether it lies inside of the map.
std::optional<GridUpdate> toGridUpdate(const map_msgs::OccupancyGridUpdate& msg, std::string* why = nullptr);
/// The cells of `grid` in `rect`, which must lie inside.
map_msgs::OccupancyGridUpdate toGridUpdateMsg(const OccupancyGrid& grid, const CellRect& rect, const std::string& frame,
                                              Time stamp);

/// Nothing if any pose is malformed. An empty path is valid.
std::optional<std::vector<Pose2>> toPath(const nav_msgs::Path& msg, std::string* why = nullptr);
nav_msgs::Path toPathMsg(const std::vector<Pose2>& path, const std::string& frame, Time stamp);

}  // namespace frontier_pilot
