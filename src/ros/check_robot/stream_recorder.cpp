#include "ros/check_robot/stream_recorder.h"

#include <algorithm>

#include "ros/common/clock.h"

namespace frontier_pilot {
namespace {

constexpr std::size_t kMostLags = 10000;
constexpr std::size_t kMostNames = 8;  // enough for the operator

void insertSome(std::set<std::string>& names, const std::string& name) {
  if (names.size() < kMostNames) names.insert(name);
}

}  // namespace

void StreamRecorder::add(const std::string& publisher, const std::string& frame, const ros::Time& stamp,
                         const std::string& problem) {
  const Time now = rosNow();
  if (count_++ == 0) {
    first_ros_ = now;
    first_ = steadyNow();
  }
  last_ros_ = now;
  last_ = steadyNow();
  insertSome(publishers_, publisher);
  insertSome(frames_, frame);
  if (stamps_.size() < 2) stamps_.insert(toTime(stamp));
  if (!problem.empty()) problem_ = problem;
  if (now != Time{} && !stamp.isZero() && lags_.size() < kMostLags) lags_.push_back(toSeconds(now - toTime(stamp)));
}

/// In ROS time, which is what the nodes go by; in steady time while there is none.
double StreamRecorder::rate() const {
  if (count_ < 2) return 0.0;
  const double ros = toSeconds(last_ros_ - first_ros_);
  const double seconds = ros > 0.0 ? ros : toSeconds(last_ - first_);
  return seconds > 0.0 ? static_cast<double>(count_ - 1) / seconds : 0.0;
}

robot_check::Stream StreamRecorder::summary() const {
  robot_check::Stream stream;
  stream.count = count_;
  stream.rate = rate();
  stream.publishers.assign(publishers_.begin(), publishers_.end());
  stream.frames.assign(frames_.begin(), frames_.end());
  stream.stamps_advance = count_ < 3 || stamps_.size() > 1;
  stream.problem = problem_;
  if (!lags_.empty()) {
    std::vector<double> sorted = lags_;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    stream.lag = *middle;
  }
  return stream;
}

}  // namespace frontier_pilot
