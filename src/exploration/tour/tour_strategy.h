#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "exploration/goal_strategy.h"
#include "exploration/history/blacklist.h"
#include "exploration/tour/open_tour.h"
#include "exploration/tour/passages.h"
#include "exploration/tour/unknown_region.h"
#include "exploration/tour/viewpoint_distances.h"
#include "exploration/tour/viewpoints.h"

namespace frontier_pilot::exploration {

/// The first stop of a short tour that sees every frontier, priced in seconds. Viewpoints are chosen so that each
/// frontier is seen whole from one of them; the stops are ordered as an open travelling salesman's tour; the first one
/// is moved to where the detour is least. Slivers, behind which next to nothing is left to see, are only looked at in
/// passing; so are small frontiers, behind which little is expected, until no others are left. [EXP-9]
/// The order of decisions follows Kulich, Faigl & Preucil, "On Distance Utility in the Exploration Task", ICRA 2011,
/// who plan a travelling salesman's tour over representatives of the frontiers.
class TourStrategy : public GoalStrategy {
 public:
  explicit TourStrategy(const ExplorerParameters& parameters);

  std::optional<ChosenGoal> choose(FrontierEvaluator& evaluator, const Situation& situation) override;
  void stayedUnknown() override;
  void reset() override {
    distrusted_.reset();
    changes_of_mind_ = 0;
  }
  /// A tour changes with what is seen on the way, so that it is planned twice as often as other goals are compared.
  double decisionPeriods() const override { return 0.5; }

 private:
  /// A viewpoint of the tour and those of its frontiers that no earlier stop has shown.
  struct Stop {
    std::size_t viewpoint = 0;
    std::vector<std::size_t> frontiers;
    double area = 0.0;       ///< that it shows of these [m^2]
    double arrival = 0.0;    ///< from now, by the costs of the plan [s]
    double open_area = 0.0;  ///< greatest unknown area around one of these [m^2]
  };
  /// Stops in the order of their visits, and how long that takes [s].
  struct Plan {
    std::vector<Stop> stops;
    double cost = 0.0;
  };

  bool isNearlyThere(const Situation& situation) const;
  void expireDistrust();
  void seek();
  void measureOpenAreas();
  double openAreaAt(std::size_t frontier);
  void findSlivers();
  double expectedAreaAt(std::size_t frontier);
  void expectAreas();
  void putOffSmallOnes();
  std::optional<std::size_t> presentViewpoint(const Situation& situation) const;
  void leaveToOthers(SharedWork& shared);
  void rejectRest();
  Plan choosePlan(const Situation& situation);
  Plan plan(std::optional<std::size_t> first);
  std::vector<Stop> cover(std::optional<std::size_t> first) const;
  Stop stopAt(std::size_t viewpoint, std::vector<bool>& shown) const;
  double worthOf(std::size_t viewpoint, const std::vector<bool>& shown) const;
  TourCosts price(const std::vector<Stop>& stops);
  double exitOf(const Stop& stop) const;
  double secondsFor(double distance) const;
  Pose2 poseAt(std::size_t viewpoint) const;
  double secondsToLookFrom(std::size_t viewpoint, const Pose2& before) const;
  double wayTo(std::size_t viewpoint) const;
  void shorten(Plan& plan);
  double detourFor(const Viewpoint& viewpoint, const std::vector<bool>& shown) const;
  void takeNearOne(Plan& plan);
  bool shows(std::size_t viewpoint, const std::vector<std::size_t>& frontiers) const;
  ChosenGoal goalAt(const Pose2& pose) const;
  ChosenGoal goalOf(const Plan& plan, const Situation& situation);
  double arrivalYaw(Cell goal) const;

  TourParameters parameters_;
  double min_distance_;  ///< [m]
  RobotLimits limits_;
  ViewpointSearch search_;
  ViewpointDistances distances_;
  UnknownRegions regions_;
  Passages passages_;
  FrontierEvaluator* evaluator_ = nullptr;  ///< of the decision, as is all up to left_
  Pose2 robot_;                             ///< T_map_robot
  std::vector<SoughtFrontier> sought_;
  bool all_sought_ = true;  ///< false: farther frontiers are left out of the tour
  std::vector<Viewpoint> viewpoints_;
  std::vector<double> ways_home_;   ///< from each viewpoint [m]; negative where none leads or none is wanted
  std::vector<double> open_areas_;  ///< unknown area around each frontier [m^2]
  std::vector<bool> slivers_;       ///< by frontier
  std::vector<double> expected_;    ///< floor behind each frontier, if it can be told [m^2]; else infinite
  std::vector<bool> put_off_;       ///< by frontier: a sliver, or a small one that waits or is left
  std::vector<bool> left_;          ///< by frontier: to other robots
  int changes_of_mind_ = 0;         ///< goals in a row that were left while they still had something to show
  std::vector<Vec2> aimed_at_;      ///< anchors of the frontiers that the last goal should show
  Blacklist distrusted_;            ///< anchors of frontiers that stayed unknown when seen from a viewpoint
  std::uint32_t restarts_ = 0;      ///< of the map's counts of changes at the last decision
};

}  // namespace frontier_pilot::exploration
