#include "ros/common/memory/memory_report.h"

#include <diagnostic_msgs/DiagnosticStatus.h>

#include <chrono>

#include "ros/common/memory/disk.h"

namespace frontier_pilot {
namespace {

constexpr Duration kLateWrite = std::chrono::seconds(5);  // a disk that is silent for less is only slow

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

std::string MemoryReport::setProblem(const std::string& what, const std::string& problem, SteadyTime now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  bool counts = true;
  if (problem == kSilentDisk) {
    counts = now - silent_since_.emplace(what, now).first->second >= kLateWrite;
  } else {
    silent_since_.erase(what);
  }
  std::string counted = counts ? problem : std::string();
  set(problems_, what, counted);
  return counted;
}

void MemoryReport::setLoss(const std::string& what, const std::string& why) {
  const std::lock_guard<std::mutex> lock(mutex_);
  set(losses_, what, why);
}

void MemoryReport::set(Reasons& reasons, const std::string& what, const std::string& why) {
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
