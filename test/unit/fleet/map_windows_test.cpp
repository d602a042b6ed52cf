// Which parts of a map are searched for in another one, and when.
#include "fleet/place/map_windows.h"

#include <gtest/gtest.h>

#include <vector>

namespace frontier_pilot {
namespace {

using fleet::MapWindow;
using fleet::WindowRound;

std::vector<MapWindow> columns(const std::vector<int>& xs) {
  std::vector<MapWindow> windows;
  for (const int x : xs) windows.push_back({Cell{x, 0}, Vec2(x, 0.0)});
  return windows;
}

std::vector<int> xsOf(const std::vector<MapWindow>& windows) {
  std::vector<int> xs;
  for (const MapWindow& window : windows) xs.push_back(window.cell.x);
  return xs;
}

bool nowhere(const Vec2&) { return false; }

// [MUL-1]
TEST(MapWindows, AreSearchedForByTurns) {
  WindowRound round{2, {}, {}};
  EXPECT_EQ(xsOf(round.next(columns({1, 2, 3}), nowhere)), (std::vector<int>{1, 2}));
  EXPECT_EQ(xsOf(round.next(columns({1, 2, 3}), nowhere)), (std::vector<int>{3, 1}));
  EXPECT_EQ(xsOf(round.next(columns({1}), nowhere)), (std::vector<int>{1})) << "each once";
  EXPECT_TRUE(round.next({}, nowhere).empty());
}

// [MUL-1] A count of windows in a circle would begin elsewhere whenever the circle becomes larger.
TEST(MapWindows, AreSearchedForByTurnsAlsoWhileTheMapGrows) {
  WindowRound round{2, {}, {}};
  EXPECT_EQ(xsOf(round.next(columns({5, 6, 7, 8}), nowhere)), (std::vector<int>{5, 6}));
  EXPECT_EQ(xsOf(round.next(columns({1, 2, 3, 5, 6, 7, 8, 9}), nowhere)), (std::vector<int>{7, 8}));
  EXPECT_EQ(xsOf(round.next(columns({1, 2, 3, 5, 7, 9}), nowhere)), (std::vector<int>{9, 1}));
}

// [MUL-1]
TEST(MapWindows, AreToAHalfThoseThatAGuessLetsExpectInTheOtherMap) {
  WindowRound round{4, {}, Pose2(10.0, 0.0, 0.0)};
  const auto is_known = [](const Vec2& in_a) { return in_a.x() > 14.5; };
  EXPECT_EQ(xsOf(round.next(columns({1, 2, 3, 4, 5, 6, 7}), is_known)), (std::vector<int>{5, 6, 1, 2}));
  EXPECT_EQ(xsOf(round.next(columns({1, 2, 3, 4, 5, 6, 7}), is_known)), (std::vector<int>{5, 6, 3, 4}));
}

}  // namespace
}  // namespace frontier_pilot
