#include "ros/fleet_stop/stop_answer.h"

#include <algorithm>

#include "ros/common/messages/stop_words.h"
#include "ros/common/names.h"

namespace frontier_pilot {
namespace {

std::string reasonOf(const StopAnswer& answer) {
  switch (answer.outcome) {
    case StopOutcome::kConfirmed:
      return "confirmed";
    case StopOutcome::kSilent:
      return "silent";
    case StopOutcome::kNoService:
      return "no service";
    case StopOutcome::kRefused:
      return "refused" + (answer.text.empty() ? "" : ": " + answer.text);
  }
  return "?";
}

}  // namespace

std::string robotOf(const std::string& service) {
  const std::string end = std::string("/") + names::kEmergencyStop;
  const bool fits = service.size() > end.size() && service.compare(service.size() - end.size(), end.size(), end) == 0;
  const std::string robot = fits ? service.substr(0, service.size() - end.size()) : "";
  if (robot.empty()) return "/";
  return robot.substr(robot.front() == '/' ? 1 : 0);
}

std::string serviceBeside(const std::string& topic) {
  const std::string end = std::string("/") + names::kArbiterStatus;
  if (topic.size() < end.size() || topic.compare(topic.size() - end.size(), end.size(), end) != 0) return {};
  return topic.substr(0, topic.size() - end.size()) + "/" + names::kEmergencyStop;
}

FleetAnswer summarize(const std::vector<RobotAnswer>& answers) {
  if (answers.empty()) return {false, "no robot is listed or known"};
  const auto confirmed = std::count_if(answers.begin(), answers.end(), [](const RobotAnswer& robot) {
    return robot.answer.outcome == StopOutcome::kConfirmed;
  });
  FleetAnswer answer;
  answer.success = confirmed == static_cast<std::ptrdiff_t>(answers.size());
  answer.message = std::to_string(confirmed) + " of " + std::to_string(answers.size()) + " robots stopped";
  for (const RobotAnswer& robot : answers) {
    const std::string name = robotOf(robot.service);
    if (robot.answer.outcome != StopOutcome::kConfirmed) {
      answer.message += "; not confirmed by " + name + ": " + reasonOf(robot.answer);
    } else if (mayBeUnsent(robot.answer.text)) {
      answer.message += "; " + name + ": " + robot.answer.text;
    } else if (!isSigned(robot.answer.text)) {
      answer.message += "; " + unsignedAnswerOf(name);
    }
  }
  return answer;
}

}  // namespace frontier_pilot
