#pragma once

#include <ros/message_event.h>
#include <ros/serialization.h>
#include <ros/subscribe_options.h>

#include <algorithm>
#include <boost/make_shared.hpp>
#include <cstdint>
#include <exception>
#include <map>
#include <mutex>
#include <string>
#include <typeinfo>
#include <utility>
#include <vector>

#include "ros/common/diagnostics.h"

namespace frontier_pilot {

/// A stream that deserializes a message with a check that roscpp lacks: roscpp allocates as many elements as an array
/// claims to have before it checks whether the message is long enough for them. Throws
/// ros::serialization::StreamOverrunException if the message is too short. [FLT-1]
class CheckedStream {
 public:
  CheckedStream(std::uint8_t* data, std::uint32_t size) : data_(data), end_(data + size) {}

  template <class T>
  void next(T& value) {
    ros::serialization::deserialize(*this, value);
  }
  template <class T, class Allocator>
  void next(std::vector<T, Allocator>& values) {
    static const std::uint32_t kLeastElement = ros::serialization::serializationLength(T());
    std::uint32_t count = 0;
    std::uint8_t* const array = data_;
    next(count);
    if (count > left() / std::max<std::uint32_t>(kLeastElement, 1)) ros::serialization::throwStreamOverrun();
    data_ = array;
    ros::serialization::deserialize(*this, values);
  }
  /// Skips `size` bytes and returns where they begin.
  std::uint8_t* advance(std::uint32_t size) {
    if (size > left()) ros::serialization::throwStreamOverrun();
    std::uint8_t* const here = data_;
    data_ += size;
    return here;
  }

 private:
  std::uint32_t left() const { return static_cast<std::uint32_t>(end_ - data_); }

  std::uint8_t* data_;
  std::uint8_t* end_;
};

/// Messages that could not be deserialized: counted by topic and reason, with a warning at most every five seconds.
/// Safe to use from several threads. [FLT-1]
class UnreadableMessages {
 public:
  void add(const std::string& topic, const std::string& why) noexcept;
  std::uint64_t total() const;
  /// For /diagnostics; adds nothing if every message could be read.
  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const;

 private:
  mutable std::mutex mutex_;
  std::map<std::string, Rejections> by_topic_;
};

/// What roscpp is given for a message that cannot be read. Without anything it would deserialize an empty message again
/// for the next callback of the topic, from bytes that it has freed.
inline const ros::VoidConstPtr& unreadableMessage() {
  static const ros::VoidConstPtr kUnreadable = boost::make_shared<char>();
  return kUnreadable;
}

/// Deserializes messages with a CheckedStream and hands them to a callback. A message that cannot be read is dropped
/// and counted in `unreadable`, which has to outlive the subscription; roscpp would log a line for each. [FLT-1]
template <class Msg>
class CheckedSubscription : public ros::SubscriptionCallbackHelperT<const ros::MessageEvent<const Msg>&> {
 public:
  using Base = ros::SubscriptionCallbackHelperT<const ros::MessageEvent<const Msg>&>;

  CheckedSubscription(std::string topic, UnreadableMessages& unreadable, const typename Base::Callback& handle)
      : Base(handle), topic_(std::move(topic)), unreadable_(unreadable) {}

  ros::VoidConstPtr deserialize(const ros::SubscriptionCallbackHelperDeserializeParams& bytes) override {
    try {
      const auto msg = boost::make_shared<Msg>();
      CheckedStream(bytes.buffer, bytes.length).next(*msg);
      return msg;
    } catch (const ros::serialization::StreamOverrunException&) {
      unreadable_.add(topic_, "shorter than its fields");
    } catch (const std::exception& error) {
      unreadable_.add(topic_, error.what());
    }
    return unreadableMessage();
  }
  void call(ros::SubscriptionCallbackHelperCallParams& params) override {
    if (params.event.getConstMessage() != unreadableMessage()) Base::call(params);
  }
  /// roscpp deserializes a message once for all callbacks of this type, with the helper of one of them: all of them are
  /// checked, then.
  const std::type_info& getTypeInfo() override { return typeid(CheckedSubscription); }

 private:
  std::string topic_;
  UnreadableMessages& unreadable_;
};

/// The options that subscribe `handle(const ros::MessageEvent<const Msg>&)` to `topic` with a CheckedSubscription.
template <class Msg>
ros::SubscribeOptions checkedSubscription(const std::string& topic, std::uint32_t queue_size,
                                          UnreadableMessages& unreadable,
                                          const boost::function<void(const ros::MessageEvent<const Msg>&)>& handle,
                                          const ros::TransportHints& hints = {}) {
  ros::SubscribeOptions options;
  options.template initByFullCallbackType<const ros::MessageEvent<const Msg>&>(topic, queue_size, handle);
  options.helper = boost::make_shared<CheckedSubscription<Msg>>(topic, unreadable, handle);
  options.transport_hints = hints;
  return options;
}

}  // namespace frontier_pilot
