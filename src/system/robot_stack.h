#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/arbiter/arbiter.h"
#include "frontier_pilot/exploration/explorer.h"
#include "frontier_pilot/fleet/claims.h"
#include "frontier_pilot/fleet/merged_map.h"
#include "frontier_pilot/fleet/traffic.h"
#include "frontier_pilot/mapping/mapper.h"
#include "frontier_pilot/navigation/navigator.h"
#include "frontier_pilot/sim/simulator.h"
#include "frontier_pilot/system/closed_loop.h"

namespace frontier_pilot::system {

/// What drives one robot of the simulator: its mapper, navigator, explorer and arbiter, connected as its nodes are by
/// topics. Alone, its navigator and explorer work on its own map; with others, on its view: what all of them have
/// mapped, in its own map frame, which begins where it started. [MUL-1]
class RobotStack {
 public:
  /// `simulator` has to outlive the stack. Throws what the constructor of arbiter::Arbiter throws.
  RobotStack(sim::Simulator& simulator, std::size_t robot, const ClosedLoopParameters& parameters,
             double (*wall_clock)());

  /// Takes the readings of the simulator's last step, and maps the scans that have arrived by now.
  void sense();
  /// Lets navigator and explorer follow the mapper.
  void followMapper();
  /// Brings what the others know of its map up to date, and returns the parts that have changed by that.
  std::vector<CellRect> publishMap();
  /// What the others know of its map.
  const OccupancyGrid& published() const { return published_.map(); }
  /// Takes over the map of the robot `source`, which may be this one, and of which the parts `changed` may differ.
  /// `T_map_source` is the pose of its frame in this robot's map frame.
  void mergeMap(std::size_t source, const OccupancyGrid& map, const std::vector<CellRect>& changed,
                const Pose2& T_map_source);
  /// What it tells the others, in the map frame of the first robot.
  fleet::ClaimsMessage claims() const;
  void hear(const fleet::ClaimsMessage& message) { book_.take(message, now()); }
  /// Where it is going to drive, in the same frame; nothing as long as it does not know. [MUL-3]
  std::optional<fleet::MotionMessage> motion() const { return rule_.message(); }
  void hear(const fleet::MotionMessage& message) { rule_.hear(message, now()); }
  bool powered() const { return powered_; }
  void setPowered(bool on) { powered_ = on; }
  /// One cycle of the explorer and of the navigator.
  void control();
  /// One cycle of the arbiter.
  void arbitrate();
  void setNavEnabled(bool on) { arbiter_.setEnabled(nav_source_, on, instant()); }

  const mapping::Mapper& mapper() const { return mapper_; }
  const OccupancyGrid& view() const { return view_.map().empty() ? mapper_.grid() : view_.map(); }
  const navigation::Navigator& navigator() const { return navigator_; }
  const navigation::NavigatorOutput& navigation() const { return navigation_; }
  const exploration::Explorer& explorer() const { return explorer_; }
  const exploration::ExplorerProgress& status() const { return status_; }
  bool done() const { return status_.state == exploration::ExplorerState::kDone; }
  std::vector<std::string> takeLog();
  const ModuleTimes& times() const { return times_; }
  std::uint64_t hash() const { return hash_; }

 private:
  /// The readings of the robot's sensors at one moment.
  struct Sensed {
    MotionSample odometry;
    std::optional<LaserScan2> scan;
  };

  Time now() const { return simulator_.now(); }
  void setMap(const OccupancyGrid& map, const CellRect& changed);
  void map(const LaserScan2& scan);
  void explore();
  void navigate();
  navigation::NavOrder giveWay();
  void noteGoals(const navigation::NavigatorOutput& output);
  Instant instant() const;
  StampedPose2 lastPose() const;
  void log(const std::string& line);
  void mix(double value);

  sim::Simulator& simulator_;
  std::size_t robot_;
  bool powered_ = true;
  Pose2 T_common_map_;
  fleet::ClaimBook book_;
  bool gives_way_;
  fleet::TrafficRule rule_;
  mapping::Mapper mapper_;
  fleet::MapSnapshot followed_;  ///< this, the next two and the view are empty while the robot is alone
  fleet::MapSnapshot published_;
  CellRect unpublished_;
  fleet::MergedMap view_{fleet::FirstSource::kPrevails};
  navigation::Navigator navigator_;
  exploration::Explorer explorer_;
  arbiter::Arbiter arbiter_;
  std::size_t nav_source_;
  double (*wall_clock_)();

  Duration head_start_;
  Duration latency_;
  std::deque<Sensed> on_the_way_;
  Sensed sensed_;  ///< the latest that has arrived
  ScanPlacer placer_;
  LaserScan2 scan_;
  exploration::GoalCommand pending_;
  std::optional<navigation::NavGoal> goal_;  ///< of the navigator
  navigation::NavigatorOutput navigation_;
  std::vector<exploration::GoalEvent> goal_events_;
  exploration::ExplorerProgress status_;
  std::vector<std::string> log_;
  ModuleTimes times_;
  std::uint64_t hash_ = 14695981039346656037ULL;
};

}  // namespace frontier_pilot::system
