// A million random steps against the slow model, and the invariants that need no model.
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "arbiter_model.h"
#include "frontier_pilot/arbiter/arbiter.h"

namespace frontier_pilot {
namespace {

constexpr int kSteps = 1000000;  // for each of four configurations

/// One arbiter, one model, and dice.
class RandomDrive {
 public:
  RandomDrive(const arbiter::ArbiterParameters& parameters, std::uint32_t seed)
      : parameters_(parameters), arbiter_(parameters), model_(parameters), dice_(seed) {}

  void step() {
    letTimePass();
    const int what = pick(100);
    if (what < 70) return message();
    if (what < 85) return tick();
    if (what < 90) return update();
    if (what < 94) return switchOne();
    if (what < 96) return stop();
    clear();
  }
  std::string failure() const { return failure_; }
  int motions() const { return motions_; }
  int clears() const { return clears_; }

 private:
  int pick(int n) { return std::uniform_int_distribution<int>(0, n - 1)(dice_); }
  std::size_t anySource() { return static_cast<std::size_t>(pick(static_cast<int>(parameters_.sources.size()))); }

  /// Mostly small steps; now and then silence, a standing ROS clock, and jumps both ways.
  void letTimePass() {
    const Duration small = std::chrono::milliseconds(pick(60));
    const int what = pick(200);
    now_.steady += small;
    if (what < 170) now_.ros += small;
    if (what == 170) now_.ros -= std::chrono::milliseconds(1 + pick(3000));
    if (what == 171) now_.ros += std::chrono::milliseconds(pick(3000));
    if (what == 172) now_.steady += std::chrono::milliseconds(pick(1500));
    if (what == 173 || what == 174) passTogether(std::chrono::milliseconds(pick(2500)));
    if (what == 175) passTogether(std::chrono::milliseconds(1000));  // exactly a timeout
    if (what == 176) passTogether(std::chrono::milliseconds(500));   // exactly the quiet time
  }
  void passTogether(Duration duration) {
    now_.steady += duration;
    now_.ros += duration;
  }
  double anyNumber() {
    const double values[] = {0.0,
                             0.0,
                             0.0,
                             -0.0,
                             0.1,
                             -0.1,
                             0.22,
                             5.0,
                             -5.0,
                             1e308,
                             -1e308,
                             5e-324,
                             std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()};
    const int which = pick(18);
    return which < 15 ? values[which] : std::uniform_real_distribution<double>(-1.0, 1.0)(dice_);
  }

  void message() {
    const std::size_t source = anySource();
    const Twist2 twist{anyNumber(), anyNumber()};
    const bool hold = pick(4) == 0;
    const auto out = arbiter_.onCommand(source, twist, now_, hold);
    model_.message(source, twist, hold, now_);
    int driver = -1;
    const Twist2 expected = model_.wheels(now_.ros, &driver);
    if (driver == static_cast<int>(source) && !out) fail("the winner's message was not forwarded [ARB-2]");
    if (model_.latched() && out) fail("something left on arrival while latched [ARB-7]");
    compare(out, expected);
  }
  void tick() {
    const auto out = arbiter_.tick(now_);
    model_.timePasses(now_);
    int driver = -1;
    const Twist2 expected = model_.wheels(now_.ros, &driver);
    if (driver < 0 && !out) fail("no zero left at a tick without a driver [ARB-2]");
    compare(out, expected);
  }
  void update() {
    const auto out = arbiter_.update(now_);
    model_.timePasses(now_);
    compare(out, model_.wheels(now_.ros));
  }
  void switchOne() {
    const std::size_t source = anySource();
    const bool on = pick(3) > 0;
    const Twist2 before = wheels_;
    const arbiter::ArbiterAnswer answer = arbiter_.setEnabled(source, on, now_);
    model_.enable(source, on, now_);
    compare(answer.publish, model_.wheels(now_.ros));
    if (on && !wheels_.isZero() && before.isZero() &&
        arbiter_.status(now_).active_source == parameters_.sources[source].name)
      fail("enabling revived a command [ARB-6]");
  }
  void stop() {
    const arbiter::ArbiterAnswer answer = arbiter_.stop("dice", now_);
    model_.stop(now_);
    if (!answer.publish || !answer.publish->isZero()) fail("a stop without a zero [ARB-7]");
    compare(answer.publish, {});
  }
  void clear() {
    const SteadyTime called = now_.steady - std::chrono::milliseconds(pick(4) == 0 ? pick(50) : 0);
    const bool was_latched = arbiter_.stopped();
    const arbiter::ArbiterAnswer answer = arbiter_.clear(called, now_);
    if (answer.success != model_.clear(called, now_)) fail("clear: " + answer.message + " [ARB-8]");
    compare(answer.publish, model_.wheels(now_.ros));
    if (was_latched && !wheels_.isZero()) fail("a clear moved the robot [ARB-8]");
    if (was_latched && answer.success) ++clears_;
  }

  void compare(const std::optional<Twist2>& out, const Twist2& expected) {
    if (out) wheels_ = *out;
    if (!wheels_.isZero()) ++motions_;
    if (wheels_ != expected) fail("the wheels are not what the model says [ARB-1]");
    if (arbiter_.stopped() != model_.latched()) fail("the latch differs [ARB-7]");
    if (arbiter_.stopped() && !wheels_.isZero()) fail("latched and not zero [ARB-7]");
    if (!wheels_.isFinite()) fail("not finite [ARB-5]");
    if (std::abs(wheels_.linear) > parameters_.robot.limits.max_linear) fail("beyond the limits [ARB-5]");
    if (std::abs(wheels_.angular) > parameters_.robot.limits.max_angular) fail("beyond the limits [ARB-5]");
  }
  void fail(const std::string& what) {
    if (failure_.empty()) failure_ = what;
  }

  arbiter::ArbiterParameters parameters_;
  arbiter::Arbiter arbiter_;
  ArbiterModel model_;
  std::mt19937 dice_;
  Instant now_{timeFromSeconds(1e5), timeFromSeconds<SteadyTime>(100.0)};
  Twist2 wheels_;
  std::string failure_;
  int motions_ = 0, clears_ = 0;
};

void drive(const arbiter::ArbiterParameters& parameters, std::uint32_t seed) {
  RandomDrive random(parameters, seed);
  for (int i = 0; i < kSteps && random.failure().empty(); ++i) {
    random.step();
    ASSERT_EQ(random.failure(), "") << "seed " << seed << ", step " << i;
  }
  EXPECT_GT(random.motions(), kSteps / 100) << "the dice must reach what they are to test";
  EXPECT_GT(random.clears(), 10);
}

// [ARB-1] [ARB-2] [ARB-3] [ARB-5] [ARB-6] [ARB-7] [ARB-8] [ARB-9]
TEST(ArbiterRandom, AgreesWithTheModelUnderTheDefaultConfiguration_ARB_1) { drive({}, 1); }

// [ARB-4]
TEST(ArbiterRandom, AgreesWithTheModelWhenAvoidIsRequired_ARB_4) {
  arbiter::ArbiterParameters parameters;
  parameters.sources[0].required = true;
  drive(parameters, 2);
}

// [ARB-4]
TEST(ArbiterRandom, AgreesWithTheModelWhenTwoSourcesAreRequiredAndTheListIsNotSorted_ARB_4) {
  arbiter::ArbiterParameters parameters;
  std::swap(parameters.sources[0], parameters.sources[3]);
  parameters.sources[1].required = true;
  parameters.sources[3].required = true;
  parameters.sources[4].zero_means_idle = true;
  drive(parameters, 3);
}

// [ARB-1]
TEST(ArbiterRandom, AgreesWithTheModelWhenTimeoutsDifferAndOneSourceStartsDisabled_ARB_1) {
  arbiter::ArbiterParameters parameters;
  for (std::size_t i = 0; i < parameters.sources.size(); ++i) {
    parameters.sources[i].timeout = 0.1 * static_cast<double>(i + 1);
  }
  parameters.sources[2].enabled = false;
  drive(parameters, 4);
}

}  // namespace
}  // namespace frontier_pilot
