#include "ros/common/messages/latched_repeats.h"

#include <algorithm>

#include "ros/common/master/own_parameters.h"
#include "ros/common/throttled_log.h"

namespace frontier_pilot {
namespace {

std::string valueOf(const ros::M_string& header, const char* key) {
  const auto found = header.find(key);
  return found == header.end() ? std::string() : found->second;
}

}  // namespace

bool LatchedRepeats::isRepeat(const Header& header, SteadyTime now) {
  if (!header || valueOf(*header, "latching") != "1") return false;
  const std::string publisher = valueOf(*header, "callerid");
  const auto known =
      std::find_if(heard_.begin(), heard_.end(), [&](const auto& entry) { return entry.first == publisher; });
  if (known == heard_.end()) {
    if (heard_.size() == kMostRemembered) heard_.pop_front();
    heard_.emplace_back(publisher, header);
    return now < settled_;
  }
  const bool is_repeat = known->second != header;
  heard_.erase(known);
  heard_.emplace_back(publisher, header);  // the one that was heard last is forgotten last
  return is_repeat;
}

Duration settlingOfARestart() { return replacesAProcess() ? kSettling : Duration::zero(); }

void sayRepeat(const std::string& topic, const std::string& publisher) {
  THROTTLED_WARN("a message of " << publisher << " on " << topic
                                 << " is ignored: it was published before, and its publisher latches it");
}

}  // namespace frontier_pilot
