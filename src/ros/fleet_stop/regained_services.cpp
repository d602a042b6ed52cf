#include "ros/fleet_stop/regained_services.h"

#include <utility>

#include "ros/fleet_stop/stop_answer.h"

namespace frontier_pilot {

std::vector<std::string> RegainedServices::take(const NodesByName& publishers, const NodesByName& providers) {
  std::vector<std::string> regained;
  const bool is_first_look = !std::exchange(has_looked_, true);
  const std::map<std::string, std::string> before = std::exchange(provider_, {});
  for (const auto& [topic, nodes] : publishers) {
    const std::string service = serviceBeside(topic);
    if (service.empty()) continue;
    const std::vector<std::string> current = nodesOf(providers, service);
    const std::string provider = current.empty() ? std::string() : current.front();
    provider_[service] = provider;
    const auto known = before.find(service);
    if (is_first_look || (known != before.end() && known->second == provider)) continue;
    if (isNodeOf(publishers, topic, provider)) regained.push_back(service);
  }
  return regained;
}

}  // namespace frontier_pilot
