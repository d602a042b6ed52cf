#include "support/ascii_world.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace frontier_pilot::test {
namespace {

bool blank(const std::string& line) { return line.find_first_not_of(' ') == std::string::npos; }

std::vector<std::string> linesOf(const std::string& drawing) {
  std::vector<std::string> lines;
  std::istringstream in(drawing);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  while (!lines.empty() && blank(lines.front())) lines.erase(lines.begin());
  while (!lines.empty() && blank(lines.back())) lines.pop_back();
  if (lines.empty()) throw std::invalid_argument("the drawing is empty");
  return lines;
}

std::size_t commonIndent(const std::vector<std::string>& lines) {
  std::size_t indent = std::string::npos;
  for (const std::string& line : lines) {
    if (!blank(line)) indent = std::min(indent, line.find_first_not_of(' '));
  }
  return indent;
}

std::int8_t valueOf(char drawn) {
  if (drawn == '#') return kOccupied;
  return drawn == '?' ? kUnknown : kFree;
}

}  // namespace

Grid<std::uint8_t> AsciiWorld::solid(bool unknown_is_solid) const {
  Grid<std::uint8_t> out(map.geometry());
  for (std::size_t i = 0; i < map.size(); ++i) {
    out[i] = isOccupied(map[i]) || (unknown_is_solid && isUnknown(map[i])) ? 1 : 0;
  }
  return out;
}

AsciiWorld drawWorld(const std::string& drawing, double resolution, const Vec2& origin) {
  std::vector<std::string> lines = linesOf(drawing);
  const std::size_t indent = commonIndent(lines);
  std::size_t width = 0;
  for (std::string& line : lines) {
    line.erase(0, std::min(indent, line.size()));
    width = std::max(width, line.size());
  }
  GridGeometry geometry;
  geometry.resolution = resolution;
  geometry.origin = origin;
  geometry.width = static_cast<int>(width);
  geometry.height = static_cast<int>(lines.size());
  AsciiWorld world{OccupancyGrid(geometry, kUnknown), {}};
  for (int y = 0; y < geometry.height; ++y) {
    const std::string& line = lines[lines.size() - 1 - static_cast<std::size_t>(y)];
    for (int x = 0; x < static_cast<int>(line.size()); ++x) {
      const char drawn = line[static_cast<std::size_t>(x)];
      world.map[Cell{x, y}] = valueOf(drawn);
      if (std::string("#. ?").find(drawn) == std::string::npos) world.marks[drawn].push_back({x, y});
    }
  }
  return world;
}

std::string toAscii(const OccupancyGrid& map, const std::map<char, std::vector<Cell>>& marks) {
  std::vector<std::string> lines(static_cast<std::size_t>(map.height()));
  for (int y = 0; y < map.height(); ++y) {
    std::string& line = lines[static_cast<std::size_t>(map.height() - 1 - y)];
    for (int x = 0; x < map.width(); ++x) {
      const std::int8_t value = map[Cell{x, y}];
      line += isUnknown(value) ? '?' : (isOccupied(value) ? '#' : '.');
    }
  }
  for (const auto& [mark, cells] : marks) {
    for (const Cell c : cells) {
      if (map.contains(c))
        lines[static_cast<std::size_t>(map.height() - 1 - c.y)][static_cast<std::size_t>(c.x)] = mark;
    }
  }
  std::string out;
  for (const std::string& line : lines) out += line + "\n";
  return out;
}

}  // namespace frontier_pilot::test
