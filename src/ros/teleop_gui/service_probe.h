#pragma once

#include <cstdint>
#include <string>
#include <utility>

struct addrinfo;

namespace frontier_pilot {

/// Finds out whether a service is there, in the way of `ros::service::exists`, but asks only once until the server has
/// answered, and waits for no more than two seconds for the master and for one for a connection. The questions that a
/// frozen node has not read would fill its queue of connections until nobody could connect any more, not even a stop.
class ServiceProbe {
 public:
  /// `service` is its resolved name.
  explicit ServiceProbe(std::string service) : service_(std::move(service)) {}
  ~ServiceProbe() { hangUp(); }
  ServiceProbe(const ServiceProbe&) = delete;
  ServiceProbe& operator=(const ServiceProbe&) = delete;

  /// Whether the service is there. While a question has no answer, this is what was known before.
  bool look();

 private:
  bool waitsForAnswer() const;
  bool ask(const std::string& host, std::uint32_t port);
  bool connectTo(const addrinfo& address);
  bool sendQuestion() const;
  void hangUp();

  std::string service_;
  std::string uri_;  ///< of the server that was asked last
  int socket_ = -1;  ///< of the question that was sent last; -1 if there is none
  bool up_ = false;
};

}  // namespace frontier_pilot
