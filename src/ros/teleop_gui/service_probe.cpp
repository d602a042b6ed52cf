#include "ros/teleop_gui/service_probe.h"

#include <netdb.h>
#include <poll.h>
#include <ros/header.h>
#include <ros/network.h>
#include <ros/this_node.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <vector>

#include "ros/common/master/master_state.h"

namespace frontier_pilot {
namespace {

constexpr int kPatience = 1000;  // [ms] for a connection

/// Whether something of `events`, an error or an end has come within `patience` [ms].
bool hasCome(int socket, short events, int patience) {
  pollfd wanted{socket, events, 0};
  return poll(&wanted, 1, patience) > 0;
}

int errorOf(int socket) {
  int error = 0;
  socklen_t size = sizeof(error);
  return getsockopt(socket, SOL_SOCKET, SO_ERROR, &error, &size) == 0 ? error : errno;
}

}  // namespace

bool ServiceProbe::look() {
  const std::string uri = uriOfService(service_);
  if (uri == uri_ && waitsForAnswer()) return up_;
  hangUp();
  uri_ = uri;
  std::string host;
  std::uint32_t port = 0;
  up_ = ros::network::splitURI(uri, host, port) && ask(host, port);
  return up_;
}

bool ServiceProbe::waitsForAnswer() const { return socket_ >= 0 && !hasCome(socket_, POLLIN, 0); }

bool ServiceProbe::ask(const std::string& host, std::uint32_t port) {
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found) != 0) return false;
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> addresses(found, freeaddrinfo);
  for (const addrinfo* address = found; address != nullptr; address = address->ai_next) {
    if (connectTo(*address)) return sendQuestion();
    hangUp();
  }
  return false;
}

bool ServiceProbe::connectTo(const addrinfo& address) {
  socket_ = socket(address.ai_family, address.ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (socket_ < 0) return false;
  if (connect(socket_, address.ai_addr, address.ai_addrlen) == 0) return true;
  return errno == EINPROGRESS && hasCome(socket_, POLLOUT, kPatience) && errorOf(socket_) == 0;
}

/// The header of a connection that asks only whether the service is there.
bool ServiceProbe::sendQuestion() const {
  const ros::M_string question{
      {"probe", "1"}, {"md5sum", "*"}, {"callerid", ros::this_node::getName()}, {"service", service_}};
  boost::shared_array<std::uint8_t> header;
  std::uint32_t size = 0;
  ros::Header::write(question, header, size);
  std::vector<std::uint8_t> message(sizeof(size) + size);
  std::memcpy(message.data(), &size, sizeof(size));
  std::memcpy(message.data() + sizeof(size), header.get(), size);
  return send(socket_, message.data(), message.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(message.size());
}

void ServiceProbe::hangUp() {
  if (socket_ >= 0) close(socket_);
  socket_ = -1;
}

}  // namespace frontier_pilot
