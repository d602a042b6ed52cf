#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/core/robot_model.h"

/// What a running robot looks like from outside, and what is wrong with it. No ROS: an observation is plain data.
namespace frontier_pilot::robot_check {

/// A topic as the master knows it. Names are resolved.
struct Topic {
  std::string name;
  std::string type;                      ///< "sensor_msgs/LaserScan"
  std::vector<std::string> publishers;   ///< nodes
  std::vector<std::string> subscribers;  ///< nodes
};

/// What arrived on one topic, or as one transform, during the observation.
struct Stream {
  std::size_t count = 0;
  double rate = 0.0;                    ///< [Hz]
  std::vector<std::string> publishers;  ///< nodes that sent a message
  std::vector<std::string> frames;      ///< the different `frame_id`s
  std::optional<double> lag;            ///< median of the time of arrival minus the stamp [s]; none without a clock
  bool stamps_advance = true;           ///< false: every message had the same stamp
  std::string problem;                  ///< why the last message that cannot be used cannot be; empty: there was none
};

struct ScanStream : Stream {
  double usable_share = 1.0;       ///< of the beams of the last scan
  std::size_t beams = 0;           ///< of the last scan
  double angle_increment = 0.0;    ///< between two beams of the last scan [rad]
  double time_increment = 0.0;     ///< between two beams, as the last scan says [s]
  std::optional<LaserScan2> last;  ///< in the scanner's own frame; none if no scan could be used
};

/// A transform that somebody publishes.
struct FrameLink {
  std::string parent, child;
  Eigen::Isometry3d T_parent_child = Eigen::Isometry3d::Identity();  ///< the latest
  bool is_static = false;
  Stream stream;
};

struct Observation {
  double seconds = 0.0;  ///< how long it took [s]
  bool use_sim_time = false;
  bool clock_moves = false;  ///< whether /clock was seen to advance
  std::vector<Topic> topics;
  std::map<std::string, std::string> providers;  ///< node by service
  std::vector<FrameLink> links;
  std::vector<FrameLink> useless_links;  ///< no transform of these could be used: for the nodes they do not exist
  ScanStream scan;
  Stream odometry;
};

/// The names that the nodes use, resolved, and the robot that they were told of.
struct Expectation {
  std::string scan = "/scan";
  std::string odom = "/odom";
  std::string cmd_vel = "/cmd_vel";
  /// The topics on which our own nodes give velocities to the arbiter; a remapped cmd_vel leaves them as they are.
  std::vector<std::string> sources = {"/cmd_vel_avoid", "/cmd_vel_behavior", "/cmd_vel_patrol", "/cmd_vel_nav",
                                      "/cmd_vel_manual"};
  std::string manual = "/cmd_vel_manual";  ///< the one of them for whoever drives by hand
  std::string arbiter_status = "/cmd_vel_arbiter/status";
  std::string map = "/map";
  std::string save_map = "/mapper/save_map";  ///< the service by which our own mapper is recognised
  std::string map_frame = "map";
  RobotModel robot;  ///< with its base frame and frame of odometry
};

}  // namespace frontier_pilot::robot_check
