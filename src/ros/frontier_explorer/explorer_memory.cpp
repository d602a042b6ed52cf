#include "ros/frontier_explorer/explorer_memory.h"

#include <ros/this_node.h>

#include <limits>
#include <sstream>
#include <vector>

namespace frontier_pilot {
namespace {

constexpr const char* kReturns = "returns to the start";
constexpr const char* kStays = "stays where the exploration ends";

void write(std::ostream& text, const std::vector<Vec2>& corners) {
  text << corners.size();
  for (const Vec2& corner : corners) text << ' ' << corner.x() << ' ' << corner.y();
}

bool read(std::istream& text, std::vector<Vec2>& corners) {
  std::size_t count = 0;
  text >> count;
  double x = 0.0, y = 0.0;
  for (std::size_t i = 0; i < count && text >> x >> y; ++i) corners.emplace_back(x, y);
  return !text.fail();
}

std::string inWords(const std::string& problem) {
  return problem.empty() ? problem : "; would not survive a restart: " + problem;
}

std::string nodeName() { return ros::this_node::getName(); }

}  // namespace

std::string toText(const exploration::ExplorationBounds& bounds) {
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  write(text, bounds.stay_within);
  text << ' ' << bounds.keep_out.size();
  for (const std::vector<Vec2>& area : bounds.keep_out) write(text << ' ', area);
  return text.str();
}

std::optional<exploration::ExplorationBounds> boundsIn(const std::string& text) {
  std::istringstream words(text);
  exploration::ExplorationBounds bounds;
  std::size_t areas = 0;
  if (!read(words, bounds.stay_within) || !(words >> areas)) return std::nullopt;
  for (std::size_t i = 0; i < areas; ++i) {
    bounds.keep_out.emplace_back();
    if (!read(words, bounds.keep_out.back())) return std::nullopt;
  }
  if (words >> std::ws && !words.eof()) return std::nullopt;
  return bounds.problem().empty() ? std::optional<exploration::ExplorationBounds>(bounds) : std::nullopt;
}

ExplorerMemory::ExplorerMemory(NodeConnections& connections)
    : bounds_("exploration_bounds", nodeName(), SessionMemory::Owner::kNode, connections),
      return_("return_to_start", nodeName(), SessionMemory::Owner::kNode, connections),
      end_("exploration_end", nodeName(), SessionMemory::Owner::kNode, connections) {
  for (RememberedText* text : {&bounds_, &return_, &end_}) {
    if (!text->left().empty()) text->set(text->left().front());
  }
  if (!end_.left().empty()) ended_ = end_.left().front();
}

void ExplorerMemory::end() {
  for (RememberedText* text : {&bounds_, &return_, &end_}) text->end(true);
}

ExplorerMemory::Left ExplorerMemory::left() const {
  Left left;
  if (!end_.left().empty()) left.why_stand = "the exploration had ended: " + end_.left().front();
  if (!return_.left().empty()) left.returns_to_start = return_.left().front() == kReturns;
  if (bounds_.left().empty()) return left;
  left.bounds = boundsIn(bounds_.left().front());
  if (!left.bounds) left.why_stand = "the bounds that were set for the exploration cannot be read any more";
  return left;
}

std::string ExplorerMemory::keepBounds(const exploration::ExplorationBounds& bounds) {
  return inWords(bounds_.set(toText(bounds)));
}

std::string ExplorerMemory::keepReturnToStart(bool returns) {
  return inWords(return_.set(returns ? kReturns : kStays));
}

void ExplorerMemory::keepEnd(const std::optional<std::string>& reason) {
  if (reason == ended_) return;
  ended_ = reason;
  end_.set(reason);
}

}  // namespace frontier_pilot
