#include "frontier_pilot/planning/global_planner.h"

#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <cmath>

#include "frontier_pilot/core/bounds.h"
#include "planning/inflation_exit.h"
#include "planning/ompl_planner.h"
#include "planning/oriented_search.h"
#include "planning/path_smoothing.h"

namespace frontier_pilot::planning {
namespace {

namespace ob = ompl::base;

constexpr const char* kRrtConnect = "rrt_connect";
constexpr const char* kAnyAngleGrid = "any_angle_grid";

/// By default OMPL logs to the console and seeds from the clock; both have to be changed once, before any OMPL object
/// is made.
void silenceAndSeedOmpl() {
  static const bool done = [] {
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    ompl::RNG::setSeed(1);
    return true;
  }();
  static_cast<void>(done);
}

/// Passable cells within `tolerance` [m] of `goal`, the nearest first, at most kMostGoalCells; only the goal's own cell
/// if that is passable.
std::vector<Cell> goalCells(const ClearanceMap& map, const Vec2& goal, double tolerance) {
  const GridGeometry& grid = map.geometry();
  const Cell own = grid.cellAt(goal);
  if (map.isPassable(own)) return {own};
  std::vector<std::pair<double, Cell>> near;
  const int reach = static_cast<int>(std::ceil(tolerance / grid.resolution));
  const CellRect around = CellRect{own.x, own.y, 1, 1}.grown(reach).intersection(grid.rect());
  for (int y = around.y; y < around.y + around.height; ++y) {
    for (int x = around.x; x < around.x + around.width; ++x) {
      const double distance = (grid.centre({x, y}) - goal).norm();
      if (distance <= tolerance && map.isPassable({x, y})) near.emplace_back(distance, Cell{x, y});
    }
  }
  std::stable_sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  near.resize(std::min(near.size(), bounds::kMostGoalCells));
  std::vector<Cell> cells;
  for (const auto& candidate : near) cells.push_back(candidate.second);
  return cells;
}

PlanStatus whyUnreachable(const ClearanceMap& map, Cell goal) {
  if (map.isPassable(goal)) return PlanStatus::kNoPath;
  const bool near_obstacle = map.field().at(goal) < map.leastClearance();
  return near_obstacle ? PlanStatus::kGoalOccupied : PlanStatus::kGoalUnreachable;
}

PlanStatus checkRequest(const ClearanceMap& map, const PlanRequest& request) {
  if (map.empty()) return PlanStatus::kNoMap;
  if (!request.start.allFinite() || !request.goal.allFinite()) return PlanStatus::kInvalidRequest;
  // Very large coordinates would overflow a cell's integers.
  const auto inside = [&](const Vec2& point) {
    return (point - map.geometry().origin).cwiseAbs().maxCoeff() < 1e6 &&
           map.geometry().contains(map.geometry().cellAt(point));
  };
  if (!inside(request.start)) return PlanStatus::kStartOutside;
  if (!inside(request.goal)) return PlanStatus::kGoalOutside;
  return PlanStatus::kFound;
}

ob::ProblemDefinitionPtr makeProblem(const ob::SpaceInformationPtr& si, const ClearanceMap& map,
                                     const std::vector<InflationExit>& escapes, const std::vector<Cell>& goals) {
  auto problem = std::make_shared<ob::ProblemDefinition>(si);
  auto goal = std::make_shared<ob::GoalStates>(si);
  ob::ScopedState<> state(si);
  for (const InflationExit& escape : escapes) {
    setPoint(state.get(), map.geometry().centre(escape.cells.back()));
    problem->addStartState(state);
  }
  for (const Cell cell : goals) {
    setPoint(state.get(), map.geometry().centre(cell));
    goal->addState(state);
  }
  problem->setGoal(goal);
  return problem;
}

std::vector<Vec2> solutionPoints(const ob::ProblemDefinition& problem) {
  std::vector<Vec2> points;
  const auto* path = problem.getSolutionPath()->as<ompl::geometric::PathGeometric>();
  for (std::size_t i = 0; i < path->getStateCount(); ++i) {
    points.push_back(pointOf(path->getState(static_cast<unsigned>(i))));
  }
  return points;
}

/// Connects the exact start and goal of the request to a path between cells, and smooths it.
PlanResult finish(const ClearanceMap& map, const PlanRequest& request, const std::vector<InflationExit>& escapes,
                  std::vector<Vec2> points) {
  const GridGeometry& grid = map.geometry();
  const Cell first = grid.cellAt(points.front());
  const auto escape =
      std::find_if(escapes.begin(), escapes.end(), [&](const InflationExit& e) { return e.cells.back() == first; });
  if (grid.cellAt(points.back()) == grid.cellAt(request.goal) && map.isValid(points.back(), request.goal)) {
    points.push_back(request.goal);
  }
  PlanResult result;
  std::vector<Vec2> way_out;
  if (map.isValid(request.start, points.front())) {
    points.insert(points.begin(), request.start);
  } else if (escape == escapes.end()) {
    result.status = PlanStatus::kNoPath;
    return result;
  } else {
    way_out.push_back(request.start);
    for (std::size_t i = 1; i + 1 < escape->cells.size(); ++i) way_out.push_back(grid.centre(escape->cells[i]));
  }
  const Path smooth = smoothPath(map, Path(points));
  way_out.insert(way_out.end(), smooth.points().begin(), smooth.points().end());
  result.path = Path(way_out);
  result.escape = result.path.points().size() - smooth.points().size();
  result.status = isPathValid(map, result.path, result.escape) ? PlanStatus::kFound : PlanStatus::kNoPath;
  return result;
}

}  // namespace

struct GlobalPlanner::Impl {
  GlobalPlannerParams params;
  OutlineCheck outline;
  Corridor corridor;
  GridSearch search;

  PlanResult plan(const ClearanceMap& map, const PlanRequest& request, const std::vector<InflationExit>& escapes,
                  const std::vector<Cell>& goals) {
    PlanResult result;
    result.status =
        escapes.empty() ? PlanStatus::kStartBlocked : whyUnreachable(map, map.geometry().cellAt(request.goal));
    if (escapes.empty() || goals.empty()) return result;
    const ob::SpaceInformationPtr si = makeSpaceInformation(map);
    const ob::ProblemDefinitionPtr problem = makeProblem(si, map, escapes, goals);
    std::size_t expanded = 0;
    if (solve(map, si, problem, expanded)) result = finish(map, request, escapes, solutionPoints(*problem));
    result.expanded = expanded;
    return result;
  }

  /// `result`, a path for the lane, if the outline can follow it; else one with the same escape that leaves room for
  /// the turns.
  PlanResult withRoomToTurn(const ClearanceMap& map, const PlanRequest& request, PlanResult result,
                            const std::vector<Cell>& goals) const {
    const std::optional<Pose2> robot =
        request.start_yaw ? std::optional<Pose2>(Pose2(request.start, *request.start_yaw)) : std::nullopt;
    if (!result.found() || outline.canFollow(map, result.path, result.escape, 0.0, robot)) return result;
    const std::vector<Vec2> lane = result.path.points();
    const std::vector<Cell> end{map.geometry().cellAt(lane.back())};
    const Cell start = map.geometry().cellAt(lane[result.escape]);
    const std::optional<Pose2> from = result.escape > 0 ? std::nullopt : robot;
    result.path = Path();
    result.postponed = request.quick;
    const bool has_others = goals.size() > 1 || goals.front() != end.front();
    // To the end of the path for the lane, else to any cell within the tolerance; tight places are the last resort.
    for (const OutlineCheck& check : {outline, outline.inTightPlaces()}) {
      std::size_t left = request.quick ? 0 : bounds::kMostOrientedStates;
      for (const std::vector<Cell>* to : {&end, &goals}) {
        if (left == 0 || (to == &goals && !has_others)) continue;
        OrientedSearch oriented(map, check);
        std::vector<Vec2> points = oriented.search(start, from, *to, to == &end && has_others ? left - left / 4 : left);
        result.expanded += oriented.expanded();
        left -= oriented.expanded();
        if (points.empty()) continue;
        points.insert(points.begin(), lane.begin(), lane.begin() + static_cast<std::ptrdiff_t>(result.escape));
        result.path = Path(points);
        return result;
      }
    }
    const bool may_turn = outline.canTurnRound(map, request.start);
    result.status = may_turn ? PlanStatus::kNoPath : PlanStatus::kStartBlocked;
    return result;
  }

  /// Returns whether the problem has an exact solution now.
  bool solve(const ClearanceMap& map, const ob::SpaceInformationPtr& si, const ob::ProblemDefinitionPtr& problem,
             std::size_t& expanded) {
    if (params.algorithm == kRrtConnect) {
      ompl::geometric::RRTConnect planner(si);
      planner.setProblemDefinition(problem);
      planner.setup();
      ob::IterationTerminationCondition iterations(static_cast<unsigned>(params.max_iterations));
      return planner.solve(iterations) == ob::PlannerStatus::EXACT_SOLUTION;
    }
    AnyAngleGridPlanner planner(si, map, corridor, search);
    planner.setProblemDefinition(problem);
    const bool solved = planner.solve(ob::plannerNonTerminatingCondition()) == ob::PlannerStatus::EXACT_SOLUTION;
    expanded = planner.expanded();
    return solved;
  }
};

void GlobalPlannerParams::check(Problems& problems) const {
  if (algorithm == kAnyAngleGrid || algorithm == kRrtConnect) return;
  problems.push_back("algorithm: must be any_angle_grid or rrt_connect, is " + algorithm);
}

const char* toString(PlanStatus status) {
  switch (status) {
    case PlanStatus::kFound:
      return "path found";
    case PlanStatus::kNoMap:
      return "no map";
    case PlanStatus::kInvalidRequest:
      return "start or goal is not finite";
    case PlanStatus::kStartOutside:
      return "start outside of the map";
    case PlanStatus::kStartBlocked:
      return "start blocked";
    case PlanStatus::kGoalOutside:
      return "goal outside of the map";
    case PlanStatus::kGoalOccupied:
      return "goal occupied";
    case PlanStatus::kGoalUnreachable:
      return "goal unreachable";
    case PlanStatus::kNoPath:
      return "no path";
  }
  return "unknown";
}

GlobalPlanner::GlobalPlanner(const GlobalPlannerParams& params, const OutlineCheck& outline)
    : impl_(std::make_unique<Impl>()) {
  impl_->params = params;
  impl_->outline = outline;
  silenceAndSeedOmpl();
}
GlobalPlanner::~GlobalPlanner() = default;
GlobalPlanner::GlobalPlanner(GlobalPlanner&&) noexcept = default;
GlobalPlanner& GlobalPlanner::operator=(GlobalPlanner&&) noexcept = default;

PlanResult GlobalPlanner::plan(const ClearanceMap& map, const PlanRequest& request) {
  PlanResult result;
  result.status = checkRequest(map, request);
  if (!result.found()) return result;
  const double asked = request.goal_tolerance >= 0.0 ? request.goal_tolerance : impl_->params.goal_tolerance;
  const double tolerance = std::min(asked, bounds::kMostGoalTolerance);
  const std::vector<Cell> goals = goalCells(map, request.goal, tolerance);
  const Cell start = map.geometry().cellAt(request.start);
  const double radius = impl_->params.escape_radius;
  result = impl_->plan(map, request, findInflationExits(map, start, radius), goals);
  // On an island of passable cells the only way out may be a gap that the map shows as too narrow.
  if (!result.found() && !goals.empty()) {
    result = impl_->plan(map, request, findInflationExits(map, start, radius, true), goals);
  }
  return impl_->withRoomToTurn(map, request, std::move(result), goals);
}

bool isPathValid(const ClearanceMap& map, const Path& path, std::size_t escape, double from) {
  const std::vector<Vec2>& points = path.points();
  if (points.empty()) return false;
  if (points.size() == 1) return escape > 0 || map.isValid(points.front());
  for (std::size_t i = escape; i + 1 < points.size(); ++i) {
    if (path.arcLength(i + 1) <= from) continue;
    const Vec2 start = path.arcLength(i) < from ? path.at(from) : points[i];
    if (!map.isValid(start, points[i + 1])) return false;
  }
  return true;
}

}  // namespace frontier_pilot::planning
