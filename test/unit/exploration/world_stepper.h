#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/grid_traversal.h"
#include "frontier_pilot/exploration/explorer.h"
#include "frontier_pilot/grids/ray_casting.h"

namespace frontier_pilot::test {

/// The smallest world to explore in: a robot that follows the shortest way to its goal at constant speed, and a scanner
/// that shows the truth. No dynamics, no noise; what is measured is the choice of goals alone.
class WorldStepper {
 public:
  struct Options {
    double speed = 0.5;  // [m/s]
    double range = 8.0;  // [m]
    int beams = 360;
    double tick = 0.1;        // [s]
    double clearance = 0.15;  // [m]
  };

  WorldStepper(const OccupancyGrid& truth, const Vec2& start, const Options& options)
      : options_(options), truth_(truth), caster_(solid(truth)), map_(truth.geometry(), kUnknown) {
    pose_ = Pose2(start, 0.0);
    exploration::TraversableSpace floor(options.clearance + 0.01);
    floor.update(truth, truth.geometry().rect());
    exploration::TravelField reach;
    reach.compute(floor, truth, truth.geometry().cellAt(start), 0.5);
    markReachableFloor(reach);
    scan();
  }

  /// One tick with the explorer in the loop.
  exploration::ExplorerOutput step(exploration::Explorer& explorer) {
    if (!changed_.empty()) explorer.setMap(map_, changed_);
    changed_ = {};
    inputs_.T_map_base = StampedPose2{now_, pose_};
    inputs_.odometry_stamp = now_;
    exploration::ExplorerOutput output = explorer.update(inputs_, now_);
    inputs_.goal_events.clear();
    obey(output.command);
    drive();
    now_ += fromSeconds(options_.tick);
    return output;
  }

  /// Share of the floor a disc of the clearance can cover, from the start, that the map shows as free.
  double explored() const { return static_cast<double>(seen_floor_) / static_cast<double>(floor_cells_); }
  double distance() const { return distance_; }
  double seconds() const { return toSeconds(now_); }
  const OccupancyGrid& map() const { return map_; }
  Time now() const { return now_; }
  const Pose2& pose() const { return pose_; }
  exploration::ExplorerInputs& inputs() { return inputs_; }
  int plans = 0;
  const Grid<std::uint8_t>& floor() const { return floor_; }

 private:
  static Grid<std::uint8_t> solid(const OccupancyGrid& truth) {
    Grid<std::uint8_t> result(truth.geometry());
    for (std::size_t i = 0; i < truth.size(); ++i) result[i] = isFree(truth[i]) ? 0 : 1;
    return result;
  }

  void markReachableFloor(const exploration::TravelField& reach) {
    floor_ = Grid<std::uint8_t>(truth_.geometry());
    const int r = static_cast<int>(std::ceil(options_.clearance / truth_.resolution()));
    for (std::size_t i = 0; i < truth_.size(); ++i) {
      const Cell c = truth_.geometry().cell(i);
      if (!reach.reached(c)) continue;
      for (int dy = -r; dy <= r; ++dy) {
        for (int dx = -r; dx <= r; ++dx) {
          const Cell n{c.x + dx, c.y + dy};
          if (dx * dx + dy * dy <= r * r && truth_.contains(n) && isFree(truth_[n])) floor_[n] = 1;
        }
      }
    }
    floor_cells_ = static_cast<std::size_t>(std::count(floor_.cells().begin(), floor_.cells().end(), 1));
  }

  void set(Cell c, std::int8_t value) {
    if (!map_.contains(c) || map_[c] == value || (value == kFree && !isUnknown(map_[c]))) return;
    if (floor_[c] != 0 && value == kFree && map_[c] != kFree) ++seen_floor_;
    if (floor_[c] != 0 && value != kFree && map_[c] == kFree) --seen_floor_;
    map_[c] = value;
    changed_.include(c);
    unplanned_.include(c);
  }

  void scan() {
    for (int i = 0; i < options_.beams; ++i) {
      const Vec2 unit = direction(pose_.yaw + 2.0 * kPi * i / options_.beams);
      const double range = caster_.cast(pose_.position(), unit, options_.range);
      const Vec2 end = pose_.position() + range * unit;
      visitCells(map_.geometry(), pose_.position(), end, [&](Cell c) {
        if (map_.contains(c) && isFree(truth_[c])) set(c, kFree);
        return true;
      });
      const Cell hit = map_.geometry().cellAt(end + 1e-4 * unit);
      if (range < options_.range && map_.contains(hit) && !isFree(truth_[hit])) set(hit, kOccupied);
    }
  }

  void obey(const exploration::GoalCommand& command) {
    if (command.kind == exploration::GoalCommand::Kind::kCancel) path_.clear();
    if (command.kind != exploration::GoalCommand::Kind::kSend) return;
    goal_id_ = command.goal_id;
    plan(command.goal.position());
  }

  /// The way back from the goal, down the distances to the robot.
  void plan(const Vec2& goal) {
    ++plans;
    path_.clear();
    roomy_.update(map_, unplanned_);
    space_.update(map_, unplanned_);
    unplanned_ = {};
    const Cell here = map_.geometry().cellAt(pose_.position());
    Cell c = map_.geometry().cellAt(goal);
    exploration::TravelField field;
    field.compute(roomy_, map_, here, 0.6);
    if (!field.reached(c)) field.compute(space_, map_, here, 0.6);
    if (!field.reached(c)) {
      inputs_.goal_events.push_back({goal_id_, exploration::GoalEvent::Kind::kAborted, "no path"});
      return;
    }
    for (double left = field.distance(c); left > 0.0;) {
      path_.push_back(map_.geometry().centre(c));
      Cell best = c;
      for (int d = 0; d < 9; ++d) {
        const Cell n{c.x + d % 3 - 1, c.y + d / 3 - 1};
        if (field.distance(n) < field.distance(best)) best = n;
      }
      if (best == c) break;
      c = best;
      left = field.distance(c);
    }
    if (path_.empty()) path_.push_back(goal);
  }

  void drive() {
    if (path_.empty()) return;
    double left = options_.speed * options_.tick;
    while (!path_.empty() && left > 0.0) {
      const Vec2 towards = path_.back() - pose_.position();
      const double length = towards.norm();
      const double step = std::min(left, length);
      if (length > 1e-9) pose_ = Pose2(pose_.position() + step / length * towards, bearing(towards));
      distance_ += step;
      left -= step;
      if (step >= length - 1e-12) path_.pop_back();
    }
    scan();
    if (path_.empty()) inputs_.goal_events.push_back({goal_id_, exploration::GoalEvent::Kind::kReached, ""});
  }

  Options options_;
  OccupancyGrid truth_;
  grids::RayCaster caster_;
  OccupancyGrid map_;
  exploration::TraversableSpace space_{0.15};
  exploration::TraversableSpace roomy_{0.15, exploration::KeepClearOf::kObstaclesAndUnknown};
  CellRect unplanned_;
  Grid<std::uint8_t> floor_;
  std::size_t floor_cells_ = 0;
  std::size_t seen_floor_ = 0;
  CellRect changed_;
  Pose2 pose_;
  Time now_{};
  exploration::ExplorerInputs inputs_;
  std::vector<Vec2> path_;  // the next point is the last one
  std::uint32_t goal_id_ = 0;
  double distance_ = 0.0;
};

}  // namespace frontier_pilot::test
