#pragma once

#include <ros/node_handle.h>
#include <ros/service_client.h>

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "frontier_pilot/core/time.h"
#include "ros/common/callback_guard.h"
#include "ros/common/messages/stop_words.h"
#include "ros/fleet_stop/stop_answer.h"

namespace frontier_pilot {

/// The line to the service `emergency_stop` of one robot. It is connected before it is needed, so that a stop costs no
/// question to the master and reaches the robot even while the master is gone; a line that breaks is connected again.
/// A robot that does not confirm a stop, for instance because its arbiter is being restarted, is asked again for half a
/// minute.
/// Calls are made on a thread of the line's own, so that a robot that does not answer delays no other. [MUL-4]
class StopLine {
 public:
  StopLine(const ros::NodeHandle& node, std::string service);
  /// Waits for an attempt to connect, which may take two minutes where a computer is switched off.
  ~StopLine();
  StopLine(const StopLine&) = delete;
  StopLine& operator=(const StopLine&) = delete;

  const std::string& service() const { return service_; }
  bool connected() const { return connected_; }
  /// The service may be another node's than that to which the line leads. A stop that was confirmed, but not by an
  /// arbiter, is owed to the one that has the service now.
  void connectAnew() {
    const std::lock_guard<std::mutex> lock(mutex_);
    leads_elsewhere_ = true;
    const bool is_answered = answered_ == asked_ && answer_.outcome == StopOutcome::kConfirmed;
    owed_ = owed_ || (is_answered && !isSigned(answer_.text));
  }
  /// Lets the thread end, without waiting for it: it has when `ended` is true.
  void end();
  bool ended() const { return ended_; }
  /// Begins a call. While an earlier one waits for its answer this one follows it, one for all that are asked for
  /// meanwhile: the robot may have been told and cleared since. After some seconds the earlier one is given up, and
  /// made again over a new connection. One that cannot begin for half a minute, because connecting takes as long, is
  /// not made any more: somebody may have seen to the robot and started it meanwhile.
  void ask();
  /// The answer to the call begun last; kSilent if there is none at `deadline`.
  StopAnswer answerUntil(SteadyTime deadline);

 private:
  void run();
  void settle(std::uint64_t number, StopAnswer answer);
  /// Of a call that was made again because the robot had not confirmed the last one.
  void settleLate(std::uint64_t number, const StopAnswer& answer);
  void connect();
  bool isConnected();
  void disconnect();
  /// `kNoService` if it cannot begin before `latest`.
  StopAnswer call(SteadyTime latest);

  ros::NodeHandle node_;
  std::string service_;
  CallbackGuard guard_;
  std::atomic<bool> connected_{false};
  std::atomic<bool> leads_elsewhere_{false};
  std::atomic<bool> ended_{false};
  std::mutex mutex_;  ///< guards all that follow
  std::condition_variable wake_;
  bool ending_ = false;
  std::uint64_t asked_ = 0;                  ///< calls begun
  SteadyTime asked_at_;                      ///< when the last one was
  std::uint64_t answered_ = 0;               ///< calls that have ended
  std::optional<SteadyTime> calling_since_;  ///< while a call is under way
  StopAnswer answer_;                        ///< to the last call that has ended
  bool owed_ = false;                        ///< a call that was not confirmed is made again for a while
  ros::ServiceClient client_;
  std::thread thread_;  ///< the last member: it starts when all others are constructed
};

}  // namespace frontier_pilot
