#include <geometry_msgs/PoseStamped.h>

#include <algorithm>

#include "ros/common/clock.h"
#include "ros/common/messages/conversions.h"
#include "ros/common/parameters.h"
#include "ros/common/tf/odometry_source.h"
#include "ros/frontier_explorer/explorer_status.h"
#include "ros/frontier_explorer/frontier_explorer_adapter.h"

namespace frontier_pilot {

FrontierExplorerAdapter::FrontierExplorerAdapter(ros::NodeHandle& node, ros::NodeHandle& private_node)
    : parameters_(loadNodeParameters<ExplorerNodeParameters>(private_node)),
      base_frame_(parameters_.explorer.robot.baseFrameOr(parameters_.base_frame)),
      explorer_(parameters_.explorer),
      team_(parameters_.fleet, parameters_.map_frame, tf_),
      navigation_(node),
      map_at_end_(node, parameters_.save_map_at_end, parameters_.fleet.name),
      diagnostics_(node, private_node),
      enabled_(parameters_.autostart),
      connections_(node) {
  resume();
  diagnostics_.add("exploration", [this](auto& status) { diagnose(status); });
  diagnostics_.add("connections", [this](auto& status) { connections_.report(status); });
  diagnostics_.add("memory", [this](auto& status) { connections_.memory().report(status); });
  team_.connect(connections_, node, diagnostics_);
  map_.subscribe(connections_, parameters_.map_frame);
  followOdometry(connections_, tf_, parameters_.explorer.robot, base_frame_, 20,
                 &FrontierExplorerAdapter::handleOdometry, this);
  connections_.needPoseIn(parameters_.map_frame, "map_frame", tf_, base_frame_);
  localization_.subscribe(connections_);
  connections_.inputs().need([this](const auto&) {
    return navigation_.available() ? "" : std::string("no move_base: start navigation.launch, or another navigation");
  });
  connections_.followStop(&FrontierExplorerAdapter::handleStop, this);
  connections_.subscribe(names::kArbiterStatus, 1, &FrontierExplorerAdapter::handleArbiter, this);
  connections_.subscribe(names::kBatteryState, 1, &FrontierExplorerAdapter::handleBattery, this);
  connections_.subscribeToCommands(names::kClickedPoint, 20, &FrontierExplorerAdapter::handleClick, this);
  connections_.subscribeToCommands(names::kInspect, 20, &FrontierExplorerAdapter::handleInspect, this);
  connections_.subscribe(names::kMapReplaced, 1, &FrontierExplorerAdapter::handleReplaced, this);
  status_publisher_ = node.advertise<ExplorerStatus>(names::kExplorerStatus, 20, true);
  markers_publisher_ = node.advertise<visualization_msgs::MarkerArray>(names::kFrontiers, 1, true);
  goal_publisher_ = node.advertise<geometry_msgs::PoseStamped>(names::kExplorerGoal, 5, true);
  addServices();
  connections_.every(ros::Duration(1.0 / parameters_.rate), [this] { tick(); });
  connections_.everySteady(ros::WallDuration(parameters_.explorer.report_period), [this] { watchClock(); });
  connections_.clock().onJump([this] { odometry_stamp_ = last_status_ = std::nullopt; });
}

void FrontierExplorerAdapter::handleOdometry(const nav_msgs::Odometry& msg) {
  std::string why;
  const auto odometry = toOdometry(msg, &why);
  if (!odometry) return bad_odometry_.add(why);
  odometry_stamp_ = std::min(odometry->stamp, rosNow());  // a stamp ahead of the clock would keep it fresh for as long
}

/// After a hold-up the explorer first reads what came meanwhile, such as a stop; but a pause takes effect at once.
void FrontierExplorerAdapter::tick() {
  const auto now = connections_.clock().now();
  if (now && !waits()) update(*now);
}

bool FrontierExplorerAdapter::waits() { return enabled_ && connections_.clock().isCatchingUp(); }

std::string FrontierExplorerAdapter::fromWhen() {
  return waits() ? "; this takes effect in less than a second, because the explorer was held up" : "";
}

void FrontierExplorerAdapter::update(Time now) {
  // A goal that waited goes first: this decision may take as long as the one before. But not over somebody else's goal.
  if (enabled_ && !navigation_.servesOthers()) obeyOrder(now);
  expireClicks();
  const CellRect changed = map_.takeChanged();
  if (map_.ready() && !changed.empty()) explorer_.setMap(map_.map(), changed);
  if (map_.takeReplaced()) leaveMap("the map of another node has replaced theirs");
  const exploration::ExplorerInputs inputs = gather(now);
  const exploration::ExplorerOutput output = explorer_.update(inputs, now);
  team_.tell(inputs.T_map_base, explorer_.claims(), now);
  status_ = output.status;
  remember();
  saveMap(output);
  if (output.command.kind != exploration::GoalCommand::Kind::kNone) order_ = output.command;
  obeyOrder(now);
  report(output);
  for (const exploration::ExplorerProgress& transition : output.transitions) publishStatus(transition, now);
  if (!last_status_ || now - *last_status_ >= std::chrono::seconds(1)) publishStatus(status_, now);
  showFrontiers(output.frontiers_judged, now);
}

void FrontierExplorerAdapter::saveMap(const exploration::ExplorerOutput& output) {
  const auto done = [](const exploration::ExplorerProgress& p) { return p.state == exploration::ExplorerState::kDone; };
  const bool ended = std::any_of(output.transitions.begin(), output.transitions.end(), done);
  if (map_at_end_.update(ended, done(status_), steadyNow())) last_status_.reset();
}

exploration::ExplorerInputs FrontierExplorerAdapter::gather(Time now) {
  exploration::ExplorerInputs inputs;
  inputs.enabled = enabled_ && !awaitsArbiter();
  inputs.stopped = stopped_;
  inputs.reset = std::exchange(reset_, false);
  inputs.start = std::exchange(start_, false);
  inputs.map_available = map_.ready() && map_.published();
  inputs.navigation_available = navigation_.available();
  inputs.navigation_refused = permission_.refusal(now, steadyNow());
  inputs.others_goal = navigation_.servesOthers();
  inputs.odometry_stamp = odometry_stamp_;
  inputs.battery = battery();
  inputs.goal_events = navigation_.takeEvents();
  inputs.others = team_.others(now);
  if (const auto stamp = tf_.latestStamp(parameters_.map_frame, base_frame_)) {
    // A chain of static transforms alone has no stamp: it holds now.
    const Time when = *stamp == Time{} ? now : *stamp;
    const auto pose = tf_.lookup(parameters_.map_frame, base_frame_, *stamp);
    if (pose) inputs.T_map_base = StampedPose2{when, *pose};
  }
  inputs.localized = localization_.isLocalizedAt(inputs.T_map_base);
  return inputs;
}

/// A stop may have come, and its clear, while a decision took long or the process was held up in it: a goal waits until
/// they would have been read, and each of them drops it. [ARB-8]
void FrontierExplorerAdapter::obeyOrder(Time now) {
  using Kind = exploration::GoalCommand::Kind;
  connections_.clock().now();  // notices a hold-up
  if (order_.kind == Kind::kSend && waits()) return;
  const exploration::GoalCommand order = std::exchange(order_, {});
  if (order.kind == Kind::kCancel) navigation_.cancel();
  if (order.kind != Kind::kSend) return;
  navigation_.send(order.goal_id, order.goal, parameters_.map_frame, now);
  goal_publisher_.publish(toPoseStampedMsg(order.goal, parameters_.map_frame, now));
}

void FrontierExplorerAdapter::publishStatus(const exploration::ExplorerProgress& status, Time now) {
  ExplorerStatus msg = toStatusMsg(status, parameters_.map_frame, now);
  addLimits(msg);
  addInspections(msg);
  addFrontiers(msg);
  const std::string& missing = connections_.inputs().missing();
  if (status.state == exploration::ExplorerState::kIdle && !missing.empty()) msg.reason_text += " (" + missing + ")";
  status_publisher_.publish(msg);
  last_status_ = now;
}

}  // namespace frontier_pilot
