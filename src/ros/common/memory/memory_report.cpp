#include "ros/common/memory/memory_report.h"

#include <diagnostic_msgs/DiagnosticStatus.h>

namespace frontier_pilot {
namespace {

void mergeReasons(const std::map<std::string, std::string>& reasons, unsigned char level, const std::string& verb,
                  diagnostic_updater::DiagnosticStatusWrapper& status) {
  if (reasons.empty()) return;
  const auto& [what, why] = *reasons.begin();
  const std::string more = reasons.size() > 1 ? " and " + std::to_string(reasons.size() - 1) + " more" : "";
  status.mergeSummary(level, what + more + " " + verb + ": " + why);
  const std::string ending = " " + verb;
  for (const auto& [each, reason] : reasons) status.add(each + ending, reason);
}

}  // namespace

void MemoryReport::set(Reasons& reasons, const std::string& what, const std::string& why) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (why.empty()) {
    reasons.erase(what);
  } else {
    reasons[what] = why;
  }
}

void MemoryReport::report(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  using diagnostic_msgs::DiagnosticStatus;
  const std::lock_guard<std::mutex> lock(mutex_);
  status.summary(DiagnosticStatus::OK, "everything that has to survive a restart is stored");
  mergeReasons(losses_, DiagnosticStatus::ERROR, "was lost", status);
  mergeReasons(problems_, DiagnosticStatus::WARN, "would not survive this node", status);
}

}  // namespace frontier_pilot
