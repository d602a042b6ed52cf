// What a node says of itself on the command line.

#include "ros/common/help/node_usage.h"

#include <gtest/gtest.h>
#include <std_msgs/Bool.h>
#include <std_srvs/Trigger.h>

#include "ros/common/help/usages.h"

namespace frontier_pilot {
namespace {

NodeUsage exampleUsage() {
  NodeUsage usage;
  usage.name = "example";
  usage.purpose = "Shows how it is done.";
  usage.reads = {port<std_msgs::Bool>("light")};
  usage.services = {servicePort<std_srvs::Trigger>("lamp/test")};
  usage.parameters = {{"size", "double", "m", "0.5", "> 0", "how large it is"}, {"other", "int", "", "1", "", "rare"}};
  usage.main_parameters = {"size"};
  usage.example = "rosrun frontier_pilot example _size:=2";
  return usage;
}

TEST(NodeUsage, TellsPurposeTopicsServicesMainParametersAndAnExample) {
  const std::string help = helpOf(exampleUsage());
  for (const char* line :
       {"usage: rosrun frontier_pilot example [", "Shows how it is done.", "reads\n  light  std_msgs/Bool\n",
        "services\n  lamp/test  std_srvs/Trigger\n", "  ~size  0.5 m  how large it is\n",
        "(docs/parameters.md has all 2)", "example\n  rosrun frontier_pilot example _size:=2\n"}) {
    EXPECT_NE(help.find(line), std::string::npos) << line << "\nin\n" << help;
  }
  EXPECT_EQ(help.find("publishes"), std::string::npos) << "it publishes nothing";
  EXPECT_EQ(help.find("~other"), std::string::npos);
}

TEST(NodeUsage, OnlyWordsThatRosDoesNotReadAreWrong) {
  NodeUsage usage = exampleUsage();
  EXPECT_EQ(answerCommandLine({"a:=b", "_size:=2", "__name:=x", "__log:=/tmp/x.log"}, usage), std::nullopt);
  EXPECT_EQ(answerCommandLine({"a:=b", "--nonsense"}, usage), 2);
  EXPECT_EQ(answerCommandLine({"--nonsense", "-h"}, usage), 0);
  EXPECT_EQ(answerCommandLine({"-style", "Fusion"}, usage), 2);
  usage.library_options = {"-style"};
  EXPECT_EQ(answerCommandLine({"-style", "Fusion"}, usage), std::nullopt);
  EXPECT_EQ(answerCommandLine({"-style"}, usage), 2);
}

TEST(NodeUsage, ItemsOfAListAreOneRow) {
  const std::vector<detail::Describer::Row> rows = {{"sources[0]/name", "string", "", "a", "", "its name"},
                                                    {"sources[0]/rate", "double", "", "1", "", "its rate"},
                                                    {"sources[1]/name", "string", "", "b", "", "its name"},
                                                    {"sources[1]/rate", "double", "", "1", "", "its rate"}};
  const auto merged = withOneItem(rows);
  ASSERT_EQ(merged.size(), 2U);
  EXPECT_EQ(merged[0].name, "sources[i]/name");
  EXPECT_EQ(merged[0].value, "a, b");
  EXPECT_EQ(merged[1].value, "1");
  EXPECT_EQ(rowsNamed(rows, {"sources[i]/rate"}).size(), 1U);
}

}  // namespace
}  // namespace frontier_pilot
