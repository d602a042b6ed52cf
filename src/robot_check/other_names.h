#pragma once

#include <set>
#include <string>
#include <vector>

#include "robot_check/observation.h"

/// Whether what is missing is there under another name.
namespace frontier_pilot::robot_check {

/// The topic with this name; nullptr if the master has none.
const Topic* findTopic(const std::vector<Topic>& topics, const std::string& name);

/// The topics of `type`, other than `name`, that somebody publishes.
std::vector<const Topic*> othersOfType(const std::vector<Topic>& topics, const std::string& name,
                                       const std::string& type);

/// The frame that has the same role as `wanted` under another name: the same name with another prefix, or base_link for
/// base_footprint and the reverse. Empty if there is none.
std::string standInFor(const std::string& wanted, const std::set<std::string>& frames);

/// Whether `sayMissingTopic` names a topic to set instead.
bool isThereUnderAnotherName(const std::vector<Topic>& topics, const std::string& name, const std::string& type);

/// "nobody publishes /scan; /base_scan is a sensor_msgs/LaserScan of /driver: set scan:=/base_scan", for the argument
/// `argument` of the launch files; without another topic of that type the sentence ends after its first part, and with
/// several of them it lists them all and leaves the choice to the reader.
std::string sayMissingTopic(const std::vector<Topic>& topics, const std::string& name, const std::string& type,
                            const std::string& argument);

/// "no frame base_footprint; base_link exists: set base_frame:=base_link".
std::string sayMissingFrame(const std::string& wanted, const std::set<std::string>& frames,
                            const std::string& argument);

}  // namespace frontier_pilot::robot_check
