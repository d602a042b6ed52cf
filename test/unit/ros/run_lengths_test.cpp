#include "ros/common/maps/run_lengths.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/grid.h"

namespace frontier_pilot {
namespace {

using Cells = std::vector<std::int8_t>;
using Bytes = std::vector<std::uint8_t>;

Bytes encode(const Cells& cells) {
  RunWriter writer;
  writer.add(cells.data(), cells.size());
  return writer.take();
}

/// Runs of lengths and values as they occur in maps, and of any others.
Cells randomCells(std::mt19937& random) {
  constexpr std::array<std::size_t, 12> kLengths = {1, 1, 2, 3, 59, 60, 61, 62, 316, 317, 318, 70000};
  Cells cells;
  const std::size_t runs = random() % 12;
  for (std::size_t i = 0; i < runs; ++i) {
    const auto value = static_cast<std::int8_t>(random() % 2 == 0 ? static_cast<int>(random() % 102) - 1
                                                                  : std::array<int, 3>{-1, 0, 100}[random() % 3]);
    cells.insert(cells.end(), kLengths[random() % kLengths.size()], value);
  }
  return cells;
}

TEST(RunLengths, WhatWasWrittenIsReadAgainWhateverThePiecesItCameIn) {  // [MUL-1]
  std::mt19937 random(1);
  for (int i = 0; i < 300; ++i) {
    const Cells cells = randomCells(random);
    RunWriter writer;
    for (std::size_t begin = 0; begin < cells.size();) {
      const std::size_t count = std::min<std::size_t>(cells.size() - begin, 1 + random() % 1000);
      writer.add(cells.data() + begin, count);
      begin += count;
    }
    const Bytes bytes = writer.take();
    ASSERT_EQ(bytes, encode(cells)) << "the pieces make no difference";
    ASSERT_EQ(countCells(bytes, cells.size()), cells.size());
    Cells decoded(cells.size());
    RunReader reader(bytes);
    for (std::size_t begin = 0; begin < cells.size();) {
      const std::size_t count = std::min<std::size_t>(cells.size() - begin, 1 + random() % 1000);
      ASSERT_TRUE(reader.read(decoded.data() + begin, count));
      begin += count;
    }
    ASSERT_EQ(decoded, cells);
    std::int8_t more = 0;
    EXPECT_FALSE(reader.read(&more, 1));
  }
}

TEST(RunLengths, AWriterWhoseBytesWereTakenBeginsAnew) {
  RunWriter writer;
  const Cells cells(5, kOccupied);
  writer.add(cells.data(), cells.size());
  const Bytes first = writer.take();
  EXPECT_TRUE(writer.take().empty());
  writer.add(cells.data(), cells.size());
  EXPECT_EQ(writer.take(), first);
}

TEST(RunLengths, AUsualRunTakesAByteAndAnEmptyMapAHandful) {  // [MUL-1]
  for (const std::int8_t value : {kUnknown, kFree, kOccupied}) EXPECT_EQ(encode(Cells(60, value)).size(), 1U);
  EXPECT_EQ(encode(Cells(60, 42)).size(), 2U);
  EXPECT_EQ(encode(Cells(4000000, kUnknown)).size(), 4U);
}

TEST(RunLengths, FLT_1_AFewBytesThatClaimMoreCellsThanThereMayBeAreRefusedWithoutAnyMemory) {  // [FLT-1]
  Bytes bytes;
  for (int i = 0; i < 100; ++i) bytes.insert(bytes.end(), {0x3F, 0xFF, 0xFF, 0xFF, 0xFF});
  EXPECT_EQ(countCells(bytes, bounds::kMostMapCells), std::nullopt);
  bytes = {0x3F, 0xFF, 0xFF, 0xFF, 0xFF};
  EXPECT_EQ(countCells(bytes, std::size_t{1} << 40), (std::size_t{1} << 32) + 60);
}

TEST(RunLengths, FLT_1_BytesThatAreCutOffOrHaveAnImpossibleValueAreRefused) {  // [FLT-1]
  for (const Bytes& bytes : {Bytes{0xC0}, Bytes{0x3C}, Bytes{0x3F, 1, 2, 3}, Bytes{0xFC, 5}, Bytes{0xC0, 101},
                             Bytes{0xC0, 0xFE}, Bytes{0x00, 0xC0}}) {
    EXPECT_EQ(countCells(bytes, 1000000), std::nullopt) << bytes.size();
  }
  EXPECT_EQ(countCells({}, 0), 0U);
}

TEST(RunLengths, FLT_1_AnyBytesAreEitherRefusedOrReadAsCountedWithPossibleValues) {  // [FLT-1]
  std::mt19937 random(2);
  int taken = 0;
  for (int i = 0; i < 20000; ++i) {
    Bytes bytes(random() % 8);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random() % 3 == 0 ? random() : random() % 60);
    const auto count = countCells(bytes, 100000);
    if (!count) continue;
    ++taken;
    Cells cells(*count);
    RunReader reader(bytes);
    ASSERT_TRUE(reader.read(cells.data(), cells.size()));
    for (const std::int8_t cell : cells) ASSERT_TRUE(cell >= kUnknown && cell <= kOccupied);
    std::int8_t more = 0;
    ASSERT_FALSE(reader.read(&more, 1));
  }
  EXPECT_GT(taken, 1000);
}

}  // namespace
}  // namespace frontier_pilot
