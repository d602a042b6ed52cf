#include "exploration/tour/tour_strategy.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace frontier_pilot::exploration {
namespace {

constexpr double kNoWay = -1.0;  // as ViewpointDistances::to

/// Frontiers nearer than this to one that stayed unknown are the same one [m].
BlacklistParameters distrustParameters(BlacklistParameters parameters) {
  parameters.radius = 0.4;
  return parameters;
}

}  // namespace

TourStrategy::TourStrategy(const ExplorerParameters& parameters)
    : parameters_(parameters.tour),
      min_distance_(parameters.frontier.min_distance),
      limits_(parameters.robot.limits),
      search_(parameters.frontier.view),
      regions_(std::max({parameters_.open_area, parameters_.hidden_area, parameters_.sliver_area,
                         parameters_.small_area, parameters_.most_left})),
      distrusted_(distrustParameters(parameters.blacklist)) {}

std::optional<ChosenGoal> TourStrategy::choose(FrontierEvaluator& evaluator, const Situation& situation) {
  evaluator_ = &evaluator;
  robot_ = situation.T_map_robot;
  distances_.follow(evaluator);
  expireDistrust();
  seek();
  left_.assign(evaluator.frontiers().size(), false);
  viewpoints_ = search_.find(evaluator, sought_, situation.current);
  if (isNearlyThere(situation)) return goalAt(*situation.current);
  distances_.restart(viewpoints_, evaluator, situation.T_map_robot);
  ways_home_ = situation.home ? distances_.to(*situation.home) : std::vector<double>(viewpoints_.size(), kNoWay);
  measureOpenAreas();
  findSlivers();
  expectAreas();
  putOffSmallOnes();
  if (situation.shared != nullptr) leaveToOthers(*situation.shared);
  const Plan plan = choosePlan(situation);
  if (!plan.stops.empty()) return goalOf(plan, situation);
  rejectRest();
  return std::nullopt;
}

/// Nothing is left that is worth a trip: says of each frontier why.
void TourStrategy::rejectRest() {
  for (const SoughtFrontier& each : sought_) {
    if (put_off_[each.index] && !left_[each.index]) evaluator_->reject(each.index, Rejection::kSmallCorner);
  }
  evaluator_->rejectAll(Rejection::kNothingToSee);
}

void TourStrategy::stayedUnknown() {
  for (const Vec2& place : aimed_at_) {
    if (distrusted_.find(place) == nullptr) distrusted_.add(place, "stayed unknown", evaluator_->map());
  }
}

/// A frontier around which the map has changed may be seen from elsewhere again.
void TourStrategy::expireDistrust() {
  const ObservedMap& map = evaluator_->map();
  if (std::exchange(restarts_, map.restarts()) != map.restarts()) distrusted_.rebase(map);
  distrusted_.expire(map);
}

/// Takes the nearest frontiers: farther ones will have changed when the robot gets there. Those that were not seen from
/// a viewpoint although they should have been are looked at from their own goals.
void TourStrategy::seek() {
  constexpr std::size_t kMostFrontiers = 100;
  const std::vector<Frontier>& all = evaluator_->frontiers();
  std::vector<std::size_t> nearest;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].selectable()) nearest.push_back(i);
  }
  std::stable_sort(nearest.begin(), nearest.end(),
                   [&](std::size_t a, std::size_t b) { return all[a].distance < all[b].distance; });
  all_sought_ = nearest.size() <= kMostFrontiers;
  nearest.resize(std::min(nearest.size(), kMostFrontiers));
  sought_.clear();
  for (const std::size_t i : nearest) {
    const Vec2 anchor = evaluator_->map().geometry().centre(all[i].anchor);
    sought_.push_back({i, distrusted_.find(anchor) == nullptr});
  }
}

void TourStrategy::measureOpenAreas() {
  open_areas_.assign(evaluator_->frontiers().size(), 0.0);
  for (const SoughtFrontier& each : sought_) open_areas_[each.index] = openAreaAt(each.index);
}

/// The greatest area behind the anchor and a few other cells of the frontier: it may border both a pocket and a room.
double TourStrategy::openAreaAt(std::size_t frontier) {
  constexpr int kOtherCells = 4;
  const FrontierCluster& cluster = evaluator_->clusters().clusters[frontier];
  double area = regions_.areaBehind(evaluator_->frontiers()[frontier].anchor, evaluator_->map());
  for (int k = 0; k < kOtherCells && area < parameters_.hidden_area; ++k) {
    const Cell cell = cellOf(evaluator_->clusters(), cluster, (cluster.cells - 1) * k / (kOtherCells - 1));
    area = std::max(area, regions_.areaBehind(cell, evaluator_->map()));
  }
  return area;
}

/// A sliver is a frontier around which little unknown area is connected, or no more than the inside of a piece of
/// furniture of which next to nothing is in sight from anywhere. Slivers are left behind as long as all of them
/// together are a small share of the known floor; otherwise none is one.
void TourStrategy::findSlivers() {
  slivers_.assign(evaluator_->frontiers().size(), false);
  double sum = 0.0;
  for (const SoughtFrontier& each : sought_) {
    const double open_area = open_areas_[each.index];
    const bool pocket = open_area < parameters_.sliver_area;
    const bool hidden = open_area < parameters_.hidden_area && search_.mostOf(each.index) < parameters_.least_area;
    if (!pocket && !hidden) continue;
    slivers_[each.index] = true;
    sum += std::min(open_area, parameters_.sliver_area);
  }
  const bool too_many = !all_sought_ || sum > parameters_.sliver_share * evaluator_->map().freeArea();
  if (too_many) slivers_.assign(slivers_.size(), false);
}

/// Whether the robot is about to arrive where something is left to see, although the frontier to be seen there is too
/// near to be chosen by now. A robot that turned away would choose it again as soon as it is a little farther away.
bool TourStrategy::isNearlyThere(const Situation& situation) const {
  constexpr double kNearly = 0.05;  // [m] above min_distance
  if (!situation.current || !situation.keep_current || presentViewpoint(situation)) return false;
  const Cell cell = evaluator_->map().geometry().cellAt(situation.current->position());
  return evaluator_->travel().distance(cell) < min_distance_ + kNearly &&
         evaluator_->infoAt(*situation.current).area >= evaluator_->leastInfo();
}

/// The best plan, or the one that goes on to the present viewpoint unless the best is shorter by the margin. The margin
/// doubles each time that a goal is left for a better one, until one has been seen: long tours are not solved exactly,
/// and the robot could otherwise turn back and forth between two that look alike.
TourStrategy::Plan TourStrategy::choosePlan(const Situation& situation) {
  Plan best = plan(std::nullopt);
  const auto present = presentViewpoint(situation);
  if (!present) changes_of_mind_ = 0;
  if (best.stops.empty() || !present || best.stops.front().viewpoint == *present) return best;
  constexpr int kMostDoublings = 8;
  const double margin = std::ldexp(parameters_.switch_margin, std::min(changes_of_mind_, kMostDoublings));
  Plan kept = plan(present);
  if (kept.cost < best.cost + margin) return kept;
  ++changes_of_mind_;
  return best;
}

/// With `first` given, that viewpoint comes first.
TourStrategy::Plan TourStrategy::plan(std::optional<std::size_t> first) {
  const std::vector<Stop> stops = cover(first);
  if (stops.empty()) return {};
  const TourCosts costs = price(stops);
  const Tour tour = first ? solveOpenTour(costs, 0) : solveOpenTour(costs);
  Plan plan;
  plan.cost = costOf(tour, costs);
  double arrival = 0.0;
  for (std::size_t i = 0; i < tour.size(); ++i) {
    arrival += i == 0 ? costs.first[tour[0]] : costs.leg(tour[i - 1], tour[i]);
    plan.stops.push_back(stops[tour[i]]);
    plan.stops.back().arrival = arrival;
  }
  if (first) return plan;
  shorten(plan);
  takeNearOne(plan);
  return plan;
}

/// Chooses viewpoints that together show every frontier that is not put off: `first`, then always the one that shows
/// most of what is not yet shown by others for the way to it. Chvatal, "A Greedy Heuristic for the Set-Covering
/// Problem", Mathematics of Operations Research 4(3), 1979.
std::vector<TourStrategy::Stop> TourStrategy::cover(std::optional<std::size_t> first) const {
  constexpr std::size_t kMostStops = 40;
  std::vector<bool> shown(evaluator_->frontiers().size(), false);
  std::vector<Stop> stops;
  if (first) stops.push_back(stopAt(*first, shown));
  while (stops.size() < kMostStops) {
    double most = 0.0;
    std::size_t best = viewpoints_.size();
    for (std::size_t v = 0; v < viewpoints_.size(); ++v) {
      const double worth = worthOf(v, shown);
      if (worth <= most) continue;
      most = worth;
      best = v;
    }
    if (best == viewpoints_.size()) break;
    stops.push_back(stopAt(best, shown));
  }
  return stops;
}

/// What a viewpoint shows of the frontiers not yet shown, per metre of the way to it.
double TourStrategy::worthOf(std::size_t viewpoint, const std::vector<bool>& shown) const {
  constexpr double kAreaOfOneMore = 20.0;  // [m^2]: counts as much as another frontier
  constexpr double kNear = 3.0;            // [m], added to the way
  double worth = 0.0;
  for (const Sight& sight : viewpoints_[viewpoint].sights) {
    if (!shown[sight.frontier] && !put_off_[sight.frontier] && !left_[sight.frontier])
      worth += 1.0 + sight.area / kAreaOfOneMore;
  }
  return worth / (kNear + wayTo(viewpoint));
}

TourStrategy::Stop TourStrategy::stopAt(std::size_t viewpoint, std::vector<bool>& shown) const {
  Stop stop;
  stop.viewpoint = viewpoint;
  for (const Sight& sight : viewpoints_[viewpoint].sights) {
    if (shown[sight.frontier] || left_[sight.frontier]) continue;
    shown[sight.frontier] = true;
    stop.frontiers.push_back(sight.frontier);
    stop.area += sight.area;
    stop.open_area = std::max(stop.open_area, open_areas_[sight.frontier]);
  }
  return stop;
}

double TourStrategy::secondsFor(double distance) const { return distance / meanSpeed(limits_); }

double TourStrategy::wayTo(std::size_t viewpoint) const {
  return evaluator_->travel().distance(viewpoints_[viewpoint].cell);
}

/// How far beyond the stop the robot is expected to be when it has seen what the unknown behind leads to [m].
double TourStrategy::exitOf(const Stop& stop) const {
  return parameters_.exit_depth * std::min(1.0, stop.open_area / parameters_.open_area);
}

TourCosts TourStrategy::price(const std::vector<Stop>& stops) {
  constexpr double kShareOfTurn = 0.7;  // of a turn on the spot: the robot turns while it drives
  TourCosts costs(stops.size());
  std::vector<std::size_t> viewpoints;
  for (const Stop& stop : stops) viewpoints.push_back(stop.viewpoint);
  distances_.connect(viewpoints);
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const std::size_t viewpoint = stops[i].viewpoint;
    costs.first[i] = secondsFor(wayTo(viewpoint)) + kShareOfTurn * distances_.turnTo(viewpoint) / limits_.max_angular +
                     secondsToLookFrom(viewpoint, robot_);
    for (std::size_t j = 0; j < stops.size(); ++j) {
      costs.leg(i, j) = secondsFor(distances_.between(viewpoint, viewpoints[j]) + exitOf(stops[i])) +
                        secondsToLookFrom(viewpoints[j], poseAt(viewpoint));
    }
    const double way_home = ways_home_[viewpoint];
    if (way_home >= 0.0) costs.last[i] = secondsFor(way_home + exitOf(stops[i]));
  }
  return costs;
}

bool TourStrategy::shows(std::size_t viewpoint, const std::vector<std::size_t>& frontiers) const {
  const std::vector<Sight>& sights = viewpoints_[viewpoint].sights;
  return std::all_of(frontiers.begin(), frontiers.end(), [&](std::size_t frontier) {
    return std::any_of(sights.begin(), sights.end(), [&](const Sight& s) { return s.frontier == frontier; });
  });
}

/// Moves the first stop to the viewpoint that shows the same frontiers with the shortest way over it to the second one.
/// The more there is to see, the less is known about the second one, and the less the way to it counts.
void TourStrategy::shorten(Plan& plan) {
  constexpr double kWorthIt = 0.1;       // [m]
  constexpr double kAllOthersNew = 6.0;  // [m^2]: after seeing this much the next stop will be another one
  Stop& first = plan.stops.front();
  const std::vector<double>* onwards = plan.stops.size() > 1 ? &distances_.from(plan.stops[1].viewpoint) : nullptr;
  const double certainty = 1.0 - std::min(1.0, first.area / kAllOthersNew);
  const auto length = [&](std::size_t v) { return wayTo(v) + (onwards != nullptr ? certainty * (*onwards)[v] : 0.0); };
  double least = length(first.viewpoint) - kWorthIt;
  for (std::size_t v = 0; v < viewpoints_.size(); ++v) {
    if (length(v) >= least || !shows(v, first.frontiers)) continue;
    least = length(v);
    first.viewpoint = v;
  }
}

}  // namespace frontier_pilot::exploration
