#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "exploration/frontier_evaluator.h"
#include "exploration/tour/best_look.h"
#include "exploration/tour/frontier_views.h"

namespace frontier_pilot::exploration {

/// What a viewpoint shows of one frontier.
struct Sight {
  std::size_t frontier = 0;  ///< index in FrontierEvaluator::frontiers()
  double area = 0.0;         ///< unknown area behind it that is in sight [m^2]
};

/// A place that the robot can reach, from which at least one frontier can be seen whole.
struct Viewpoint {
  Cell cell;
  std::vector<Sight> sights;  ///< of the frontiers that it shows whole
  Look look;                  ///< with which it shows most of them; the rest is seen while the robot turns to it
};

/// A frontier that viewpoints are looked for.
struct SoughtFrontier {
  std::size_t index = 0;  ///< in FrontierEvaluator::frontiers()
  bool trusted = true;    ///< whether it may be seen from other places than its own goal
};

/// Finds the viewpoints of frontiers: their own goals and the nodes of a lattice around them. A frontier
/// is seen whole from a viewpoint that shows at least half of the area that the best viewpoint shows.
class ViewpointSearch {
 public:
  explicit ViewpointSearch(const ViewParameters& parameters) : views_(parameters) {}

  /// `present`, the goal being driven to, stays a viewpoint until it shows clearly less than others.
  std::vector<Viewpoint> find(const FrontierEvaluator& evaluator, const std::vector<SoughtFrontier>& sought,
                              const std::optional<Pose2>& present);
  /// The greatest area that any viewpoint of the last search shows of a frontier [m^2].
  double mostOf(std::size_t frontier) const { return most_[frontier]; }

 private:
  void label(const FrontierEvaluator& evaluator, const std::vector<SoughtFrontier>& sought);
  std::vector<Cell> sample(const FrontierEvaluator& evaluator, const std::vector<SoughtFrontier>& sought,
                           const std::optional<Cell>& present) const;
  std::vector<Sight> sightsFrom(Cell viewpoint, const FrontierEvaluator& evaluator);
  Look lookFrom(const Viewpoint& viewpoint, const FrontierEvaluator& evaluator);
  static void addUnseen(const FrontierEvaluator& evaluator, const std::vector<SoughtFrontier>& sought,
                        std::vector<Viewpoint>& all);

  FrontierViews views_;
  std::vector<double> most_;           ///< by frontier [m^2]
  Grid<std::uint16_t> labels_;         ///< 1 + the place in the list of sought frontiers of a cell's; 0: none
  std::vector<std::size_t> sought_;    ///< the frontiers that are sought, at most 65535
  std::vector<std::size_t> labelled_;  ///< indices of the cells with a label
};

}  // namespace frontier_pilot::exploration
