#pragma once

#include <ros/callback_queue.h>
#include <ros/spinner.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "ros/common/node_connections.h"
#include "ros/common/threads/questions.h"

namespace frontier_pilot {

/// Serves one service on a thread of its own, because its work would hold up the node's for too long. It may ask about
/// `Subject`, which belongs to the node's thread and is only touched there.
template <class Subject>
class ServiceThread {
 public:
  /// With several `threads` a call that hangs holds up no other one.
  explicit ServiceThread(std::uint32_t threads = 1) : spinner_(threads, &queue_) {}

  /// Advertises the service and starts the thread; `handle` is called on it.
  template <class Request, class Response>
  void serve(NodeConnections& connections, const char* service,
             const std::function<bool(Request&, Response&)>& handle) {
    connections.serve<Request, Response>(service, handle, &queue_);
    spinner_.start();
  }

  /// What `question` gives on the node's thread; nothing if that did not take it up within ten seconds, or it threw, or
  /// the thread is closed. To be called by `handle`.
  template <class Answer>
  std::optional<Answer> ask(const std::function<Answer(Subject&)>& question) {
    return questions_.template ask<Answer>(question);
  }

  /// Answers a question that waits. To be called periodically on the node's thread.
  void answer(Subject& subject) { questions_.answer(subject); }

  /// Makes questions that wait fail, and all later ones. To be called before the connections are destroyed, which waits
  /// for the call that is being served.
  void close() { questions_.close(); }
  bool closed() const { return questions_.closed(); }
  /// Why `ask` has given nothing, where the node was to do `what` with its map.
  std::string whyNot(const std::string& node, const std::string& what) const {
    return "the " + node + (closed() ? " is shut down" : " was too busy to " + what);
  }

  /// What the thread has to do: calls of the service, and other callbacks.
  ros::CallbackQueue& queue() { return queue_; }

 private:
  Questions<Subject> questions_{std::chrono::seconds(10)};  // enough for a busy node
  ros::CallbackQueue queue_;
  ros::AsyncSpinner spinner_;  ///< the last member: all others exist while it runs
};

}  // namespace frontier_pilot
