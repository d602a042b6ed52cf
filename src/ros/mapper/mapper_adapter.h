#pragma once

#include <frontier_pilot/LoadMap.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <nav_msgs/GetMap.h>
#include <nav_msgs/Odometry.h>
#include <ros/node_handle.h>
#include <sensor_msgs/LaserScan.h>
#include <std_srvs/Trigger.h>

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/map_files/map_io.h"
#include "frontier_pilot/mapping/mapper.h"
#include "frontier_pilot/mapping/odometry_anchor.h"
#include "frontier_pilot/mapping/scan_pairing.h"
#include "ros/common/diagnostics.h"
#include "ros/common/messages/scan_motion_report.h"
#include "ros/common/node_connections.h"
#include "ros/common/tf/tf_bridge.h"
#include "ros/common/threads/worker.h"
#include "ros/mapper/map_autosave.h"
#include "ros/mapper/map_saver.h"
#include "ros/mapper/map_searcher.h"
#include "ros/mapper/mapper_parameters.h"
#include "ros/mapper/mapper_publisher.h"

namespace frontier_pilot {

/// The node `mapper`: takes scans and odometry, and publishes the map and `map -> odom`.
class MapperAdapter {
 public:
  MapperAdapter(ros::NodeHandle& node, ros::NodeHandle& private_node);
  ~MapperAdapter() { saver_.close(), searcher_.close(); }
  /// Removes the copy of the map: a mapper started after a regular shutdown begins with a new map. It stays if the
  /// mapper did not continue with it, or ends because another process has its name; it is put aside if the map could
  /// not be saved when it was last to be.
  void sayLastWords();
  MapperAdapter(const MapperAdapter&) = delete;
  MapperAdapter& operator=(const MapperAdapter&) = delete;

 private:
  using Status = diagnostic_updater::DiagnosticStatusWrapper;
  struct TimedRevision {
    slam::MapRevision revision;
    double seconds;  ///< that computing it took [s]
  };
  struct Restored {
    occupancy::OccupancyMap map;
    MapPose pose;
  };

  void connect();
  void advertiseServices();
  void handleOdometry(const nav_msgs::Odometry& msg);
  void noteOdometryReset();
  void handleScan(const sensor_msgs::LaserScan& msg);
  std::optional<LaserScan2> read(const sensor_msgs::LaserScan& msg);
  void insertPaired();
  /// Takes over the worker's result, and gives it new work if it is idle.
  void startRevision();
  void takeOver(TimedRevision& done);
  void note(mapping::ScanVerdict verdict, const std::string& detail);
  void publishIfLost();
  void broadcast();
  /// With respect to the odometry as published: the mapper's own `odom` is odometry without its jumps.
  Pose2 T_map_odom() const { return mapper_.T_map_odom() * anchor_.T_smooth_odom(); }
  /// Loads `map_file`, if given; throws a ConfigurationError if it cannot be loaded.
  void loadFirstMap(const ros::NodeHandle& private_node);
  map_files::MapIoResult load(const std::string& path);
  std::string keepLoaded();
  /// The text to append to the answer of a call whose effect would not survive this node, which is logged.
  static std::string afterDeath(const std::string& what, const std::string& problem);
  /// Reads the map of a mapper that died in this session, if there is one.
  void restore();
  void putAside(const std::string& other_map_file);
  void resume(const Pose2& T_odom_base);
  void autosave();
  bool leaveUnsaved();
  void rememberPose();
  void awaitAutosave(Duration patience = std::chrono::seconds(5));
  void sayWhereLocalised(mapping::ScanVerdict verdict, const Pose2& T_map_base);
  void handleInitialPose(const geometry_msgs::PoseWithCovarianceStamped& msg);
  bool handleLoad(LoadMap::Request& request, LoadMap::Response& response);
  bool handleGet(nav_msgs::GetMap::Request& request, nav_msgs::GetMap::Response& response);
  bool handleReset(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  void report(Status& status) const;
  void reportOdometry(Status& status) const;
  void summarize(Status& status) const;

  MapperNodeParameters parameters_;
  std::string base_frame_, odom_frame_;
  mapping::Mapper mapper_;
  mapping::OdometryAnchor anchor_;
  mapping::ScanPairing pairing_;
  TfBridge tf_;
  MapperPublisher publisher_;
  NodeDiagnostics diagnostics_;
  Rejections bad_scans_{"scan"}, bad_odometry_{"odometry"}, bad_initial_poses_{"initial pose"};
  BeamTiming timing_{parameters_.mapper.robot.scanner};
  ScanMotionReport scan_motion_;
  std::optional<SteadyTime> odometry_reset_, last_inserted_;  ///< when it was reset, when a scan was accepted last
  std::string revision_failure_;                              ///< the exception that ended loop closing last
  double revision_seconds_ = 0.0;                             ///< how long the last revision took [s]
  std::shared_ptr<slam::MapRevision> old_;  ///< the map that the last revision replaced, to be freed by the worker
  Worker<TimedRevision> worker_;
  MapSaver saver_;
  MapSearcher searcher_;
  MapAutosave autosave_{parameters_.map_file};
  std::string warned_of_;                      ///< why the map would not survive, as the log was told last
  bool looked_for_ = false;                    ///< whether the robot is to be found on a known map
  std::optional<Restored> restored_;           ///< until resume() has taken it over
  Mailbox<std::vector<std::string>> session_;  ///< names of the new ROS session after a restart of the master
  NodeConnections connections_;
};

}  // namespace frontier_pilot
