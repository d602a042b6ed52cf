#include "frontier_pilot/fleet/traffic.h"

#include <algorithm>
#include <utility>

#include "fleet/bay_search.h"
#include "fleet/path_conflict.h"

namespace frontier_pilot::fleet {
namespace {

constexpr double kPeriod = 0.25;          ///< between two decisions [s]
constexpr std::size_t kMostRelated = 20;  ///< robots whose ways are compared with the own one, the nearest
constexpr double kApart = 0.1;            ///< gap with which robots pass each other [m]
constexpr double kRoom = 0.15;         ///< the same, on each of three sides, of two robots that pass in a passage [m]
constexpr double kBayGap = 0.1;        ///< further gap of a place to wait at [m]
constexpr double kHalt = 0.8;          ///< how far before a narrow stretch a robot waits [m]
constexpr double kAwaits = 0.9;        ///< how near one comes to a robot that gets out of the way [m]
constexpr double kComing = 3.0;        ///< a robot that is farther away need not be given way to yet [m]
constexpr double kEqual = 0.5;         ///< ways that differ by less count as equal [m]
constexpr double kBeside = 0.6;        ///< a robot that is let past has passed at this gap [m]
constexpr double kMoved = 0.2;         ///< [m]
constexpr double kStands = 15.0;       ///< a robot that should move and does not is no longer waited for [s]
constexpr double kIgnored = 20.0;      ///< for how long the rule then takes it for an obstacle [s]
constexpr double kSearchPeriod = 1.0;  ///< between two searches for a place to wait at [s]
constexpr double kNewGoal = 0.5;       ///< [m]
constexpr double kBlur = 0.3;          ///< how far a robot may have come since its last message [m]
constexpr double kIdle = 3.0;          ///< a robot without a way that has stood for this long may be sent aside [s]
constexpr double kStuck = 5.0;         ///< for how long a robot that found no place to wait at says so [s]
constexpr double kReach = 10.0;        ///< a robot that is farther away is not waited for [m]
constexpr double kLongest = 60.0;      ///< nor is one that was waited for so long [s]

TrafficOrder hold(const std::string& other) { return {TrafficOrder::Kind::kHold, Vec2::Zero(), other, {}, {}}; }

}  // namespace

std::string TrafficOrder::text() const {
  switch (kind) {
    case Kind::kFree:
      return {};
    case Kind::kHold:
      return "waits for " + other;
    case Kind::kAside:
      return "makes way for " + other;
  }
  return {};
}

navigation::NavOrder TrafficOrder::forNavigator() const {
  navigation::NavOrder asked;
  asked.hold = kind == Kind::kHold;
  if (kind == Kind::kAside) asked.aside = place;
  asked.why = text();
  asked.making_way = making_way;
  asked.moving = moving;
  return asked;
}

bool TrafficRule::isAlone() const {
  return std::none_of(others_.begin(), others_.end(),
                      [](const Other& other) { return other.relation != Relation::kNone; });
}

double TrafficRule::apartFrom(const Other& other) const { return radius_ + other.radius + kApart; }

TrafficOrder TrafficRule::update(const TrafficInputs& inputs, Time now) {
  if (decided_ && now < *decided_) forget();  // the clock was set back
  position_ = inputs.T_map_base.position();
  if (!goal_ || !inputs.path.empty()) path_ = inputs.path;
  const bool due = !decided_ || toSeconds(now - *decided_) >= kPeriod;
  if (due) decide(inputs, now);
  order_.moving = movingNearby(inputs, now);
  return order_;
}

void TrafficRule::forget() {
  heard_.clear();
  memories_.clear();
  others_.clear();
  order_ = {};
  astray_ = cannot_yield_ = false;
  decided_.reset();
  searched_.reset();
  stands_since_ = Time{};
}

void TrafficRule::decide(const TrafficInputs& inputs, Time now) {
  decided_ = now;
  T_map_common_ = inputs.T_map_common;
  const bool new_goal =
      goal_.has_value() != inputs.goal.has_value() || (goal_ && (*goal_ - *inputs.goal).norm() > kNewGoal);
  goal_ = inputs.goal;
  followWay(inputs, new_goal);
  if ((position_ - stands_at_).norm() > kMoved || order_.kind == TrafficOrder::Kind::kAside) {
    stands_at_ = position_;
    stands_since_ = now;
  }
  listen(inputs, now);
  if (inputs.map == nullptr || inputs.map->empty()) others_.clear();
  // Anybody can send the ways of a hundred robots, and each comparison goes along both ways.
  const std::size_t count = std::min(others_.size(), kMostRelated);
  const auto is_nearer = [this](const Other& a, const Other& b) {
    return (a.position - position_).squaredNorm() < (b.position - position_).squaredNorm();
  };
  if (count < others_.size()) std::nth_element(others_.begin(), others_.begin() + count, others_.end(), is_nearer);
  for (std::size_t i = 0; i < count; ++i) relate(others_[i], inputs, now);
  order_ = orderOf(inputs, now);
  order_.making_way.clear();  // an order that stays in force has those of the decision before
  for (const Other& other : others_) {
    if (other.relation == Relation::kPasses) order_.making_way.push_back({other.position, other.radius + kBlur});
  }
  if (order_.kind == TrafficOrder::Kind::kAside) astray_ = true;
  if (order_.kind == TrafficOrder::Kind::kFree) astray_ = false;
  if (new_goal ||
      (order_.kind == TrafficOrder::Kind::kFree && isAlone() && toSeconds(now - searched_.value_or(now)) > kStuck))
    cannot_yield_ = false;
}

/// Keeps the way to the goal: a robot that is sent aside, or whose navigator finds no path because another robot stands
/// on it, still wants to go there.
void TrafficRule::followWay(const TrafficInputs& inputs, bool new_goal) {
  if (!inputs.goal || new_goal) way_.clear();
  if (!inputs.goal || astray_) return;
  if (!inputs.path.empty()) {
    way_ = inputs.path;
  } else if (way_.size() > 1) {
    way_ = remaining(way_, position_);
  }
  path_ = way_;
}

void TrafficRule::relate(Other& other, const TrafficInputs& inputs, Time now) {
  Memory& memory = memories_[other.name];
  if (now < memory.anchored || (other.position - memory.anchor).norm() > kMoved || memory.relation == Relation::kNone) {
    memory.anchor = other.position;
    memory.anchored = now;
  }
  if (memory.ignored_until && now < *memory.ignored_until) return;
  memory.ignored_until.reset();
  other.relation = memory.relation = relationTo(other, memory.relation, inputs, now, other.entry);
  if (runsOutOfPatience(other, memory, now)) {
    other.relation = memory.relation = Relation::kNone;
    memory.ignored_until = now + fromSeconds(kIgnored);
  }
}

bool TrafficRule::runsOutOfPatience(const Other& other, Memory& memory, Time now) const {
  const bool waited_for = order_.kind == TrafficOrder::Kind::kHold && order_.other == other.name;
  if (!waited_for) {
    if (other.relation != Relation::kNone) memory.anchored = std::max(memory.anchored, now);
    memory.waited_since.reset();
    return false;
  }
  if (!memory.waited_since) memory.waited_since = now;
  return toSeconds(now - memory.anchored) > kStands || toSeconds(now - *memory.waited_since) > kLongest;
}

TrafficRule::Relation TrafficRule::relationTo(const Other& other, Relation before, const TrafficInputs& inputs,
                                              Time now, double& entry) const {
  const PassingRoom room{apartFrom(other), 2.0 * (radius_ + other.radius) + 3.0 * kRoom};
  if (!goal_) return Relation::kNone;
  if (way_.size() < 2) {  // it stands, and may stand in the other's way
    const bool stands = astray_ || toSeconds(now - stands_since_) > kIdle;
    if (!stands || cannot_yield_ || !other.has_way) return Relation::kNone;
    return findConflict(other.path, {position_}, room, *inputs.map) ? Relation::kYields : Relation::kNone;
  }
  const auto conflict = findConflict(way_, other.path, room, *inputs.map);
  entry = conflict ? conflict->own_entry : 0.0;
  if (!other.has_way) return conflict && !other.cannot_yield ? Relation::kPasses : Relation::kNone;
  const bool beside = (other.position - position_).norm() < apartFrom(other) + kBeside;
  if (!conflict && beside && before == Relation::kYields && order_.kind != TrafficOrder::Kind::kFree)
    return Relation::kYields;
  const bool near = (other.position - position_).norm() < kReach;
  if (!conflict) return near && other.passes_this && !other.yields_to_this ? Relation::kYields : Relation::kNone;
  const double more = conflict->own_exit - conflict->other_exit;
  return precedence(other, before, std::abs(more) < kEqual ? own_name_ < other.name : more < 0.0);
}

/// Who goes first: what both have said stays as it is, and where they contradict each other their names decide.
TrafficRule::Relation TrafficRule::precedence(const Other& other, Relation before, bool nearer) const {
  if (cannot_yield_ != other.cannot_yield) return cannot_yield_ ? Relation::kPasses : Relation::kYields;
  const Relation by_name = own_name_ < other.name ? Relation::kPasses : Relation::kYields;
  if (other.yields_to_this) return before == Relation::kYields ? by_name : Relation::kPasses;
  if (other.passes_this) return before == Relation::kPasses ? by_name : Relation::kYields;
  if (before != Relation::kNone) return before;
  return nearer ? Relation::kPasses : Relation::kYields;
}

/// The first robot to which this one yields and whose way leads past `place` with less than its gap and `margin` [m].
const TrafficRule::Other* TrafficRule::inTheWay(const Vec2& place, double margin) const {
  for (const Other& other : others_) {
    const bool yields = other.relation == Relation::kYields;
    if (yields && distanceTo(other.path, place) < apartFrom(other) + margin) return &other;
  }
  return nullptr;
}

TrafficOrder TrafficRule::orderOf(const TrafficInputs& inputs, Time now) {
  const auto yields = [](const Other& other) { return other.relation == Relation::kYields; };
  if (std::any_of(others_.begin(), others_.end(), yields)) return orderToYield(inputs, now);
  const std::vector<Vec2> ahead = resampled(inputs.path, 0.5 * kAwaits, kAwaits);
  for (const Other& other : others_) {
    if (other.relation != Relation::kPasses || ahead.size() < 2) continue;
    if (distanceTo(ahead, other.position) < apartFrom(other)) return hold(other.name);
  }
  return {};
}

TrafficOrder TrafficRule::orderToYield(const TrafficInputs& inputs, Time now) {
  const Other* in_the_way = inTheWay(position_, 0.0);
  const Other* first = nullptr;
  bool far = !astray_ && goal_.has_value();
  for (const Other& other : others_) {
    if (other.relation != Relation::kYields) continue;
    if (first == nullptr) first = &other;
    far = far && other.entry > kHalt;
  }
  const bool coming = in_the_way != nullptr && (in_the_way->position - position_).norm() < kComing;
  if (far && !coming) return {};
  if (in_the_way == nullptr) {
    const bool arriving = order_.kind == TrafficOrder::Kind::kAside && inTheWay(position_, 0.5 * kBayGap) != nullptr;
    if (arriving && !inputs.aside_failed) return order_;
    return hold(first->name);
  }
  const bool valid = order_.kind == TrafficOrder::Kind::kAside && !inputs.aside_failed &&
                     inTheWay(order_.place, 0.5 * kBayGap) == nullptr;
  if (valid) return order_;
  const bool may_search = !searched_ || now < *searched_ || toSeconds(now - *searched_) >= kSearchPeriod;
  if (may_search) {
    searched_ = now;
    std::vector<KeepOff> off, bodies;
    for (const Other& other : others_) {
      if (other.relation == Relation::kYields) off.push_back({other.path, apartFrom(other) + kBayGap});
      bodies.push_back({{other.position}, apartFrom(other) - 0.5 * kApart});
    }
    const auto bay = findBay(*inputs.map, position_, radius_, off, bodies);
    cannot_yield_ = !bay || (inputs.aside_failed && (*bay - order_.place).norm() < kMoved);
    if (!cannot_yield_) return {TrafficOrder::Kind::kAside, *bay, in_the_way->name, {}, {}};
  }
  return hold(in_the_way->name);
}

}  // namespace frontier_pilot::fleet
