#pragma once

#include <string>

namespace frontier_pilot {

/// Registers this node at the master once more, for what roscpp took care of when it was set up. Names are resolved.
/// roscpp itself does so only once. Its connections stay as they are. False if the master does not take it.
bool registerPublisher(const std::string& topic);
bool registerService(const std::string& service);
/// Whether the master sends those who call `service` to this process; true also if it does not answer.
bool pointsHere(const std::string& service);
/// Also connects to the publishers that the master knows, beside those that are connected already.
bool registerSubscriber(const std::string& topic);

}  // namespace frontier_pilot
