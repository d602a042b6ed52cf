#include "robot_check/other_names.h"

#include <algorithm>

namespace frontier_pilot::robot_check {
namespace {

/// What follows the last slash: robot1/base_link is a base_link.
std::string withoutPrefix(const std::string& frame) { return frame.substr(frame.find_last_of('/') + 1); }

/// The names that drivers give to the frame of the base, the usual ones first.
const std::vector<std::string>& baseNames() {
  static const std::vector<std::string> kNames = {"base_footprint", "base_link", "base", "base_frame", "chassis"};
  return kNames;
}

std::string findByName(const std::string& name, const std::set<std::string>& frames) {
  const auto found =
      std::find_if(frames.begin(), frames.end(), [&](const std::string& f) { return withoutPrefix(f) == name; });
  return found == frames.end() ? std::string() : *found;
}

/// The topic with this name that somebody publishes with another type; nullptr if there is none.
const Topic* otherTypeOf(const std::vector<Topic>& topics, const std::string& name, const std::string& type) {
  const Topic* topic = findTopic(topics, name);
  return topic != nullptr && !topic->publishers.empty() && topic->type != type ? topic : nullptr;
}

}  // namespace

const Topic* findTopic(const std::vector<Topic>& topics, const std::string& name) {
  const auto found = std::find_if(topics.begin(), topics.end(), [&](const Topic& topic) { return topic.name == name; });
  return found == topics.end() ? nullptr : &*found;
}

std::vector<const Topic*> othersOfType(const std::vector<Topic>& topics, const std::string& name,
                                       const std::string& type) {
  std::vector<const Topic*> others;
  for (const Topic& topic : topics) {
    if (topic.name != name && topic.type == type && !topic.publishers.empty()) others.push_back(&topic);
  }
  return others;
}

std::string standInFor(const std::string& wanted, const std::set<std::string>& frames) {
  const std::string bare = withoutPrefix(wanted);
  if (std::string same = findByName(bare, frames); !same.empty()) return same;
  const auto& names = baseNames();
  if (std::find(names.begin(), names.end(), bare) == names.end()) return {};
  for (const std::string& name : names) {
    if (std::string frame = findByName(name, frames); !frame.empty()) return frame;
  }
  return {};
}

bool isThereUnderAnotherName(const std::vector<Topic>& topics, const std::string& name, const std::string& type) {
  return otherTypeOf(topics, name, type) == nullptr && !othersOfType(topics, name, type).empty();
}

std::string sayMissingTopic(const std::vector<Topic>& topics, const std::string& name, const std::string& type,
                            const std::string& argument) {
  if (const Topic* topic = otherTypeOf(topics, name, type)) {
    return name + " is a " + topic->type + " of " + topic->publishers.front() + ", not a " + type;
  }
  std::string text = "nobody publishes " + name;
  const auto others = othersOfType(topics, name, type);
  if (others.empty()) return text;
  for (const Topic* other : others) text += "; " + other->name + " is a " + type + " of " + other->publishers.front();
  const bool is_sure = others.size() == 1;
  return text + ": set " + argument + ":=" + (is_sure ? others.front()->name : "NAME, the one that is the robot's");
}

std::string sayMissingFrame(const std::string& wanted, const std::set<std::string>& frames,
                            const std::string& argument) {
  const std::string other = standInFor(wanted, frames);
  if (other.empty()) return "no frame " + wanted;
  return "no frame " + wanted + "; " + other + " exists: set " + argument + ":=" + other;
}

}  // namespace frontier_pilot::robot_check
