#pragma once

#include <ros/node_handle.h>
#include <ros/service_client.h>

#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "frontier_pilot/core/time.h"
#include "ros/common/callback_guard.h"
#include "teleop/operator_link.h"

namespace frontier_pilot {

/// Adds a line to the operator's log; may be called from any thread.
using OperatorLog = std::function<void(teleop::Severity, const std::string&)>;

/// Writes a line for the operator into the node's own log as well.
void logForOperator(teleop::Severity severity, const std::string& text);

/// Told of the answer to a call, or why there is none: whether it succeeded, and a message; may be called from any
/// thread.
using ServiceAnswered = std::function<void(const std::string& service, bool success, const std::string& message)>;

/// Whether `service` is a valid ROS name. For an invalid one roscpp throws, also in threads where nothing catches it.
bool isServiceName(const std::string& service);

/// Calls services on a thread of its own, one after the other, and logs their answers. The destructor ends a call that
/// is waiting, even if the server never answers.
class ServiceCaller {
 public:
  ServiceCaller(const ros::NodeHandle& node, OperatorLog log, ServiceAnswered answered = {});
  ~ServiceCaller();
  ServiceCaller(const ServiceCaller&) = delete;
  ServiceCaller& operator=(const ServiceCaller&) = delete;

  /// Calls a std_srvs/SetBool. A call of the same service that is still queued is replaced. While a call with the same
  /// value waits for its answer, another one is not made: it would be carried out later than what others have asked for
  /// meanwhile, and might clear a stop that nobody has seen here.
  void set(const std::string& service, bool value);
  /// Calls a std_srvs/Trigger.
  void trigger(const std::string& service);
  /// Calls a std_srvs/Trigger again and again for ten seconds until there is an answer, or until `withdraw`: whoever
  /// presses stop while the arbiter is being restarted has pressed it.
  void insist(const std::string& service);
  void withdraw();
  /// Calls the mapper's SaveMap or LoadMap with a path.
  void saveMap(const std::string& service, const std::string& path);
  void loadMap(const std::string& service, const std::string& path);
  /// Logs, once for each call, that it has been without an answer for too long. To be called periodically.
  void reportSlow(SteadyTime now);

 private:
  struct Call {
    enum class Type { kSetBool, kTrigger, kSaveMap, kLoadMap };
    std::string service;
    Type type = Type::kTrigger;
    bool value = false;  ///< of a SetBool
    std::string path;    ///< of a map
    bool insists = false;
  };
  struct Answer {
    bool success = false;
    std::string message;
  };

  void post(const Call& call);
  bool isUnderWay(const Call& call) const;
  void run();
  void tryPerform(const Call& call);
  void perform(const Call& call);
  /// The server's answer; nothing if there is none.
  std::optional<Answer> ask(const Call& call);
  std::optional<Answer> askAgain(const Call& call);
  template <class Service>
  std::optional<Answer> ask(const std::string& name, Service& service);
  /// False if the service could not be connected to, or if this object is being destroyed.
  bool begin(const ros::ServiceClient& client);
  bool isEnding();

  ros::NodeHandle node_;
  OperatorLog log_;
  ServiceAnswered answered_;
  CallbackGuard guard_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<Call> calls_;
  ros::ServiceClient client_;  ///< of the call in progress
  std::optional<Call> under_way_;
  std::optional<SteadyTime> since_;  ///< when the call that is under way was begun; none once it was called slow
  bool withdrawn_ = false;
  bool stopping_ = false;
  std::thread thread_;
};

/// Knows which services are available, by checking them once a second on a thread of its own.
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

  ros::NodeHandle node_;
  std::function<void(const std::string&)> appeared_;
  CallbackGuard guard_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::map<std::string, bool> up_;
  bool master_up_ = true;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace frontier_pilot
