#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/parameters.h"
#include "frontier_pilot/core/robot_model.h"

namespace frontier_pilot::exploration {

/// How the view from a goal is estimated.
struct ViewParameters {
  double sensor_range = 8.0;
  double unknown_depth = 1.5;        ///< what lies this far behind the first unknown cell counts as seen [m]
  int rays = 120;                    ///< number of beams over the full circle
  double field_of_view = 2.0 * kPi;  ///< of the scanner, taken from the description of the robot [rad]
  double direction = 0.0;            ///< of the middle of the field of view, relative to the robot's heading [rad]

  /// Whether it does not matter which way the robot looks; a scanner that misses only a narrow wedge counts as such.
  bool allAround() const { return field_of_view > 11.0 / 6.0 * kPi; }
  /// The yaw of a robot that looks towards `bearing` [rad].
  double yawTowards(double bearing) const { return allAround() ? bearing : normalizeAngle(bearing - direction); }
  /// Whether a robot with `yaw` sees what is in the direction `bearing` [rad].
  bool shows(double bearing, double yaw) const {
    return allAround() || std::abs(angleDifference(bearing, yaw + direction)) <= 0.5 * field_of_view;
  }

  template <class V>
  void describe(V& v) {
    v.field("sensor_range", sensor_range, "m",
            "range that is assumed when the view from a goal is estimated, at most that of the robot's scanner",
            scanRange());
    v.fixed({"unknown_depth", "rays"});
  }
};

/// Weights and scales of the goal score. [EXP-4]
struct ScoreParameters {
  double w_info = 1.0;
  double w_dist = 1.0;
  double w_obs = 1.2;
  double w_visit = 0.8;
  double info_scale = 8.0;      ///< expected area that counts half [m^2]
  double distance_scale = 3.0;  ///< distance that counts 1 [m]
  double switch_margin = 0.5;   ///< bonus in the score of a goal near the present one
  bool info_by_ray_casting = true;
  bool distance_by_travel = true;

  template <class V>
  void describe(V& v) {
    v.field("w_info", w_info, "", "weight of the expected information", between(0.0, 1e6));
    v.field("w_dist", w_dist, "", "weight of the distance", between(0.0, 1e6));
    v.field("w_obs", w_obs, "", "weight of the obstacle density around the goal", between(0.0, 1e6));
    v.field("w_visit", w_visit, "", "weight of earlier goals close by", between(0.0, 1e6));
    v.fixed({"info_scale", "distance_scale", "switch_margin"});
    v.field("info_by_ray_casting", info_by_ray_casting, "",
            "estimate the information by ray casting; false: by the share of unknown cells around the goal");
    v.field("distance_by_travel", distance_by_travel, "",
            "score by the travel distance to the goal; false: by the Euclidean distance");
  }
};

/// How strategy `tour` decides.
struct TourParameters {
  double exit_depth = 2.0;      ///< how far the unknown behind an open frontier is expected to lead [m]
  double open_area = 5.0;       ///< unknown area around a frontier from which on it counts as open [m^2]
  double switch_margin = 3.0;   ///< a tour with another first goal has to be this much shorter [s]
  double sliver_area = 0.2;     ///< a frontier with less connected unknown area around it is a sliver [m^2]
  double hidden_area = 1.5;     ///< so is one with less than this of which even the best viewpoint shows [m^2] ...
  double least_area = 0.05;     ///< ... less than this [m^2]
  double sliver_share = 0.004;  ///< slivers may be left while together they are a smaller share of the known floor
  double sliver_detour = 2.0;   ///< slivers are looked at on the way if that takes less [s]

  double small_area = 1.2;        ///< a frontier behind which less floor is expected is small [m^2]
  double small_detour = 3.0;      ///< a small one that is put off is looked at on the way if that takes less than ...
  double detour_per_area = 12.0;  ///< ... this [s], and this for each square metre expected behind it [s/m^2]
  double put_off_share = 0.03;    ///< share of the known floor that may be expected behind all that are put off
  double left_share = 0.01;       ///< the same of those that are left in the end
  double most_left = 0.8;         ///< one behind which more is expected is never left: it may be a door [m^2]
};

/// Which frontiers can be chosen. [EXP-2] [EXP-3]
struct FrontierParameters {
  int min_frontier_cells = 4;
  double max_cluster_extent = 3.0;  ///< longer clusters are cut [m]
  double clearance_margin = 0.045;
  double trap_margin = 0.03;        ///< added to clearance_margin in the space that is tried first [m]
  double escape_radius = 0.6;       ///< paths may begin this far from a robot too near to an obstacle [m]
  double goal_search_radius = 1.0;  ///< greatest distance of a goal from the frontier cell that it has to see [m]
  double min_distance = 0.45;
  int obstacle_radius_cells = 6;
  double max_obstacle_density = 0.30;
  double min_info_area = 0.01;
  double min_info_share = 2e-4;  ///< least area expected at a goal, as a share of the map's free area
  double visit_radius = 0.6;     ///< goals reached within this distance count as visits [m]
  ViewParameters view;
  ScoreParameters score;

  template <class V>
  void describe(V& v) {
    v.field("min_frontier_cells", min_frontier_cells, "", "frontiers of fewer cells are ignored", countFrom(1));
    v.fixed({"max_cluster_extent"});
    v.field(
        "clearance_margin", clearance_margin, "m",
        "room that a path to a goal leaves on either side of the robot: about one cell, which is how exactly walls are "
        "mapped",
        between(0.0, 10.0));
    v.moved("inscribed_radius", "clearance_margin (on top of half the robot's width)");
    v.fixed({"trap_margin", "escape_radius", "goal_search_radius"});
    v.field("min_distance", min_distance, "m", "goals to which the way is shorter than this are not sent",
            between(0.0, 100.0));
    v.field("obstacle_radius_cells", obstacle_radius_cells, "cells", "radius in which the obstacle density is measured",
            between(1, 40));
    v.field("max_obstacle_density", max_obstacle_density, "",
            "goals with a greater obstacle density around them are not sent", between(0.0, 1.0));
    v.field("min_info_area", min_info_area, "m^2",
            "goals that are expected to show less unknown area than this are not sent", between(0.0, 1e6));
    v.fixed({"min_info_share", "visit_radius"});
    v.group("view", view, "what is expected to be seen from a goal");
    v.group("score", score, "how goals are compared");
  }
};

/// Which places are not to be tried, and for how long. [EXP-5]
struct BlacklistParameters {
  double radius = 0.60;
  double change_radius = 1.0;  ///< distance from a place within which changes of the map are counted [m]
  int change_cells = 20;       ///< number of changed cells that lifts a first entry; doubled for each earlier one

  template <class V>
  void describe(V& v) {
    v.field("radius", radius, "m", "frontiers with a goal nearer than this to a blacklisted goal are not tried",
            positiveUpTo(1000.0));
    v.fixed({"change_radius", "change_cells"});
  }
};

/// Where an exploration takes place: simple polygons in the map's frame [m]. [EXP-10]
struct ExplorationBounds {
  std::vector<Vec2> stay_within;            ///< empty: everywhere
  std::vector<std::vector<Vec2>> keep_out;  ///< areas to stay out of

  bool empty() const { return stay_within.empty() && keep_out.empty(); }
  bool contain(const Vec2& point) const;
  /// What is wrong with them, naming the polygon; empty if nothing is.
  std::string problem() const;
  /// For a log or an answer: the number of corners and the areas.
  std::string describe() const;
};

/// The bounds as lists of numbers. [EXP-10]
struct BoundsParameters {
  std::vector<double> stay_within;
  std::vector<std::vector<double>> keep_out;

  ExplorationBounds polygons() const;

  template <class V>
  void describe(V& v) {
    const Bounds coordinate = between(-bounds::kMostCoordinate, bounds::kMostCoordinate);
    v.field("stay_within", stay_within, "m",
            "corners x1, y1, x2, y2, ... of the area to explore, in map_frame; empty: everywhere", coordinate);
    v.field("keep_out", keep_out, "m", "areas to stay out of, a list of corners like stay_within for each", coordinate);
  }
  void check(Problems& problems) const;
};

/// When an exploration ends although frontiers are left; 0: no such rule. [EXP-10]
struct UntilParameters {
  double area = 0.0;
  double time = 0.0;
  double distance = 0.0;
  double battery = 0.0;
  double share = 0.0;

  /// The rules that are set, for a status: "400 m2 are known or 600 s have passed"; empty if none is. `area` is counted
  /// from `explored_before` [m^2] on, see ExplorerProgress.
  std::string inWords(double explored_before = 0.0) const;

  template <class V>
  void describe(V& v) {
    v.field("area", area, "m^2", "end the exploration when this much floor is known to be free; 0: no such end",
            between(0.0, 1e9));
    v.field("time", time, "s",
            "end the exploration after this long, without pauses and waiting for inputs; 0: no such end",
            timeSpanOrNone());
    v.field("distance", distance, "m", "end the exploration after this much driving; 0: no such end",
            between(0.0, 1e9));
    v.field("battery", battery, "",
            "end the exploration when battery_state reports this share of the charge or less; 0: no such end",
            between(0.0, 1.0));
    v.field("share", share, "",
            "end the exploration when this share of the estimate of the whole floor is explored; 0: no such end",
            between(0.0, 1.0));
  }
};

/// Poses that somebody wants the robot to take during the exploration. [EXP-10]
struct InspectParameters {
  double detour = 4.0;
  double stay = 3.0;

  template <class V>
  void describe(V& v) {
    v.field("detour", detour, "m",
            "a pose is inspected as soon as the way over it to the next goal is at most this longer",
            between(0.0, 1000.0));
    v.field("stay", stay, "s", "how long the robot stands at a pose that it inspects", timeSpanOrNone());
  }
};

/// Parameters of the explorer.
struct ExplorerParameters {
  RobotModel robot;
  std::string strategy = "tour";  ///< `tour`, `greedy` or `nearest`
  double rich_min_density = 0.0;
  double goal_timeout = 120.0;
  int max_goal_retries = 1;
  double check_period = 0.5;  ///< time between two checks of what there is to see at the goal [s]
  double decision_period = 2.0;
  double settle_time = 1.0;
  double done_settle_time = 3.0;
  double yield_time = 5.0;       ///< wait after another client has preempted a goal [s]
  double vanished_share = 0.25;  ///< with less of the expected area left, the goal is given up
  double input_timeout = 1.5;
  double report_period = 5.0;
  bool return_to_start = false;
  FrontierParameters frontier;
  BlacklistParameters blacklist;
  TourParameters tour;
  BoundsParameters bounds;
  UntilParameters until;
  InspectParameters inspect;

  template <class V>
  void describe(V& v) {
    describeRobot(v, robot);
    v.field(
        "strategy", strategy, "",
        "which goal comes next: tour, the first one of a tour over all of them; greedy, the one with the best score; "
        "nearest, the one with the shortest way");
    v.field(
        "rich_min_density", rich_min_density, "",
        "least information density of the frontiers that phase RICH selects; 0: the score alone decides in both phases",
        between(0.0, 1.0));
    v.field("goal_timeout", goal_timeout, "s",
            "after this long a goal is cancelled, unless the robot is still on a longer way to it; a frontier's goal "
            "is also blacklisted",
            timeSpan());
    v.field("max_goal_retries", max_goal_retries, "",
            "failures allowed within blacklist/radius; with one more the place is blacklisted", countFrom(0));
    v.fixed({"check_period"});
    v.field("decision_period", decision_period, "s", "time between two comparisons of the present goal with the others",
            timeSpan());
    v.field("settle_time", settle_time, "s", "time to wait at a goal for the map to show what was expected",
            timeSpanOrNone());
    v.field("done_settle_time", done_settle_time, "s", "exploration is done after this long without a goal to send",
            timeSpanOrNone());
    v.fixed({"yield_time", "vanished_share"});
    v.field(
        "input_timeout", input_timeout, "s",
        "greatest age of pose and odometry; beyond it they count as missing, until they are younger than half of it",
        timeSpan());
    v.field("report_period", report_period, "s", "time between two warnings about missing inputs", tickPeriod());
    v.field("return_to_start", return_to_start, "", "drive back to the start before DONE");
    v.group("frontier", frontier, "frontiers and their goals");
    v.group("blacklist", blacklist, "places that are not to be tried");
    v.group("bounds", bounds, "where to explore");
    v.group("until", until, "when to end");
    v.group("inspect", inspect, "poses to take on the way");
    v.tunable({"goal_timeout", "frontier/min_frontier_cells", "frontier/max_obstacle_density", "frontier/min_info_area",
               "frontier/score/w_info", "frontier/score/w_dist", "frontier/score/w_obs", "frontier/score/w_visit"});
  }
  void check(Problems& problems) const {
    if (strategy == "tour" || strategy == "greedy" || strategy == "nearest") return;
    problems.push_back("strategy: must be tour, greedy or nearest, not '" + strategy + "'");
  }
};

}  // namespace frontier_pilot::exploration
