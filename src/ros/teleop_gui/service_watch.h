#pragma once

#include <ros/node_handle.h>

#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>

#include "ros/common/callback_guard.h"
#include "ros/teleop_gui/service_probe.h"

namespace frontier_pilot {

/// Knows which services are available, by checking them once a second on a thread of its own. A master that hangs
/// holds that thread, and so the destructor, for two seconds.
class ServiceWatch {
 public:
  /// `appeared` is called on that thread when a service has become available.
  ServiceWatch(const ros::NodeHandle& node, std::function<void(const std::string&)> appeared);
  ~ServiceWatch();
  ServiceWatch(const ServiceWatch&) = delete;
  ServiceWatch& operator=(const ServiceWatch&) = delete;

  /// An invalid name is ignored, and its service is never up.
  void watch(const std::string& service);
  bool up(const std::string& service) const;
  bool masterUp() const;

 private:
  void run();
  void lookOnce();
  bool isEnding() const;

  ros::NodeHandle node_;
  std::function<void(const std::string&)> appeared_;
  CallbackGuard guard_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::map<std::string, bool> up_;
  bool master_up_ = true;
  bool stopping_ = false;
  std::map<std::string, ServiceProbe> probes_;  ///< used by the thread alone
  std::thread thread_;
};

}  // namespace frontier_pilot
