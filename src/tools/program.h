#pragma once

#include <functional>
#include <string>
#include <vector>

namespace frontier_pilot::tools {

/// Runs a program for the command line. --help or -h prints `usage` and returns 0; otherwise `run` gets the words after
/// the program's name, and returns the exit code. A std::invalid_argument is a wrong argument, which is told in one
/// line on stderr, with the first line of `usage`, and returns 2; so does any other exception, with 1.
int runProgram(const std::string& name, const std::vector<std::string>& words, const char* usage,
               const std::function<int(const std::vector<std::string>&)>& run);

}  // namespace frontier_pilot::tools
