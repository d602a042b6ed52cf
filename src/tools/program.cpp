#include "tools/program.h"

#include <algorithm>
#include <csignal>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

namespace frontier_pilot::tools {
namespace {

constexpr int kFailed = 1, kUsage = 2;

bool asksForHelp(const std::vector<std::string>& words) {
  return std::any_of(words.begin(), words.end(), [](const auto& word) { return word == "--help" || word == "-h"; });
}

}  // namespace

int runProgram(const std::string& name, const std::vector<std::string>& words, const char* usage,
               const std::function<int(const std::vector<std::string>&)>& run) {
  // A file that exceeds a limit of the system (ulimit -f) is an error of its writer, and no reason to be killed.
  std::signal(SIGXFSZ, SIG_IGN);
  if (asksForHelp(words)) {
    std::cout << usage;
    return 0;
  }
  try {
    return run(words);
  } catch (const std::invalid_argument& error) {
    const std::string text = usage;
    std::cerr << name << ": " << error.what() << "; " << text.substr(0, text.find('\n')) << ", see --help\n";
    return kUsage;
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << "\n";
    return kFailed;
  }
}

}  // namespace frontier_pilot::tools
