#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>

namespace frontier_pilot {

/// When `process`, of this computer, was started, in clock ticks since boot; 0 if it no longer exists.
std::uint64_t beginOf(int process);

/// The id of this computer's present run.
std::string bootId();

/// A process and the one that started it, told from all others that had their numbers before or have them since. A node
/// that roslaunch restarts was started by the same process as the one before it, also if a launch-prefix lies between.
struct ProcessIdentity {
  int process = 0;
  int starter = 0;                  ///< roslaunch, or the parent
  std::uint64_t began = 0;          ///< start time of the process, because process ids are reused
  std::uint64_t starter_began = 0;  ///< that of its starter; 0 if that is outside of this container
  std::string boot;                 ///< both count from the start of the computer
  std::string master;               ///< the URI of its ROS master

  /// Of this process.
  static ProcessIdentity own();
  /// Whether the process exists.
  bool lives() const;
  /// Whether the process no longer exists and this one was started in its place: by the process that had started it,
  /// and for a master at the same address.
  bool isReplacedByThisOne() const;
  /// Whether this process may continue what that one did, whether or not that one still lives: the computer has not
  /// been restarted since, and this process was started by the same roslaunch, or by hand, by someone who knows what
  /// was said before.
  bool isOfThisLaunch() const;
  /// Whether both were started by the same process.
  bool isOfStarterOf(const ProcessIdentity& other) const;
};

/// Writes and reads one line. What cannot be read is left as it is.
std::ostream& operator<<(std::ostream& stream, const ProcessIdentity& identity);
std::istream& operator>>(std::istream& stream, ProcessIdentity& identity);

}  // namespace frontier_pilot
