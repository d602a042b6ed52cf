#include "planning/oriented_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>
#include <tuple>
#include <unordered_map>

#include "frontier_pilot/grids/cell_search.h"

namespace frontier_pilot::planning {
namespace {

constexpr int kDirections = 16;
/// The steps of the directions, counter-clockwise from x.
constexpr std::array<std::array<int, 2>, kDirections> kSteps{{{1, 0},
                                                              {2, 1},
                                                              {1, 1},
                                                              {1, 2},
                                                              {0, 1},
                                                              {-1, 2},
                                                              {-1, 1},
                                                              {-2, 1},
                                                              {-1, 0},
                                                              {-2, -1},
                                                              {-1, -1},
                                                              {-1, -2},
                                                              {0, -1},
                                                              {1, -2},
                                                              {1, -1},
                                                              {2, -1}}};
/// Cost of turning [m/rad], so that of equally long paths the one that turns least is found.
constexpr double kTurnCost = 0.1;
/// How many points ahead straight lines are tried.
constexpr std::size_t kLongestShortcut = 60;

double yawOf(int direction) {
  const auto& step = kSteps[static_cast<std::size_t>(direction)];
  return std::atan2(step[1], step[0]);
}

/// Cost of the cheapest 8-connected path from each cell to the nearest goal, for a robot that needs no room to turn:
/// Dijkstra's search over the passable cells; infinite where there is no path.
class CostToGo {
 public:
  CostToGo(const ClearanceMap& map, const std::vector<Cell>& goals)
      : map_(map), cost_(map.geometry(), std::numeric_limits<float>::infinity()) {
    for (const Cell goal : goals) push(goal, 0.0F);
    while (!open_.empty()) {
      const auto [cost, index] = open_.top();
      open_.pop();
      if (cost <= cost_[index]) expand(map_.geometry().cell(index), cost);
    }
  }
  double operator()(Cell cell) const { return static_cast<double>(cost_[cell]); }

 private:
  void push(Cell cell, float cost) {
    if (cost >= cost_[cell]) return;
    cost_[cell] = cost;
    open_.emplace(cost, map_.geometry().index(cell));
  }

  void expand(Cell cell, float cost) {
    for (const Cell step : grids::kNeighbourSteps) {
      const Cell next{cell.x + step.x, cell.y + step.y};
      if (!map_.geometry().contains(next) || !map_.isPassable(next)) continue;
      const double length = std::hypot(step.x, step.y) * map_.geometry().resolution;
      push(next, cost + static_cast<float>(length * map_.weight(map_.costClass(next))));
    }
  }

  using Open = std::pair<float, std::size_t>;

  const ClearanceMap& map_;
  Grid<float> cost_;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open_;
};

/// One search: the open list and the nodes of all states reached so far.
class Search {
 public:
  Search(const ClearanceMap& map, const OutlineCheck& outline, const OutlineCheck::Leave& leave,
         const std::vector<Cell>& goals)
      : map_(map), outline_(outline), leave_(leave), to_go_(map, goals) {}

  /// Begins with every direction that the robot can turn to or, without `robot`, in which it fits.
  void begin(Cell start, const std::optional<Pose2>& robot) {
    const Vec2 centre = map_.geometry().centre(start);
    for (int i = 0; i < kDirections; ++i) {
      const double yaw = robot ? robot->yaw : yawOf(i);
      if (!outline_.canTurn(map_, centre, yaw, yawOf(i), leave_.slackAt(centre))) continue;
      const double angle = std::abs(angleDifference(yawOf(i), yaw));
      relax(keyOf(start, i), kTurnCost * angle, kNobody);
    }
  }

  /// A state at a goal; nullopt if none is reached within `most` states.
  std::optional<std::uint64_t> run(std::size_t most) {
    while (!open_.empty() && expanded_ < most) {
      const auto [estimate, key] = open_.top();
      open_.pop();
      Node& node = nodes_[key];
      if (node.closed) continue;
      node.closed = true;
      ++expanded_;
      if (to_go_(cellOf(key)) == 0.0) return key;
      expand(key, node.cost);
    }
    return std::nullopt;
  }

  std::vector<Vec2> pointsTo(std::uint64_t key) const {
    std::vector<Vec2> points;
    for (; key != kNobody; key = nodes_.at(key).parent) {
      const Vec2 centre = map_.geometry().centre(cellOf(key));
      if (points.empty() || points.back() != centre) points.push_back(centre);
    }
    std::reverse(points.begin(), points.end());
    return points;
  }
  std::size_t expanded() const { return expanded_; }

 private:
  struct Node {
    double cost = std::numeric_limits<double>::infinity();
    std::uint64_t parent = kNobody;
    bool closed = false;
  };
  static constexpr std::uint64_t kNobody = std::numeric_limits<std::uint64_t>::max();

  std::uint64_t keyOf(Cell cell, int direction) const {
    return static_cast<std::uint64_t>(map_.geometry().index(cell)) * kDirections +
           static_cast<std::uint64_t>(direction);
  }
  Cell cellOf(std::uint64_t key) const { return map_.geometry().cell(static_cast<std::size_t>(key / kDirections)); }
  static int directionOf(std::uint64_t key) { return static_cast<int>(key % kDirections); }

  void expand(std::uint64_t key, double cost) {
    const Cell cell = cellOf(key);
    const int direction = directionOf(key);
    const Vec2 here = map_.geometry().centre(cell);
    const auto& step = kSteps[static_cast<std::size_t>(direction)];
    const Cell ahead{cell.x + step[0], cell.y + step[1]};
    if (map_.geometry().contains(ahead)) {
      const Vec2 there = map_.geometry().centre(ahead);
      const double length = map_.segmentCost(here, there);
      if (length >= 0.0 && outline_.fits(map_, {there, yawOf(direction)}, leave_.slackAt(there))) {
        relax(keyOf(ahead, direction), cost + length, key);
      }
    }
    for (const int turned : {(direction + 1) % kDirections, (direction + kDirections - 1) % kDirections}) {
      if (!outline_.canTurn(map_, here, yawOf(direction), yawOf(turned), leave_.slackAt(here))) continue;
      const double angle = std::abs(angleDifference(yawOf(turned), yawOf(direction)));
      relax(keyOf(cell, turned), cost + kTurnCost * angle, key);
    }
  }

  void relax(std::uint64_t key, double cost, std::uint64_t parent) {
    Node& node = nodes_[key];
    if (node.closed || cost >= node.cost) return;
    node.cost = cost;
    node.parent = parent;
    const double to_go = to_go_(cellOf(key));
    if (std::isfinite(to_go)) open_.emplace(cost + to_go, key);
  }

  using Open = std::pair<double, std::uint64_t>;

  const ClearanceMap& map_;
  const OutlineCheck& outline_;
  OutlineCheck::Leave leave_;
  CostToGo to_go_;
  std::unordered_map<std::uint64_t, Node> nodes_;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open_;
  std::size_t expanded_ = 0;
};

/// Replaces pieces of a path by straight lines wherever the robot can turn onto the line, follow it and turn off it.
std::vector<Vec2> pulledTaut(const ClearanceMap& map, const OutlineCheck& outline, const std::vector<Vec2>& points,
                             const std::optional<Pose2>& robot) {
  std::vector<Vec2> kept{points.front()};
  for (std::size_t i = 0; i + 1 < points.size();) {
    // Whether the robot can turn onto a line from here, coming along the previous one or standing at the start.
    const auto canBegin = [&](double line) {
      if (i == 0) return !robot || outline.canTurn(map, points[0], robot->yaw, line);
      return outline.canTurn(map, points[i], bearing(kept.back() - kept[kept.size() - 2]), line);
    };
    std::size_t next = i + 1;
    for (std::size_t k = std::min(points.size() - 1, i + kLongestShortcut); k > i + 1; --k) {
      const double line = bearing(points[k] - points[i]);
      if (!map.isValid(points[i], points[k]) || !outline.canDrive(map, points[i], points[k]) || !canBegin(line))
        continue;
      if (k + 1 < points.size() && !outline.canTurn(map, points[k], line, bearing(points[k + 1] - points[k]))) continue;
      next = k;
      break;
    }
    kept.push_back(points[next]);
    i = next;
  }
  return kept;
}

}  // namespace

std::vector<Vec2> OrientedSearch::search(Cell start, const std::optional<Pose2>& robot, const std::vector<Cell>& goals,
                                         std::size_t most) {
  // The search begins at the centre of the cell that the robot is in.
  const Vec2 centre = map_.geometry().centre(start);
  const std::optional<Pose2> begin = robot ? std::optional<Pose2>(Pose2(centre, robot->yaw)) : std::nullopt;
  Search search(map_, outline_, OutlineCheck::Leave(outline_, map_, begin), goals);
  search.begin(start, begin);
  const std::optional<std::uint64_t> end = search.run(most);
  expanded_ = search.expanded();
  if (!end) return {};
  std::vector<Vec2> points = pulledTaut(map_, outline_, search.pointsTo(*end), begin);
  // The search may have turned the longer way round; the follower turns the shorter way.
  return outline_.canFollow(map_, Path(points), 0, 0.0, begin) ? points : std::vector<Vec2>{};
}

}  // namespace frontier_pilot::planning
