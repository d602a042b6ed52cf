#pragma once

#include <ros/callback_queue.h>
#include <ros/spinner.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>

#include "ros/common/messages/mailbox.h"
#include "ros/common/node_connections.h"

namespace frontier_pilot {

/// Serves one service on a thread of its own, because its work would hold up the node's for too long. It may ask about
/// `Subject`, which belongs to the node's thread and is only touched there.
template <class Subject>
class ServiceThread {
 public:
  /// Advertises the service and starts the thread; `handle` is called on it.
  template <class Request, class Response>
  void serve(NodeConnections& connections, const char* service,
             const std::function<bool(Request&, Response&)>& handle) {
    connections.serve<Request, Response>(service, handle, &queue_);
    spinner_.start();
  }

  /// What `question` gives on the node's thread; nothing if it was not answered within ten seconds, or threw, or the
  /// thread is closed. To be called by `handle`.
  template <class Answer>
  std::optional<Answer> ask(const std::function<Answer(Subject&)>& question) {
    constexpr auto kPatience = std::chrono::seconds(10);  // enough for a busy node
    auto promise = std::make_shared<std::promise<Answer>>();
    std::future<Answer> answer = promise->get_future();
    asked_.put([promise, question](Subject& subject) { promise->set_value(question(subject)); });
    promise.reset();
    if (closed_ || answer.wait_for(kPatience) != std::future_status::ready) asked_.take();
    if (answer.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
    try {
      return answer.get();
    } catch (const std::future_error&) {
      return std::nullopt;
    }
  }

  /// Answers a question that waits. To be called periodically on the node's thread.
  void answer(Subject& subject) {
    if (const auto question = asked_.take()) (*question)(subject);
  }

  /// Makes questions that wait fail, and all later ones. To be called before the connections are destroyed, which waits
  /// for the call that is being served.
  void close() {
    closed_ = true;
    asked_.take();  // destroying the promise wakes the thread that waits for it
  }
  bool closed() const { return closed_; }
  /// Why `ask` has given nothing, of a subject that is the map of `node`.
  std::string whyNoMap(const std::string& node) const {
    return "the " + node + (closed_ ? " is shut down" : " was too busy to hand over its map");
  }

  /// What the thread has to do: calls of the service, and other callbacks.
  ros::CallbackQueue& queue() { return queue_; }

 private:
  std::atomic<bool> closed_{false};
  Mailbox<std::function<void(Subject&)>> asked_;
  ros::CallbackQueue queue_;
  ros::AsyncSpinner spinner_{1, &queue_};  ///< the last member: all others exist while it runs
};

}  // namespace frontier_pilot
