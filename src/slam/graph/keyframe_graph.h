#pragma once

#include <vector>

#include "frontier_pilot/slam/parameters.h"
#include "slam/graph/submap_graph.h"

namespace frontier_pilot::slam {

/// The poses in the map of all keyframes, T_map_base, optimised as nodes of their own: each is held by the steps from
/// and to its neighbours, and by its closures. A closure counts as one with the keyframe of the submap that is nearest
/// to where it was found. So the error that a closure shows ends up where the steps are weak, also within submaps,
/// which SubmapGraph treats as rigid.
std::vector<Pose2> keyframePoses(const SubmapGraph& graph, const RefinementParameters& parameters = {});

}  // namespace frontier_pilot::slam
