#include "ros/common/messages/latched_repeats.h"

#include <algorithm>
#include <iterator>

#include "ros/common/master/own_parameters.h"
#include "ros/common/throttled_log.h"

namespace frontier_pilot {
namespace {

std::string valueOf(const ros::M_string& header, const char* key) {
  const auto found = header.find(key);
  return found == header.end() ? std::string() : found->second;
}

}  // namespace

void LateConnections::note(const std::set<Connection>& missing, SteadyTime now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  constexpr Duration kLateAfter = std::chrono::milliseconds(800);
  std::map<Connection, SteadyTime> since;
  for (const auto& connection : missing) {
    const auto before = since_.find(connection);
    since[connection] = before == since_.end() ? now : before->second;
    if (now - since[connection] >= kLateAfter) late_[connection] = now;
  }
  since_ = std::move(since);
  for (auto it = late_.begin(); it != late_.end();) it = now - it->second > kSettling ? late_.erase(it) : std::next(it);
}

bool LateConnections::has(const std::string& topic, const std::string& publisher, SteadyTime now) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = late_.find({topic, publisher});
  return found != late_.end() && now - found->second <= kSettling;
}

LateConnections& lateConnections() {
  static LateConnections late;
  return late;
}

void LatchedRepeats::look(SteadyTime now) {
  if (!is_settled_) is_settled_ = !hold_ups_.isCatchingUp(now) && now >= settling_until_;
}

bool LatchedRepeats::isRepeat(const Header& header, SteadyTime now) {
  look(now);
  if (!header || valueOf(*header, "latching") != "1") return false;
  const std::string publisher = valueOf(*header, "callerid");
  const auto known =
      std::find_if(heard_.begin(), heard_.end(), [&](const auto& entry) { return entry.first == publisher; });
  if (known == heard_.end()) {
    if (heard_.size() == kMostRemembered) heard_.pop_front();
    heard_.emplace_back(publisher, header);
    return !is_settled_ || (settles_ && late_.has(topic_, publisher, now));
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
