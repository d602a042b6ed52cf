#pragma once

#include <cstddef>
#include <vector>

#include "frontier_pilot/slam/parameters.h"
#include "slam/back_end/loop_closer.h"
#include "slam/graph/submap_graph.h"

namespace frontier_pilot::slam {

/// Refines drives whose scans come so far apart that many steps between keyframes are known by odometry only. Such a
/// step bends the submaps that contain it, so that loops are found late and poorly. Once closures have shown the
/// error, the submaps are bent (`keyframePoses`) and all loops are searched for again, in more submaps for each
/// keyframe. Drives whose scans match are never refined.
class Refinement {
 public:
  explicit Refinement(const GraphSlamParameters& parameters = {}) : parameters_(parameters) {}

  /// Notes that a keyframe was added.
  void note(const KeyframeStep& step);
  /// Whether there is enough that is new, so that all refinements of a drive cost a bounded multiple of the last one.
  bool isDue() const;
  /// Replaces `graph` by one whose local frame is the map, with bent submaps, and `closer` by the one that has closed
  /// its loops. The counts of `closer` stay. If that loses more than half of the closures, both stay as they are.
  /// Returns all closures of the new graph.
  std::vector<LoopClosure> refine(SubmapGraph& graph, LoopCloser& closer);

 private:
  GraphSlamParameters parameters_;
  std::size_t keyframes_ = 0;
  std::size_t weak_ = 0;  ///< number of weak steps
  std::size_t last_ = 0;  ///< number of keyframes when the graph was refined last
};

}  // namespace frontier_pilot::slam
