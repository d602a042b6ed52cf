#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "frontier_pilot/occupancy/scan_inserter.h"
#include "frontier_pilot/slam/parameters.h"
#include "frontier_pilot/slam/pose_correction.h"
#include "slam/back_end/loop_closer.h"
#include "slam/graph/submap_graph.h"

namespace frontier_pilot::slam {

/// What is thought about in the background: the graph, the search for loops, and the map that follows from them. A
/// state machine of its own, fed with keyframes; it shares nothing with who feeds it.
class GraphBackEnd {
 public:
  /// `base`, if any, is what every rendering begins with: a map in OctoMap's binary format.
  GraphBackEnd(const GraphSlamParameters& parameters, const occupancy::OccupancyMapParameters& map,
               const occupancy::ScanInsertionParameters& insertion, std::string base = {});

  /// Takes `batch` in, keyframe by keyframe.
  MapRevision update(std::vector<PlacedKeyframe> batch);
  /// The map of `refused`, the last revision, was not taken over: the owner's map and poses are as before it. Revisions
  /// move nothing until the next one with a map, which stands for this one too.
  void takeBack(const MapRevision& refused);

  const SubmapGraph& graph() const { return graph_; }
  std::vector<KeyframePose> trajectory() const;

 private:
  bool isRenderingDue() const;
  void render(MapRevision& revision);

  GraphSlamParameters parameters_;
  occupancy::OccupancyMapParameters map_parameters_;
  occupancy::ScanInserter inserter_;
  std::string base_;
  SubmapGraph graph_;
  LoopCloser closer_;
  std::vector<Pose2> rendered_;        ///< by keyframe: T_map_base of its trace in the map
  std::vector<Pose2> replaced_;        ///< the same before the map was last rendered
  std::size_t rendered_count_ = 0;     ///< how many keyframes there were when the map was last rendered
  bool moved_ = false;                 ///< the graph has moved since then
  bool withheld_ = false;              ///< a map was refused: the owner's poses wait for the next one
  Pose2 T_new_old_;                    ///< by what the graph has moved the local frame, not told to the owner yet
  std::vector<LoopClosure> closures_;  ///< the closures that did
};

}  // namespace frontier_pilot::slam
