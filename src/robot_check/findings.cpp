#include "robot_check/findings.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <utility>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/text.h"
#include "robot_check/checks.h"

namespace frontier_pilot::robot_check {
namespace {

constexpr double kMostAhead = 0.1;  // [s] that a stamp may be ahead

const char* labelOf(Mark mark) {
  switch (mark) {
    case Mark::kGood:
      return "ok      ";
    case Mark::kNote:
      return "note    ";
    case Mark::kProblem:
      return "PROBLEM ";
  }
  return "";
}

}  // namespace

void good(Findings& findings, std::string text) { findings.push_back({Mark::kGood, std::move(text), {}}); }
void note(Findings& findings, std::string text, std::string advice) {
  findings.push_back({Mark::kNote, std::move(text), std::move(advice)});
}
void problem(Findings& findings, std::string text, std::string advice) {
  findings.push_back({Mark::kProblem, std::move(text), std::move(advice)});
}

std::string number(double value) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << value;
  return text.str();
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

void checkLag(const Observation& seen, const Stream& stream, const std::string& name, double tolerated,
              Findings& findings) {
  if (!stream.lag) return;
  const std::string clocks = "synchronise the clocks of the computers (chrony, ntp)" +
                             std::string(seen.use_sim_time ? ", and let all nodes follow /clock" : "");
  if (*stream.lag < -kMostAhead) {
    problem(findings,
            "the stamps of " + name + " are " + number(-*stream.lag) + " s ahead of this computer's clock: the clock " +
                "of the computer of " + joined(stream.publishers) + " is fast",
            clocks);
  } else if (*stream.lag > tolerated) {
    problem(findings,
            "the stamps of " + name + " are " + number(*stream.lag) + " s behind this computer's clock: either the " +
                "clock of the computer of " + joined(stream.publishers) + " is slow, or its messages arrive late",
            clocks + "; if they agree, look for a slow network or a busy driver");
  }
}

Findings judge(const Observation& seen, const Expectation& expected) {
  Findings findings;
  checkTime(seen, findings);
  checkFrames(seen, expected, findings);
  checkOdometry(seen, expected, findings);
  checkScan(seen, expected, findings);
  checkMount(seen, expected, findings);
  checkDrive(seen, expected, findings);
  checkMappers(seen, expected, findings);
  return findings;
}

bool couldDrive(const Findings& findings) {
  return std::none_of(findings.begin(), findings.end(), [](const Finding& f) { return f.mark == Mark::kProblem; });
}

std::string toText(const Findings& findings) {
  std::string text;
  for (const Finding& finding : findings) {
    text += labelOf(finding.mark) + printable(finding.text, bounds::kMostLine) + "\n";
    if (!finding.advice.empty()) text += "          -> " + printable(finding.advice, bounds::kMostLine) + "\n";
  }
  const auto problems =
      std::count_if(findings.begin(), findings.end(), [](const Finding& f) { return f.mark == Mark::kProblem; });
  if (problems == 0) return text + "The robot could drive.\n";
  return text + "The robot cannot drive yet: " + std::to_string(problems) +
         (problems == 1 ? " problem.\n" : " problems.\n");
}

}  // namespace frontier_pilot::robot_check
