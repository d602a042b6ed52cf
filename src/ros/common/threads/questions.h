#pragma once

#include <atomic>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>

#include "frontier_pilot/core/time.h"
#include "ros/common/messages/mailbox.h"

namespace frontier_pilot {

/// What other threads ask, one after the other, about a `Subject` that belongs to one thread and is only touched there.
template <class Subject>
class Questions {
 public:
  /// `patience`: for the other thread to take up a question.
  explicit Questions(Duration patience) : patience_(patience) {}

  /// What `question` gives on the other thread; nothing if it was not taken up in time, or threw, or this is closed.
  /// One that was taken up is waited for to its end, so that what it has changed is never denied.
  template <class Answer>
  std::optional<Answer> ask(const std::function<Answer(Subject&)>& question) {
    const std::lock_guard<std::mutex> one_at_a_time(asking_);
    auto promise = std::make_shared<std::promise<Answer>>();
    std::future<Answer> answer = promise->get_future();
    asked_.put([promise, question](Subject& subject) { promise->set_value(question(subject)); });
    promise.reset();
    if ((closed_ || answer.wait_for(patience_) != std::future_status::ready) && asked_.take()) return std::nullopt;
    try {
      return answer.get();
    } catch (const std::future_error&) {
      return std::nullopt;
    }
  }

  /// Answers a question that waits. To be called periodically on the subject's thread.
  void answer(Subject& subject) {
    if (const auto question = asked_.take()) (*question)(subject);
  }

  /// Makes a question that waits fail, and all later ones.
  void close() {
    closed_ = true;
    asked_.take();  // destroying the promise wakes the thread that waits for it
  }
  bool closed() const { return closed_; }

 private:
  const Duration patience_;
  std::mutex asking_;
  std::atomic<bool> closed_{false};
  Mailbox<std::function<void(Subject&)>> asked_;
};

}  // namespace frontier_pilot
