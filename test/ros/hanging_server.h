#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>

#include <atomic>
#include <cstddef>
#include <mutex>
#include <string>
#include <vector>

namespace frontier_pilot {

/// A service that keeps all its callers waiting until it is freed, or only the first of them.
template <class Service>
class HangingServer {
 public:
  using Request = typename Service::Request;
  enum class Hangs { kAlways, kOnce };

  explicit HangingServer(const std::string& name, Hangs hangs = Hangs::kAlways) : hangs_(hangs) {
    ros::NodeHandle node;
    node.setCallbackQueue(&queue_);
    const boost::function<bool(Request&, typename Service::Response&)> handle =
        [this](Request& request, typename Service::Response& response) {
          const bool first = add(request) == 1;
          while (!freed_ && (first || hangs_ == Hangs::kAlways)) ros::WallDuration(0.01).sleep();
          return response.success = 1;
        };
    server_ = node.advertiseService(name, handle);
    spinner_.start();
  }
  ~HangingServer() {
    free();
    spinner_.stop();
  }
  void free() { freed_ = true; }
  std::vector<Request> calls() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return calls_;
  }

 private:
  std::size_t add(const Request& request) {
    const std::lock_guard<std::mutex> lock(mutex_);
    calls_.push_back(request);
    return calls_.size();
  }

  const Hangs hangs_;
  std::atomic<bool> freed_{false};
  std::mutex mutex_;
  std::vector<Request> calls_;
  ros::CallbackQueue queue_;
  ros::ServiceServer server_;
  ros::AsyncSpinner spinner_{2, &queue_};
};

}  // namespace frontier_pilot
