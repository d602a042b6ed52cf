// How the window finds out which services are there.
#include "ros/teleop_gui/service_watch.h"

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <ros/ros.h>
#include <sys/socket.h>
#include <unistd.h>

#include <string>

#include "ros/common/master/xml_rpc.h"
#include "ros/wait_for.h"

namespace frontier_pilot {
namespace {

using test::waitFor;

/// A node that is frozen: it is registered for a service, and its system takes connections that nobody reads.
class FrozenNode {
 public:
  explicit FrozenNode(const std::string& service) : socket_(socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof(address);
    EXPECT_EQ(bind(socket_, reinterpret_cast<sockaddr*>(&address), size), 0);
    EXPECT_EQ(listen(socket_, 100), 0);
    EXPECT_EQ(getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size), 0);
    XmlRpc::XmlRpcValue request;
    request[0] = "/frozen_node";
    request[1] = service;
    request[2] = "rosrpc://127.0.0.1:" + std::to_string(ntohs(address.sin_port));
    request[3] = "http://127.0.0.1:1/";
    EXPECT_TRUE(requestFromMaster("registerService", request));
  }
  ~FrozenNode() { close(socket_); }
  FrozenNode(const FrozenNode&) = delete;
  FrozenNode& operator=(const FrozenNode&) = delete;

  /// Takes and ends the connections that have come since the last call; how many there were.
  int thaw() const {
    int count = 0;
    for (int connection = 0; (connection = accept(socket_, nullptr, nullptr)) >= 0; ++count) close(connection);
    return count;
  }

 private:
  int socket_;
};

// [GUI-2] [GUI-3]
TEST(ServiceWatchOnTheWire, ANodeThatDoesNotAnswerIsNotAskedAgainSoThatItsConnectionsAreLeftForAStop_GUI_2) {
  const FrozenNode arbiter("/frozen_stop");
  ServiceWatch watch(ros::NodeHandle(), [](const std::string&) {});
  watch.watch("frozen_stop");
  EXPECT_TRUE(waitFor([&] { return watch.up("frozen_stop"); }));
  ros::WallDuration(4.0).sleep();  // it looks once a second
  EXPECT_EQ(arbiter.thaw(), 1);
  EXPECT_TRUE(watch.up("frozen_stop")) << "it may be there still";
  int asked = 0;
  EXPECT_TRUE(waitFor([&] { return (asked += arbiter.thaw()) > 0; })) << "it is asked again once it has answered";
}

}  // namespace
}  // namespace frontier_pilot

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "service_watch_test");
  const ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
