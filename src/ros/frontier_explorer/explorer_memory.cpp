#include "ros/frontier_explorer/explorer_memory.h"

#include <ros/this_node.h>

#include <limits>
#include <sstream>
#include <utility>
#include <vector>

#include "frontier_pilot/core/bounds.h"

namespace frontier_pilot {
namespace {

constexpr char kBounds = 'b', kReturns = 'r', kStays = 's', kUntold = '-', kStart = '@', kStops = '#';

void write(std::ostream& text, const std::vector<Vec2>& corners) {
  text << corners.size();
  for (const Vec2& corner : corners) text << ' ' << corner.x() << ' ' << corner.y();
}

void write(std::ostream& text, const exploration::ExplorationBounds& bounds) {
  write(text, bounds.stay_within);
  text << ' ' << bounds.keep_out.size();
  for (const std::vector<Vec2>& area : bounds.keep_out) write(text << ' ', area);
}

bool read(std::istream& text, std::vector<Vec2>& corners) {
  std::size_t count = 0;
  text >> count;
  double x = 0.0, y = 0.0;
  for (std::size_t i = 0; i < count && text >> x >> y; ++i) corners.emplace_back(x, y);
  return !text.fail();
}

bool read(std::istream& text, exploration::ExplorationBounds& bounds) {
  std::size_t areas = 0;
  if (!read(text, bounds.stay_within) || !(text >> areas)) return false;
  for (std::size_t i = 0; i < areas; ++i) {
    bounds.keep_out.emplace_back();
    if (!read(text, bounds.keep_out.back())) return false;
  }
  return bounds.problem().empty();
}

/// Whether a start that is there can be read.
bool read(std::istream& text, std::optional<Pose2>& start) {
  if ((text >> std::ws).peek() != kStart) return true;
  start.emplace();
  if (!(text.ignore() >> start->x >> start->y >> start->yaw)) return false;
  return start->isFinite() && bounds::isWithin(start->position().cwiseAbs().maxCoeff(), bounds::kMostCoordinate);
}

/// Whether a count that is there can be read.
bool read(std::istream& text, std::optional<std::uint64_t>& count) {
  if ((text >> std::ws).peek() != kStops) return true;
  return !(text.ignore() >> count.emplace()).fail();
}

}  // namespace

std::string toText(const ExplorerOrders& orders) {
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  if (orders.bounds) {
    write(text << kBounds << ' ', *orders.bounds);
  } else {
    text << kUntold;
  }
  const auto home = orders.returns_to_start;
  text << ' ' << (home ? (*home ? kReturns : kStays) : kUntold);
  if (const auto& start = orders.start) text << ' ' << kStart << start->x << ' ' << start->y << ' ' << start->yaw;
  if (orders.stops) text << ' ' << kStops << *orders.stops;
  if (orders.ended) text << ' ' << *orders.ended;
  return text.str();
}

std::optional<ExplorerOrders> ordersIn(const std::string& text) {
  std::istringstream words(text);
  ExplorerOrders orders;
  char bounds = 0, home = 0;
  words >> bounds;
  if (bounds == kBounds) {
    if (!read(words, orders.bounds.emplace())) return std::nullopt;
  } else if (bounds != kUntold) {
    return std::nullopt;
  }
  if (!(words >> home) || (home != kReturns && home != kStays && home != kUntold)) return std::nullopt;
  if (home != kUntold) orders.returns_to_start = home == kReturns;
  if (!read(words, orders.start) || !read(words, orders.stops)) return std::nullopt;
  if (std::string ended; std::getline(words >> std::ws, ended)) orders.ended = ended;
  return orders;
}

ExplorerOrders ofAnotherLaunch(const ExplorerOrders& orders) {
  ExplorerOrders kept;
  kept.bounds = orders.bounds;
  kept.stops = orders.stops;
  return kept;
}

ExplorerMemory::ExplorerMemory(NodeConnections& connections)
    : text_("exploration_orders", ros::this_node::getName(), SessionMemory::Owner::kNode, connections) {
  if (text_.left().empty()) return;
  const bool goes_on = !text_.leftByThisLaunch().empty();
  const std::string& left = goes_on ? text_.leftByThisLaunch().front() : text_.left().front();
  const auto orders = ordersIn(left);
  is_damaged_ = !orders;
  if (orders) orders_ = goes_on ? *orders : ofAnotherLaunch(*orders);
  text_.set(is_damaged_ ? left : toText(orders_));
}

std::string ExplorerMemory::whyStand() const {
  if (is_damaged_) return "what the explorer was told before cannot be read any more; it may have had bounds";
  return orders_.ended ? "the exploration had ended: " + *orders_.ended : std::string();
}

std::string ExplorerMemory::keepBounds(const exploration::ExplorationBounds& bounds) {
  orders_.bounds = bounds;
  is_damaged_ = false;
  return keep();
}

std::string ExplorerMemory::keepReturnToStart(bool returns) {
  orders_.returns_to_start = returns;
  return keep();
}

void ExplorerMemory::keepStart(const std::optional<Pose2>& start) {
  if (start == orders_.start) return;
  orders_.start = start;
  keep();
}

void ExplorerMemory::keepEnd(const std::optional<std::string>& reason) {
  if (reason == orders_.ended) return;
  orders_.ended = reason;
  keep();
}

void ExplorerMemory::keepStops(std::uint64_t stops) {
  if (stops == orders_.stops) return;
  orders_.stops = stops;
  keep();
}

void ExplorerMemory::end() {
  if (std::exchange(ended_, true)) return;
  ExplorerOrders stops;
  stops.stops = orders_.stops;
  if (stops.stops) text_.set(toText(stops));
  text_.end(!stops.stops);
}

void ExplorerMemory::leave() {
  ended_ = true;
  text_.end(false);
}

std::string ExplorerMemory::keep() {
  if (is_damaged_) return {};  // the next process has to stand, too, until the bounds are set anew
  const std::string problem = text_.set(toText(orders_));
  return problem.empty() ? problem : "; would not survive this node: " + problem;
}

}  // namespace frontier_pilot
