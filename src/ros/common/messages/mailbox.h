#pragma once

#include <mutex>
#include <optional>
#include <utility>

#include "frontier_pilot/core/time.h"

namespace frontier_pilot {

/// The latest message of an input and when it arrived, for a node's own thread.
template <class T>
class Latest {
 public:
  /// `received` is steady time, so that the age grows also while a simulated clock stands still.
  void put(T value, SteadyTime received) {
    value_ = std::move(value);
    received_ = received;
  }
  void clear() { value_.reset(); }

  bool has() const { return value_.has_value(); }
  const std::optional<T>& get() const { return value_; }
  /// How long ago the message arrived; nothing if there is none.
  std::optional<Duration> age(SteadyTime now) const {
    return value_ ? std::optional<Duration>(now - received_) : std::nullopt;
  }
  /// The value unless it is missing or older than `max_age`.
  std::optional<T> fresh(SteadyTime now, Duration max_age) const {
    return value_ && now - received_ <= max_age ? value_ : std::nullopt;
  }

 private:
  std::optional<T> value_;
  SteadyTime received_{};
};

/// Hands the latest value from one thread to another, such as a worker's result; an unread one is overwritten.
template <class T>
class Mailbox {
 public:
  void put(T value) {
    const std::lock_guard<std::mutex> lock(mutex_);
    value_ = std::move(value);
  }
  /// The value, once.
  std::optional<T> take() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::exchange(value_, std::nullopt);
  }

 private:
  std::mutex mutex_;
  std::optional<T> value_;
};

}  // namespace frontier_pilot
