#pragma once

#include <rosbag/bag.h>

#include <string>
#include <vector>

#include "tools/map_log_options.h"

namespace frontier_pilot {

/// The topics of a bag that are read, and what the operator should know of the choice.
struct BagChoice {
  tools::BagTopics topics;
  std::vector<std::string> words;  ///< empty where nothing had to be chosen and nothing is unusual
};

/// Chooses the topics that `wanted` leaves open, as the node bag_player does: of several LaserScan topics the one with
/// the widest field of view, of several Odometry topics the one called odom, or else the one with most messages.
BagChoice chooseTopics(const rosbag::Bag& bag, const tools::BagTopics& wanted);

/// Whether two names are the same topic: bags contain them with or without the leading slash.
bool isSameTopic(const std::string& a, const std::string& b);

/// For each stretch of more than two seconds, and ten usual gaps, without a message a text that says when and how long;
/// `stamps` [s] in any order.
std::vector<std::string> describeHoles(const std::string& what, std::vector<double> stamps);

}  // namespace frontier_pilot
