#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace frontier_pilot {

/// Writes cells as runs of equal values, in the code that msg/MapChanges.msg describes: a byte for a run of up to 60
/// cells that are unknown, free or occupied. The cells may come in pieces; a run goes on across them.
class RunWriter {
 public:
  void add(const std::int8_t* cells, std::size_t count);
  /// The bytes of all cells added so far; the writer begins anew.
  std::vector<std::uint8_t> take();

 private:
  void writeRun();

  std::vector<std::uint8_t> bytes_;
  std::int8_t value_ = 0;     ///< of the run that is not written yet
  std::uint64_t length_ = 0;  ///< of that run [cells]
};

/// How many cells the bytes stand for, without decoding them: this needs no memory, and time by the number of bytes
/// alone. Nothing if they are malformed: cut off, a value outside of -1...100, or more than `most` cells. [FLT-1]
std::optional<std::size_t> countCells(const std::vector<std::uint8_t>& bytes, std::size_t most);

/// Reads what a RunWriter wrote.
class RunReader {
 public:
  /// `bytes` must outlive the reader.
  explicit RunReader(const std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}

  /// Writes the next `count` cells to `out`. Returns false, after some of them perhaps, if the bytes do not stand for
  /// as many or are malformed.
  bool read(std::int8_t* out, std::size_t count);

 private:
  bool nextRun();
  friend std::optional<std::size_t> countCells(const std::vector<std::uint8_t>& bytes, std::size_t most);

  const std::vector<std::uint8_t>& bytes_;
  std::size_t next_ = 0;      ///< the byte that is read next
  std::int8_t value_ = 0;     ///< of the run that is being read
  std::uint64_t length_ = 0;  ///< what is left of that run [cells]
};

}  // namespace frontier_pilot
