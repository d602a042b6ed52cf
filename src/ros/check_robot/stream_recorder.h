#pragma once

#include <ros/time.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "frontier_pilot/core/time.h"
#include "robot_check/observation.h"

namespace frontier_pilot {

/// Counts what arrives on a topic, or as one transform, and measures its rate and how late its stamps are.
class StreamRecorder {
 public:
  /// A message of the node `publisher`; `problem`: why it cannot be used, empty if it can.
  void add(const std::string& publisher, const std::string& frame, const ros::Time& stamp, const std::string& problem);
  robot_check::Stream summary() const;

 private:
  double rate() const;

  std::size_t count_ = 0;
  std::set<std::string> publishers_, frames_;
  std::vector<double> lags_;  ///< [s], in the order of arrival; not more than kMostLags
  std::set<Time> stamps_;     ///< the different ones; two are enough
  std::string problem_;
  Time first_ros_{}, last_ros_{};
  SteadyTime first_{}, last_{};
};

}  // namespace frontier_pilot
