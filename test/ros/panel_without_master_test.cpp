// The operator's panel when its master dies. The test has a master of its own, which it may kill.

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
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
  Master() : port_(20000 + static_cast<int>(getpid()) % 10000) {
    setenv("ROS_MASTER_URI", ("http://127.0.0.1:" + std::to_string(port_)).c_str(), 1);
    begin();
  }
  void begin() {
    process_ = fork();
    if (process_ != 0) return;
    execlp("rosmaster", "rosmaster", "--core", "-p", std::to_string(port_).c_str(), nullptr);
    _exit(127);
  }
  void hang(bool on) const { kill(process_, on ? SIGSTOP : SIGCONT); }
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
  pid_t process_ = 0;
};

/// An arbiter at that master.
class Arbiter {
 public:
  Arbiter() : process_(fork()) {
    if (process_ != 0) return;
    const std::string path = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "cmd_vel_arbiter";
    execl(path.c_str(), "cmd_vel_arbiter", nullptr);
    _exit(127);
  }
  ~Arbiter() {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  Arbiter(const Arbiter&) = delete;
  Arbiter& operator=(const Arbiter&) = delete;

 private:
  pid_t process_;
};

Master* g_master = nullptr;

// [ARB-7] [FLT-2]
TEST(PanelWithoutAMaster, AStopIsDoneAtANewMasterThatHangs_ARB_7_FLT_2) {
  const Arbiter arbiter;
  GuiBridge bridge(ros::NodeHandle(), teleop::TeleopParameters(), GuiBridge::Manual::kOnDemand, [] { return true; });
  const auto stopped = [&] { return bridge.state().emergency_stop.value_or(false); };
  ASSERT_TRUE(waitFor([&] { return bridge.state().connected && bridge.state().stop_service_up; }));
  g_master->end();
  ros::WallDuration(1.0).sleep();
  g_master->begin();
  ros::WallDuration(3.0).sleep();  // in which everything is registered again
  g_master->hang(true);
  bridge.request({teleop::OperatorRequest::Kind::kEmergencyStop, true, ""});
  EXPECT_TRUE(waitFor(stopped));
  g_master->hang(false);
}

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
