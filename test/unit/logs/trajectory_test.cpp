#include "frontier_pilot/logs/trajectory.h"

#include <gtest/gtest.h>

#include <sstream>

namespace frontier_pilot {
namespace {

TEST(Tum, HasALineForEachPose) {
  std::ostringstream out;
  logs::writeTum(out, {{timeFromSeconds(1.5), {1.0, -2.0, kPi / 2}}, {timeFromSeconds(2.0), {}}});
  EXPECT_EQ(
      out.str(),
      "1.500000 1.000000 -2.000000 0 0 0 0.707107 0.707107\n2.000000 0.000000 0.000000 0 0 0 0.000000 1.000000\n");
}

}  // namespace
}  // namespace frontier_pilot
