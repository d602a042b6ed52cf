// The cells of a map as runs of equal values, which any node may send.

#include <optional>
#include <vector>

#include "frontier_pilot/core/grid.h"
#include "fuzz/fuzz.h"
#include "ros/common/maps/run_lengths.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace frontier_pilot;  // NOLINT(google-build-using-namespace): a program of its own
  constexpr std::size_t kMost = 100000;
  const std::vector<std::uint8_t> bytes(data, data + size);
  const std::optional<std::size_t> count = countCells(bytes, kMost);
  if (!count) return 0;
  fuzz::require(*count <= kMost, "no more cells than there may be");
  std::vector<std::int8_t> cells(*count);
  RunReader reader(bytes);
  fuzz::require(reader.read(cells.data(), cells.size()), "as many cells as were counted");
  for (const std::int8_t cell : cells) fuzz::require(cell >= kUnknown && cell <= kOccupied, "a value of a cell");
  std::int8_t more = 0;
  fuzz::require(!reader.read(&more, 1), "no more cells than were counted");
  RunWriter writer;
  writer.add(cells.data(), cells.size());
  const std::vector<std::uint8_t> again = writer.take();
  fuzz::require(again.size() <= bytes.size(), "the writer's code is the shortest");
  fuzz::require(countCells(again, kMost) == count, "what the writer writes is read");
  return 0;
}
