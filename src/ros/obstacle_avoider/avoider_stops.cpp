#include "ros/common/messages/conversions.h"
#include "ros/common/names.h"
#include "ros/obstacle_avoider/obstacle_avoider_adapter.h"

/// What an emergency stop means to the avoider.
namespace frontier_pilot {
namespace {

constexpr Duration kForArbiter = std::chrono::seconds(1);  ///< for which one that begins waits for its status

}  // namespace

/// A clear moves nothing: a recovery ends with the stop, and none begins before another source drives the robot. One
/// that begins, perhaps in the place of one that ended while the robot was stopped, asks the arbiter whether it ever
/// was. [ARB-8] [FLT-2]
void ObstacleAvoiderAdapter::followStops() {
  avoider_.setResting(true, rosNow());
  asks_since_ = steadyNow();
  connections_.followStop(&ObstacleAvoiderAdapter::handleStop, this);
  connections_.subscribe(names::kArbiterStatus, 1, &ObstacleAvoiderAdapter::handleArbiter, this);
  connections_.subscribe(names::kCmdVel, 1, &ObstacleAvoiderAdapter::handleCommand, this,
                         ros::TransportHints().tcpNoDelay());
  connections_.everySteady(ros::WallDuration(0.1), [this] { wakeWithoutArbiter(); });
}

void ObstacleAvoiderAdapter::handleStop(const std_msgs::Bool& msg) {
  stopped_ = msg.data != 0;
  if (!stopped_) return;
  asks_since_.reset();
  publish(avoider_.setResting(true, rosNow()));
}

void ObstacleAvoiderAdapter::handleArbiter(const ArbiterStatus& msg) {
  if (!asks_since_) return;
  asks_since_.reset();
  if (msg.stops == 0 && !stopped_) publish(avoider_.setResting(false, rosNow()));
}

void ObstacleAvoiderAdapter::wakeWithoutArbiter() {
  if (!asks_since_ || steadyNow() - *asks_since_ < kForArbiter) return;
  asks_since_.reset();
  publish(avoider_.setResting(false, rosNow()));
}

/// While the avoider rests it is another source that moves the robot.
void ObstacleAvoiderAdapter::handleCommand(const geometry_msgs::Twist& msg) {
  const std::optional<Twist2> command = toTwist(msg);
  if (!stopped_ && avoider_.rests() && command && !command->isZero()) publish(avoider_.setResting(false, rosNow()));
}

}  // namespace frontier_pilot
