#pragma once

#include <frontier_pilot/ArbiterStatus.h>
#include <ros/node_handle.h>
#include <ros/steady_timer.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/Bool.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ros/common/callback_guard.h"
#include "ros/common/clock.h"
#include "ros/common/clock_monitor.h"
#include "ros/common/inputs/input_watch.h"
#include "ros/common/inputs/stop_follower.h"
#include "ros/common/inputs/topic_input.h"
#include "ros/common/inputs/transform_input.h"
#include "ros/common/master/master_watch.h"
#include "ros/common/memory/memory_report.h"
#include "ros/common/messages/checked_subscription.h"
#include "ros/common/messages/latched_repeats.h"
#include "ros/common/messages/service_answer.h"
#include "ros/common/names.h"
#include "ros/common/ros_timer.h"
#include "ros/common/tf/frame_name.h"

namespace frontier_pilot {

/// Whether a node waits for an input and says so as long as that is missing.
enum class Need { kNeeded, kOptional };

/// A node's subscriptions, services and timers, for as long as this object lives. Every callback is guarded: exceptions
/// are counted and logged, and the node goes on (with roscpp alone the node would end, or that timer would never be
/// called again). Registrations that the master has lost are renewed. This must be the last member of a node, because
/// its callbacks use the others. [FLT-1]
class NodeConnections {
 public:
  /// `master_period` is the time between two looks at what the master knows of this node.
  explicit NodeConnections(const ros::NodeHandle& node, Duration master_period = std::chrono::milliseconds(1200))
      : node_(node), clock_(node), master_(master_period) {
    everySteady(ros::WallDuration(1.0), [this] {
      master_.listTopics(inputs_.needsSomething() && !inputs_.ready());
      if (inputs_.needsSomething()) inputs_.look(master_.topics(), steadyNow());
    });
  }

  /// The whole name of a topic or service, with the namespace and the remappings of the node's handle.
  std::string resolve(const std::string& name) const { return node_.resolveName(name); }

  /// `handle(const Msg&)` for each message of `topic`.
  template <class Msg, class F>
  ros::Subscriber subscribe(const std::string& topic, std::uint32_t queue_size, F handle,
                            const ros::TransportHints& hints = {}) {
    return subscribeToEvents<Msg>(
        topic, queue_size, [handle](const ros::MessageEvent<const Msg>& event) { handle(*event.getConstMessage()); },
        hints);
  }
  template <class Node, class Msg>
  ros::Subscriber subscribe(const std::string& topic, std::uint32_t queue_size, void (Node::*handle)(const Msg&),
                            Node* node, const ros::TransportHints& hints = {}) {
    return subscribe<Msg>(
        topic, queue_size, [node, handle](const Msg& msg) { (node->*handle)(msg); }, hints);
  }
  /// The same with the message's event, which names the node that published it.
  template <class Msg, class F>
  ros::Subscriber subscribeToEvents(const std::string& topic, std::uint32_t queue_size, F handle,
                                    const ros::TransportHints& hints = {}) {
    const boost::function<void(const ros::MessageEvent<const Msg>&)> guarded =
        [this, what = messageOf(topic), handle](const ros::MessageEvent<const Msg>& event) {
          guard_.run(what, [&] { handle(event); });
        };
    ros::SubscribeOptions options = checkedSubscription<Msg>(topic, queue_size, unreadable_, guarded, hints);
    const auto has_ended = [](const ros::Subscriber& subscriber) { return !subscriber; };
    subscribers_.erase(std::remove_if(subscribers_.begin(), subscribers_.end(), has_ended), subscribers_.end());
    subscribers_.push_back(node_.subscribe(options));
    return subscribers_.back();
  }

  /// The same as `subscribe`, for commands: one that was published before, and that a latching publisher delivers
  /// again, is dropped. In the first `settling` that holds for the first message of each latching publisher, and later
  /// for that of one which is connected late.
  template <class Msg, class F>
  ros::Subscriber subscribeToCommands(const std::string& topic, std::uint32_t queue_size, F handle,
                                      const ros::TransportHints& hints = {}, Duration settling = settlingOfARestart()) {
    const auto repeats = std::make_shared<LatchedRepeats>(node_.resolveName(topic), steadyNow(), settling);
    if (settling > Duration::zero()) everySteady(ros::WallDuration(0.1), [repeats] { repeats->look(steadyNow()); });
    return subscribeToEvents<Msg>(
        topic, queue_size,
        [repeats, topic, handle](const ros::MessageEvent<const Msg>& event) {
          if (repeats->isRepeat(event.getConnectionHeaderPtr(), steadyNow())) {
            sayRepeat(topic, event.getPublisherName());
          } else {
            handle(*event.getConstMessage());
          }
        },
        hints);
  }
  template <class Node, class Msg>
  ros::Subscriber subscribeToCommands(const std::string& topic, std::uint32_t queue_size,
                                      void (Node::*handle)(const Msg&), Node* node) {
    return subscribeToCommands<Msg>(topic, queue_size, [node, handle](const Msg& msg) { (node->*handle)(msg); });
  }

  /// The same as `subscribe`, for a topic that only one node should publish, such as `scan` or `odom`, and for which
  /// the node waits if it is `need`ed: report() says whether messages arrive, how late their stamps are, and who
  /// publishes when there are several. Messages of all of them are used, but not those of a second scanner in another
  /// frame; `usable(msg)`, if given, says which of those could be used: the others are passed on, for the node to
  /// refuse them by itself. [ROB-2]
  template <class Msg, class F>
  ros::Subscriber subscribeToOne(const std::string& topic, std::uint32_t queue_size, F handle,
                                 const ros::TransportHints& hints = {}, Need need = Need::kNeeded,
                                 const std::function<bool(const Msg&)>& usable = {}) {
    const auto input = std::make_shared<TopicInput>(topic, ros::message_traits::DataType<Msg>::value());
    one_[topic] = input;
    if (need == Need::kNeeded) {
      inputs_.need([input](const InputWatch::Topics& topics) { return input->missing(topics, steadyNow(), rosNow()); });
    }
    return subscribeToEvents<Msg>(
        topic, queue_size,
        [input, handle, usable](const ros::MessageEvent<const Msg>& event) {
          const Msg& msg = *event.getConstMessage();
          const auto may_be_used = [&] { return !usable || usable(msg); };
          if (input->admit(arrivalOf(msg, event.getPublisherName()), steadyNow(), rosNow(), may_be_used)) handle(msg);
        },
        hints);
  }
  template <class Node, class Msg>
  ros::Subscriber subscribeToOne(const std::string& topic, std::uint32_t queue_size, void (Node::*handle)(const Msg&),
                                 Node* node, const ros::TransportHints& hints = {}, Need need = Need::kNeeded) {
    return subscribeToOne<Msg>(
        topic, queue_size, [node, handle](const Msg& msg) { (node->*handle)(msg); }, hints, need);
  }

  /// The same for `scan`; the node also waits for where the scanner is mounted on the base. `tf` must outlive it.
  template <class Node>
  ros::Subscriber subscribeToScanner(const TfBridge& tf, const std::string& base_frame, std::uint32_t queue_size,
                                     void (Node::*handle)(const sensor_msgs::LaserScan&), Node* node,
                                     const ros::TransportHints& hints = {}) {
    ros::Subscriber subscriber = subscribeToOne<sensor_msgs::LaserScan>(
        names::kScan, queue_size, [node, handle](const sensor_msgs::LaserScan& msg) { (node->*handle)(msg); }, hints,
        Need::kNeeded, scansThatCanBeUsed(tf, base_frame));
    inputs_.need(needMount(tf, base_frame, [input = one_.at(names::kScan)] { return input->frame(); }));
    return subscriber;
  }

  /// For each message of `emergency_stop_state`, and for what a node that was held up may have missed of them: see
  /// StopFollower. [FLT-2]
  template <class Node>
  void followStop(void (Node::*handle)(const std_msgs::Bool&), Node* node) {
    constexpr std::uint32_t kStopsAndClears = 10;  // so that a stop is read that was cleared before this node could
    const auto tell = [handle, node](bool stopped) {
      std_msgs::Bool msg;
      msg.data = static_cast<std::uint8_t>(stopped);
      (node->*handle)(msg);
    };
    const auto follower = std::make_shared<StopFollower>(tell, anyMayLive);
    const ros::Subscriber state = subscribe<std_msgs::Bool>(
        names::kEmergencyStopState, kStopsAndClears,
        [this, follower](const std_msgs::Bool& msg) {
          clock_.now();  // notices a hold-up
          follower->take(msg.data != 0, clock_.holdUps());
        },
        ros::TransportHints().tcpNoDelay());
    subscribeToEvents<ArbiterStatus>(
        names::kArbiterStatus, 1,
        [this, follower](const ros::MessageEvent<const ArbiterStatus>& event) {
          const ArbiterStatus& msg = *event.getConstMessage();
          clock_.now();
          follower->count(event.getPublisherName(), msg.stops, msg.emergency_stop != 0, clock_.holdUps());
        },
        ros::TransportHints().tcpNoDelay());
    everySteady(ros::WallDuration(0.05), [this, follower, topic = state.getTopic()] {
      clock_.now();
      follower->tick(master_.connectedPublishersOf(topic), clock_.holdUps(), clock_.isCatchingUp());
    });
  }

  /// `handle(request, response)` answers calls of `service`; if it throws, the answer says why. The calls come from
  /// `queue`, or from that of the node.
  template <class Node, class Request, class Response>
  void serve(const std::string& service, bool (Node::*handle)(Request&, Response&), Node* node) {
    serve<Request, Response>(
        service, [node, handle](Request& request, Response& response) { return (node->*handle)(request, response); });
  }
  template <class Request, class Response, class F>
  void serve(const std::string& service, F handle, ros::CallbackQueueInterface* queue = nullptr) {
    const boost::function<bool(Request&, Response&)> guarded = [this, what = "a request to " + service, handle](
                                                                   Request& request, Response& response) {
      return answerCall(guard_, what, handle, request, response);
    };
    ros::AdvertiseServiceOptions options;
    options.init(service, guarded);
    options.callback_queue = queue;
    serve(options);
  }
  /// For a service with options of its own; roscpp itself catches what its callback throws.
  void serve(ros::AdvertiseServiceOptions& options) {
    services_.push_back(node_.advertiseService(options));
    master_.claimService(services_.back().getService());
  }

  /// Calls `tick()` every `period` of ROS time.
  template <class F>
  void every(const ros::Duration& period, F tick) {
    timers_.push_back(
        std::make_unique<RosTimer>(node_, toDuration(period), [this, tick] { guard_.run("a timer", tick); }));
  }
  /// Calls `tick()` every `period` of steady time.
  template <class F>
  void everySteady(const ros::WallDuration& period, F tick) {
    steady_timers_.push_back(
        node_.createSteadyTimer(period, [this, tick](const ros::SteadyTimerEvent&) { guard_.run("a timer", tick); }));
  }

  CallbackGuard& guard() { return guard_; }
  ClockMonitor& clock() { return clock_; }
  MasterWatch& master() { return master_; }
  const MasterWatch& master() const { return master_; }
  MemoryReport& memory() { return memory_; }
  /// For /diagnostics: whether this node is registered at the master, whether its clock jumped, exceptions of
  /// callbacks, messages that could not be read, and topics with several publishers that should have one. For the
  /// thread that runs the callbacks.
  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const {
    using diagnostic_msgs::DiagnosticStatus;
    master_.diagnose(status);
    clock_.report(status);
    guard_.report(status);
    unreadable_.report(status);
    for (const auto& [topic, input] : one_) input->report(status, steadyNow(), ros::Time::isSimTime());
    inputs_.report(status);
  }
  /// What the node waits for. Topics of `subscribeToOne` that it needs are among it.
  InputWatch& inputs() { return inputs_; }
  const InputWatch& inputs() const { return inputs_; }
  /// The node also waits for the pose of its base in `frame`, which the launch files' argument `argument` names.
  void needPoseIn(const std::string& frame, const char* argument, const TfBridge& tf, const std::string& base_frame) {
    inputs_.need(needTransform(tf, {frame, argument}, {base_frame, "base_frame"}));
  }

 private:
  /// For messages with a header; for others only the publisher is known.
  template <class Msg>
  static Arrival arrivalOf(const Msg& msg, const std::string& publisher) {
    Arrival arrival{publisher, {}, {}};
    if (const std::string* frame = ros::message_traits::FrameId<Msg>::pointer(msg)) arrival.frame = plain(*frame);
    if (const ros::Time* stamp = ros::message_traits::TimeStamp<Msg>::pointer(msg)) arrival.stamp = toTime(*stamp);
    return arrival;
  }
  static std::string messageOf(const std::string& topic) { return "a message of " + topic; }

  ros::NodeHandle node_;
  CallbackGuard guard_;
  MemoryReport memory_;
  UnreadableMessages unreadable_;
  std::map<std::string, std::shared_ptr<TopicInput>> one_;  ///< by topic
  InputWatch inputs_;
  ClockMonitor clock_;
  std::vector<ros::Subscriber> subscribers_;
  std::vector<ros::ServiceServer> services_;
  std::vector<std::unique_ptr<RosTimer>> timers_;
  std::vector<ros::SteadyTimer> steady_timers_;
  MasterWatch master_;  ///< the last member: it ends before topics and services are unregistered
};

}  // namespace frontier_pilot
