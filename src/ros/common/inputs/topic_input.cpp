#include "ros/common/inputs/topic_input.h"

#include <ros/names.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "robot_check/other_names.h"

namespace frontier_pilot {
namespace {

constexpr Duration kAlive = std::chrono::seconds(3);  // without a message for this long an input is missing
constexpr std::size_t kMostLags = 50;
constexpr std::size_t kEnoughLags = 10;
constexpr double kTolerated = 0.1;  // [s] that stamps may be ahead or behind
constexpr const char* kScanType = "sensor_msgs/LaserScan";

}  // namespace

TopicInput::TopicInput(std::string topic, std::string type) : topic_(std::move(topic)), type_(std::move(type)) {}

bool TopicInput::admit(const Arrival& arrival, SteadyTime now, Time ros_now, const std::function<bool()>& usable) {
  publishers_.add(arrival.publisher, now);
  if (isSecondScanner(arrival, now)) {
    if (usable && !usable()) return true;
    second_ = arrival.frame + " of " + arrival.publisher;
    second_heard_ = now;
    return false;
  }
  frame_ = arrival.frame;
  publisher_ = arrival.publisher;
  heard_ = now;
  heard_ros_ = ros_now;
  noteLag(arrival, now, ros_now);
  return true;
}

bool TopicInput::isSecondScanner(const Arrival& arrival, SteadyTime now) const {
  const bool first_lives = heard_ && now - *heard_ <= kAlive;
  return type_ == kScanType && first_lives && arrival.frame != frame_ && arrival.publisher != publisher_;
}

void TopicInput::noteLag(const Arrival& arrival, SteadyTime now, Time ros_now) {
  if (!arrival.stamp || ros_now == Time{}) return;
  lags_.push_back(toSeconds(ros_now - *arrival.stamp));
  arrivals_.push_back(now);
  if (lags_.size() <= kMostLags) return;
  lags_.pop_front();
  arrivals_.pop_front();
}

std::optional<double> TopicInput::lag() const {
  if (lags_.size() < kEnoughLags) return std::nullopt;
  std::vector<double> sorted(lags_.begin(), lags_.end());
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return *middle;
}

/// The mean time between two messages [s].
double TopicInput::period() const {
  if (arrivals_.size() < 2) return 0.0;
  return toSeconds(arrivals_.back() - arrivals_.front()) / static_cast<double>(arrivals_.size() - 1);
}

std::string TopicInput::missing(const std::vector<robot_check::Topic>& topics, SteadyTime now, Time ros_now) const {
  const bool due = now - heard_.value_or(now) > kAlive && std::abs(toSeconds(ros_now - heard_ros_)) > toSeconds(kAlive);
  if (heard_ && !due) return {};
  const std::string name = ros::names::resolve(topic_);
  if (topics.empty()) return "nothing arrives on " + name;
  const robot_check::Topic* topic = robot_check::findTopic(topics, name);
  if (topic == nullptr || topic->publishers.empty() || topic->type != type_)
    return robot_check::sayMissingTopic(topics, name, type_, topic_);
  return name + " is published by " + topic->publishers.front() + ", but nothing arrives";
}

void TopicInput::report(diagnostic_updater::DiagnosticStatusWrapper& status, SteadyTime now,
                        bool simulated_time) const {
  using diagnostic_msgs::DiagnosticStatus;
  const std::string names = publishers_.severalNames(now);
  if (!names.empty())
    status.mergeSummaryf(DiagnosticStatus::WARN, "several nodes publish %s: %s", topic_.c_str(), names.c_str());
  if (second_heard_ && now - *second_heard_ <= kAlive) {
    status.mergeSummary(DiagnosticStatus::ERROR, "several scanners publish " + topic_ + ": " + frame_ + " of " +
                                                     publisher_ + " is used, " + second_ +
                                                     " is refused: merge them into one scan, for example with " +
                                                     "laserscan_multi_merger of ira_laser_tools");
  }
  const std::optional<double> late = lag();
  if (!late) return;
  status.addf("stamps of " + topic_ + " behind the clock [s]", "%.3f", *late);
  // A scan is stamped when its first beam is measured, and sent after the last one.
  const double most = kTolerated + (type_ == kScanType ? period() : 0.0);
  if (simulated_time || (*late >= -kTolerated && *late <= most)) return;
  status.mergeSummaryf(DiagnosticStatus::WARN, "the stamps of %s are %.2f s %s: do the clocks of the computers differ?",
                       topic_.c_str(), std::abs(*late), *late < 0.0 ? "ahead" : "late");
}

}  // namespace frontier_pilot
