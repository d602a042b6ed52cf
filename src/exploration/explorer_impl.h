#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "exploration/frontier_evaluator.h"
#include "exploration/goal_strategy.h"
#include "exploration/history/goal_history.h"
#include "exploration/inspection/inspection_list.h"
#include "exploration/limits/stopping_rules.h"
#include "exploration/progress/goal_patience.h"
#include "exploration/team/shared_work.h"
#include "frontier_pilot/exploration/explorer.h"

namespace frontier_pilot::exploration {

/// The explorer's state machine: events and transitions in explorer.cpp, the actions in each state in
/// explorer_steps.cpp, the fall-backs for when no frontier can be selected in fall_backs.cpp, what it waits for in
/// progress/explorer_waits.cpp, how far it has come in progress/explorer_progress.cpp, what bounds and ends an
/// exploration in limits/explorer_limits.cpp, what is inspected meanwhile in inspection/inspections.cpp, and what it
/// leaves to the robots of its team in team/team_steps.cpp.
class Explorer::Impl {
 public:
  explicit Impl(const ExplorerParameters& parameters);

  void setMap(const OccupancyGrid& map, const CellRect& changed);
  void setBounds(const ExplorationBounds& bounds, const OccupancyGrid& map);
  void setReturnToStart(bool on) { parameters_.return_to_start = on; }
  bool returnsToStart() const { return parameters_.return_to_start; }
  const std::optional<Pose2>& start() const { return start_; }
  void setStart(const Pose2& T_map_start) { start_ = T_map_start; }
  std::optional<ExplorerReason> endedBy() const { return ended_by_; }
  void setParameters(const ExplorerParameters& parameters);
  std::string inspect(const Pose2& pose);
  void clearInspections();
  void leaveMap();
  std::vector<Pose2> inspections() const;
  ExplorerOutput update(const ExplorerInputs& inputs, Time now);

  FrontierEvaluator& evaluator() { return evaluator_; }
  const FrontierEvaluator& evaluator() const { return evaluator_; }
  const GoalHistory& history() const { return history_; }
  const std::optional<Pose2>& goal() const { return goal_pose_; }
  const std::vector<Vec2>& tour() const { return chosen_.tour; }
  std::string explain() const;
  std::vector<Claim> claims() const;

 private:
  /// A goal sent to the navigation.
  struct Goal {
    enum class Purpose {
      kFrontier,    ///< to see what is unknown
      kStepBack,    ///< to get away from a frontier that is too near
      kInspection,  ///< to take a pose that somebody asked for
      kReturn,      ///< to be back at the start
    };
    std::uint32_t id = 0;
    Vec2 position = Vec2::Zero();
    double yaw = 0.0;               ///< that the robot takes there [rad], in the map's frame
    double info_area = 0.0;         ///< expected area when it was chosen [m^2]
    Vec2 sent_from = Vec2::Zero();  ///< where the robot was then [m]
    Purpose purpose = Purpose::kFrontier;
    std::uint32_t inspection = 0;  ///< id of the pose to inspect
    bool on_the_way = false;       ///< sent to a stop on the way, around what is out of bounds

    Pose2 pose() const { return {position, yaw}; }
  };

  /// An alternative that is tried when the ordinary judgement leaves no selectable frontier.
  struct FallBack {
    enum class Scope {
      kEveryDecision,  ///< judges the same map by other rules; also tried while the robot drives to a goal
      kWithoutGoal,    ///< changes the basis of the next decision or sends a goal of its own; only without a goal
    };
    const char* name;  ///< ends the text of a goal that a fall-back of kEveryDecision has found
    Scope scope;
    bool (Impl::*attempt)(Time now);  ///< returns whether it helped
  };
  static const std::array<FallBack, 5> kFallBacks;

  void trackMotion(const ExplorerInputs& inputs, Time now);
  Duration sinceLastTick(Time now) const;
  /// No time has passed where the clock jumped.
  void heedClock(Time now);
  void forgetTime(Time now);
  void skipTime(Duration gap);
  void reset(Time now);
  bool ready(const ExplorerInputs& inputs, Time now);
  /// Cancels the goal and waits.
  void standFor(ExplorerReason reason, Time now);
  void stopFor(const std::string& missing, ExplorerReason first, Time now);
  bool isStale(Time stamp, Time now, bool& was_stale) const;
  std::vector<ExplorerReason> missingInputs(const ExplorerInputs& inputs, Time now);
  bool givesUpReturn(const std::optional<Goal>& goal, Time now);
  void endReturn();
  void standUntilItCanDrive(const std::string& what, Time now);
  bool waitsForNavigation(Time now) const;
  void obeyReplacedMap(Time now);
  void handleEvent(const GoalEvent& event, Time now);
  void stopReached(const Goal& goal, Time now);
  void goalFailed(const Goal& goal, const std::string& what);
  void goalTimedOut(const Goal& goal);

  void step(Time now);
  void selectGoal(Time now);
  void navigate(Time now);
  void evaluateArrival(Time now);
  void stayDone(Time now);

  bool isSame(const Goal& goal, const ChosenGoal& chosen) const;
  bool decide(ExplorerReason reason, Time now);
  std::optional<ChosenGoal> judgeAndChoose(bool keep_present, Time now);
  std::size_t countRejected(Rejection rejection) const;
  bool informationGone();
  FrontierEvaluator::Context context();
  Situation situation(bool keep_present);

  const FallBack* fallBack(FallBack::Scope scope, Time now);
  bool judgeTightWays(Time now);
  bool judgeWaysFromStart(Time now);
  bool goOnToCoverage(Time now);
  bool anyRich();
  bool stepBack(Time now);
  bool retryBlacklisted(Time now);

  void countExploring(double driven, Time now);
  StoppingRules::State rulesState() const;
  void startAgain(Time now);
  bool yield(const ExplorerInputs& inputs, Time now);
  bool withinLimits(Time now);
  bool keepWithinBounds(Time now);
  void endByRule(Time now);
  bool mayReturn() const;

  struct ReachableInspection {
    Inspection inspection;
    Cell cell;              ///< where the robot can stand
    double distance = 0.0;  ///< travel distance to it [m]
  };
  std::vector<ReachableInspection> reachableInspections() const;
  bool inspectOnTheWay(const ChosenGoal& next, Time now);
  bool inspectWhatIsLeft(Time now);
  void sendToInspection(const ReachableInspection& place, Time now);
  bool hasInspected(Time now);
  void inspectionFailed(const Goal& goal, const std::string& what);
  void obeyClearedInspections(Time now);

  void finish(Time now);
  ExplorerReason whyNothingIsLeft() const;
  void returnToStart(Time now);

  void send(Goal goal, ExplorerReason reason, const std::string& text, Time now);
  double secondsTo(const Vec2& goal) const;
  void cancelGoal();
  void enter(ExplorerState state, ExplorerReason reason, const std::string& text, Time now);
  void note(bool warning, const std::string& text) { out_.notes.push_back({warning, text}); }
  bool leavesWorkToOthers() const;
  void standAside(Time now);
  void noteClaims();

  void countFrontiers();
  void estimateWhole();
  void setWholeExplored();

  ExplorerParameters parameters_;
  FrontierEvaluator evaluator_;
  GoalHistory history_;
  std::unique_ptr<GoalStrategy> strategy_;
  StoppingRules rules_;
  SharedWork shared_;
  std::vector<Claim> claims_;  ///< at the last decision
  Time claims_at_;             ///< when their costs held
  InspectionList inspections_;
  bool inspections_cleared_ = false;  ///< since the last tick
  TravelField onwards_;               ///< from the poses to inspect to the next goal

  ExplorerOutput out_;
  ExplorerProgress status_;
  std::optional<Goal> goal_;              ///< being driven to
  std::optional<GoalPatience> patience_;  ///< for the goal that was sent last
  std::optional<Goal> arrived_;           ///< reached and not yet evaluated
  std::optional<Pose2> goal_pose_;
  ChosenGoal chosen_;  ///< at the last decision; without a goal its members are empty
  std::optional<Pose2> start_;
  std::optional<Pose2> T_map_base_;
  std::optional<Vec2> unable_at_;  ///< where the navigation could drive nowhere [m], until it has driven again
  std::optional<double> battery_;
  /// A decision about a large map takes seconds; what is longer was no time that passed.
  static constexpr Duration kLongestTick = std::chrono::seconds(30);
  std::optional<Time> last_update_;
  std::optional<Time> last_report_;
  std::optional<Time> nothing_left_since_;
  Time state_since_;
  Time last_check_;
  Time last_decision_;
  std::uint32_t next_goal_id_ = 1;
  std::uint64_t judged_changes_ = 0;  ///< changes() of the map at the last decision
  bool was_running_ = false;
  bool bounds_changed_ = false;  ///< since the last tick
  bool map_replaced_ = false;    ///< since the last tick
  int step_backs_ = 0;
  const FallBack* judged_by_ = nullptr;        ///< fall-back of the last decision; null if none was needed
  std::optional<ExplorerReason> ended_by_;     ///< the stopping rule, until started again
  std::optional<ExplorerReason> done_reason_;  ///< kept while the robot returns to the start
  bool odometry_is_stale_ = false, pose_is_stale_ = false;
  std::optional<Time> return_waits_since_;  ///< since when it has got nowhere on the way
};

}  // namespace frontier_pilot::exploration
