#include "frontier_pilot/scan_matching/correlative_search.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "frontier_pilot/core/motion.h"

namespace frontier_pilot::scan_matching {
namespace {

/// Poses of one direction whose offsets lie in a square of 2^level cells.
struct Node {
  int angle;     ///< the direction, in angle steps from the expected one
  Cell offset;   ///< the square's lower left one [cells]
  double bound;  ///< upper bound on the rating of its poses
  double score;  ///< upper bound on their score
};

/// The angle between directions [rad], by which the points move one cell in the root mean square. If the farthest point
/// determined it, a single distant return would make the search expensive and no better.
double angleStep(const surfaces::SurfacePoints& points, double resolution) {
  double sum = 0.0;
  for (const surfaces::SurfacePoint& point : points) sum += point.position.squaredNorm();
  return resolution / std::max(resolution, std::sqrt(sum / static_cast<double>(points.size())));
}

/// The number nearest to zero in [first, last].
int nearestToZero(int first, int last) { return std::max(first, std::min(0, last)); }

class BranchAndBound {
 public:
  BranchAndBound(const MaxPyramid& pyramid, const surfaces::SurfacePoints& points, const SearchRequest& request)
      : pyramid_(pyramid),
        request_(request),
        resolution_(pyramid.geometry().resolution),
        step_(angleStep(points, resolution_)),
        angles_(steps(std::min(request.window.yaw, kPi), step_)),
        half_{steps(request.window.x, resolution_), steps(request.window.y, resolution_)},
        scale_(1.0 / (255.0 * static_cast<double>(points.size()))) {
    if (request.allowed != nullptr) expected_ = request.allowed->geometry().cellAt(request.expected.position());
    for (int angle = -angles_; angle <= angles_; ++angle) place(points, angle);
  }

  std::optional<SearchResult> run() {
    std::vector<Node> nodes;
    const int side = 1 << pyramid_.top();
    for (int angle = -angles_; angle <= angles_; ++angle) {
      for (int y = -half_.y; y <= half_.y; y += side) {
        for (int x = -half_.x; x <= half_.x; x += side) add(nodes, angle, {x, y}, pyramid_.top());
      }
    }
    descend(nodes, pyramid_.top());
    return best_ && !stopped_ ? std::optional<SearchResult>(result(*best_)) : std::nullopt;
  }

 private:
  static int steps(double half_width, double step) { return static_cast<int>(std::ceil(half_width / step - 1e-9)); }

  /// Finds the cells that the points lie in for one direction and no offset.
  void place(const surfaces::SurfacePoints& points, int angle) {
    const Pose2 T_map_points(request_.expected.position(), request_.expected.yaw + angle * step_);
    const Rotation2 rotation(T_map_points.yaw);
    for (const surfaces::SurfacePoint& point : points) {
      cells_.push_back(pyramid_.geometry().cellAt(T_map_points.position() + rotation * point.position));
    }
    points_ = points.size();
  }

  /// Adds the node if it may contain a better pose than the best so far.
  void add(std::vector<Node>& nodes, int angle, Cell offset, int level) const {
    if (!isAllowed(offset, level)) return;
    const double score = scoreOf(angle, offset, level);
    const double bound = score - leastPenalty(angle, offset, level);
    if (score >= request_.min_score && (!best_ || bound > best_->bound)) {
      nodes.push_back({angle, offset, bound, score});
    }
  }

  /// Whether any position of the square is allowed.
  bool isAllowed(Cell offset, int level) const {
    if (request_.allowed == nullptr) return true;
    return request_.allowed->level(level).at(expected_.x + offset.x, expected_.y + offset.y) > 0;
  }

  double scoreOf(int angle, Cell offset, int level) const {
    const MaxPyramid::Level& maxima = pyramid_.level(level);
    const Cell* cell = cells_.data() + static_cast<std::size_t>(angle + angles_) * points_;
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i < points_; ++i) sum += maxima.at(cell[i].x + offset.x, cell[i].y + offset.y);
    return scale_ * sum;
  }

  double leastPenalty(int angle, Cell offset, int level) const {
    const SearchPenalty& penalty = request_.penalty;
    const int side = (1 << level) - 1;
    const int x = nearestToZero(offset.x, offset.x + side);
    const int y = nearestToZero(offset.y, offset.y + side);
    const double moved = resolution_ * std::hypot(x, y) / penalty.sigma_position;
    const double turned = step_ * angle / penalty.sigma_yaw;
    return penalty.weight * std::min(penalty.limit * penalty.limit, moved * moved + turned * turned);
  }

  /// Best first: as soon as one node cannot beat the best pose, none after it can.
  void descend(std::vector<Node>& nodes, int level) {
    std::stable_sort(nodes.begin(), nodes.end(), [](const Node& a, const Node& b) { return a.bound > b.bound; });
    for (const Node& node : nodes) {
      if (best_ && node.bound <= best_->bound) return;
      if (isStopped()) return;
      if (level == 0) {
        if (!isExcluded(node) && (!request_.accept || request_.accept(poseOf(node)))) best_ = node;
        continue;
      }
      std::vector<Node> parts = split(node, level - 1);
      descend(parts, level - 1);
    }
  }

  bool isStopped() {
    stopped_ = stopped_ || (request_.stop && request_.stop());
    return stopped_;
  }

  std::vector<Node> split(const Node& node, int level) const {
    std::vector<Node> parts;
    const int side = 1 << level;
    for (const Cell step : {Cell{0, 0}, Cell{side, 0}, Cell{0, side}, Cell{side, side}}) {
      const Cell offset{node.offset.x + step.x, node.offset.y + step.y};
      if (offset.x <= half_.x && offset.y <= half_.y) add(parts, node.angle, offset, level);
    }
    return parts;
  }

  Pose2 poseOf(const Node& node) const {
    return {request_.expected.position() + resolution_ * Vec2(node.offset.x, node.offset.y),
            normalizeAngle(request_.expected.yaw + node.angle * step_)};
  }

  bool isExcluded(const Node& node) const {
    const Pose2 pose = poseOf(node);
    return std::any_of(request_.exclusions.begin(), request_.exclusions.end(), [&](const SearchExclusion& exclusion) {
      return !isJump(exclusion.pose, pose, exclusion.distance, exclusion.angle);
    });
  }

  SearchResult result(const Node& node) const {
    const bool at_last_angle = std::abs(node.angle) == angles_ && request_.window.yaw < kPi;
    const bool at_edge = std::abs(node.offset.x) == half_.x || std::abs(node.offset.y) == half_.y;
    return {poseOf(node), node.score, node.bound, at_last_angle || at_edge};
  }

  const MaxPyramid& pyramid_;
  const SearchRequest& request_;
  double resolution_;
  double step_;          ///< [rad]
  int angles_;           ///< directions on each side of the expected one
  Cell half_;            ///< greatest offset
  Cell expected_{0, 0};  ///< cell of the expected position in the grid of allowed positions
  double scale_;         ///< factor from a sum of likelihoods to a score
  std::size_t points_ = 0;
  std::vector<Cell> cells_;  ///< of the points, direction by direction
  std::optional<Node> best_;
  bool stopped_ = false;
};

}  // namespace

std::optional<SearchResult> correlativeSearch(const MaxPyramid& pyramid, const surfaces::SurfacePoints& points,
                                              const SearchRequest& request) {
  return BranchAndBound(pyramid, points, request).run();
}

int pyramidTop(const SearchWindow& window, double resolution) {
  constexpr int kHighest = 7;
  const double cells = 2.0 * std::max(window.x, window.y) / resolution + 1.0;
  return std::clamp(static_cast<int>(std::log2(cells)), 0, kHighest);
}

}  // namespace frontier_pilot::scan_matching
