// Latencies over ROS: from publishing through the arbiter or a relay and back, and from emergency_stop to the last
// non-zero message. Started by arbiter_latency.py together with the nodes that are measured.
#include <geometry_msgs/Twist.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <fstream>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "ros/common/clock.h"
#include "tools/arguments.h"
#include "tools/program.h"

namespace {

using frontier_pilot::Duration;
using frontier_pilot::steadyNow;
using frontier_pilot::SteadyTime;
using frontier_pilot::toSeconds;

const std::vector<std::string> kLoad = {"cmd_vel_patrol", "cmd_vel_nav", "cmd_vel_manual"};

double percentile(std::vector<double>& sorted, double share) {
  if (sorted.empty()) return 0.0;
  return sorted[std::min(sorted.size() - 1, static_cast<std::size_t>(share * static_cast<double>(sorted.size())))];
}

/// Sends on one topic, listens on another, and recognises a message by its rate of turn.
class Path {
 public:
  Path(ros::NodeHandle& node, const std::string& in, const std::string& out) : name_(out) {
    publisher_ = node.advertise<geometry_msgs::Twist>(in, 1);
    subscriber_ = node.subscribe<geometry_msgs::Twist>(
        out, 1000, [this](const geometry_msgs::Twist::ConstPtr& msg) { take(*msg); }, ros::VoidConstPtr(),
        ros::TransportHints().tcpNoDelay());
  }
  bool connected() const { return publisher_.getNumSubscribers() > 0 && subscriber_.getNumPublishers() > 0; }
  void send() {
    geometry_msgs::Twist msg;
    const std::size_t index = sent_ % kMarks;
    msg.angular.z = 1e-5 * static_cast<double>(index + 1);
    sent_at_[index] = steadyNow();
    ++sent_;
    publisher_.publish(msg);
  }
  void forget() {
    latencies_.clear();
    sent_ = 0;
  }
  void report(double rate) {
    std::sort(latencies_.begin(), latencies_.end());
    std::printf("%-10s %6.0f Hz  p50 %.3f ms  p99 %.3f ms  p99.9 %.3f ms  (%zu of %zu back)\n", name_.c_str(), rate,
                percentile(latencies_, 0.5), percentile(latencies_, 0.99), percentile(latencies_, 0.999),
                latencies_.size(), sent_);
    forget();
  }

 private:
  static constexpr std::size_t kMarks = 100000;

  void take(const geometry_msgs::Twist& msg) {
    const long mark = std::lround(msg.angular.z * 1e5);
    if (mark < 1 || static_cast<std::size_t>(mark) > kMarks) return;
    SteadyTime& sent = sent_at_[static_cast<std::size_t>(mark - 1)];
    if (sent != SteadyTime{}) latencies_.push_back(1e3 * toSeconds(steadyNow() - sent));
    sent = SteadyTime{};
  }

  std::string name_;
  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
  std::vector<SteadyTime> sent_at_ = std::vector<SteadyTime>(kMarks);
  std::vector<double> latencies_;
  std::size_t sent_ = 0;
};

void spinUntil(SteadyTime end) {
  while (steadyNow() < end) {
    const double left = toSeconds(end - steadyNow());
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(std::max(0.0, left)));
  }
}

/// Both paths at the same rate in the same run, half a period apart.
void measure(Path& relay, Path& arbiter, double rate, double seconds) {
  const Duration half = frontier_pilot::fromSeconds(0.5 / rate);
  SteadyTime next = steadyNow();
  const SteadyTime end = next + frontier_pilot::fromSeconds(seconds);
  while (next < end) {
    relay.send();
    spinUntil(next += half);
    arbiter.send();
    spinUntil(next += half);
  }
  spinUntil(steadyNow() + std::chrono::milliseconds(100));
  relay.report(rate);
  arbiter.report(rate);
}

/// Publishes on several topics at a constant rate, each on a thread of its own.
class Load {
 public:
  Load(ros::NodeHandle& node, const std::vector<std::string>& topics, double rate) {
    for (const std::string& topic : topics) {
      threads_.emplace_back([this, rate, publisher = node.advertise<geometry_msgs::Twist>(topic, 1)] {
        geometry_msgs::Twist msg;
        msg.linear.x = 0.1;
        for (ros::WallRate pace(rate); running_; pace.sleep()) publisher.publish(msg);
      });
    }
  }
  ~Load() {
    running_ = false;
    for (std::thread& thread : threads_) thread.join();
  }

 private:
  std::atomic<bool> running_{true};
  std::vector<std::thread> threads_;
};

long residentKilobytes(const std::string& node) {
  const std::string command = "rosnode info " + node + " 2>/dev/null | sed -n 's/^Pid: //p'";
  char text[64] = {};
  FILE* pipe = popen(command.c_str(), "r");
  const bool ok = pipe != nullptr && std::fgets(text, sizeof text, pipe) != nullptr;
  if (pipe != nullptr) pclose(pipe);
  if (!ok) return -1;
  std::ifstream status("/proc/" + std::to_string(std::atoi(text)) + "/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind("VmRSS:", 0) == 0) return std::atol(line.c_str() + 6);
  }
  return -1;
}

/// Measures the time from the call of emergency_stop to the arrival of the last message that is not zero.
void measureStops(ros::NodeHandle& node, int count) {
  std::atomic<Duration::rep> last_motion{0};
  ros::CallbackQueue queue;
  ros::NodeHandle listener(node);
  listener.setCallbackQueue(&queue);
  const auto subscriber = listener.subscribe<geometry_msgs::Twist>(
      "cmd_vel", 1000,
      [&](const geometry_msgs::Twist::ConstPtr& msg) {
        if (msg->linear.x != 0.0) last_motion = steadyNow().time_since_epoch().count();
      },
      ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
  ros::AsyncSpinner spinner(1, &queue);
  spinner.start();
  auto stop = node.serviceClient<std_srvs::Trigger>("emergency_stop", true);
  auto set = node.serviceClient<std_srvs::SetBool>("set_emergency_stop", true);
  std::vector<double> latencies;
  for (int i = 0; i < count; ++i) {
    {
      const Load load(node, kLoad, 1000.0);
      const auto started = steadyNow().time_since_epoch().count();
      while (last_motion < started) ros::WallDuration(0.001).sleep();
      std_srvs::Trigger trigger;
      const SteadyTime called = steadyNow();
      stop.call(trigger);
      ros::WallDuration(0.03).sleep();  // for messages that are still on the way
      latencies.push_back(std::max(0.0, 1e3 * toSeconds(Duration(last_motion) - called.time_since_epoch())));
    }
    std_srvs::SetBool clear;
    do {
      ros::WallDuration(0.02).sleep();
      set.call(clear);
    } while (clear.response.success == 0 && ros::ok());
  }
  std::sort(latencies.begin(), latencies.end());
  std::printf("stop under 3 x 1 kHz, %d times: p50 %.3f ms  p99 %.3f ms  p99.9 %.3f ms  worst %.3f ms\n", count,
              percentile(latencies, 0.5), percentile(latencies, 0.99), percentile(latencies, 0.999), latencies.back());
}

struct Options {
  double seconds = 10.0;  ///< of each rate
  int stops = 1000;
};

Options parse(const std::vector<std::string>& words) {
  Options options;
  frontier_pilot::tools::Arguments arguments(words);
  while (!arguments.atEnd()) {
    const std::string word = arguments.next();
    if (word == "--seconds") {
      options.seconds = arguments.number();
    } else if (word == "--stops") {
      options.stops = arguments.integer();
    } else {
      throw std::invalid_argument("unknown argument " + word);
    }
  }
  return options;
}

int probe(const Options& options) {
  const double seconds = options.seconds;
  ros::NodeHandle node;
  Path relay(node, "relay_in", "relay_out");
  Path arbiter(node, "cmd_vel_behavior", "cmd_vel");
  // A relay advertises its output only after it has received its first message.
  while (ros::ok() && !(relay.connected() && arbiter.connected())) {
    relay.send();
    spinUntil(steadyNow() + std::chrono::milliseconds(50));
  }
  relay.forget();
  for (const double rate : {10.0, 50.0, 200.0, 1000.0}) measure(relay, arbiter, rate, seconds);
  std::vector<ros::Publisher> connected;  // keeps the connections of the load open, so that it starts at full rate
  for (const std::string& topic : kLoad) connected.push_back(node.advertise<geometry_msgs::Twist>(topic, 1));
  spinUntil(steadyNow() + std::chrono::seconds(1));
  std::printf("with three more sources at 1 kHz each:\n");
  const long before = residentKilobytes("cmd_vel_arbiter");
  {
    const Load load(node, kLoad, 1000.0);
    for (int minute_part = 0; minute_part < 3; ++minute_part) measure(relay, arbiter, 200.0, 2.0 * seconds);
  }
  std::printf("memory of the arbiter before and after: %ld kB, %ld kB\n", before, residentKilobytes("cmd_vel_arbiter"));
  measureStops(node, options.stops);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  constexpr const char* kUsage =
      "usage: arbiter_latency_probe [--seconds S] [--stops N]\n"
      "Measures latencies over ROS: through the arbiter (cmd_vel_behavior, cmd_vel), through a relay (relay_in, "
      "relay_out),\n"
      "and from emergency_stop to the last non-zero message. Started by arbiter_latency.py with the nodes it "
      "measures.\n"
      "  --seconds S  of each rate (10)\n"
      "  --stops N    emergency stops under load (1000)\n"
      "Example:\n"
      "  bench/arbiter_latency.py build/bin/arbiter_latency_probe\n";
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  std::vector<std::string> words;
  ros::removeROSArgs(argc, argv, words);
  return frontier_pilot::tools::runProgram("arbiter_latency_probe", {words.begin() + 1, words.end()}, kUsage,
                                           [&](const auto& given) {
                                             const Options options = parse(given);
                                             ros::init(argc, argv, "arbiter_latency_probe");
                                             return probe(options);
                                           });
}
