#pragma once

#include <optional>
#include <vector>

#include "exploration/frontier_evaluator.h"
#include "exploration/tour/viewpoints.h"
#include "exploration/travel/coarse_space.h"

namespace frontier_pilot::exploration {

/// Travel distances between the viewpoints of one decision, by wavefronts over coarse cells from those that they are
/// asked for.
class ViewpointDistances {
 public:
  /// Takes over what has changed in the space by which the evaluator has judged. Returns the block of coarse cells that
  /// has been computed.
  CellRect follow(FrontierEvaluator& evaluator);
  /// Forgets the distances between the viewpoints of the last decision. By the evaluator's travel distances from the
  /// robot it is known how far the wavefronts have to go.
  void restart(const std::vector<Viewpoint>& viewpoints, const FrontierEvaluator& evaluator, const Pose2& T_map_robot);

  /// From a viewpoint to all others [m], twice the Euclidean distance to those that no way leads to. Valid until
  /// `restart`.
  const std::vector<double>& from(std::size_t viewpoint);
  /// Prepares `between` for any two of `viewpoints`. A way has the same length in both directions, so that each
  /// wavefront only goes as far as the viewpoints that follow.
  void connect(const std::vector<std::size_t>& viewpoints);
  /// The distance of two viewpoints that `connect` was called with, as `from` gives it.
  double between(std::size_t a, std::size_t b) const { return rows_[a][b]; }
  /// From every viewpoint to `place` [m]; negative where no way leads.
  std::vector<double> to(const Vec2& place);
  /// The angle between the yaw of the robot and the direction in which the way to a viewpoint begins [rad], 0 to pi.
  double turnTo(std::size_t viewpoint) const;

 private:
  const CoarseSpace& coarse() const { return followed_[judged_].coarse; }
  std::vector<double>& row(std::size_t viewpoint);
  double farthestFrom(std::size_t viewpoint) const;
  void note(std::size_t from, std::size_t to);

  /// One of the evaluator's spaces in coarse cells.
  struct Followed {
    const TraversableSpace* space = nullptr;
    CoarseSpace coarse;
  };

  std::vector<Followed> followed_;
  std::size_t judged_ = 0;  ///< index of the space by which the evaluator has judged
  TravelField field_;
  Pose2 robot_;             ///< T_map_robot
  TravelField from_robot_;  ///< the wavefront that begins there
  std::vector<Vec2> places_;
  std::vector<Cell> cells_;
  std::vector<double> ways_;               ///< from the robot [m]
  double longest_way_ = 0.0;               ///< from the robot to a viewpoint [m]
  std::vector<std::vector<double>> rows_;  ///< empty until asked for; negative: not known yet
};

}  // namespace frontier_pilot::exploration
