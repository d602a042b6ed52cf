#pragma once

#include <boost/signals2/connection.hpp>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>

#include "frontier_pilot/core/time.h"

namespace frontier_pilot {

/// Waits until published messages have been handed to the operating system.
///
/// `ros::Publisher::publish` only puts a message into a queue that roscpp's poll thread writes to the sockets, while
/// the answer to a service call is written at once by the thread that serves it. Under load the answer overtakes the
/// message by some milliseconds. A stop must not be answered before its zero has left. [ARB-7]
class PublishFlush {
 public:
  PublishFlush();
  ~PublishFlush();
  PublishFlush(const PublishFlush&) = delete;
  PublishFlush& operator=(const PublishFlush&) = delete;

  /// Returns true once every message that this thread has published so far is written to the sockets of all subscribers
  /// that read; false if that has not happened within `patience`. Must not be called from the poll thread.
  bool wait(Duration patience);

 private:
  void countRound();

  std::mutex mutex_;
  std::condition_variable round_done_;
  std::uint64_t rounds_ = 0;
  boost::signals2::connection listener_;
};

/// Waits until what a node has published before its end is written to the sockets, or for half a second, which is
/// enough on a busy machine. After a shutdown of ROS there are no sockets.
void flushLastWords();

}  // namespace frontier_pilot
