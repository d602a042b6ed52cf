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
#include <vector>

#include "ros/common/clock.h"
#include "ros/teleop_gui/gui_bridge.h"
#include "ros/wait_for.h"

namespace frontier_pilot {
namespace {

using test::waitFor;

/// A program that is killed with this object at the latest.
class Program {
 public:
  Program() = default;
  ~Program() { end(); }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void begin(std::vector<std::string> words) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    process_ = fork();
    if (process_ != 0) return;
    execvp(arguments.front(), arguments.data());
    _exit(127);
  }
  void tell(int signal) const {
    if (process_ > 0) kill(process_, signal);
  }
  void end() {
    if (process_ <= 0) return;
    tell(SIGKILL);
    waitpid(process_, nullptr, 0);
    process_ = 0;
  }

 private:
  pid_t process_ = 0;
};

/// A ROS master at a port that depends on this process.
class Master {
 public:
  Master() {
    setenv("ROS_MASTER_URI", ("http://127.0.0.1:" + port_).c_str(), 1);
    begin();
  }
  void begin() { program_.begin({"rosmaster", "--core", "-p", port_}); }
  void hang(bool on) const { program_.tell(on ? SIGSTOP : SIGCONT); }
  void end() { program_.end(); }

 private:
  std::string port_ = std::to_string(20000 + static_cast<int>(getpid()) % 10000);
  Program program_;
};

Master* g_master = nullptr;

// [ARB-7] [FLT-2]
TEST(PanelWithoutAMaster, AStopIsDoneAtANewMasterThatHangs_ARB_7_FLT_2) {
  Program arbiter;
  arbiter.begin({std::filesystem::read_symlink("/proc/self/exe").replace_filename("cmd_vel_arbiter")});
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
