// Parameters that change while a node runs: what clients are told, and which requests are taken.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "frontier_pilot/core/robot_model.h"
#include "ros/behavior_server/behavior_server_adapter.h"
#include "ros/cmd_vel_arbiter/cmd_vel_arbiter_adapter.h"
#include "ros/common/tuning/reconfigure_messages.h"
#include "ros/frontier_explorer/frontier_explorer_adapter.h"
#include "ros/navigator/navigator_adapter.h"
#include "ros/obstacle_avoider/obstacle_avoider_adapter.h"
#include "ros/patrol_server/patrol_server_adapter.h"

namespace frontier_pilot {
namespace {

struct Tunable {
  RobotModel robot;
  double near = 0.5;
  double far = 1.0;
  int count = 3;
  bool on = false;
  double rate = 10.0;

  template <class V>
  void describe(V& v) {
    describeRobot(v, robot);
    v.field("near", near, "m", "the near one", scanRangeOrNone());
    v.field("far", far, "m", "the far one", coordinate());
    v.field("count", count, "", "how many", countFrom(1));
    v.field("on", on, "", "whether");
    v.field("rate", rate, "Hz", "how often", tickRate());
    v.tunable({"near", "far", "count", "on", "limits/max_linear"});
  }
  void check(Problems& problems) const {
    if (near >= far) problems.emplace_back("far: must be beyond near");
  }
};

/// A struct of parameters in use, as a node has it.
class TunableParameters : public ::testing::Test {
 protected:
  /// What is wrong with a request; empty if it was taken.
  Problems ask(const dynamic_reconfigure::Config& msg) {
    Problems problems;
    const ParameterMap changes = toChanges(msg, tunables.inForce(), problems);
    return problems.empty() ? tunables.change(changes) : problems;
  }
  Problems askFor(const std::string& name, double value) { return ask(with({}, name, value)); }
  static dynamic_reconfigure::Config with(dynamic_reconfigure::Config msg, const std::string& name, double value) {
    dynamic_reconfigure::DoubleParameter parameter;
    parameter.name = name;
    parameter.value = value;
    msg.doubles.push_back(parameter);
    return msg;
  }

  Tunable applied;
  int times = 0;
  Tunables tunables = tunablesOf<Tunable>(Tunable(), [this](const Tunable& changed) {
    applied = changed;
    ++times;
  });
};

TEST_F(TunableParameters, AreToldWithTypeBoundsDefaultAndMeaning) {
  const dynamic_reconfigure::ConfigDescription msg = toDescriptionMsg(tunables.defaults);
  ASSERT_EQ(msg.groups.size(), 1U);
  const auto& told = msg.groups[0].parameters;
  ASSERT_EQ(told.size(), 5U) << "rate may not change";
  EXPECT_EQ(told[0].name, "near");
  EXPECT_EQ(told[0].type, "double");
  EXPECT_EQ(told[0].description, "the near one [m], >= 0 and <= 1000");
  EXPECT_EQ(told[2].type, "int");
  EXPECT_EQ(told[3].type, "bool");
  EXPECT_EQ(told[4].name, "limits/max_linear");
  EXPECT_EQ(msg.dflt.doubles[0].value, 0.5);
  EXPECT_EQ(msg.min.doubles[0].value, 0.0);
  EXPECT_EQ(msg.max.doubles[0].value, 1000.0);
  EXPECT_EQ(msg.max.doubles[2].value, 20.0);
  EXPECT_EQ(msg.min.ints[0].value, 1);
  EXPECT_EQ(msg.max.ints[0].value, 1000000000);
  EXPECT_EQ(msg.min.bools[0].value, 0);
  EXPECT_EQ(msg.max.bools[0].value, 1);
}

TEST_F(TunableParameters, AGoodRequestIsAppliedAtOnceWithAllItsValues) {
  EXPECT_TRUE(ask(with(with({}, "far", 3.0), "near", 2.0)).empty()) << "together they are good";
  EXPECT_EQ(times, 1);
  EXPECT_EQ(applied.near, 2.0);
  EXPECT_EQ(applied.far, 3.0);
  EXPECT_TRUE(askFor("limits/max_linear", 0.1).empty());
  EXPECT_EQ(applied.robot.limits.max_linear, 0.1);
  EXPECT_EQ(applied.near, 2.0) << "the rest stays";
  EXPECT_EQ(toConfigMsg(tunables.inForce()).doubles[2].value, 0.1);
}

// [FLT-1]
TEST_F(TunableParameters, ARequestIsRefusedWholeForOneBadValue_FLT_1) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  for (const double bad : {-1.0, kNaN, kInfinite, -kInfinite}) {
    const Problems problems = ask(with(with({}, "far", 3.0), "near", bad));
    ASSERT_EQ(problems.size(), 1U) << bad;
    EXPECT_EQ(problems[0].rfind("near: ", 0), 0U) << problems[0];
  }
  EXPECT_FALSE(askFor("near", 5.0).empty()) << "a rule between two of them";
  EXPECT_FALSE(askFor("rate", 5.0).empty()) << "may not change";
  EXPECT_FALSE(askFor("nonsense", 5.0).empty());
  EXPECT_FALSE(askFor("limits/max_linear/x", 0.1).empty());
  EXPECT_FALSE(askFor("", 0.1).empty());
  EXPECT_FALSE(askFor("count", 4.0).empty()) << "of the wrong type";
  EXPECT_EQ(times, 0);
  EXPECT_EQ(toConfigMsg(tunables.inForce()).doubles[1].value, 1.0);
}

TEST(TunableParametersOfEveryNode, HaveFieldsAndDefaultsWithinTheirBounds) {
  const auto expectGood = [](const char* node, const std::vector<TunableField>& fields) {
    EXPECT_FALSE(fields.empty()) << node;
    for (const TunableField& field : fields) {
      const auto* number = std::get_if<double>(&field.value.value);
      EXPECT_TRUE(number == nullptr || field.bounds.allows(*number)) << node << " " << field.name;
    }
  };
  expectGood("cmd_vel_arbiter", tunableFields(arbiter::ArbiterParameters()));
  expectGood("obstacle_avoider", tunableFields(ObstacleAvoiderNodeParameters()));
  expectGood("patrol_server", tunableFields(PatrolServerParameters()));
  expectGood("behavior_server", tunableFields(BehaviorServerParameters()));
  expectGood("navigator", tunableFields(NavigatorNodeParameters()));
  expectGood("frontier_explorer", tunableFields(ExplorerNodeParameters()));
}

}  // namespace
}  // namespace frontier_pilot
