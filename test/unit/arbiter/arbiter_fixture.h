#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>

#include "frontier_pilot/arbiter/arbiter.h"

namespace frontier_pilot {

/// An arbiter under test and a pair of clocks that the test drives.
class ArbiterTest : public ::testing::Test {
 protected:
  static constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

  void configure(const arbiter::ArbiterParameters& parameters) { arbiter = arbiter::Arbiter(parameters); }
  arbiter::ArbiterParameters withRequiredAvoid() const {
    arbiter::ArbiterParameters parameters;
    parameters.sources[0].required = true;
    return parameters;
  }

  /// Both clocks go on together, tick by tick, as on a robot.
  void wait(double seconds) {
    for (int left = static_cast<int>(seconds * 1000.0 + 0.5); left > 0; left -= 50) {
      advance(0.001 * std::min(left, 50));
      out(arbiter.tick(now));
    }
  }
  void advance(double seconds) {
    now.ros += fromSeconds(seconds);
    now.steady += fromSeconds(seconds);
  }
  /// ROS time stands still meanwhile.
  void waitWithStoppedClock(double seconds) {
    for (int left = static_cast<int>(seconds * 1000.0 + 0.5); left > 0; left -= 50) {
      now.steady += fromSeconds(0.001 * std::min(left, 50));
      out(arbiter.tick(now));
    }
  }
  void jump(double seconds) { now.ros += fromSeconds(seconds); }

  std::optional<Twist2> send(const std::string& source, double linear, double angular = 0.0) {
    return out(arbiter.onCommand(*arbiter.find(source), {linear, angular}, now));
  }
  arbiter::ArbiterAnswer enable(const std::string& source, bool enabled) {
    return answer(arbiter.setEnabled(*arbiter.find(source), enabled, now));
  }
  std::optional<Twist2> setUnreachable(const std::string& why) { return out(arbiter.setUnreachable(why, now)); }
  std::optional<Twist2> contest(const std::string& rival) { return out(arbiter.contest(rival, now)); }
  arbiter::ArbiterAnswer stop() { return answer(arbiter.stop("test", now)); }
  arbiter::ArbiterAnswer clear() { return answer(arbiter.clear(now.steady, now)); }
  arbiter::SourceStatus source(const std::string& name) {
    for (const arbiter::SourceStatus& status : arbiter.status(now).sources) {
      if (status.name == name) return status;
    }
    return {};
  }

  arbiter::Arbiter arbiter{arbiter::ArbiterParameters{}};
  Instant now{timeFromSeconds(1000.0), timeFromSeconds<SteadyTime>(50.0)};
  Twist2 wheels;      ///< the last twist that left
  int published = 0;  ///< how many left

 private:
  std::optional<Twist2> out(const std::optional<Twist2>& twist) {
    if (twist) wheels = *twist;
    if (twist) ++published;
    return twist;
  }
  arbiter::ArbiterAnswer answer(const arbiter::ArbiterAnswer& given) {
    out(given.publish);
    return given;
  }
};

}  // namespace frontier_pilot
