#include <cstdio>
#include <map>
#include <string>

#include "exploration/explorer_impl.h"

namespace frontier_pilot::exploration {
namespace {

std::string place(const Vec2& position) {
  char text[48];
  std::snprintf(text, sizeof text, "(%.1f, %.1f)", position.x(), position.y());
  return text;
}

/// The stops after the present one.
std::string listNext(const std::vector<Vec2>& tour) {
  constexpr std::size_t kMost = 5;
  if (tour.size() < 2) return "";
  std::string text = " Then:";
  for (std::size_t i = 1; i < tour.size() && i <= kMost; ++i) text += (i > 1 ? ", " : " ") + place(tour[i]);
  if (tour.size() > kMost + 1) text += " and " + std::to_string(tour.size() - kMost - 1) + " more";
  return text + ".";
}

/// How many frontiers cannot be chosen, by the reason.
std::string listRejected(const std::vector<Frontier>& frontiers) {
  std::map<Rejection, int> counts;
  for (const Frontier& frontier : frontiers) {
    if (!frontier.selectable()) ++counts[frontier.rejection];
  }
  if (counts.empty()) return "";
  std::string text;
  for (const auto& [reason, count] : counts) {
    text += (text.empty() ? " Left out: " : ", ") + std::to_string(count) + " " + toString(reason);
  }
  return text + ".";
}

}  // namespace

std::string Explorer::Impl::explain() const {
  const std::string others = listRejected(evaluator_.frontiers());
  const std::string state = std::string(toString(status_.state)) + ": ";
  if (!goal_)
    return state + (status_.reason_text.empty() ? toString(status_.reason) : status_.reason_text) + "." + others;
  const std::string to = std::string(toString(status_.reason)) + ". The goal is " + place(goal_->position);
  switch (goal_->purpose) {
    case Goal::Purpose::kReturn:
      return state + to + ", the start." + others;
    case Goal::Purpose::kStepBack:
      return state + to + ", to get away from a frontier that is too near." + others;
    case Goal::Purpose::kInspection:
      return state + to + ", which somebody wants inspected." + others;
    case Goal::Purpose::kFrontier:
      break;
  }
  return state + to + (chosen_.why.empty() ? "" : ", " + chosen_.why) + "." + listNext(chosen_.tour) + others;
}

}  // namespace frontier_pilot::exploration
