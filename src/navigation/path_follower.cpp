#include "navigation/path_follower.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace frontier_pilot::navigation {
namespace {

constexpr double kStep = 0.05;            ///< of a trial [s]
constexpr double kSpeedMargin = 0.08;     ///< extra clearance at speed, because measurements are late [m per m/s]
constexpr double kNarrowSpeed = 0.12;     ///< without extra clearance: narrow places are driven slowly [m/s]
constexpr double kMinGap = 0.004;         ///< least gap between a disc and scan points [m]
constexpr double kMinSideGap = 0.01;      ///< and a straight side, which is close to many noisy points [m]
constexpr double kMapSlack = 0.02;        ///< a follower may be this much nearer to walls than a path [m]
constexpr double kLongestBraking = 10.0;  ///< [s]
constexpr double kCreep = 0.02;           ///< speed at the end of a path [m/s]
constexpr double kBehind = 2.6;           ///< beyond this bearing a target is neither left nor right [rad]
constexpr double kContactPenalty = 0.2;   ///< [m of progress]
constexpr double kDeviationWeight = 0.5;  ///< [m of progress per m off the path]
constexpr double kTouchShare = 0.5;       ///< of the scan's margin that is given up before it counts as a contact
constexpr double kGoodEnough = 0.9;       ///< share of full-speed progress; then no other variant is tried

}  // namespace

double stoppableRate(double angle, const RobotLimits& limits) {
  const double rate = std::sqrt(2.0 * 0.8 * limits.max_angular_acc * std::abs(angle));
  return std::copysign(std::min(rate, limits.max_angular), angle);
}

double PathFollower::Trial::score() const { return progress - kDeviationWeight * deviation; }

PathFollower::PathFollower(const FollowerParams& params, const RobotModel& robot)
    : params_(params),
      limits_(robot.limits),
      outline_(robot.drivenOutline()),
      outline_on_map_(planning::OutlineCheck(outline_).inTightPlaces()),
      radius_(outline_.isDisc() ? outline_.inscribedRadius() : 0.0) {}

bool PathFollower::Vicinity::isFree(const Pose2& pose, double speed) const {
  if (least_clearance > 0.0 && map.clearance(pose.position()) < least_clearance) return false;
  if (corners_count && !follower.outline_on_map_.fits(map, pose, kMapSlack)) return false;
  const auto more = static_cast<float>(kSpeedMargin * std::max(0.0, speed - kNarrowSpeed));
  return isFreeOfPoints(pose, more);
}

bool PathFollower::Vicinity::isDiscFreeOfPoints(const Vec2& position, float more) const {
  const auto x = static_cast<float>(position.x());
  const auto y = static_cast<float>(position.y());
  bool touched = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float dx = points.x[i] - x;
    const float dy = points.y[i] - y;
    const float least = least_distances[i] + more;
    touched |= dx * dx + dy * dy < least * least;
  }
  return !touched;
}

bool PathFollower::Vicinity::isFreeOfPoints(const Pose2& pose, float more) const {
  return follower.outline_.isDisc() ? isDiscFreeOfPoints(pose.position(), more) : isOutlineFreeOfPoints(pose, more);
}

bool PathFollower::Vicinity::isOutlineFreeOfPoints(const Pose2& pose, float more) const {
  const auto x = static_cast<float>(pose.x);
  const auto y = static_cast<float>(pose.y);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float least = least_distances[i] + more;
    const float reach = least + static_cast<float>(follower.outline_.circumscribedRadius());
    const float dx = points.x[i] - x;
    const float dy = points.y[i] - y;
    if (dx * dx + dy * dy >= reach * reach) continue;
    const Vec2 point(static_cast<double>(points.x[i]), static_cast<double>(points.y[i]));
    if (follower.distanceTo(point, pose) < static_cast<double>(least)) return false;
  }
  return true;
}

void PathFollower::setPath(planning::Path path) {
  path_ = std::move(path);
  progress_ = 0.0;
}

double PathFollower::distanceTo(const Vec2& point, const Pose2& pose) const {
  return outline_.isDisc() ? (point - pose.position()).norm() : outline_.distance(pose.inverse() * point);
}

PathFollower::Vicinity PathFollower::vicinity(const FollowerInputs& inputs) const {
  const Pose2& pose = inputs.T_map_base;
  const double braking = limits_.max_linear / (2.0 * limits_.max_linear_acc);  // in time at full speed [s]
  const double farthest = limits_.max_linear * std::max(params_.horizon, params_.command_lifetime + kStep + braking);
  const double reach = farthest + outline_.circumscribedRadius() + params_.scan_margin + 0.1;
  Vicinity around{inputs.scan.near(pose.position(), reach),         inputs.map, *this, {}, 0.0, false,
                  NeighbourCheck(inputs.neighbours, pose, outline_)};
  around.least_distances.reserve(around.points.size());
  for (std::size_t i = 0; i < around.points.size(); ++i) {
    const Vec2 point(static_cast<double>(around.points.x[i]), static_cast<double>(around.points.y[i]));
    around.least_distances.push_back(static_cast<float>(leastDistance(distanceTo(point, pose))));
  }
  // Inside the map's inflation only the scan is checked, for the map would not let the robot out.
  const double needed = inputs.map.leastClearance() - kMapSlack;
  if (inputs.map.clearance(pose.position()) >= needed) around.least_clearance = needed;
  around.corners_count = !outline_on_map_.isTrivial() && outline_on_map_.fits(inputs.map, pose, kMapSlack);
  return around;
}

double PathFollower::leastDistance(double now) const {
  const double least = radius_ + params_.scan_margin;
  if (now >= least) return least;
  // Too near already: come no nearer. Because measurements are noisy, without a floor the robot would creep into the
  // wall.
  const double floor = outline_.isDisc() ? radius_ + kMinGap : kMinSideGap;
  constexpr double kRounding = 1e-4;  // of the distances compared with it
  return now < floor ? now - kRounding : std::max(floor, now - 0.002);
}

double PathFollower::turnRate(double angle, const Twist2& twist) const {
  // If the target is straight behind, noise would decide between left and right: keep turning as begun.
  const bool undecided = std::abs(angle) > kBehind && std::abs(twist.angular) > 0.1;
  return stoppableRate(undecided ? std::copysign(angle, twist.angular) : angle, limits_);
}

Twist2 PathFollower::pursue(const Policy& policy, const Pose2& pose, const Twist2& twist, double along) const {
  const Vec2 ahead = pose.inverse() * path_.at(along + policy.lookahead);
  const double angle = bearing(ahead);
  const double distance = std::max(ahead.norm(), 1e-3);
  if (std::abs(angle) > policy.turn_angle) return {0.0, turnRate(angle, twist)};
  const double curvature = 2.0 * std::sin(angle) / distance;
  const double left = path_.length() - along;
  double speed = std::min(policy.speed, kCreep + std::sqrt(limits_.max_linear_acc * std::max(0.0, left)));
  if (std::abs(curvature) * speed > limits_.max_angular) speed = limits_.max_angular / std::abs(curvature);
  return {speed, speed * curvature};
}

PathFollower::Trial PathFollower::tryOut(const Policy& policy, const FollowerInputs& inputs,
                                         const Vicinity& around) const {
  Trial trial;
  Pose2 pose = inputs.T_map_base;
  Twist2 twist = inputs.twist;
  double along = progress_;
  const int steps = static_cast<int>(std::ceil(params_.horizon / kStep));
  trial.points.reserve(static_cast<std::size_t>(steps));
  for (int i = 0; i < steps; ++i) {
    const Twist2 command = pursue(policy, pose, twist, along);
    if (i == 0) trial.command = command;
    twist = limitAcceleration(command, twist, limits_, kStep);
    pose = integrate(pose, twist, kStep);
    if (!around.isFree(pose, std::abs(twist.linear))) break;
    if (!around.neighbours.isFree(pose.position(), (i + 1) * kStep)) break;
    along = path_.project(pose.position(), along, along + 0.3);
    trial.free_time += kStep;
    trial.points.push_back(pose.position());
  }
  trial.progress = along - progress_;
  trial.deviation = (path_.at(along) - pose.position()).norm();
  if (trial.free_time < params_.horizon - kStep) trial.progress -= kContactPenalty;
  return trial;
}

bool PathFollower::isSafe(const Trial& trial, const FollowerInputs& inputs, const Vicinity& around) const {
  if (!canBeTheLast(trial.command, inputs, around)) return false;
  // The next data are assumed to be as old as these.
  const double reaction = params_.reaction_time + inputs.age;
  if (!outline_.isDisc()) return canStop(trial.command, reaction, inputs, around);
  // A disc sweeps no new ground when it turns on the spot.
  if (trial.command.linear == 0.0 && inputs.twist.linear < kCreep) return true;
  const double speed = std::max(inputs.twist.linear, trial.command.linear);
  if (trial.free_time < reaction + speed / limits_.max_linear_acc) return false;
  return staysOnItsSide(trial.command, reaction, inputs, around);
}

bool PathFollower::canStop(const Twist2& command, double reaction, const FollowerInputs& inputs,
                           const Vicinity& around) const {
  return stopsWhere(
      [&](const Pose2& pose, const Twist2& twist, double t) {
        return around.isFree(pose, std::abs(twist.linear)) && around.neighbours.isFree(pose.position(), t) &&
               around.neighbours.isOnOwnSide(pose);
      },
      command, reaction, inputs);
}

bool PathFollower::staysOnItsSide(const Twist2& command, double reaction, const FollowerInputs& inputs,
                                  const Vicinity& around) const {
  if (!around.neighbours.seesSomething()) return true;
  return stopsWhere([&](const Pose2& pose, const Twist2&, double) { return around.neighbours.isOnOwnSide(pose); },
                    command, reaction, inputs);
}

bool PathFollower::canBeTheLast(const Twist2& command, const FollowerInputs& inputs, const Vicinity& around) const {
  if (command.linear == 0.0 && inputs.twist.linear < kCreep) return true;
  const auto less = static_cast<float>(-kTouchShare * params_.scan_margin);
  return stopsWhere([&](const Pose2& pose, const Twist2&, double) { return around.isFreeOfPoints(pose, less); },
                    command, params_.command_lifetime + kStep, inputs);
}

bool PathFollower::stopsWhere(const std::function<bool(const Pose2&, const Twist2&, double)>& is_free,
                              const Twist2& command, double seconds, const FollowerInputs& inputs) const {
  Pose2 pose = inputs.T_map_base;
  Twist2 twist = inputs.twist;
  const auto moves = [&] { return twist.linear != 0.0 || twist.angular != 0.0; };
  for (double t = 0.0; t < seconds || moves(); t += kStep) {
    if (t > seconds + kLongestBraking) return false;
    twist = limitAcceleration(t < seconds ? command : Twist2{}, twist, limits_, kStep);
    pose = integrate(pose, twist, kStep);
    if (!is_free(pose, twist, t + kStep)) return false;
  }
  return true;
}

FollowerOutput PathFollower::turn(double angle, const FollowerInputs& inputs) const {
  const Twist2 command{0.0, stoppableRate(angle, limits_)};
  if (outline_.isDisc()) return {command, false};
  const Vicinity around = vicinity(inputs);
  const double seconds = params_.reaction_time + inputs.age + std::abs(command.angular) / limits_.max_angular_acc;
  for (double t = kStep; t < seconds + kStep; t += kStep) {
    if (!around.isFree(integrate(inputs.T_map_base, command, t), 0.0)) return {{}, true};
  }
  if (!staysOnItsSide(command, params_.reaction_time + inputs.age, inputs, around)) return {{}, true};
  return {command, false};
}

FollowerOutput PathFollower::update(const FollowerInputs& inputs) {
  progress_ = path_.project(inputs.T_map_base.position(), progress_ - 0.1, progress_ + 1.0);
  const Vicinity around = vicinity(inputs);
  const double full = limits_.max_linear;
  const double far = std::max(params_.min_lookahead, params_.lookahead_time * full);
  const double near = std::max(0.75 * params_.min_lookahead, 0.5 * far);
  const double turn = params_.turn_in_place_angle;
  const std::array<Policy, 8> policies{{{far, full, turn},
                                        {near, full, turn},
                                        {near, 0.6 * full, turn},
                                        {far, 0.6 * full, turn},
                                        {near, 0.3 * full, turn},
                                        {near, 0.5 * full, 0.3},
                                        {near, 0.12 * full, turn},
                                        {0.5 * near, 0.2 * full, 0.3}}};
  const double possible = std::min(full * params_.horizon, remaining());
  Trial best;
  bool found = false;
  for (const Policy& policy : policies) {
    Trial trial = tryOut(policy, inputs, around);
    if (!isSafe(trial, inputs, around)) continue;
    if (!found || trial.score() > best.score()) best = std::move(trial);
    found = true;
    if (best.score() >= kGoodEnough * possible) break;
  }
  prediction_ = best.points;
  return {found ? best.command : Twist2{}, !found};
}

}  // namespace frontier_pilot::navigation
