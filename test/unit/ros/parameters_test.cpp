#include "ros/common/parameters.h"

#include <gtest/gtest.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <stdexcept>

#include "frontier_pilot/core/robot_model.h"
#include "ros/common/master/parameter_values.h"

namespace frontier_pilot {
namespace {

TEST(Parameters, EveryTypeOfTheParameterServerIsRead) {
  XmlRpc::XmlRpcValue value;
  value["flag"] = true;
  value["count"] = 3;
  value["length"] = 0.5;
  value["name"] = std::string("robot");
  value["list"][0] = 1;
  value["list"][1] = 2.5;
  value["group"]["inner"] = 7;
  const auto map = std::get<ParameterMap>(toParameterValue(value).value);
  EXPECT_EQ(std::get<bool>(map.at("flag").value), true);
  EXPECT_EQ(std::get<std::int64_t>(map.at("count").value), 3);
  EXPECT_EQ(std::get<double>(map.at("length").value), 0.5);
  EXPECT_EQ(std::get<std::string>(map.at("name").value), "robot");
  EXPECT_EQ(std::get<ParameterList>(map.at("list").value).size(), 2U);
  EXPECT_EQ(std::get<std::int64_t>(std::get<ParameterMap>(map.at("group").value).at("inner").value), 7);
}

TEST(Parameters, AnIntegerIsGoodWhereARealIsMeant) {
  XmlRpc::XmlRpcValue value;
  value["max_linear"] = 1;
  RobotLimits limits;
  EXPECT_TRUE(loadParameters(std::get<ParameterMap>(toParameterValue(value).value), limits).empty());
  EXPECT_EQ(limits.max_linear, 1.0);
}

TEST(Parameters, BinaryDataIsNoValueThatAFieldAccepts) {
  XmlRpc::XmlRpcValue value;
  char data[] = "abc";
  value["max_linear"] = XmlRpc::XmlRpcValue(data, sizeof(data));
  RobotLimits limits;
  EXPECT_EQ(loadParameters(std::get<ParameterMap>(toParameterValue(value).value), limits).size(), 1U);
}

TEST(Parameters, AnErrorListsEveryProblemByName) {
  XmlRpc::XmlRpcValue value;
  value["max_linear"] = -1.0;
  value["max_anglar"] = 2.0;
  RobotLimits limits;
  const Problems problems = loadParameters(std::get<ParameterMap>(toParameterValue(value).value), limits);
  const std::string text = ConfigurationError("/robot", problems).what();
  for (const char* part : {"/robot", "max_linear", "max_anglar"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " missing in: " << text;
  }
}

TEST(Parameters, AProblemThatQuotesALongValueIsCut) {
  const Problems problems = {"odometry: must be topic or tf, not '" + std::string(100000, 'a') + "'",
                             "watchdog: must be > 0"};
  const std::string text = ConfigurationError("/robot", problems).what();
  EXPECT_LT(text.size(), 1200U);
  EXPECT_NE(text.find("a ...\n  watchdog: must be > 0"), std::string::npos) << text;
}

// [FLT-1]
TEST(Parameters, TooDeepOnesAndTooManyAreRefused) {
  XmlRpc::XmlRpcValue deep;
  XmlRpc::XmlRpcValue* inner = &deep;
  for (int i = 0; i < 40; ++i) inner = &(*inner)["a"];
  *inner = 1;
  EXPECT_THROW(toParameterValue(deep), std::length_error);
  XmlRpc::XmlRpcValue many;
  many["list"].setSize(100'001);
  for (int i = 0; i < many["list"].size(); ++i) many["list"][i] = i;
  EXPECT_THROW(toParameterValue(many), std::length_error);
  EXPECT_EQ(std::get<ParameterMap>(toParameterValue(deep["a"]["a"]["a"]["a"]["a"]["a"]["a"]["a"]["a"]).value).size(),
            1U);
}

}  // namespace
}  // namespace frontier_pilot
