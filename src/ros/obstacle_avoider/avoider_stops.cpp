#include "ros/common/messages/conversions.h"
#include "ros/common/names.h"
#include "ros/obstacle_avoider/obstacle_avoider_adapter.h"

/// What an emergency stop means to the avoider.
namespace frontier_pilot {
namespace {

constexpr Duration kForArbiter = std::chrono::seconds(1);  ///< for which one that begins waits for its status

constexpr const char* kWasStopped = "waits until the robot is driven, because it was stopped";
constexpr const char* kAsks = "waits for the arbiter to say whether the robot was stopped";

}  // namespace

/// A clear moves nothing: a recovery ends with the stop, and none begins before another source drives the robot. One
/// that begins, perhaps in the place of one that ended while the robot was stopped, asks the arbiter whether it ever
/// was. [ARB-8] [FLT-2]
void ObstacleAvoiderAdapter::followStops() {
  earlier_stops_.ask(0, kForArbiter, steadyNow());
  updateRest();
  connections_.followStop(&ObstacleAvoiderAdapter::handleStop, this);
  connections_.subscribe(names::kArbiterStatus, 1, &ObstacleAvoiderAdapter::handleArbiter, this);
  connections_.subscribe(names::kCmdVel, 1, &ObstacleAvoiderAdapter::handleCommand, this,
                         ros::TransportHints().tcpNoDelay());
  connections_.everySteady(ros::WallDuration(0.1), [this] { updateRest(); });
}

void ObstacleAvoiderAdapter::handleStop(const std_msgs::Bool& msg) {
  earlier_stops_.hear();
  stopped_ = msg.data != 0;
  was_stopped_ = was_stopped_ || stopped_;
  updateRest();
}

void ObstacleAvoiderAdapter::handleArbiter(const ArbiterStatus& msg) {
  was_stopped_ = earlier_stops_.take(msg.stops).value_or(false) || was_stopped_;
  updateRest();
}

/// While the avoider rests it is another source that moves the robot.
void ObstacleAvoiderAdapter::handleCommand(const geometry_msgs::Twist& msg) {
  const std::optional<Twist2> command = toTwist(msg);
  if (whyRest().empty() || stopped_ || !command || command->isZero()) return;
  was_stopped_ = false;
  earlier_stops_.dismiss();
  updateRest();
}

std::string ObstacleAvoiderAdapter::whyRest() const {
  if (was_stopped_) return kWasStopped;
  return earlier_stops_.holdsBack(steadyNow()) ? kAsks : "";
}

void ObstacleAvoiderAdapter::updateRest() { publish(avoider_.setResting(whyRest(), rosNow())); }

}  // namespace frontier_pilot
