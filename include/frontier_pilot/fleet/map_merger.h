#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/core/time.h"
#include "frontier_pilot/fleet/merged_map.h"
#include "frontier_pilot/fleet/parameters.h"

namespace frontier_pilot::fleet {

/// How well two maps agree where both know something, under an assumed transform between their frames. Sums over
/// several maps are meaningful.
struct Agreement {
  double overlap = 0.0;          ///< area that both know [m^2]
  std::size_t known = 0;         ///< cells that both know
  std::size_t agreeing = 0;      ///< of these, cells that are free in both or occupied in both
  std::size_t walls = 0;         ///< occupied cells of either map that the other one knows
  std::size_t contradicted = 0;  ///< of these, cells where the other map knows free space for MergedMap::kClearance

  /// Share of the cells that both know that agree; 1 without any.
  double agreeingShare() const;
  /// Share of the walls that the other map contradicts; 0 while there are so few that they say nothing: where robots
  /// saw each other, each leaves some tens of cells that the other contradicts.
  double contradictedShare() const;
  Agreement& operator+=(const Agreement& other);
};

/// Compares each cell of `b` with the cell of `a` in which its centre lies, and the other way round for walls. A wrong
/// transform puts walls of one map into the free space of the other. [MUL-1]
Agreement compare(const OccupancyGrid& a, const OccupancyGrid& b, const Pose2& T_a_b);

/// A transform under which two maps agree.
struct PlaceMatch {
  Pose2 T_a_b;
  Agreement agreement;
  std::size_t supported = 0;  ///< points of `b`'s walls that lie on walls of `a`
};

/// What a search for a robot's place has found.
struct PlaceFinding {
  std::size_t reference = 0;  ///< the robot whose map is `a` of the matches
  std::size_t robot = 0;      ///< the one whose map is `b`
  bool refined = false;       ///< it was not looked for, but its present place was corrected
  bool reversed = false;      ///< windows of `a` were searched for in `b`
  std::vector<PlaceMatch> matches;
  std::optional<Cell> last_window;  ///< that was searched for, by its cell: the next search begins behind it
};
/// Such a search; to be called once. It holds copies of the maps, and may run on any thread.
using PlaceWork = std::function<PlaceFinding()>;

/// Whether a robot's map is part of the common one.
enum class MergeState {
  kNoMap,             ///< none has come yet
  kPlaceUnknown,      ///< it is not known yet where the robot started; it is looked for
  kTooLargeToSearch,  ///< that is not known, and not looked for: a search would need too much memory
  kMerged,
  kContradicted,     ///< its walls lie in the free space of others: its place is wrong, or its map
  kOtherResolution,  ///< see SourceResult
  kTooLarge,         ///< see SourceResult
};
const char* toString(MergeState state);

/// What is known of a robot's map.
struct MergeStatus {
  MergeState state = MergeState::kNoMap;
  Time since{};         ///< when the state began
  Agreement agreement;  ///< with the merged maps of the robots before it in the list, at the last check
  int windows = 0;  ///< parts of its map and of another that lead to the place at which it is looked for, or was found
};

/// Several robots' maps as one: the common map, in the frame of the first robot, and a view for each robot in its own
/// frame. A view is the robot's own map, exactly, and where that is unknown what the others know. So a robot whose
/// place is not known works on with its own map, and its plans never depend on the transforms between the robots,
/// which may change. [MUL-1]
///
/// A merge is held against what both have seen as long as it lasts: once a second one robot is compared with the
/// merged ones before it in the list, and left out while they contradict each other. [MUL-1]
class MapMerger {
 public:
  explicit MapMerger(const MapMergerParameters& parameters);

  std::size_t size() const { return robots_.size(); }
  /// The cells `changed` of the map of robot `robot` are new, or all of them if its geometry is.
  void setMap(std::size_t robot, const OccupancyGrid& map, const CellRect& changed, Time now);
  /// Where robot `robot` started, in the frame of the first one; or that this is not known any more. The first robot's
  /// place is fixed.
  void setPlace(std::size_t robot, const std::optional<Pose2>& T_map_robot, Time now);
  /// A search for the place of a robot that is not known, or for a better estimate of one that was found, if it is time
  /// for one and two maps overlap that may. Without `known_starts` only. Its result goes to `accept`; only then another
  /// one is begun. Once `stop` is true, which is asked again and again and then has to stay true, a search ends without
  /// a result. Maps for which it would need too much memory are not searched. [FLT-1]
  std::optional<PlaceWork> takeWork(Time now, const std::function<bool()>& stop = {});
  /// A place counts as found when several windows of either map lead to it, and no other one does.
  void accept(const PlaceFinding& finding, Time now);
  /// Checks a merge, if it is time to. To be called regularly.
  void update(Time now);

  MergedMap& common() { return common_; }
  MergedMap& view(std::size_t robot) { return robots_[robot].view; }
  /// The place of the robot's map in the common one; nothing unless it is merged.
  std::optional<Pose2> place(std::size_t robot) const;
  const MergeStatus& status(std::size_t robot) const { return robots_[robot].status; }

 private:
  /// The search for a robot's place in the map of one other: windows of its map are searched for in that one, and by
  /// turns windows of that one in its map.
  struct Look {
    bool reversed = false;
    std::array<std::optional<Cell>, 2> last_window;  ///< that was searched for, of its map and of the other one
    std::array<int, 2> windows{};                    ///< of either that lead to the candidate

    int allWindows() const { return windows[0] + windows[1]; }
  };
  struct Robot {
    MapSnapshot snapshot;
    std::optional<Pose2> T_map_robot;
    bool contradicted = false;
    MergedMap view{FirstSource::kPrevails};
    MergeStatus status;
    MergeState unplaced = MergeState::kPlaceUnknown;  ///< its state while the place is not known
    std::set<std::size_t> not_searched;               ///< robots in whose maps it cannot be looked for
    std::map<std::size_t, Look> looks;                ///< by the robot in whose map it is looked for
    std::optional<PlaceMatch> candidate;              ///< its transform is T_map_robot

    const OccupancyGrid& map() const { return snapshot.map(); }
    bool hasMap() const { return status.state != MergeState::kNoMap; }
    /// No window leads to a place any more.
    void forgetWindows();
  };

  bool isMerged(std::size_t robot) const { return robots_[robot].status.state == MergeState::kMerged; }
  /// Takes the map of `robot` into the common map and into the views of the merged robots, or out of them.
  void share(std::size_t robot, const std::vector<CellRect>& changed, Time now);
  void withdraw(std::size_t robot);
  /// The place of `robot` was found, and does not hold any more: it is looked for anew.
  void forgetPlace(std::size_t robot, Time now);
  /// Forgets what was found by the map that `robot` had, if `map` is another one.
  void noticeAnotherMap(std::size_t robot, const OccupancyGrid& map, const CellRect& changed, Time now);
  /// The map of `other` in the view of `robot`; both are merged.
  void show(std::size_t other, std::size_t robot, const std::vector<CellRect>& changed);
  void enter(std::size_t robot, MergeState state, Time now);
  void judge(std::size_t robot, Time now);
  bool mayBeSearched(const PlaceFinding& finding, Time now);
  static void weigh(Robot& robot, const PlaceFinding& finding, const Pose2& T_map_reference);

  MapMergerParameters parameters_;
  std::deque<Robot> robots_;
  MergedMap common_{FirstSource::kIsEqual};
  std::optional<Time> last_check_;
  std::size_t next_check_ = 0;
  bool searching_ = false;
  std::optional<Time> last_search_;
  std::size_t next_search_ = 0;
};

}  // namespace frontier_pilot::fleet
