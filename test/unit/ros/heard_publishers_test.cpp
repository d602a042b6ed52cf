#include "ros/common/messages/heard_publishers.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

SteadyTime steadyAt(double seconds) { return SteadyTime{} + fromSeconds(seconds); }

TEST(HeardPublishers, AreNamedWhenTheyAreSeveralAndForgottenWhenTheyFallSilent_FLT_1) {
  HeardPublishers heard;
  EXPECT_EQ(heard.severalNames(steadyAt(0.0)), "");
  heard.add("/base", steadyAt(0.0));
  EXPECT_EQ(heard.severalNames(steadyAt(0.1)), "");
  heard.add("/another", steadyAt(0.2));
  EXPECT_EQ(heard.severalNames(steadyAt(0.3)), "/another, /base");
  heard.add("/base", steadyAt(5.0));
  EXPECT_EQ(heard.severalNames(steadyAt(5.1)), "");
}

TEST(HeardPublishers, AreAFewNamesHoweverManyThereAre_FLT_1) {
  HeardPublishers heard;
  for (int i = 0; i < 1000; ++i) heard.add(std::string(100, 'x') + std::to_string(i), steadyAt(0.001 * i));
  EXPECT_LT(heard.severalNames(steadyAt(1.0)).size(), 1000U);
}

}  // namespace
}  // namespace frontier_pilot
