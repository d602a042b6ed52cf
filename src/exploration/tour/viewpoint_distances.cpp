#include "exploration/tour/viewpoint_distances.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace frontier_pilot::exploration {
namespace {

constexpr double kSlack = 1.2;  // paths over coarse cells may be longer than those over the map's

}  // namespace

CellRect ViewpointDistances::follow(FrontierEvaluator& evaluator) {
  const TraversableSpace& space = evaluator.space();
  const auto known =
      std::find_if(followed_.begin(), followed_.end(), [&](const Followed& f) { return f.space == &space; });
  judged_ = static_cast<std::size_t>(known - followed_.begin());
  if (known == followed_.end()) followed_.push_back({&space, {}});
  return followed_[judged_].coarse.update(space, evaluator.takeSpaceChanges());
}

void ViewpointDistances::restart(const std::vector<Viewpoint>& viewpoints, const FrontierEvaluator& evaluator,
                                 const Pose2& T_map_robot) {
  places_.clear();
  cells_.clear();
  ways_.clear();
  for (const Viewpoint& viewpoint : viewpoints) {
    places_.push_back(evaluator.map().geometry().centre(viewpoint.cell));
    cells_.push_back(coarse().geometry().cellAt(places_.back()));
    ways_.push_back(evaluator.travel().distance(viewpoint.cell));
  }
  longest_way_ = ways_.empty() ? 0.0 : *std::max_element(ways_.begin(), ways_.end());
  rows_.assign(viewpoints.size(), {});
  robot_ = T_map_robot;
  from_robot_.compute(coarse().neighbours(), coarse().geometry().cellAt(robot_.position()),
                      kSlack * (longest_way_ + 1.0));
}

const std::vector<double>& ViewpointDistances::from(std::size_t viewpoint) {
  const std::vector<double>& distances = row(viewpoint);
  if (std::none_of(distances.begin(), distances.end(), [](double d) { return d < 0.0; })) return distances;
  field_.compute(coarse().neighbours(), cells_[viewpoint], farthestFrom(viewpoint));
  for (std::size_t other = 0; other < cells_.size(); ++other) note(viewpoint, other);
  return distances;
}

void ViewpointDistances::connect(const std::vector<std::size_t>& viewpoints) {
  for (const std::size_t viewpoint : viewpoints) row(viewpoint);
  std::vector<Cell> targets;
  for (auto from = viewpoints.begin(); from != viewpoints.end(); ++from) {
    std::vector<std::size_t> missing;
    std::copy_if(from, viewpoints.end(), std::back_inserter(missing),
                 [&](std::size_t to) { return between(*from, to) < 0.0; });
    if (missing.empty()) continue;
    targets.clear();
    for (const std::size_t to : missing) targets.push_back(cells_[to]);
    field_.compute(coarse().neighbours(), cells_[*from], farthestFrom(*from), targets);
    for (const std::size_t to : missing) note(*from, to);
  }
}

/// With what other rows already say.
std::vector<double>& ViewpointDistances::row(std::size_t viewpoint) {
  constexpr double kNotKnown = -1.0;
  std::vector<double>& distances = rows_[viewpoint];
  if (!distances.empty()) return distances;
  distances.assign(rows_.size(), kNotKnown);
  for (std::size_t other = 0; other < rows_.size(); ++other) {
    if (!rows_[other].empty()) distances[other] = rows_[other][viewpoint];
  }
  return distances;
}

/// No way between two viewpoints is longer than that over the robot, but for the larger cells.
double ViewpointDistances::farthestFrom(std::size_t viewpoint) const {
  return kSlack * (ways_[viewpoint] + longest_way_) + kSlack;
}

/// Takes over the distance of `to` from the wavefront that began at `from`.
void ViewpointDistances::note(std::size_t from, std::size_t to) {
  const double distance = field_.distance(cells_[to]);
  const double known = std::isfinite(distance) ? distance : 2.0 * (places_[to] - places_[from]).norm();
  rows_[from][to] = known;
  if (!rows_[to].empty()) rows_[to][from] = known;
}

std::vector<double> ViewpointDistances::to(const Vec2& place) {
  field_.compute(coarse().neighbours(), coarse().geometry().cellAt(place), std::numeric_limits<double>::infinity());
  std::vector<double> distances;
  for (const Cell cell : cells_) distances.push_back(field_.reached(cell) ? field_.distance(cell) : -1.0);
  return distances;
}

double ViewpointDistances::turnTo(std::size_t viewpoint) const {
  constexpr int kAhead = 5;  // [cells]: where the way is looked at
  const Cell robot = coarse().geometry().cellAt(robot_.position());
  Cell at = cells_[viewpoint];
  if (!from_robot_.reached(at)) return 0.0;
  while (std::max(std::abs(at.x - robot.x), std::abs(at.y - robot.y)) > kAhead) {
    const Cell next = nextTowardsOrigin(from_robot_, at);
    if (next == at) break;
    at = next;
  }
  const Vec2 ahead = coarse().geometry().centre(at) - robot_.position();
  if (ahead.norm() < coarse().geometry().resolution) return 0.0;
  return std::abs(angleDifference(bearing(ahead), robot_.yaw));
}

}  // namespace frontier_pilot::exploration
