#pragma once

#include <ros/node_handle.h>
#include <ros/service_client.h>

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

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

/// How an answer is shown: one that leaves a doubt whether the robot stands is no plain success.
teleop::Severity severityOfAnswer(bool success, const std::string& said);

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

  /// What becomes of a call that cannot be made at once, because another one waits for its answer: it is right however
  /// late it is, as what ends a motion, or it is dropped after two seconds, with a word to the operator.
  enum class Late { kDone, kDropped };
  /// What the answer to a stop has to have: that of an arbiter is signed by it.
  enum class Signature { kNone, kOfArbiter };

  /// Calls a std_srvs/SetBool. A call of the same service that is still queued is replaced, as with all that follow,
  /// and the operator is told if it asked for something else. While a call with the same value waits for its answer,
  /// another one is not made: it would be carried out later than what others have asked for meanwhile, and might clear
  /// a stop that nobody has seen here.
  void set(const std::string& service, bool value, Late late = Late::kDropped);
  /// Calls a std_srvs/Trigger.
  void trigger(const std::string& service);
  /// Drops the calls that are not right however late they are and that have not been sent yet. For a stop that came
  /// after them.
  void dropWhatWaits(const std::string& why);
  /// Calls a std_srvs/Trigger again and again for ten seconds until there is an answer, or until `withdraw`: whoever
  /// presses stop while the arbiter is being restarted has pressed it. A connection on which no answer comes is given
  /// up after `patience`, and after twice as long each time that follows, and another one is made: after an outage of
  /// the network the old one may hang for minutes. A service that answers later than that is called again.
  /// While the master does not answer, or has no such service, the connection that was made before is used.
  /// A success that lacks the `expected` signature is logged as a doubt. [ARB-12]
  void insist(const std::string& service, Duration patience, Signature expected = Signature::kNone);
  void withdraw();
  /// Waits, as long as `running`, until the calls that insist have come to their end, and says so: whoever presses stop
  /// and closes the window has pressed it.
  void finishInsisting(const std::function<bool()>& running);
  /// Connects to a service that may have to be insisted on, unless that has been done, so that the call needs no
  /// master. Tries once a second at most, and only while it is `seen` at the master. To be called periodically.
  void getReady(const std::string& service, bool seen);
  /// Whether there is such a connection. Its other end may have been unreachable for minutes without a sign of it here.
  bool isReady(const std::string& service);
  /// Calls the mapper's SaveMap, which is right however late it is, or LoadMap, which is not, with a path.
  void saveMap(const std::string& service, const std::string& path);
  void loadMap(const std::string& service, const std::string& path);
  /// Logs, once for each call, that it has been without an answer for too long, and gives up the connections of a stop
  /// on which no answer comes. To be called periodically.
  void lookAfter(SteadyTime now);

 private:
  struct Call {
    enum class Type { kSetBool, kTrigger, kSaveMap, kLoadMap };
    std::string service;
    Type type = Type::kTrigger;
    Late late = Late::kDropped;
    bool value = false;  ///< of a SetBool
    std::string path{};  ///< of a map
    bool insists = false;
    Duration patience{};  ///< of a call that insists, for an answer on its first connection
    Signature expected = Signature::kNone;
    SteadyTime asked_at{};

    /// For the operator, with all that it asks for.
    std::string text() const;
  };
  static constexpr Duration kInsists = std::chrono::seconds(10);
  struct Answer {
    bool success = false;
    std::string message;
  };

  void post(Call call);
  /// Takes the queued calls out for which `which` is true. The caller holds the lock.
  std::vector<Call> takeOut(const std::function<bool(const Call&)>& which);
  void sayNotDone(const Call& call, const std::string& why);
  bool isUnderWay(const Call& call) const;
  /// The service of a call that insists and is queued or under way; nothing if there is none.
  std::optional<std::string> whatInsists();
  void run();
  void tryPerform(const Call& call);
  void perform(const Call& call);
  /// The server's answer; nothing if there is none. roscpp waits for ever for a master that hangs, so the master is
  /// asked first whether it answers.
  std::optional<Answer> attempt(const Call& call);
  bool masterAnswers();
  bool isSeen(const std::string& service);
  /// Over a new connection.
  std::optional<Answer> ask(const Call& call);
  std::optional<Answer> askAgain(const Call& call);
  /// Over the connection that was made before.
  std::optional<Answer> askReady(const Call& call);
  template <class Service>
  std::optional<Answer> ask(const std::string& name, Service& service);
  template <class Service>
  std::optional<Answer> ask(ros::ServiceClient client, Service& service);
  /// The caller holds the lock, which is not held meanwhile.
  void connectAhead(std::unique_lock<std::mutex>& lock);
  /// False if the service could not be connected to, if the call is not to be made any more, or if this object is being
  /// destroyed.
  bool begin(const ros::ServiceClient& client);
  bool isEnding();
  bool isCalledOff();
  SteadyTime insistsUntil();
  std::string whyNone();
  std::string whyNotDone();
  /// The caller holds the lock.
  void giveUpASilentStop(SteadyTime now);

  ros::NodeHandle node_;
  OperatorLog log_;
  ServiceAnswered answered_;
  CallbackGuard guard_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<Call> calls_;
  ros::ServiceClient client_;  ///< of the call in progress
  ros::ServiceClient ready_;   ///< connected before it is needed
  std::string ready_service_;  ///< to which `ready_` leads, or is to lead
  bool to_connect_ = false;
  bool seen_ = true;           ///< at the master, as far as is known
  SteadyTime connected_at_{};  ///< when that was tried last
  std::optional<Call> under_way_;
  std::optional<SteadyTime> since_;         ///< when the call that is under way was begun; none once it was called slow
  SteadyTime insists_until_{};              ///< until when a call that insists is made again
  std::optional<SteadyTime> asking_since_;  ///< when its last connection was made; none once that was given up
  Duration patience_{};                     ///< for an answer on the present connection of a call that insists
  std::string why_not_;                     ///< why the call that is under way is not made; empty if it is
  bool sent_ = false;                       ///< it cannot be taken back
  bool gave_up_ = false;
  bool no_master_ = false;  ///< it did not answer when it was asked last
  bool withdrawn_ = false;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace frontier_pilot
