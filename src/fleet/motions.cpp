// The messages by which the robots tell each other where they are going to drive.
#include <algorithm>
#include <cmath>

#include "fleet/message_bounds.h"
#include "frontier_pilot/fleet/traffic.h"

namespace frontier_pilot::fleet {
namespace {

constexpr double kWidest = 7.1;    // as far as a corner of an outline may be from the origin [m]
constexpr double kShortest = 0.3;  // between two messages that tell a velocity: some wait, and come together [s]
constexpr double kFastest = 2.0;   // [m/s]
constexpr double kSlowest = 0.05;  // of a robot that counts as moving [m/s]
constexpr double kNearby = 5.0;    // [m]

bool isSound(const MotionMessage& message) {
  return isName(message.robot) && isPlace(message.position) && message.radius > 0.0 && message.radius <= kWidest &&
         message.valid_for > 0.0 && message.valid_for <= kLongestValid &&
         std::all_of(message.path.begin(), message.path.end(), isPlace) &&
         std::all_of(message.yields_to.begin(), message.yields_to.end(), isName) &&
         std::all_of(message.passes.begin(), message.passes.end(), isName);
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The line with points `kSpacing` apart and its last one, as far as a message takes them.
std::vector<Vec2> told(const std::vector<Vec2>& line, const Pose2& T_common_map) {
  std::vector<Vec2> points;
  double left = 0.0;  // until the next point
  for (std::size_t i = 0; i < line.size(); ++i) {
    const double step = i == 0 ? 0.0 : (line[i] - line[i - 1]).norm();
    for (double s = left; i > 0 && s < step; s += MotionMessage::kSpacing)
      points.push_back(T_common_map * Vec2(line[i - 1] + s / step * (line[i] - line[i - 1])));
    if (i > 0)
      left = left < step ? MotionMessage::kSpacing - std::fmod(step - left, MotionMessage::kSpacing) : left - step;
  }
  if (!line.empty()) points.push_back(T_common_map * line.back());
  if (points.size() > MotionMessage::kMostPoints) points.resize(MotionMessage::kMostPoints);
  return points;
}

}  // namespace

ClaimsVerdict TrafficRule::hear(const MotionMessage& message, Time now) {
  if (message.version != MotionMessage::kVersion) return ClaimsVerdict::kOtherVersion;
  if (message.path.size() > MotionMessage::kMostPoints || message.yields_to.size() > MotionMessage::kMostNames ||
      message.passes.size() > MotionMessage::kMostNames)
    return ClaimsVerdict::kTooMany;
  if (!isSound(message)) return ClaimsVerdict::kMalformed;
  if (message.robot == own_name_) return ClaimsVerdict::kOwn;
  if (heard_.size() >= kMostHeard && heard_.count(message.robot) == 0) return ClaimsVerdict::kTooMany;
  Vec2 velocity = Vec2::Zero();
  if (const auto before = heard_.find(message.robot); before != heard_.end()) {
    const double seconds = toSeconds(now - before->second.at);
    if (seconds >= 0.0 && seconds < kShortest) velocity = before->second.velocity;
    if (seconds >= kShortest && seconds <= MotionMessage::kValidFor)
      velocity = (message.position - before->second.message.position) / seconds;
    if (velocity.norm() > kFastest) velocity.setZero();  // it was put elsewhere, or its place was corrected
  }
  heard_[message.robot] = {message, now, velocity};
  return ClaimsVerdict::kTaken;
}

/// Makes `others_` of the messages that hold now. A clock that jumped back would keep silent robots for ever.
void TrafficRule::listen(const TrafficInputs& inputs, Time now) {
  others_.clear();
  for (auto it = heard_.begin(); it != heard_.end();) {
    const double age = toSeconds(now - it->second.at);
    const double valid = std::min(it->second.message.valid_for, MotionMessage::kValidFor);
    it = age < 0.0 || age > valid ? heard_.erase(it) : std::next(it);
  }
  for (auto it = memories_.begin(); it != memories_.end();) {
    const bool ignored = it->second.ignored_until && now < *it->second.ignored_until;
    it = ignored || heard_.count(it->first) > 0 ? std::next(it) : memories_.erase(it);
  }
  if (!inputs.T_map_common) return;
  for (const auto& [name, heard] : heard_) {
    const MotionMessage& message = heard.message;
    Other other;
    other.name = name;
    other.position = *inputs.T_map_common * message.position;
    other.radius = message.radius;
    other.has_way = message.path.size() > 1;
    other.path.push_back(other.position);
    for (const Vec2& point : message.path) other.path.push_back(*inputs.T_map_common * point);
    other.yields_to_this = contains(message.yields_to, own_name_);
    other.passes_this = contains(message.passes, own_name_);
    other.cannot_yield = message.cannot_yield;
    others_.push_back(std::move(other));
  }
}

/// Where those are by now that moved between their last two messages.
std::vector<navigation::MovingDisc> TrafficRule::movingNearby(const TrafficInputs& inputs, Time now) const {
  std::vector<navigation::MovingDisc> moving;
  if (!inputs.T_map_common) return moving;
  for (const auto& [name, heard] : heard_) {
    const double age = toSeconds(now - heard.at);
    if (heard.velocity.norm() < kSlowest || age < 0.0 || age > MotionMessage::kValidFor) continue;
    const Vec2 told = *inputs.T_map_common * heard.message.position;
    const Vec2 velocity = *inputs.T_map_common * (heard.message.position + heard.velocity) - told;
    const Vec2 position = told + age * velocity;
    if ((position - position_).norm() < kNearby) moving.push_back({position, velocity, heard.message.radius});
  }
  return moving;
}

std::optional<MotionMessage> TrafficRule::message() const {
  if (!T_map_common_) return std::nullopt;
  const Pose2 T_common_map = T_map_common_->inverse();
  MotionMessage message;
  message.robot = own_name_;
  message.position = T_common_map * position_;
  message.radius = radius_;
  message.path = told(path_, T_common_map);
  message.cannot_yield = cannot_yield_ || !goal_;  // without a goal it is not going to drive
  for (const Other& other : others_) {
    if (other.relation == Relation::kYields && message.yields_to.size() < MotionMessage::kMostNames)
      message.yields_to.push_back(other.name);
    if (other.relation == Relation::kPasses && message.passes.size() < MotionMessage::kMostNames)
      message.passes.push_back(other.name);
  }
  return message;
}

}  // namespace frontier_pilot::fleet
