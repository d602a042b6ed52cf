#include "ros/fleet_stop/regained_services.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

using Services = std::vector<std::string>;

const NodesByName kPublishers = {{"/robot1/cmd_vel_arbiter/status", {"/robot1/cmd_vel_arbiter"}},
                                 {"/robot1/map", {"/robot1/mapper"}}};

NodesByName providedBy(const std::string& node) { return {{"/robot1/emergency_stop", {node}}}; }

// [MUL-4] What is connected while a stranger has the service is connected to the stranger.
TEST(RegainedServices, AreThoseOfAnArbiterThatHasTakenItsServiceBack_MUL_4) {
  RegainedServices services;
  EXPECT_EQ(services.take(kPublishers, providedBy("/stranger")), Services{});
  EXPECT_EQ(services.take(kPublishers, {}), Services{}) << "nobody has it";
  EXPECT_EQ(services.take(kPublishers, providedBy("/robot1/cmd_vel_arbiter")), Services{"/robot1/emergency_stop"});
  EXPECT_EQ(services.take(kPublishers, providedBy("/robot1/cmd_vel_arbiter")), Services{}) << "once";
}

// [MUL-4] A connection to the arbiter is worth more than one to a node that has taken its service over.
TEST(RegainedServices, AreNotThoseThatAStrangerHasTakenOver_MUL_4) {
  RegainedServices services;
  EXPECT_EQ(services.take(kPublishers, providedBy("/robot1/cmd_vel_arbiter")), Services{});
  EXPECT_EQ(services.take(kPublishers, providedBy("/stranger")), Services{});
  EXPECT_EQ(services.take({}, providedBy("/robot1/cmd_vel_arbiter")), Services{}) << "it is no arbiter that is known";
}

// [MUL-4] [FLT-1] Meanwhile nobody knows the robot's arbiter, and what is remembered of robots does not grow.
TEST(RegainedServices, AreThoseOfAnArbiterThatWasGoneAltogether_MUL_4_FLT_1) {
  RegainedServices services;
  EXPECT_EQ(services.take(kPublishers, providedBy("/robot1/cmd_vel_arbiter")), Services{});
  EXPECT_EQ(services.take({}, providedBy("/stranger")), Services{});
  EXPECT_EQ(services.take(kPublishers, providedBy("/robot1/cmd_vel_arbiter")), Services{"/robot1/emergency_stop"});
}

}  // namespace
}  // namespace frontier_pilot
