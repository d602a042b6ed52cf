#pragma once

#include <chrono>
#include <utility>
#include <vector>

#include "example_state.h"
#include "teleop/operator_link.h"

namespace frontier_pilot::test {

/// Writes down what it is told.
class RecordingLink : public teleop::OperatorLink {
 public:
  SteadyTime now() const override {
    return SteadyTime(std::chrono::steady_clock::now().time_since_epoch() + suspended);
  }
  teleop::OperatorState state() override { return shown; }
  void beat(const Twist2& set_point) override { beats.push_back(set_point); }
  void request(const teleop::OperatorRequest& request) override { requests.push_back(request); }
  teleop::MapView takeMap() override { return {}; }
  std::vector<teleop::OperatorLogLine> takeLog() override { return std::exchange(log, {}); }
  bool running() const override { return is_running; }
  void close() override { ++closed; }

  teleop::OperatorState shown = exampleState();
  std::vector<Twist2> beats;
  std::vector<teleop::OperatorRequest> requests;
  std::vector<teleop::OperatorLogLine> log{{teleop::Severity::kGood, "hello from the system"}};
  bool is_running = true;
  Duration suspended{};  ///< for how long the computer was
  int closed = 0;
};

}  // namespace frontier_pilot::test
