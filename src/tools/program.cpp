#include "tools/program.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstddef>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

#include "frontier_pilot/core/files.h"
#include "frontier_pilot/core/text.h"

namespace frontier_pilot::tools {
namespace {

constexpr int kFailed = 1, kUsage = 2;
constexpr std::size_t kMostShown = 5000;  // [bytes] of an error, which may name a long path

bool asksForHelp(const std::vector<std::string>& words) {
  return std::any_of(words.begin(), words.end(), [](const auto& word) { return word == "--help" || word == "-h"; });
}

/// A standard stream that was closed (>&-) would give its number to the next file or pipe.
void openClosedStreams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) < 0) open("/dev/null", O_RDWR);  // takes the lowest number that is free
  }
}

/// The exit code of a program whose output could be written, else an exception.
int withItsOutput(int code) {
  const std::string problem = flushStandardOutput();
  if (!problem.empty()) throw std::runtime_error(problem);
  return code;
}

}  // namespace

int runProgram(const std::string& name, const std::vector<std::string>& words, const char* usage,
               const std::function<int(const std::vector<std::string>&)>& run) {
  openClosedStreams();
  // A file that exceeds a limit of the system (ulimit -f) is an error of its writer, and no reason to be killed.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    if (asksForHelp(words)) {
      std::cout << usage;
      return withItsOutput(0);
    }
    return withItsOutput(run(words));
  } catch (const std::invalid_argument& error) {
    const std::string text = usage;
    std::cerr << name << ": " << printable(error.what(), kMostShown) << "; " << text.substr(0, text.find('\n'))
              << ", see --help\n";
    return kUsage;
  } catch (const std::exception& error) {
    std::cerr << name << ": " << printable(error.what(), kMostShown) << "\n";
    return kFailed;
  }
}

}  // namespace frontier_pilot::tools
