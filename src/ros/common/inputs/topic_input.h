#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/time.h"
#include "robot_check/observation.h"
#include "ros/common/messages/heard_publishers.h"

namespace frontier_pilot {

/// A message on its way to a handler, as far as this is the same for all types.
struct Arrival {
  std::string publisher;      ///< the node that sent it
  std::string frame;          ///< its frame_id, without a leading slash
  std::optional<Time> stamp;  ///< none if it has none
};

/// A topic that one node should publish: whether messages arrive, from whom, how late their
/// stamps are, and whether several scanners share it. [ROB-2]
class TopicInput {
 public:
  /// `topic` as the node names it, such as `scan`, which is also the launch files' argument; `type` is its message's.
  TopicInput(std::string topic, std::string type);

  /// Notes a message. False: it must not be used, because it comes from a second scanner, while the first one lives.
  /// `usable()`, if given, says whether the message could be used otherwise; if not, the node is to refuse it by
  /// itself, with the reason.
  bool admit(const Arrival& arrival, SteadyTime now, Time ros_now, const std::function<bool()>& usable = {});
  /// What is missing, in words; empty while messages arrive, and while ROS time stands still or runs so slowly that the
  /// next one is not due. `topics` is what the master knows; may be empty.
  std::string missing(const std::vector<robot_check::Topic>& topics, SteadyTime now, Time ros_now) const;
  /// The frame of the last message; empty before the first one.
  const std::string& frame() const { return frame_; }
  /// How late the stamps are: the median over the last messages [s], negative if they are ahead of the clock.
  std::optional<double> lag() const;
  /// For /diagnostics: several publishers, a second scanner (an error), and stamps that are ahead or late, unless time
  /// is simulated.
  void report(diagnostic_updater::DiagnosticStatusWrapper& status, SteadyTime now, bool simulated_time) const;

 private:
  bool isSecondScanner(const Arrival& arrival, SteadyTime now) const;
  void noteLag(const Arrival& arrival, SteadyTime now, Time ros_now);
  double period() const;

  std::string topic_, type_;
  HeardPublishers publishers_;
  std::string frame_, publisher_;  ///< of the messages that are used
  std::optional<SteadyTime> heard_;
  Time heard_ros_{};    ///< the same in ROS time
  std::string second_;  ///< frame and node of the second scanner
  std::optional<SteadyTime> second_heard_;
  std::deque<double> lags_;          ///< of the last messages [s]
  std::deque<SteadyTime> arrivals_;  ///< of the same messages
};

}  // namespace frontier_pilot
