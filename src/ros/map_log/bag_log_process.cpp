#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>
#include <string_view>

#include "ros/common/clock.h"
#include "ros/map_log/bag_log.h"
#include "ros/map_log/packed_log.h"

namespace frontier_pilot {
namespace {

// The first byte of what the child sends. If nothing was sent, the child did not finish.
constexpr char kRead = 'R';
constexpr char kRefused = 'E';
constexpr char kNoMemory = 'M';

// The sanitizers of addresses and threads need more address space than any limit allows.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kLimitsAddressSpace = false;
#else
constexpr bool kLimitsAddressSpace = true;
#endif

/// The present size of this process's address space [bytes].
std::uint64_t addressSpace() {
  std::uint64_t pages = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "re")) {
    unsigned long long first = 0;
    if (std::fscanf(file, "%llu", &first) == 1) pages = first;
    std::fclose(file);
  }
  return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

void restrict(const BagReadLimits& limits) {
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
  if (!kLimitsAddressSpace) return;
  const rlim_t memory = addressSpace() + limits.memory;
  const rlimit memory_limit{memory, memory};
  setrlimit(RLIMIT_AS, &memory_limit);
}

void send(int pipe, const std::string& bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count = write(pipe, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno != EINTR) return;
    if (count > 0) done += static_cast<std::size_t>(count);
  }
}

/// Runs in the child: reads the bag and sends the result. Its output is discarded, because messages of a crash help
/// nobody.
[[noreturn]] void readInChild(int pipe, const std::string& path, const tools::BagTopics& topics,
                              const BagReadLimits& limits) {
  for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTERM, SIGINT}) std::signal(signal, SIG_DFL);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  restrict(limits);
  try {
    const std::string log = packLog(readBagLog(path, topics));
    send(pipe, std::string(1, kRead));
    send(pipe, log);
  } catch (const std::bad_alloc&) {
    send(pipe, std::string(1, kNoMemory));
  } catch (const logs::LogError& error) {
    send(pipe, kRefused + std::string(error.what()));
  } catch (const std::exception& error) {
    send(pipe, kRefused + path + ": " + error.what());
  }
  _exit(0);  // without running destructors and handlers that belong to the parent
}

/// The child process with the pipe that it sends to. The destructor kills it if it still runs.
class Child {
 public:
  Child(const std::string& path, const tools::BagTopics& topics, const BagReadLimits& limits) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw logs::LogError(path + ": no pipe: " + std::strerror(errno));
    process_ = fork();
    if (process_ == 0) readInChild(ends[1], path, topics, limits);
    close(ends[1]);
    pipe_ = ends[0];
    if (process_ < 0) throw logs::LogError(path + ": no process to read it: " + std::strerror(errno));
  }
  ~Child() {
    close(pipe_);
    if (process_ <= 0) return;
    kill(process_, SIGKILL);
    end();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Receives all that the child sends. False if it is not done by `deadline`, or sends more than `most` bytes.
  bool listen(SteadyTime deadline, std::uint64_t most, std::string& said) const {
    std::array<char, 65536> buffer{};
    while (said.size() <= most) {
      const double left = toSeconds(deadline - steadyNow());
      pollfd wait{pipe_, POLLIN, 0};
      const int ready = left > 0.0 ? poll(&wait, 1, static_cast<int>(std::min(left, 1e6) * 1e3) + 1) : 0;
      if (ready < 0 && errno == EINTR) continue;
      if (ready <= 0) return false;
      const ssize_t count = read(pipe_, buffer.data(), buffer.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return true;
      said.append(buffer.data(), static_cast<std::size_t>(count));
    }
    return false;
  }
  /// Waits until the child has ended and returns its status, as waitpid gives it.
  int end() {
    int status = 0;
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) continue;
    process_ = 0;
    return status;
  }

 private:
  pid_t process_ = -1;
  int pipe_ = -1;
};

std::string causeOf(int status) {
  if (!WIFSIGNALED(status)) return "without a result";
  return std::string("with signal ") + std::to_string(WTERMSIG(status)) + " (" + strsignal(WTERMSIG(status)) + ")";
}

}  // namespace

logs::ScanLog readBagLogApart(const std::string& path, const tools::BagTopics& topics, const BagReadLimits& limits) {
  Child child(path, topics, limits);
  const std::string megabytes = std::to_string(limits.memory >> 20U) + " MB";
  std::string said;
  if (!child.listen(steadyNow() + limits.time, limits.memory, said)) {
    if (said.size() > limits.memory) throw logs::LogError(path + ": takes more memory than " + megabytes);
    throw logs::LogError(path + ": reading it takes longer than " + std::to_string(limits.time.count()) + " s");
  }
  const int status = child.end();
  if (said.empty() || status != 0)
    throw logs::LogError(path + ": is broken: the process that reads it ended " + causeOf(status) +
                         ", because of a broken record or for lack of memory");
  if (said[0] == kNoMemory) throw logs::LogError(path + ": takes more memory than " + megabytes);
  if (said[0] != kRead) throw logs::LogError(said.substr(1));
  try {
    return unpackLog(std::string_view(said).substr(1));
  } catch (const std::length_error&) {
    throw logs::LogError(path + ": the process that reads it did not finish");
  }
}

}  // namespace frontier_pilot
