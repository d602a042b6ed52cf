#pragma once

#include <frontier_pilot/ArbiterStatus.h>
#include <frontier_pilot/ExplorerStatus.h>
#include <frontier_pilot/SetBounds.h>
#include <geometry_msgs/PointStamped.h>
#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Odometry.h>
#include <ros/node_handle.h>
#include <sensor_msgs/BatteryState.h>
#include <std_msgs/Bool.h>
#include <std_msgs/String.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <optional>
#include <string>

#include "frontier_pilot/exploration/explorer.h"
#include "ros/common/diagnostics.h"
#include "ros/common/inputs/earlier_stops.h"
#include "ros/common/inputs/localization_input.h"
#include "ros/common/inputs/navigation_permission.h"
#include "ros/common/memory/safe_switch.h"
#include "ros/common/messages/mailbox.h"
#include "ros/common/messages/map_mirror.h"
#include "ros/common/node_connections.h"
#include "ros/common/tf/tf_bridge.h"
#include "ros/common/tuning/reconfigure_server.h"
#include "ros/frontier_explorer/clicked_polygon.h"
#include "ros/frontier_explorer/explorer_memory.h"
#include "ros/frontier_explorer/explorer_parameters.h"
#include "ros/frontier_explorer/map_at_end.h"
#include "ros/frontier_explorer/move_base_client.h"
#include "ros/frontier_explorer/team_claims.h"

namespace frontier_pilot {

/// The node `frontier_explorer`: takes map, odometry and TF, and sends goals to any `move_base`.
class FrontierExplorerAdapter {
 public:
  FrontierExplorerAdapter(ros::NodeHandle& node, ros::NodeHandle& private_node);
  /// Cancels the goal: otherwise the robot would go on driving to it without an explorer.
  void sayLastWords();

 private:
  /// What became of new bounds, in words.
  struct BoundsAnswer {
    bool taken = false;
    std::string message;
  };

  void handleOdometry(const nav_msgs::Odometry& msg);
  void handleBattery(const sensor_msgs::BatteryState& msg);
  void handleStop(const std_msgs::Bool& msg);
  void handleArbiter(const ArbiterStatus& msg);
  void handleClick(const geometry_msgs::PointStamped& msg);
  void handleInspect(const geometry_msgs::PoseStamped& msg);
  void handleReplaced(const std_msgs::String& msg);
  void leaveMap(const std::string& why);
  bool handleClearInspections(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool handleEnable(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);
  bool handleExplain(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool handleReset(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool handleSetBounds(SetBounds::Request& request, SetBounds::Response& response);
  bool handleClearBounds(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool handleReturnToStart(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);
  void addServices();
  /// Publishes markers and status in the next cycle.
  void tellAtOnce() { markers_due_ = true, last_status_.reset(); }
  void resume();
  void remember();
  void pause(const std::string& why);
  bool awaitsArbiter() const { return enabled_ && earlier_stops_.holdsBack(steadyNow()); }
  BoundsAnswer takeBounds(const exploration::ExplorationBounds& bounds);
  void closePolygon();
  void expireClicks();
  std::optional<Vec2> inMapFrame(const geometry_msgs::PointStamped& msg, std::string& why) const;
  void tick();
  bool waits();
  /// For the answer to a call whose effect the caller has to wait for; empty if it has taken effect.
  std::string fromWhen();
  std::string afterItsEnd();
  void update(Time now);
  exploration::ExplorerInputs gather(Time now);
  void obeyOrder(Time now);
  void publishStatus(const exploration::ExplorerProgress& status, Time now);
  void addLimits(ExplorerStatus& msg) const;
  void addInspections(ExplorerStatus& msg) const;
  void addFrontiers(ExplorerStatus& msg) const;
  std::optional<double> battery() const;
  bool missesBattery() const;
  void report(const exploration::ExplorerOutput& output) const;
  void showFrontiers(bool news, Time now);
  void saveMap(const exploration::ExplorerOutput& output);
  void watchClock();
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) const;

  ExplorerNodeParameters parameters_;
  std::string base_frame_;
  exploration::Explorer explorer_;
  MapMirror map_;
  LocalizationInput localization_;
  TfBridge tf_;
  TeamClaims team_;
  MoveBaseClient navigation_;
  MapAtEnd map_at_end_;
  NodeDiagnostics diagnostics_;
  StartGrace grace_;
  Rejections bad_odometry_{"odometry"};
  Rejections bad_clicks_{"clicked point"};
  Rejections bad_battery_{"battery state"};
  Rejections bad_inspections_{"pose to inspect"};
  ClickedPolygon clicked_;
  Latest<double> battery_;
  Latest<ArbiterStatus> arbiter_;
  NavigationPermission permission_;
  bool battery_in_percent_ = false;  ///< its driver sends percent, not shares
  exploration::ExplorerProgress status_;
  exploration::GoalCommand order_;  ///< that is not obeyed yet
  bool enabled_;
  bool stopped_ = false;  ///< by an emergency stop
  EarlierStops earlier_stops_;
  bool reset_ = false, start_ = false;  ///< asked for since the last tick
  bool markers_due_ = false;
  std::optional<Time> odometry_stamp_;
  std::optional<Time> last_status_;
  Time watched_clock_{};
  ros::Publisher status_publisher_;
  ros::Publisher markers_publisher_;
  ros::Publisher goal_publisher_;
  std::optional<SafeSwitch> paused_;
  std::optional<ExplorerMemory> memory_;
  std::optional<ReconfigureServer> tuning_;
  NodeConnections connections_;
};

}  // namespace frontier_pilot
