#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace frontier_pilot {

/// What a file held, or why it could not be read.
struct FileContent {
  enum class Status {
    kOk,
    kMissing,  ///< there is nothing of this name
    kRefused,  ///< it is no file, too large, or cannot be read
  };
  Status status = Status::kOk;
  std::string bytes;
  std::string problem;  ///< without the file's name; empty if all is well

  bool ok() const { return status == Status::kOk; }
};

/// Reads a regular file of at most `most_bytes`. A pipe, a device or a folder of that name is refused without waiting
/// for anything. [FLT-1]
FileContent readFile(const std::filesystem::path& path, std::size_t most_bytes);

/// What has to be outlived by a file that was written.
enum class Survives {
  kProcessDeath,  ///< the writer may die at any moment; takes microseconds
  kPowerLoss,     ///< the machine may; waits for the disk
};

/// A file that takes its place only when it is whole. Until then it lies beside its target under a name that nobody can
/// guess; whatever bears the target's name, a symbolic link too, is replaced and not followed. One that does not get
/// into its place is removed. [FLT-1]
class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path target, Survives survives = Survives::kPowerLoss);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Writes the whole content beside the target. Gives what went wrong, or an empty text.
  std::string write(std::string_view content);
  /// Puts what was written in its place. Gives what went wrong, or an empty text.
  std::string commit();
  const std::filesystem::path& target() const { return target_; }

 private:
  std::string fill(int file, std::string_view content) const;

  std::filesystem::path target_;
  std::filesystem::path temporary_;  ///< empty: there is none
  Survives survives_;
};

/// `write` and `commit`. Gives what went wrong, or an empty text.
std::string writeFile(const std::filesystem::path& target, std::string_view content,
                      Survives survives = Survives::kPowerLoss);

/// Why `name` can be no file's name that people and YAML can read, or an empty text: it must be UTF-8 without control
/// characters (`isControl`), and not too long. `longest_addition` [bytes] is what will be appended to it.
std::string fileNameProblem(const std::string& name, std::size_t longest_addition);

/// The CRC-32 of ISO 3309 (polynomial 0x04C11DB7, reflected), as zip and `python3 -m zlib` have it.
std::uint32_t crc32(std::string_view bytes);

}  // namespace frontier_pilot
