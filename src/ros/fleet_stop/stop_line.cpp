#include "ros/fleet_stop/stop_line.h"

#include <ros/console.h>
#include <ros/service.h>
#include <std_srvs/Trigger.h>

#include <algorithm>
#include <utility>

#include "ros/common/clock.h"

namespace frontier_pilot {
namespace {

constexpr Duration kRetry = std::chrono::milliseconds(500);
constexpr Duration kRetryWhileOwed = std::chrono::milliseconds(100);
// roscpp logs each attempt to connect to a computer that it cannot find, so they become rarer.
constexpr Duration kRarestRetry = std::chrono::seconds(5);
constexpr Duration kRarestRetryWhileOwed = std::chrono::seconds(1);
constexpr Duration kGivenUp = std::chrono::seconds(5);
constexpr Duration kOwed = std::chrono::seconds(30);  // how long a robot that was not reached is asked again

/// Until the next attempt to connect: twice as long as the pause before this one, which has failed.
Duration pauseAfter(Duration last, bool connected, bool owed) {
  const Duration least = owed ? kRetryWhileOwed : kRetry;
  return connected ? least : std::clamp(2 * last, least, owed ? kRarestRetryWhileOwed : kRarestRetry);
}

}  // namespace

StopLine::StopLine(const ros::NodeHandle& node, std::string service)
    : node_(node), service_(std::move(service)), thread_([this] { run(); }) {}

StopLine::~StopLine() {
  end();
  thread_.join();
}

void StopLine::end() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ending_ = true;
    client_.shutdown();  // ends the call that waits for an answer
  }
  wake_.notify_all();
}

void StopLine::ask() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (calling_since_ && steadyNow() - *calling_since_ >= kGivenUp) client_.shutdown();
    ++asked_;
    asked_at_ = steadyNow();
  }
  wake_.notify_all();
}

StopAnswer StopLine::answerUntil(SteadyTime deadline) {
  std::unique_lock<std::mutex> lock(mutex_);
  const auto patience = std::max(Duration::zero(), Duration(deadline - steadyNow()));
  if (wake_.wait_for(lock, patience, [this] { return answered_ == asked_; })) return answer_;
  return {connected_ ? StopOutcome::kSilent : StopOutcome::kNoService, {}};
}

void StopLine::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  Duration pause{};
  while (!ending_) {
    lock.unlock();
    guard_.run("connecting to " + service_, [this] { connect(); });
    lock.lock();
    pause = pauseAfter(pause, connected_, owed_);
    wake_.wait_for(lock, pause, [this] { return asked_ != answered_ || ending_; });
    owed_ = owed_ && steadyNow() <= asked_at_ + kOwed;
    const bool late = asked_ == answered_;
    if (ending_ || (late && !(owed_ && connected_))) continue;
    const std::uint64_t number = asked_;
    const SteadyTime latest = asked_at_ + kOwed;
    calling_since_ = steadyNow();
    lock.unlock();
    StopAnswer answer{StopOutcome::kRefused, "the call failed"};
    guard_.run("a call of " + service_, [&] { answer = call(latest); });
    lock.lock();
    calling_since_.reset();
    if (late) {
      settleLate(number, answer);
    } else {
      settle(number, std::move(answer));
    }
  }
  ended_ = true;
}

void StopLine::settle(std::uint64_t number, StopAnswer answer) {
  answered_ = number;
  answer_ = std::move(answer);
  owed_ = answer_.outcome != StopOutcome::kConfirmed;
  wake_.notify_all();
}

void StopLine::settleLate(std::uint64_t number, const StopAnswer& answer) {
  if (answer.outcome != StopOutcome::kConfirmed || number != asked_) return;
  owed_ = false;
  ROS_WARN_STREAM(service_ << " has now confirmed the stop, which it had not confirmed when it was called");
}

void StopLine::connect() {
  if (leads_elsewhere_.exchange(false)) disconnect();
  // A killed node's service stays at the master, and a client that connects to where it was counts as valid until the
  // refusal has come, in a race with roscpp for ever; so the service is asked first whether it is there.
  if (!isConnected() && ros::service::exists(node_.resolveName(service_), false)) {
    // Persistent: such a client keeps its connection, and can be shut down in the middle of a call.
    ros::ServiceClient fresh = node_.serviceClient<std_srvs::Trigger>(service_, true);
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!ending_) client_ = fresh;
  }
  connected_ = isConnected();
}

bool StopLine::isConnected() {
  const std::lock_guard<std::mutex> lock(mutex_);  // a client must not be asked while another thread shuts it down
  return client_.isValid();
}

void StopLine::disconnect() {
  const std::lock_guard<std::mutex> lock(mutex_);
  client_.shutdown();
}

StopAnswer StopLine::call(SteadyTime latest) {
  // The connection may have been lost unnoticed: a call that fails is made once more, by a new one.
  for (int attempt = 0; attempt < 2; ++attempt) {
    connect();
    if (!connected_) return {StopOutcome::kNoService, {}};
    if (steadyNow() > latest) {
      ROS_WARN_STREAM("a stop that " << service_ << " could not be told for half a minute is not told any more");
      return {StopOutcome::kNoService, {}};
    }
    std_srvs::Trigger stop;
    if (ros::ServiceClient client = client_; client.call(stop) && !leads_elsewhere_) {
      return {stop.response.success == 0 ? StopOutcome::kRefused : StopOutcome::kConfirmed, stop.response.message};
    }
    disconnect();
  }
  // A killed node may have counted as connected both times.
  if (!ros::service::exists(node_.resolveName(service_), false)) return {StopOutcome::kNoService, {}};
  return {StopOutcome::kRefused, "the call failed"};
}

}  // namespace frontier_pilot
