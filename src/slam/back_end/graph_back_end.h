#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "frontier_pilot/occupancy/scan_inserter.h"
#include "frontier_pilot/slam/parameters.h"
#include "frontier_pilot/slam/pose_correction.h"
#include "slam/back_end/loop_closer.h"
#include "slam/back_end/refinement.h"
#include "slam/graph/submap_graph.h"

namespace frontier_pilot::slam {

/// The part of SLAM that runs in the background: the pose graph, the search for loops, and the rendering of the map. It
/// is a state machine that takes keyframes and shares no data with its caller.
class GraphBackEnd {
 public:
  /// Every rendering begins with `base`, a map in OctoMap's binary format, unless it is empty.
  GraphBackEnd(const GraphSlamParameters& parameters, const occupancy::OccupancyMapParameters& map,
               const occupancy::ScanInsertionParameters& insertion, std::string base = {});

  /// Adds the keyframes of `batch` one by one, and closes loops; renders the map if that is due.
  MapRevision update(std::vector<PlacedKeyframe> batch);
  /// The map of `refused`, the last revision, was not taken over: the owner's map and poses are as before it. Revisions
  /// move nothing until the next one with a map, which then includes the changes of this one.
  void takeBack(const MapRevision& refused);

  const SubmapGraph& graph() const { return graph_; }
  std::vector<KeyframePose> trajectory() const;

 private:
  void add(PlacedKeyframe placed);
  void refine();
  void report(LoopClosure closure);
  /// The pose in the map of the front end's local frame.
  Pose2 T_map_front() const { return graph_.T_map_local() * T_local_front_; }
  bool isRenderingDue() const;
  void render(MapRevision& revision);

  GraphSlamParameters parameters_;
  occupancy::OccupancyMapParameters map_parameters_;
  occupancy::ScanInserter inserter_;
  std::string base_;
  SubmapGraph graph_;
  LoopCloser closer_;
  Refinement refinement_;
  Pose2 T_local_front_;                ///< pose of the front end's local frame in the graph's, which refinements move
  Pose2 T_front_last_;                 ///< pose of the last keyframe in the front end's local frame
  std::vector<Pose2> rendered_;        ///< by keyframe: T_map_base with which it is drawn in the map
  std::vector<Pose2> replaced_;        ///< the same before the map was last rendered
  std::size_t rendered_count_ = 0;     ///< how many keyframes there were when the map was last rendered
  bool moved_ = false;                 ///< the graph has moved since then
  bool withheld_ = false;              ///< a map was refused: the owner's poses wait for the next one
  Pose2 T_new_old_;                    ///< how closures moved the local frame, not yet reported to the owner
  std::vector<LoopClosure> closures_;  ///< those closures
  std::set<std::pair<std::size_t, std::size_t>> reported_;  ///< submap and keyframe of every closure so far
};

}  // namespace frontier_pilot::slam
