#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/occupancy/scan_inserter.h"
#include "frontier_pilot/slam/drift_covariance.h"
#include "frontier_pilot/slam/local_slam.h"
#include "frontier_pilot/slam/loop_closer.h"
#include "frontier_pilot/slam/pose_correction.h"
#include "frontier_pilot/slam/submap_graph.h"

namespace frontier_pilot::slam {

struct RenderingParameters {
  double min_distance = 0.025;    ///< the map is rendered again when a keyframe moved this far [m]
  double min_angle = 0.005;       ///< or turned this far [rad]
  double urgent_distance = 0.05;  ///< at once, when one moved this far [m]
  double share = 0.02;            ///< else after so many new keyframes, as a share of all

  template <class Visitor>
  void describe(Visitor& v) {
    v.fixed({"min_distance", "min_angle", "urgent_distance", "share"});
  }
};

struct GraphSlamParameters {
  LocalSlamParameters local;
  SubmapDrift drift;
  PoseGraphParameters graph;
  LoopCloserParameters loops;
  RenderingParameters rendering;

  template <class Visitor>
  void describe(Visitor& v) {
    v.group("local", local, "matching of scans with the last few metres");
    v.group("drift", drift, "how far the local map is believed to drift");
    v.group("graph", graph, "the pose graph");
    v.group("loops", loops, "loop closing");
    v.group("rendering", rendering, "when the map is rendered again");
  }
};

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

/// Simultaneous localisation and mapping: scans are matched with the last few metres by LocalSlam at once, loops are
/// closed by GraphBackEnd in the background. [MAP-1]
/// The map's frame is the local one as long as no loop was closed.
class GraphSlam final : public PoseCorrection {
 public:
  /// The map that revisions bring has `map` as its parameters, scans go into it by `insertion`, and it begins with
  /// `base`, a map in OctoMap's binary format, if there is one.
  explicit GraphSlam(const GraphSlamParameters& parameters = {}, const occupancy::OccupancyMapParameters& map = {},
                     const occupancy::ScanInsertionParameters& insertion = {}, std::string base = {});

  CorrectedScan correct(const LaserScan2& scan, const Pose2& T_odom_base, const occupancy::OccupancyMap& map) override;
  RevisionWork takeWork() override;
  bool accept(const MapRevision& revision) override;
  bool refuse(const MapRevision& revision) override;
  void abandonWork() override;
  std::vector<KeyframePose> trajectory() const override { return back_end_->trajectory(); }
  void reset() override;

 private:
  void keep(LocalSlamOutput& output);

  GraphSlamParameters parameters_;
  occupancy::OccupancyMapParameters map_parameters_;
  occupancy::ScanInsertionParameters insertion_parameters_;
  std::string base_;
  LocalSlam local_;
  DriftCovariance drift_;
  Pose2 T_map_local_;
  std::shared_ptr<GraphBackEnd> back_end_;  ///< only the work touches it while it is out
  std::vector<PlacedKeyframe> inbox_;       ///< keyframes for the next work
  bool working_ = false;
  bool abandoned_ = false;  ///< the back end threw: it gets nothing any more
  std::uint64_t generation_ = 0;
};

}  // namespace frontier_pilot::slam
