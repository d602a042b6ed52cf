#pragma once

#include <vector>

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/core/parameters.h"
#include "frontier_pilot/exploration/view_gain.h"

namespace frontier_pilot::exploration {

/// Why a frontier cannot be chosen now. [EXP-3]
enum class Rejection {
  kNone,
  kTooSmall,      ///< its whole frontier, before it is cut, has fewer cells than min_frontier_cells
  kUnreachable,   ///< no cell in sight of it can be reached
  kTooNear,       ///< travel distance below min_distance, from every cell that sees it
  kCluttered,     ///< obstacle density around every such cell above max_obstacle_density
  kBlacklisted,   ///< near a blacklisted goal
  kNothingToSee,  ///< no beam from the goal is expected to find unknown ground
  kNotRich,       ///< in phase RICH: information density below rich_min_density
  kFruitless,     ///< reached before, and what it was to show stayed unknown
  kLeftOut,       ///< not judged: there are too many others, larger or nearer ones
};
const char* toString(Rejection rejection);

/// One cluster of frontier cells as the explorer judges it.
struct Frontier {
  std::vector<Cell> cells;  ///< filled on request only
  int cell_count = 0;
  Vec2 centroid = Vec2::Zero();  ///< [m]; may lie in a wall
  Cell anchor;                   ///< its own cell nearest to the centroid
  Rejection rejection = Rejection::kNone;
  Vec2 goal = Vec2::Zero();       ///< a reachable place that sees it [m]; meaningless when unreachable
  double heading = 0.0;           ///< from the goal to the frontier [rad]
  double distance = 0.0;          ///< of travel, from the robot to the goal [m]
  ViewGain info;                  ///< what the goal is expected to show
  double obstacle_density = 0.0;  ///< occupied share of the known cells around the goal
  int visits = 0;                 ///< earlier goals close by
  double score = 0.0;             ///< of selectable ones

  bool selectable() const { return rejection == Rejection::kNone; }
};

/// What the score is made of. [EXP-4]
struct ScoreParameters {
  double w_info = 1.0;
  double w_dist = 1.0;
  double w_obs = 1.2;
  double w_visit = 0.8;
  double info_scale = 8.0;
  double distance_scale = 3.0;
  double switch_margin = 0.5;
  bool info_by_ray_casting = true;
  bool distance_by_travel = true;

  template <class V>
  void describe(V& v) {
    v.field("w_info", w_info, "", "weight of the expected information", atLeast(0.0));
    v.field("w_dist", w_dist, "", "weight of the distance", atLeast(0.0));
    v.field("w_obs", w_obs, "", "weight of the obstacle density around the goal", atLeast(0.0));
    v.field("w_visit", w_visit, "", "weight of earlier goals close by", atLeast(0.0));
    v.fixed({"info_scale", "distance_scale", "switch_margin"});
    v.field("info_by_ray_casting", info_by_ray_casting, "",
            "whether the information is found by ray casting; false: by the unknown share around the goal");
    v.field("distance_by_travel", distance_by_travel, "",
            "whether the distance is that of the way to the goal; false: the Euclidean distance");
  }
};

/// Which frontiers can be chosen. [EXP-2] [EXP-3]
struct FrontierParameters {
  int min_frontier_cells = 4;
  double max_cluster_extent = 3.0;
  double clearance_margin = 0.045;
  double trap_margin = 0.03;
  double escape_radius = 0.6;
  double goal_search_radius = 1.0;
  double min_distance = 0.45;
  int obstacle_radius_cells = 6;
  double max_obstacle_density = 0.30;
  double min_info_area = 0.01;
  double min_info_share = 2e-4;
  double visit_radius = 0.6;
  ViewParameters view;
  ScoreParameters score;

  template <class V>
  void describe(V& v) {
    v.field("min_frontier_cells", min_frontier_cells, "", "smaller frontiers are ignored", atLeast(1));
    v.fixed({"max_cluster_extent"});
    v.field("clearance_margin", clearance_margin, "m",
            "room that a way to a goal leaves on either side of the robot: nearly a cell of the map, for its walls are "
            "known no better",
            atLeast(0.0));
    v.moved("inscribed_radius", "clearance_margin (on top of half the robot's width)");
    v.fixed({"trap_margin", "escape_radius", "goal_search_radius"});
    v.field("min_distance", min_distance, "m", "goals nearer to the robot are not sent", atLeast(0.0));
    v.field("obstacle_radius_cells", obstacle_radius_cells, "cells", "radius in which the obstacle density is measured",
            atLeast(1));
    v.field("max_obstacle_density", max_obstacle_density, "",
            "goals with a greater obstacle density around them are not sent", between(0.0, 1.0));
    v.field("min_info_area", min_info_area, "m^2", "goals that are expected to show less unknown area are not sent",
            atLeast(0.0));
    v.fixed({"min_info_share", "visit_radius"});
    v.group("view", view, "what is expected to be seen from a goal");
    v.group("score", score, "how goals are compared");
  }
};

}  // namespace frontier_pilot::exploration
