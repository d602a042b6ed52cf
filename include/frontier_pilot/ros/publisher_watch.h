#pragma once

#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "frontier_pilot/core/time.h"
#include "frontier_pilot/ros/mailbox.h"

namespace frontier_pilot {

/// The nodes that publish on a topic.
using Publishers = std::map<std::string, std::vector<std::string>>;

/// Asks the master again and again who publishes on some topics, on a thread of its own: the master may be slow to
/// answer, or gone. [ARB-11]
class PublisherWatch {
 public:
  /// `topics` are resolved names.
  PublisherWatch(std::vector<std::string> topics, Duration period);
  ~PublisherWatch();
  PublisherWatch(const PublisherWatch&) = delete;
  PublisherWatch& operator=(const PublisherWatch&) = delete;

  /// What the master said since the last call, if it said anything.
  std::optional<Publishers> take() { return found_.take(); }

 private:
  void run();

  std::vector<std::string> topics_;
  Duration period_;
  Mailbox<Publishers> found_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace frontier_pilot
