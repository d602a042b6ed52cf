#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "frontier_pilot/core/geometry.h"

namespace frontier_pilot::exploration {

/// A pose that somebody wants the robot to take during the exploration.
struct Inspection {
  std::uint32_t id = 0;
  Pose2 pose;  ///< in the map's frame
  int failures = 0;
};

/// The poses that are to be inspected, and how many have been. [EXP-10]
class InspectionList {
 public:
  static constexpr std::size_t kMost = 100;  ///< that wait at a time

  /// Empty if the pose has been added; otherwise why not. A pose that waits already is not added twice.
  std::string add(const Pose2& pose);
  void clear() { waiting_.clear(); }
  void done(std::uint32_t id);
  /// The navigation failed to get there. Returns whether the pose is given up: it may fail once.
  bool failed(std::uint32_t id);
  /// Gives up all that wait.
  void giveUp();

  const std::vector<Inspection>& waiting() const { return waiting_; }
  std::uint32_t doneCount() const { return done_; }
  std::uint32_t givenUpCount() const { return given_up_; }

 private:
  bool remove(std::uint32_t id);

  std::vector<Inspection> waiting_;  ///< in the order in which they were added
  std::uint32_t next_id_ = 1;
  std::uint32_t done_ = 0;
  std::uint32_t given_up_ = 0;
};

}  // namespace frontier_pilot::exploration
