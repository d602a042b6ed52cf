#include "ros/common/master/master_state.h"

#include <netdb.h>
#include <poll.h>
#include <ros/network.h>
#include <ros/this_node.h>
#include <sys/socket.h>
#include <unistd.h>
#include <xmlrpcpp/XmlRpcException.h>

#include <algorithm>
#include <cerrno>
#include <memory>

#include "ros/common/master/xml_rpc.h"

namespace frontier_pilot {
namespace {

constexpr int kPatience = 300, kHurry = 20;  // [ms] for a connection

NodesByName toNodes(XmlRpc::XmlRpcValue& list) {
  NodesByName nodes;
  for (XmlRpc::XmlRpcValue& entry : elements(list)) {
    std::vector<std::string>& names = nodes[static_cast<std::string>(entry[0])];
    for (XmlRpc::XmlRpcValue& name : elements(entry[1])) names.push_back(static_cast<std::string>(name));
  }
  return nodes;
}

/// A TCP socket, closed by the destructor.
class Socket {
 public:
  explicit Socket(const addrinfo& address)
      : descriptor_(socket(address.ai_family, address.ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)) {}
  ~Socket() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  /// False only if the connection is refused: a process that does not respond may merely hang, and recover.
  bool mayConnect(const addrinfo& address, int patience) const {
    if (descriptor_ < 0) return true;
    if (connect(descriptor_, address.ai_addr, address.ai_addrlen) == 0) return true;
    if (errno != EINPROGRESS) return errno != ECONNREFUSED;
    pollfd wanted{descriptor_, POLLOUT, 0};
    if (poll(&wanted, 1, patience) <= 0) return true;
    int error = 0;
    socklen_t size = sizeof(error);
    getsockopt(descriptor_, SOL_SOCKET, SO_ERROR, &error, &size);
    return error != ECONNREFUSED;
  }

 private:
  int descriptor_;
};

enum class Reach { kUnknownHost, kRefused, kMayConnect };

/// With `in_a_hurry` only a host that is written as an address, or is this one, can be found unreachable.
Reach reach(std::string host, std::uint32_t port, bool in_a_hurry) {
  addrinfo hints{};
  if (in_a_hurry) {
    hints.ai_flags = AI_NUMERICHOST;
    if (host == ros::network::getHost() || host == "localhost") host = "127.0.0.1";
  }
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int failure = getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found);
  if (failure == EAI_AGAIN) return Reach::kMayConnect;  // the name server is silent: nobody knows
  if (failure != 0) return in_a_hurry ? Reach::kMayConnect : Reach::kUnknownHost;
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> addresses(found, freeaddrinfo);
  for (const addrinfo* address = found; address != nullptr; address = address->ai_next) {
    if (Socket(*address).mayConnect(*address, in_a_hurry ? kHurry : kPatience)) return Reach::kMayConnect;
  }
  return Reach::kRefused;
}

/// Asks the master with `method`, `lookupNode` or `lookupService`, for the address of `name`; empty if it has none, and
/// nothing if it does not answer.
std::optional<std::string> lookUp(const char* method, const std::string& name) {
  XmlRpc::XmlRpcValue request;
  request[0] = ros::this_node::getName();
  request[1] = name;
  std::optional<RpcAnswer> uri = askTheMaster(method, request);
  if (!uri) return std::nullopt;
  if (!uri->success || uri->value.getType() != XmlRpc::XmlRpcValue::TypeString) return std::string();
  return static_cast<std::string>(uri->value);
}

std::optional<Reach> reach(const std::string& uri, bool in_a_hurry = false) {
  std::string host;
  std::uint32_t port = 0;
  if (!ros::network::splitURI(uri, host, port)) return std::nullopt;
  return reach(host, port, in_a_hurry);
}

}  // namespace

std::optional<MasterState> askMaster() {
  XmlRpc::XmlRpcValue request;
  request[0] = ros::this_node::getName();
  try {
    std::optional<XmlRpc::XmlRpcValue> state = requestFromMaster("getSystemState", request);
    if (!state) return std::nullopt;
    return MasterState{toNodes((*state)[0]), toNodes((*state)[1]), toNodes((*state)[2])};
  } catch (const XmlRpc::XmlRpcException&) {
    return std::nullopt;  // the process at that address is not a ROS master
  }
}

std::vector<std::string> nodesOf(const NodesByName& nodes, const std::string& name) {
  const auto found = nodes.find(name);
  return found == nodes.end() ? std::vector<std::string>() : found->second;
}

bool isNodeOf(const NodesByName& nodes, const std::string& name, const std::string& node) {
  const std::vector<std::string> registered = nodesOf(nodes, name);
  return std::find(registered.begin(), registered.end(), node) != registered.end();
}

std::string uriOf(const std::string& node) { return lookUp("lookupNode", node).value_or(""); }

std::string uriOfService(const std::string& service) { return lookUp("lookupService", service).value_or(""); }

std::optional<bool> lifeOf(const std::string& node) {
  const std::optional<std::string> uri = lookUp("lookupNode", node);
  if (!uri) return std::nullopt;
  const std::optional<Reach> address = reach(*uri);
  if (!address || *address == Reach::kRefused) return false;  // a host that is unknown here may be known to others
  return reach(uriOfService(node + "/set_logger_level")) != Reach::kRefused;
}

bool nodeLives(const std::string& node) { return lifeOf(node).value_or(false); }

bool anyMayLive(const std::set<std::string>& uris) {
  return std::any_of(uris.begin(), uris.end(),
                     [](const std::string& uri) { return reach(uri, true) != Reach::kRefused; });
}

bool anyMayLivePatiently(const std::set<std::string>& uris) {
  return std::any_of(uris.begin(), uris.end(), [](const std::string& uri) { return reach(uri) != Reach::kRefused; });
}

bool serviceMayAnswer(const std::string& service) {
  return reach(uriOfService(service)).value_or(Reach::kMayConnect) == Reach::kMayConnect;
}

std::string firstLiving(const std::vector<std::string>& nodes) {
  const auto living = std::find_if(nodes.begin(), nodes.end(), nodeLives);
  return living == nodes.end() ? std::string() : *living;
}

}  // namespace frontier_pilot
