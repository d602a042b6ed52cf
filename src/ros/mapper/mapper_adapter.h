#pragma once

#include <frontier_pilot/LoadMap.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <nav_msgs/GetMap.h>
#include <nav_msgs/Odometry.h>
#include <ros/node_handle.h>
#include <sensor_msgs/LaserScan.h>
#include <std_srvs/Trigger.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/map_files/map_io.h"
#include "frontier_pilot/mapping/mapper.h"
#include "frontier_pilot/mapping/odometry_anchor.h"
#include "frontier_pilot/mapping/scan_pairing.h"
#include "ros/common/diagnostics.h"
#include "ros/common/names.h"
#include "ros/common/node_connections.h"
#include "ros/common/tf/tf_bridge.h"
#include "ros/mapper/map_autosave.h"
#include "ros/mapper/map_saver.h"
#include "ros/mapper/mapper_publisher.h"
#include "ros/mapper/worker.h"

namespace frontier_pilot {

struct MapperNodeParameters {
  std::string map_frame = names::kMapFrame;
  std::string odom_frame = names::kOdomFrame;
  std::string base_frame;        ///< empty: the robot's
  std::string map_file;          ///< loaded at the start; empty: none
  double autosave_period = 2.0;  ///< between two copies of the map for after a crash [s]; 0: none is kept
  double update_period = 0.2;    ///< between two `map_updates` [s]
  double tf_period = 0.05;       ///< between two `map -> odom` [s]
  double tf_lead = 0.1;          ///< `map -> odom` is dated this much ahead, so that it holds until the next one [s]
  double silence = 2.0;          ///< without a scan in the map for so long something is wrong [s]
  mapping::MapperParameters mapper;
  mapping::OdometryAnchorParameters odometry;
  mapping::ScanPairingParameters pairing;
  mapping::MapScheduleParameters publishing;

  template <class Visitor>
  void describe(Visitor& v) {
    describeRobot(v, mapper.robot);
    v.field("map_frame", map_frame, "", "frame of the map", FrameName::kGiven);
    v.field("odom_frame", odom_frame, "", "frame of odometry", FrameName::kGiven);
    v.field("base_frame", base_frame, "", "frame of the robot; empty: robot/base_frame", FrameName::kMayBeEmpty);
    v.field("map_file", map_file, "", "saved map to begin with; empty: begin with an empty map");
    v.field(
        "autosave_period", autosave_period, "s",
        "least time between two copies of the map for a mapper that is started again after it died; 0: none is kept",
        between(0.0, 3600.0));
    v.field("localize_only", mapper.localize_only, "",
            "leave the loaded map as it is, and only localise the robot in it");
    v.field("update_period", update_period, "s", "time between two map updates", tickPeriod());
    v.fixed({"tf_period"});
    v.field("tf_lead", tf_lead, "s", "time by which the stamp of map -> odom is ahead of the clock", timeSpanOrNone());
    v.field("silence", silence, "s", "without a scan in the map for so long something is wrong", timeSpan());
    v.group("mapper", mapper, "the mapper");
    v.group("odometry", odometry, "what odometry is believed");
    v.group("pairing", pairing, "how scans find their odometry");
    v.group("publishing", publishing, "when the whole map goes out");
  }
  void check(Problems& problems) const {
    if (autosave_period > 0.0 && autosave_period < 0.1) problems.push_back("autosave_period: must be 0 or >= 0.1");
  }
};

/// The mapper as a node: scans and odometry in, map and `map -> odom` out.
class MapperAdapter {
 public:
  MapperAdapter(ros::NodeHandle& node, ros::NodeHandle& private_node);
  ~MapperAdapter() { saver_.close(); }
  /// There is nothing to go on with after an end in order.
  void sayLastWords() { autosave_.forget(); }
  MapperAdapter(const MapperAdapter&) = delete;
  MapperAdapter& operator=(const MapperAdapter&) = delete;

 private:
  using Status = diagnostic_updater::DiagnosticStatusWrapper;
  struct TimedRevision {
    slam::MapRevision revision;
    double seconds;  ///< that they took
  };
  struct Restored {
    occupancy::OccupancyMap map;
    Pose2 T_map_odom;
  };

  void connect();
  void advertiseServices();
  void handleOdometry(const nav_msgs::Odometry& msg);
  void noteOdometryReset();
  void handleScan(const sensor_msgs::LaserScan& msg);
  /// The scan, or what is wrong with it.
  std::optional<LaserScan2> read(const sensor_msgs::LaserScan& msg);
  void insertPaired();
  /// Hands work to the worker and takes its results over.
  void startRevision();
  void takeOver(TimedRevision& done);
  void note(mapping::ScanVerdict verdict, const std::string& detail);
  void broadcast();
  /// The mapper is given odometry without its jumps.
  Pose2 T_map_odom() const { return mapper_.T_map_odom() * anchor_.T_smooth_odom(); }
  /// Throws a ConfigurationError when the map to begin with cannot be loaded.
  void loadFirstMap(const ros::NodeHandle& private_node);
  map_files::MapIoResult load(const std::string& path);
  /// Reads the map of a mapper that died in this session, if there is one.
  void restore();
  /// Goes on with it, as soon as it is known where odometry has the robot.
  void resume(const Pose2& T_odom_base);
  void autosave();
  void handleInitialPose(const geometry_msgs::PoseWithCovarianceStamped& msg);
  bool handleLoad(LoadMap::Request& request, LoadMap::Response& response);
  bool handleGet(nav_msgs::GetMap::Request& request, nav_msgs::GetMap::Response& response);
  bool handleReset(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  void report(Status& status) const;
  void reportOdometry(Status& status) const;
  void summarize(Status& status) const;

  MapperNodeParameters parameters_;
  std::string base_frame_;
  mapping::Mapper mapper_;
  mapping::OdometryAnchor anchor_;
  mapping::ScanPairing pairing_;
  TfBridge tf_;
  MapperPublisher publisher_;
  NodeDiagnostics diagnostics_;
  Rejections bad_scans_{"scan"};
  Rejections bad_odometry_{"odometry"};
  Rejections bad_initial_poses_{"initial pose"};
  std::optional<SteadyTime> odometry_reset_;  ///< when the last one was noticed
  std::optional<SteadyTime> last_inserted_;   ///< when the last scan was found good
  std::string revision_failure_;              ///< what ended the revisions, until a reset
  double revision_seconds_ = 0.0;             ///< what the last revision took
  std::shared_ptr<slam::MapRevision> old_;    ///< what the last ones replaced
  Worker<TimedRevision> worker_;
  MapSaver saver_;
  MapAutosave autosave_;
  std::optional<Restored> restored_;           ///< until it is gone on with
  Mailbox<std::vector<std::string>> session_;  ///< a new one of ROS, if the master is a new one
  NodeConnections connections_;
};

}  // namespace frontier_pilot
