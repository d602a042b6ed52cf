#include "frontier_pilot/core/files.h"

#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "frontier_pilot/core/text.h"

namespace frontier_pilot {
namespace {

constexpr std::size_t kLongestName = 255;  // of a file on Linux file systems [bytes]
constexpr std::size_t kSuffix = 12;        // of a temporary file's name [bytes]

std::string errorText() { return std::strerror(errno); }

/// A file descriptor that is closed on destruction, if not before.
class OpenFile {
 public:
  explicit OpenFile(int file) : file_(file) {}
  ~OpenFile() { close(); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  bool isOpen() const { return file_ >= 0; }
  int get() const { return file_; }
  bool close() { return !isOpen() || ::close(std::exchange(file_, -1)) == 0; }

 private:
  int file_;
};

FileContent refused(const std::string& problem) { return {FileContent::Status::kRefused, {}, problem}; }

FileContent cannotOpen() {
  const bool missing = errno == ENOENT || errno == ENOTDIR;
  return {missing ? FileContent::Status::kMissing : FileContent::Status::kRefused,
          {},
          missing ? "no such file" : errorText()};
}

FileContent readOpen(int file, std::size_t most_bytes) {
  struct stat info {};
  if (fstat(file, &info) != 0) return refused(errorText());
  if (!S_ISREG(info.st_mode)) return refused("is not a regular file");
  if (static_cast<std::uint64_t>(info.st_size) > most_bytes)
    return refused("is larger than " + std::to_string(most_bytes) + " bytes");
  FileContent content;
  content.bytes.resize(static_cast<std::size_t>(info.st_size));
  std::size_t done = 0;
  while (done < content.bytes.size()) {
    const ssize_t count = ::read(file, &content.bytes[done], content.bytes.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return refused(errorText());
    if (count == 0) break;  // the file has been truncated since its size was read
    done += static_cast<std::size_t>(count);
  }
  content.bytes.resize(done);
  return content;
}

/// A random name beside `target`, not longer than a file name may be, however long the target's is. Empty if there is
/// no randomness.
std::filesystem::path temporaryName(const std::filesystem::path& target) {
  std::array<unsigned char, kSuffix - 1> random{};
  if (getrandom(random.data(), random.size(), 0) != static_cast<ssize_t>(random.size())) return {};
  std::string suffix = ".";
  for (const unsigned char byte : random) suffix += "0123456789abcdefghijklmnopqrstuv"[byte % 32];
  const std::string name = target.filename().string().substr(0, kLongestName - kSuffix);
  return target.parent_path() / (name + suffix);
}

}  // namespace

FileContent readFile(const std::filesystem::path& path, std::size_t most_bytes) {
  // Other files are not even opened: opening a device can have side effects. Should one take the place of the file
  // after this check, O_NONBLOCK keeps `open` from waiting for it.
  struct stat info {};
  if (stat(path.c_str(), &info) != 0) return cannotOpen();
  if (!S_ISREG(info.st_mode)) return refused("is not a regular file");
  const OpenFile file(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  return file.isOpen() ? readOpen(file.get(), most_bytes) : cannotOpen();
}

AtomicFile::AtomicFile(std::filesystem::path target, Survives survives)
    : target_(std::move(target)), survives_(survives) {}

AtomicFile::~AtomicFile() {
  if (!temporary_.empty()) unlink(temporary_.c_str());
}

std::string AtomicFile::write(std::string_view content) {
  std::filesystem::path name = temporaryName(target_);
  if (name.empty()) return "no random name available: " + errorText();
  OpenFile file(open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
  if (!file.isOpen()) return errorText();
  if (!temporary_.empty()) unlink(temporary_.c_str());
  temporary_ = std::move(name);
  std::string problem = fill(file.get(), content);
  if (!problem.empty()) return problem;
  return file.close() ? std::string() : errorText();
}

std::string AtomicFile::fill(int file, std::string_view content) const {
  while (!content.empty()) {
    const ssize_t count = ::write(file, content.data(), content.size());
    if (count < 0 && errno != EINTR) return errorText();
    if (count > 0) content.remove_prefix(static_cast<std::size_t>(count));
  }
  return survives_ == Survives::kPowerLoss && fsync(file) != 0 ? errorText() : std::string();
}

std::string AtomicFile::commit() {
  if (temporary_.empty()) return "nothing was written";
  if (rename(temporary_.c_str(), target_.c_str()) != 0) return errorText();
  temporary_.clear();
  if (survives_ != Survives::kPowerLoss) return {};
  const std::filesystem::path folder = target_.has_parent_path() ? target_.parent_path() : ".";
  const OpenFile directory(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  // Not every file system can sync a directory, and the file is in place whether this succeeds or not.
  if (directory.isOpen()) static_cast<void>(fsync(directory.get()));
  return {};
}

std::string writeFile(const std::filesystem::path& target, std::string_view content, Survives survives) {
  AtomicFile file(target, survives);
  const std::string problem = file.write(content);
  return problem.empty() ? file.commit() : problem;
}

std::string flushStandardOutput() {
  // std::cout writes by way of stdout, which keeps an error of an earlier line.
  const bool is_open = fcntl(STDOUT_FILENO, F_GETFD) >= 0;
  if (std::fflush(stdout) != 0 && is_open) return "cannot write its output: " + errorText();
  return is_open && std::ferror(stdout) != 0 ? "cannot write its output" : "";
}

std::string fileNameProblem(const std::string& name, std::size_t longest_addition) {
  if (name.empty() || name == "." || name == "..") return "names no file";
  if (name.size() + longest_addition > kLongestName)
    return "is longer than " + std::to_string(kLongestName - longest_addition) + " bytes";
  for (std::size_t i = 0; i < name.size();) {
    const Character character = characterAt(name, i);
    if (character.bytes == 0) return "is not UTF-8";
    if (isControl(character.code)) return "holds a control character";
    i += character.bytes;
  }
  return {};
}

std::uint32_t crc32(std::string_view bytes) {
  static const std::array<std::uint32_t, 256> table = [] {
    std::array<std::uint32_t, 256> entries{};
    for (std::uint32_t i = 0; i < entries.size(); ++i) {
      std::uint32_t value = i;
      for (int bit = 0; bit < 8; ++bit) value = (value >> 1U) ^ ((value & 1U) != 0 ? 0xEDB88320U : 0U);
      entries[i] = value;
    }
    return entries;
  }();
  std::uint32_t sum = 0xFFFFFFFFU;
  for (const char byte : bytes) sum = (sum >> 8U) ^ table[(sum ^ static_cast<unsigned char>(byte)) & 0xFFU];
  return ~sum;
}

}  // namespace frontier_pilot
