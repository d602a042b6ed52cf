#include "ros/common/memory/remembered_text.h"

#include <utility>

#include "ros/common/master/ros_sessions.h"
#include "ros/common/memory/disk.h"
#include "ros/common/throttled_log.h"

namespace frontier_pilot {

RememberedText::RememberedText(std::string what, const std::string& owner, SessionMemory::Owner kind,
                               NodeConnections& connections)
    : what_(std::move(what)), report_(connections.memory()), memory_(rosHome(), rosSessions(), what_, owner, kind) {
  left_ = memory_.recallAll();
  left_elsewhere_ = memory_.recallFromElsewhere();
  connections.master().onSession([this](const std::vector<std::string>& sessions) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (memory_.enter(sessions)) write();
  });
  connections.everySteady(ros::WallDuration(1.0), [this] {
    const std::lock_guard<std::mutex> lock(mutex_);
    write();
  });
}

void RememberedText::end(bool forget) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ended_ = true;
  if (forget) memory_.forget();
  memory_.endInOrder();
}

std::string RememberedText::set(std::optional<std::string> text) {
  const std::lock_guard<std::mutex> lock(mutex_);
  text_ = std::move(text);
  if (!text_) memory_.forget();
  return write();
}

std::string RememberedText::write() {
  if (ended_) return {};
  std::string problem = text_ ? memory_.remember(*text_) : memory_.problem();
  report_.setProblem(what_, problem);
  if (!text_ || problem.empty()) {
    warned_of_.clear();
  } else if (problem != warned_of_) {
    warned_of_ = problem;
    THROTTLED_WARN(what_ << " would not survive a restart: " << problem);
  }
  return problem;
}

}  // namespace frontier_pilot
