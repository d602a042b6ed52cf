#include <algorithm>
#include <limits>

#include "exploration/tour/tour_strategy.h"

/// The frontiers behind which little is expected: which of them wait until no others are left, which are left for good,
/// and which are taken on the way. [EXP-9]
namespace frontier_pilot::exploration {
namespace {

constexpr double kNotTold = std::numeric_limits<double>::infinity();

}  // namespace

void TourStrategy::expectAreas() {
  expected_.assign(evaluator_->frontiers().size(), kNotTold);
  for (const SoughtFrontier& each : sought_) {
    if (!slivers_[each.index]) expected_[each.index] = expectedAreaAt(each.index);
  }
}

/// The floor that a frontier is expected to lead to: a share of the unknown area that its best viewpoint shows, smaller
/// for a narrow frontier, and at most the unknown area around it. A frontier that the beams from the viewpoints hardly
/// hit is taken to show as much as one of its width usually does. Fitted to what lay behind the frontiers of the
/// invented buildings for tuning (docs/decisions/0025-large-areas-first.md). Behind a wide frontier, or at the end of a
/// passage, anything may lie.
double TourStrategy::expectedAreaAt(std::size_t frontier) {
  constexpr double kWide = 3.0;        // [m]
  constexpr double kFree = 0.4;        // share of what is in sight that turns out to be floor
  constexpr double kOpenWidth = 1.2;   // [m]: from which on that holds
  constexpr double kOpenSight = 1.5;   // [m^2]: what shows more is open at a smaller width
  constexpr double kLeastSight = 0.4;  // [m^2/m]
  const int cells = evaluator_->clusters().clusters[frontier].component_cells;
  const double width = cells * evaluator_->map().geometry().resolution;
  if (width >= kWide) return kNotTold;
  const double in_sight = std::max(search_.mostOf(frontier), kLeastSight * width);
  const double openness = std::min(1.0, width / kOpenWidth * std::max(1.0, in_sight / kOpenSight));
  const double area = std::min(open_areas_[frontier], kFree * in_sight * openness * openness);
  const bool small = area < parameters_.small_area;  // what is not small is not put off anyway
  return small && passages_.contains(evaluator_->frontiers()[frontier].anchor, evaluator_->map()) ? kNotTold : area;
}

/// Puts off the small ones with the least expected area for the way to them, as long as all of them together are a
/// small share of the known floor. While others are left, what is put off waits; after that it is left for good.
void TourStrategy::putOffSmallOnes() {
  const auto isOthers = [&](const SoughtFrontier& each) {
    return !slivers_[each.index] && !left_[each.index] && expected_[each.index] >= parameters_.small_area;
  };
  const bool others_left = std::any_of(sought_.begin(), sought_.end(), isOthers);
  const double most = others_left ? parameters_.small_area : parameters_.most_left;
  std::vector<std::size_t> small;
  for (const SoughtFrontier& each : sought_) {
    if (!slivers_[each.index] && !left_[each.index] && expected_[each.index] < most) small.push_back(each.index);
  }
  const auto worth = [&](std::size_t i) {
    constexpr double kNear = 3.0;  // [m], added to the way
    return expected_[i] / (kNear + evaluator_->frontiers()[i].distance);
  };
  std::stable_sort(small.begin(), small.end(), [&](std::size_t a, std::size_t b) { return worth(a) < worth(b); });
  const double left_share = all_sought_ ? parameters_.left_share : 0.0;
  const double share = others_left ? parameters_.put_off_share : left_share;
  double room = share * evaluator_->map().freeArea();
  put_off_ = slivers_;
  for (const std::size_t i : small) {
    room -= expected_[i];
    put_off_[i] = room > 0.0;
  }
}

/// The longest detour for what a viewpoint shows of the frontiers that are put off and that no stop shows [s]; 0 if it
/// shows none.
double TourStrategy::detourFor(const Viewpoint& viewpoint, const std::vector<bool>& shown) const {
  double longest = 0.0;
  for (const Sight& sight : viewpoint.sights) {
    const std::size_t i = sight.frontier;
    if (!put_off_[i] || shown[i] || left_[i]) continue;
    const double detour = parameters_.small_detour + parameters_.detour_per_area * expected_[i];
    longest = std::max(longest, slivers_[i] ? parameters_.sliver_detour : detour);
  }
  return longest;
}

/// Puts the viewpoint of a frontier that is put off first if the detour over it is short enough.
void TourStrategy::takeNearOne(Plan& plan) {
  std::vector<bool> shown(evaluator_->frontiers().size(), false);
  for (const Stop& stop : plan.stops) {
    for (const Sight& sight : viewpoints_[stop.viewpoint].sights) shown[sight.frontier] = true;
  }
  const std::size_t first = plan.stops.front().viewpoint;
  const std::vector<double>& from_first = distances_.from(first);
  double least = 1.0;  // share of the longest detour
  double taken = 0.0;  // [s]
  std::optional<std::size_t> best;
  for (std::size_t v = 0; v < viewpoints_.size(); ++v) {
    const double longest = detourFor(viewpoints_[v], shown);
    const double detour = secondsFor(wayTo(v) + from_first[v] - wayTo(first));
    if (longest <= 0.0 || detour >= least * longest) continue;
    least = detour / longest;
    taken = detour;
    best = v;
  }
  if (!best) return;
  plan.cost += taken;
  for (Stop& stop : plan.stops) stop.arrival += taken;
  plan.stops.insert(plan.stops.begin(), stopAt(*best, shown));
  plan.stops.front().arrival = secondsFor(wayTo(*best));
}

}  // namespace frontier_pilot::exploration
