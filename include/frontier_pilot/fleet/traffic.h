#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/core/time.h"
#include "frontier_pilot/fleet/claims.h"
#include "frontier_pilot/navigation/navigator_types.h"

namespace frontier_pilot::fleet {

/// What a robot tells the others of its fleet twice a second: where it is, where it is going to drive, and before whom
/// or after whom. All in a frame that they have in common. [MUL-3]
struct MotionMessage {
  static constexpr std::uint8_t kVersion = 1;
  static constexpr std::size_t kMostPoints = 32;  ///< with 8 bytes each, a quarter of a kilobyte
  static constexpr std::size_t kMostNames = 8;
  static constexpr double kSpacing = 0.5;   ///< of the points at which a path is told [m]
  static constexpr double kValidFor = 2.0;  ///< [s]

  std::uint8_t version = kVersion;
  std::string robot;             ///< unique in the fleet
  Vec2 position = Vec2::Zero();  ///< [m]
  double radius = 0.0;           ///< of the disc around its outline [m]
  std::vector<Vec2> path;        ///< from its position on [m]; empty: it has nowhere to go
  std::vector<std::string> yields_to;
  std::vector<std::string> passes;
  bool cannot_yield = false;     ///< it has found no place that is out of the others' way
  double valid_for = kValidFor;  ///< after the next message it holds no more, or after this time [s]
};

/// What the rule takes into account at one moment; in the robot's map frame.
struct TrafficInputs {
  Pose2 T_map_base;
  std::optional<Vec2> goal;            ///< nothing while the robot has none
  std::vector<Vec2> path;              ///< what the navigator follows, from the robot on; empty: nothing
  bool aside_failed = false;           ///< the navigator finds no way to the place of the last order
  const OccupancyGrid* map = nullptr;  ///< without the other robots, as far as possible
  std::optional<Pose2> T_map_common;   ///< nothing: the robot's place among the others is not known
};

/// What the navigator is asked to do.
struct TrafficOrder {
  enum class Kind {
    kFree,   ///< drive on
    kHold,   ///< stand
    kAside,  ///< drive to `place` and wait there
  };
  Kind kind = Kind::kFree;
  Vec2 place = Vec2::Zero();                   ///< in the map frame [m]
  std::string other;                           ///< the robot that it is about; empty while free
  std::vector<navigation::MovingDisc> moving;  ///< robots nearby that move, whatever their relation to this one
  std::vector<navigation::Disc> making_way;  ///< robots that get out of this one's way: plans need not lead around them

  /// In words, for example "waits for robot2"; empty while free.
  std::string text() const;
  navigation::NavOrder forNavigator() const;
};

/// The rule by which robots pass each other where there is no room for two: who is nearer to the way out of the narrow
/// stretch goes, and of equals the one whose name comes first; the other waits before it, or drives to the nearest
/// place that is out of the way. Each robot decides for itself by what the others say of themselves. A robot that is
/// not heard for two seconds is an obstacle like any other, and so is one that does not move although it should.
/// Deterministic; time is an argument. [MUL-3]
class TrafficRule {
 public:
  /// `own_name` is unique in the fleet, `radius` [m] that of the disc around the robot's outline.
  TrafficRule(std::string own_name, double radius) : own_name_(std::move(own_name)), radius_(radius) {}

  /// Takes a message of another robot that has arrived at `now`. What is refused changes nothing. [FLT-1]
  ClaimsVerdict hear(const MotionMessage& message, Time now);
  /// To be called in every cycle of the navigator; decides four times a second.
  TrafficOrder update(const TrafficInputs& inputs, Time now);
  /// What was heard and decided does not count any more, because the robot does not know where it is, or what time.
  void forget();
  /// What the robot is to tell the others by its last update; nothing while its place among them is not known.
  std::optional<MotionMessage> message() const;
  /// How many others were heard of at the last decision.
  std::size_t heard() const { return others_.size(); }

 private:
  enum class Relation { kNone, kYields, kPasses };
  struct Other {
    std::string name;
    Vec2 position = Vec2::Zero();
    double radius = 0.0;
    std::vector<Vec2> path;  ///< in the map frame; its position alone if it has nowhere to go
    bool has_way = false;
    bool yields_to_this = false;
    bool passes_this = false;
    bool cannot_yield = false;
    Relation relation = Relation::kNone;
    double entry = 0.0;  ///< from this robot along its way to the narrow stretch [m]
  };
  /// What is remembered of another robot between decisions.
  struct Memory {
    Relation relation = Relation::kNone;
    Vec2 anchor = Vec2::Zero();  ///< where it was when it had moved last
    Time anchored;
    std::optional<Time> waited_since;
    std::optional<Time> ignored_until;
  };
  struct Heard {
    MotionMessage message;
    Time at;
    Vec2 velocity = Vec2::Zero();  ///< in the common frame [m/s]
  };

  std::vector<navigation::MovingDisc> movingNearby(const TrafficInputs& inputs, Time now) const;
  void listen(const TrafficInputs& inputs, Time now);
  void decide(const TrafficInputs& inputs, Time now);
  void relate(Other& other, const TrafficInputs& inputs, Time now);
  Relation relationTo(const Other& other, Relation before, const TrafficInputs& inputs, Time now, double& entry) const;
  Relation precedence(const Other& other, Relation before, bool nearer) const;
  /// Forgets a relation to a robot that should move and does not.
  bool runsOutOfPatience(const Other& other, Memory& memory, Time now) const;
  void followWay(const TrafficInputs& inputs, bool new_goal);
  TrafficOrder orderOf(const TrafficInputs& inputs, Time now);
  TrafficOrder orderToYield(const TrafficInputs& inputs, Time now);
  const Other* inTheWay(const Vec2& place, double margin) const;
  double apartFrom(const Other& other) const;
  /// Whether no other robot matters at present.
  bool isAlone() const;

  std::string own_name_;
  double radius_;
  std::map<std::string, Heard> heard_;
  std::map<std::string, Memory> memories_;
  std::vector<Other> others_;
  std::vector<Vec2> way_;  ///< to the goal, as it was before the robot was sent aside or lost its path
  std::optional<Vec2> goal_;
  TrafficOrder order_;
  bool astray_ = false;  ///< it has been sent aside, and not on its way again yet
  bool cannot_yield_ = false;
  std::optional<Time> decided_, searched_;
  std::optional<Pose2> T_map_common_;
  Vec2 position_ = Vec2::Zero();
  Vec2 stands_at_ = Vec2::Zero();
  Time stands_since_;
  std::vector<Vec2> path_;  ///< as at the last update
};

}  // namespace frontier_pilot::fleet
