#include "frontier_pilot/ros/heard_publishers.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

SteadyTime at(double seconds) { return SteadyTime{} + fromSeconds(seconds); }

TEST(HeardPublishers, AreNamedWhenTheyAreSeveralAndForgottenWhenTheyFallSilent_FLT_1) {
  HeardPublishers heard;
  EXPECT_EQ(heard.severalNames(at(0.0)), "");
  heard.add("/base", at(0.0));
  EXPECT_EQ(heard.severalNames(at(0.1)), "");
  heard.add("/another", at(0.2));
  EXPECT_EQ(heard.severalNames(at(0.3)), "/another, /base");
  heard.add("/base", at(5.0));
  EXPECT_EQ(heard.severalNames(at(5.1)), "");
}

TEST(HeardPublishers, AreAFewNamesHoweverManyThereAre_FLT_1) {
  HeardPublishers heard;
  for (int i = 0; i < 1000; ++i) heard.add(std::string(100, 'x') + std::to_string(i), at(0.001 * i));
  EXPECT_LT(heard.severalNames(at(1.0)).size(), 1000U);
}

}  // namespace
}  // namespace frontier_pilot
