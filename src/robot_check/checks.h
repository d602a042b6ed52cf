#pragma once

#include <string>
#include <vector>

#include "robot_check/findings.h"
#include "robot_check/observation.h"

/// The parts of `judge`, each for one side of the robot.
namespace frontier_pilot::robot_check {

void checkTime(const Observation& seen, Findings& findings);
void checkFrames(const Observation& seen, const Expectation& expected, Findings& findings);
void checkScan(const Observation& seen, const Expectation& expected, Findings& findings);
/// Where the scanner is mounted, by TF.
void checkMount(const Observation& seen, const Expectation& expected, Findings& findings);
void checkOdometry(const Observation& seen, const Expectation& expected, Findings& findings);
void checkDrive(const Observation& seen, const Expectation& expected, Findings& findings);
void checkMappers(const Observation& seen, const Expectation& expected, Findings& findings);

/// What several of them need.
void good(Findings& findings, std::string text);
void note(Findings& findings, std::string text, std::string advice = {});
void problem(Findings& findings, std::string text, std::string advice = {});
/// Judges how late the stamps are. `tolerated` [s] is how far behind they may be; 0.1 s ahead is always tolerated.
void checkLag(const Observation& seen, const Stream& stream, const std::string& name, double tolerated,
              Findings& findings);
/// The parts of a text, numbers with two decimals.
std::string number(double value);
std::string joined(const std::vector<std::string>& names);

}  // namespace frontier_pilot::robot_check
