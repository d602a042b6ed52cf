#include <diagnostic_msgs/DiagnosticStatus.h>

#include <algorithm>
#include <utility>

#include "ros/cmd_vel_arbiter/arbiter_report.h"
#include "ros/common/messages/conversions.h"

namespace frontier_pilot {
namespace {

using Level = diagnostic_msgs::DiagnosticStatus;

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::vector<std::string> publishersOn(const std::string& topic, const ArbiterConnections& around) {
  return nodesOf(around.publishers, topic);
}

std::string stateInWords(const arbiter::SourceStatus& source, const arbiter::ArbiterSnapshot& snapshot,
                         bool has_publisher) {
  std::string state = toString(source.state);
  switch (source.state) {
    case arbiter::SourceState::kNeverHeard:
      // It was heard, but before it was enabled, a stop was cleared or the clock jumped.
      if (source.age) return "waiting for a new command";
      return state + (has_publisher ? ": no message yet" : ": no publisher");
    case arbiter::SourceState::kStale:
      return state + ": no message within its timeout";
    case arbiter::SourceState::kRejected:
      return state + ": its last message was not finite";
    case arbiter::SourceState::kIdle:
      return state + ": alive, asks for nothing";
    case arbiter::SourceState::kReady:
      return state + ": " + (snapshot.active_source.empty() ? toString(snapshot.state) : snapshot.active_source) +
             " has priority";
    case arbiter::SourceState::kActive:
      return state + ": holds the wheels";
    case arbiter::SourceState::kDisabled:
      break;
  }
  return state;
}

ArbiterSource toSourceMsg(const arbiter::SourceStatus& source, const arbiter::ArbiterSnapshot& snapshot,
                          const ArbiterConnections& around) {
  ArbiterSource msg;
  msg.name = source.name;
  msg.topic = around.source_topics.at(source.name);
  msg.publishers = publishersOn(msg.topic, around);
  msg.state = static_cast<std::uint8_t>(source.state);
  msg.state_text = stateInWords(source, snapshot, !msg.publishers.empty());
  msg.priority = source.priority;
  msg.enabled = static_cast<std::uint8_t>(source.enabled);
  msg.required = static_cast<std::uint8_t>(source.required);
  msg.age = source.age.value_or(-1.0);
  msg.rate = source.rate;
  msg.rejected = source.rejected;
  return msg;
}

void findForeignPublishers(const std::string& topic, unsigned char level, const ArbiterConnections& around,
                           std::vector<ArbiterProblem>& problems) {
  for (std::string text : publishersOn(topic, around)) {
    if (text == around.own_name) continue;
    text.append(" publishes ").append(topic).append(" as well");
    problems.push_back({level, std::move(text)});
  }
}

void findSourceProblems(const arbiter::SourceStatus& source, const ArbiterConnections& around,
                        std::vector<ArbiterProblem>& problems) {
  const std::vector<std::string> publishers = publishersOn(around.source_topics.at(source.name), around);
  if (publishers.size() > 1) {
    problems.push_back({Level::WARN, std::to_string(publishers.size()) + " nodes publish " +
                                         around.source_topics.at(source.name) + ": " + joined(publishers)});
  }
  if (source.state == arbiter::SourceState::kRejected) {
    problems.push_back({Level::WARN, source.name + " sends velocities that are not finite"});
  }
}

}  // namespace

std::vector<ArbiterProblem> findProblems(const arbiter::ArbiterSnapshot& snapshot, const ArbiterConnections& around) {
  std::vector<ArbiterProblem> problems;
  for (const std::string& text : around.registration_problems) problems.push_back({Level::ERROR, text});
  findForeignPublishers(around.cmd_vel, Level::ERROR, around, problems);
  // A stop that another node publishes there stops this arbiter, too, and other nodes take it for this one's state.
  findForeignPublishers(around.emergency_stop_state, Level::WARN, around, problems);
  for (const std::string& name : snapshot.missing_sources) {
    problems.push_back({Level::ERROR, name + " is required but silent: no forward motion below it"});
  }
  if (snapshot.state == arbiter::ArbiterState::kClockStopped)
    problems.push_back({Level::ERROR, "ROS time stands still"});
  if (!around.memory_problem.empty()) {
    const bool stopped = !snapshot.stop_cause.empty();
    problems.push_back(
        {Level::ERROR, (stopped ? "an emergency stop would not survive this node: "
                                : "the stop that was cleared would come back with the next start of this node: ") +
                           around.memory_problem});
  }
  if (!around.fleet_problem.empty()) problems.push_back({Level::ERROR, around.fleet_problem});
  if (!snapshot.stop_cause.empty()) problems.push_back({Level::WARN, "emergency stop: " + snapshot.stop_cause});
  for (const arbiter::SourceStatus& source : snapshot.sources) findSourceProblems(source, around, problems);
  if (!snapshot.unreachable.empty()) {
    problems.push_back({Level::ERROR, "no emergency stop can be called: " + snapshot.unreachable});
  }
  if (!around.master_answers) {
    problems.push_back(
        {Level::ERROR,
         "the master does not answer: only a window that was connected before can call an emergency stop"});
  }
  return problems;
}

ArbiterStatus toStatusMsg(const arbiter::ArbiterSnapshot& snapshot, const ArbiterConnections& around) {
  ArbiterStatus msg;
  msg.stamp = ros::Time::now();
  msg.summary = summarize(snapshot);
  msg.state = static_cast<std::uint8_t>(snapshot.state);
  msg.active_source = snapshot.active_source;
  msg.emergency_stop = static_cast<std::uint8_t>(snapshot.state == arbiter::ArbiterState::kEmergencyStop);
  msg.emergency_stop_cause = snapshot.stop_cause;
  msg.stops = snapshot.stops;
  msg.missing_sources = snapshot.missing_sources;
  msg.command = toTwistMsg(snapshot.command);
  for (const ArbiterProblem& problem : findProblems(snapshot, around)) msg.problems.push_back(problem.text);
  for (const arbiter::SourceStatus& source : snapshot.sources)
    msg.sources.push_back(toSourceMsg(source, snapshot, around));
  return msg;
}

std::string contentOf(const ArbiterStatus& status) {
  std::string text = status.summary + '\n' + joined(status.problems);
  for (const ArbiterSource& source : status.sources) text += '\n' + source.state_text + joined(source.publishers);
  return text;
}

void fillDiagnostics(const arbiter::ArbiterSnapshot& snapshot, const ArbiterConnections& around,
                     diagnostic_updater::DiagnosticStatusWrapper& diagnostics) {
  diagnostics.summary(Level::OK, summarize(snapshot));
  for (const ArbiterProblem& problem : findProblems(snapshot, around)) {
    diagnostics.mergeSummary(problem.level, problem.text);
  }
  diagnostics.add("driven by", snapshot.active_source.empty() ? toString(snapshot.state) : snapshot.active_source);
  for (const arbiter::SourceStatus& source : snapshot.sources) {
    const bool has_publisher = !publishersOn(around.source_topics.at(source.name), around).empty();
    diagnostics.addf(source.name, "%s, %.1f Hz, %lu refused", stateInWords(source, snapshot, has_publisher).c_str(),
                     source.rate, static_cast<unsigned long>(source.rejected));
  }
}

}  // namespace frontier_pilot
