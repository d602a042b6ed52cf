#include "occupancy/octree_check.h"

#include <array>
#include <charconv>
#include <cmath>
#include <sstream>

namespace frontier_pilot::occupancy {
namespace {

constexpr std::string_view kFirstLine = "# Octomap OcTree binary file";
constexpr std::string_view kTreeType = "OcTree";
constexpr std::size_t kLongestHeader = 4096;   // [bytes]
constexpr double kResolutionTolerance = 1e-6;  // [m]: it is written as a decimal number

OctreeFile broken(std::string problem) { return {std::move(problem), 0, {}}; }

/// Takes the first line, without its end, off `rest`. Returns false if it has no end.
bool takeLine(std::string_view& rest, std::string_view& line) {
  const std::size_t end = rest.substr(0, kLongestHeader).find('\n');
  if (end == std::string_view::npos) return false;
  line = rest.substr(0, end);
  rest.remove_prefix(end + 1);
  return true;
}

/// The whole word as a number; -1 if it is not one.
template <class T>
T numberOf(std::string_view word) {
  T value{};
  const std::from_chars_result result = std::from_chars(word.data(), word.data() + word.size(), value);
  return result.ec == std::errc() && result.ptr == word.data() + word.size() ? value : static_cast<T>(-1);
}

struct Header {
  std::string_view type;
  std::int64_t size = -1;
  double resolution = -1.0;
};

/// Takes the header off `rest`. Returns false if it has no end.
bool takeHeader(std::string_view& rest, Header& header) {
  const std::size_t whole = rest.size();
  std::string_view line;
  while (whole - rest.size() < kLongestHeader && takeLine(rest, line)) {
    if (line == "data") return true;
    const std::size_t space = line.find(' ');
    const std::string_view key = line.substr(0, space);
    const std::string_view value = space == std::string_view::npos ? std::string_view() : line.substr(space + 1);
    if (key == "id") header.type = value;
    if (key == "size") header.size = numberOf<std::int64_t>(value);
    if (key == "res") header.resolution = numberOf<double>(value);
  }
  return false;
}

/// Traverses a tree in the order in which it is written: for each inner node two bits for each of its eight children,
/// then those children that are inner nodes themselves.
class TreeWalk {
 public:
  explicit TreeWalk(std::string_view tree) : rest_(tree) {}

  /// What is wrong with the tree; nullptr if nothing is.
  const char* run(std::uint64_t announced) {
    int depth = 0;
    waiting_[0] = 1;
    while (depth >= 0) {
      if (waiting_[static_cast<std::size_t>(depth)] == 0) {
        --depth;
        continue;
      }
      --waiting_[static_cast<std::size_t>(depth)];
      int inner = 0;
      if (const char* problem = takeNode(inner)) return problem;
      if (nodes_ > announced) return "its tree has more nodes than it announces";
      if (inner == 0) continue;
      if (++depth == kOctreeLevels) return "its tree is deeper than 16 levels";
      waiting_[static_cast<std::size_t>(depth)] = inner;
    }
    if (nodes_ != announced) return "its tree has fewer nodes than it announces";
    return rest_.empty() ? nullptr : "there are bytes after its tree";
  }

 private:
  const char* takeNode(int& inner) {
    if (rest_.size() < 2) return "its tree is incomplete";
    const unsigned bits =
        static_cast<unsigned char>(rest_[0]) | static_cast<unsigned>(static_cast<unsigned char>(rest_[1])) << 8U;
    rest_.remove_prefix(2);
    if (bits == 0) return "its tree has an inner node without children";
    for (unsigned child = 0; child < 8; ++child) {
      const unsigned kind = (bits >> (2U * child)) & 3U;
      nodes_ += kind != 0 ? 1 : 0;
      inner += kind == 3U ? 1 : 0;
    }
    return nullptr;
  }

  std::string_view rest_;
  std::uint64_t nodes_ = 1;                       ///< the root
  std::array<int, kOctreeLevels + 1> waiting_{};  ///< inner nodes that are still to come, on each level
};

}  // namespace

OctreeFile checkOctree(std::string_view bytes, double resolution, std::uint64_t most_nodes) {
  std::string_view rest = bytes;
  std::string_view first;
  if (!takeLine(rest, first) || first.substr(0, kFirstLine.size()) != kFirstLine)
    return broken("no octree in OctoMap's binary format");
  Header header;
  if (!takeHeader(rest, header)) return broken("its header has no end");
  if (header.type != kTreeType) return broken("holds another kind of octree");
  if (header.size < 1) return broken("does not say how many nodes it has");
  const auto nodes = static_cast<std::uint64_t>(header.size);
  if (nodes > most_nodes) return broken("is too large: " + std::to_string(nodes) + " nodes");
  // Negated, so that NaN is refused as well.
  if (!(std::abs(header.resolution - resolution) <= kResolutionTolerance)) {
    std::ostringstream problem;
    problem << "its cells are " << header.resolution << " m wide, those of the mapper's map " << resolution << " m";
    return broken(problem.str());
  }
  if (const char* problem = TreeWalk(rest).run(nodes)) return broken(problem);
  return {{}, nodes, rest};
}

}  // namespace frontier_pilot::occupancy
