#include "ros/common/master/xml_rpc.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include "ros/common/clock.h"

namespace frontier_pilot {
namespace {

/// A server on the loopback interface that accepts connections and never says a word.
class SilentServer {
 public:
  SilentServer() : listening_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof(address);
    auto* any = reinterpret_cast<sockaddr*>(&address);
    const bool listens = ::bind(listening_, any, size) == 0 && ::listen(listening_, 1) == 0;
    if (listens && ::getsockname(listening_, any, &size) == 0) port_ = ntohs(address.sin_port);
  }
  ~SilentServer() { ::close(listening_); }
  SilentServer(const SilentServer&) = delete;
  SilentServer& operator=(const SilentServer&) = delete;

  std::uint16_t port() const { return port_; }

 private:
  int listening_;
  std::uint16_t port_ = 0;
};

TEST(XmlRpc, AServerThatNeverAnswersIsWaitedForTwoSecondsOnly_FLT_1) {
  const SilentServer server;
  ASSERT_NE(server.port(), 0);
  const SteadyTime asked = steadyNow();
  EXPECT_FALSE(requestFrom("127.0.0.1", server.port(), "getSystemState", XmlRpc::XmlRpcValue("/test")));
  const SteadyTime answered = steadyNow();
  EXPECT_GE(answered - asked, std::chrono::milliseconds(1900));
  EXPECT_LT(answered - asked, std::chrono::seconds(60)) << "and not for half an hour";
}

TEST(XmlRpc, APortWhereNobodyListensIsNoAnswer_FLT_1) {
  std::uint16_t port = 0;
  { port = SilentServer().port(); }
  EXPECT_FALSE(requestFrom("127.0.0.1", port, "getSystemState", XmlRpc::XmlRpcValue("/test")));
}

}  // namespace
}  // namespace frontier_pilot
