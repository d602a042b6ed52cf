// The operator's panel when its master dies. The test has a master of its own, which it may kill.

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "ros/common/clock.h"
#include "ros/teleop_gui/gui_bridge.h"
#include "ros/wait_for.h"

namespace frontier_pilot {
namespace {

using test::waitFor;

/// A ROS master at a port that depends on this process.
class Master {
 public:
  Master() : port_(20000 + static_cast<int>(getpid()) % 10000), process_(fork()) {
    if (process_ == 0) {
      execlp("rosmaster", "rosmaster", "--core", "-p", std::to_string(port_).c_str(), nullptr);
      _exit(127);
    }
    setenv("ROS_MASTER_URI", ("http://127.0.0.1:" + std::to_string(port_)).c_str(), 1);
  }
  ~Master() { end(); }
  Master(const Master&) = delete;
  Master& operator=(const Master&) = delete;

  void end() {
    if (process_ <= 0) return;
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
    process_ = 0;
  }

 private:
  int port_;
  pid_t process_;
};

Master* g_master = nullptr;

// [GUI-3] [FLT-1]
TEST(PanelWithoutAMaster, AnArrowKeyDoesNotHoldTheWindowsThread_GUI_3) {
  GuiBridge bridge(ros::NodeHandle(), teleop::TeleopParameters(), GuiBridge::Manual::kOnDemand, [] { return true; });
  ASSERT_TRUE(waitFor([&] { return bridge.state().connected; }));
  g_master->end();
  ASSERT_TRUE(waitFor([&] { return !bridge.state().connected; }));
  const SteadyTime begin = steadyNow();
  Duration longest{};
  for (SteadyTime now = begin; now - begin < std::chrono::seconds(2); now = steadyNow()) {
    bridge.beat({0.05, 0.0});
    EXPECT_FALSE(bridge.state().connected);
    longest = std::max<Duration>(longest, steadyNow() - now);
    ros::WallDuration(0.05).sleep();
  }
  EXPECT_LT(toSeconds(longest), 0.5);
}

}  // namespace
}  // namespace frontier_pilot

int main(int argc, char** argv) {
  frontier_pilot::Master master;
  frontier_pilot::g_master = &master;
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "panel_without_master_test");
  const ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
