#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace frontier_pilot {

/// The content of a file, or why it could not be read.
struct FileContent {
  enum class Status {
    kOk,
    kMissing,  ///< nothing of this name exists
    kRefused,  ///< it is not a regular file, is too large, or cannot be read
  };
  Status status = Status::kOk;
  std::string bytes;
  std::string problem;  ///< without the file's name; empty if there is none

  bool ok() const { return status == Status::kOk; }
};

/// Reads a regular file of at most `most_bytes`. A pipe, a device or a folder of that name is refused and never blocks
/// the call. [FLT-1]
FileContent readFile(const std::filesystem::path& path, std::size_t most_bytes);

/// What a written file must survive.
enum class Survives {
  kProcessDeath,  ///< the death of the writing process at any moment; takes microseconds
  kPowerLoss,     ///< a power loss as well; waits for the disk (fsync)
};

/// A file that appears under its target's name only once it is complete. Until then it lies beside the target under a
/// random name. Whatever has the target's name, even a symbolic link, is replaced and not followed. A file that is
/// never committed is removed. [FLT-1]
class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path target, Survives survives = Survives::kPowerLoss);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Writes the whole content beside the target. Returns what went wrong, or an empty string.
  std::string write(std::string_view content);
  /// Renames what was written to the target. Returns what went wrong, or an empty string.
  std::string commit();
  const std::filesystem::path& target() const { return target_; }

 private:
  std::string fill(int file, std::string_view content) const;

  std::filesystem::path target_;
  std::filesystem::path temporary_;  ///< empty: there is none
  Survives survives_;
};

/// `write` and `commit` in one call. Returns what went wrong, or an empty string.
std::string writeFile(const std::filesystem::path& target, std::string_view content,
                      Survives survives = Survives::kPowerLoss);

/// Writes what was printed to the standard output, if it is not closed. Returns what went wrong, or an empty string.
std::string flushStandardOutput();

/// Why `name` is not acceptable as a file name, or an empty string. It must be UTF-8 without control characters
/// (`isControl`), so that people and YAML can read it, and with `longest_addition` [bytes] appended not too long.
std::string fileNameProblem(const std::string& name, std::size_t longest_addition);

/// The CRC-32 of ISO 3309 (polynomial 0x04C11DB7, reflected), as zip and Python's `zlib.crc32` compute it.
std::uint32_t crc32(std::string_view bytes);

}  // namespace frontier_pilot
