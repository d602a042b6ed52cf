#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/motion.h"
#include "frontier_pilot/core/time.h"

namespace frontier_pilot {

struct ScannerModel;

/// A planar scan. Beam i points at `angle_min + i * angle_increment` in the sensor's frame, whose pose is
/// `T_base_sensor`. Angles are counter-clockwise as in the base frame: for a scanner mounted upside down the conversion
/// has negated `angle_min` and `angle_increment`.
/// The beams of a rolling scan were measured one after the other while the robot moved: beam i of n at
/// `stamp + i * time_increment`, or at `stamp + (n - 1 - i) * time_increment` if it is `reversed`, until `placeBeams`
/// has put each of them where the robot was at that time. From then on `stamp` is the time whose base all beams refer
/// to. [SCN-1]
struct LaserScan2 {
  Time stamp;                    ///< when the beams were measured, see above
  double time_increment = 0.0;   ///< [s], from one beam to the next; 0: all at once
  bool reversed = false;         ///< whether the last beam was measured first
  double angle_min = 0.0;        ///< [rad], in the sensor's frame
  double angle_increment = 0.0;  ///< [rad], never zero; negative when the scanner turns clockwise
  double range_min = 0.0;        ///< [m]
  double range_max = 0.0;        ///< [m]
  Pose2 T_base_sensor;           ///< where the scanner sits on the base
  std::vector<float> ranges;     ///< [m], raw: may hold NaN, 0 and infinities, see `readRange`
  /// Where the scanner was at the time of each beam, in the frame of the base at `stamp`; empty: at `T_base_sensor`.
  std::vector<Pose2> moving_mounts;

  double angle(std::size_t beam) const { return angle_min + static_cast<double>(beam) * angle_increment; }
  /// Whether the robot may have moved from beam to beam.
  bool isMoving() const { return !moving_mounts.empty(); }
  /// Where the scanner was at the time of `beam`, in the frame of the base at `stamp`.
  const Pose2& mount(std::size_t beam) const { return isMoving() ? moving_mounts[beam] : T_base_sensor; }
  /// The point at `distance` [m] along `beam`, in the frame of the base at `stamp`.
  Vec2 point(std::size_t beam, double distance) const { return mount(beam) * Vec2(distance * direction(angle(beam))); }
  /// When the last measurement was made of a scan whose beams have not been placed.
  Time end() const;
};

// A scoped enumerator shadows nothing, but GCC 12 warns about `kFree`, which grid.h also declares.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
/// What a raw range means.
enum class RangeKind {
  kInvalid,  ///< NaN, 0, or negative and finite: no information
  kHit,      ///< a surface at `distance`
  kTooNear,  ///< -inf or below `range_min`: an obstacle, taken to be at `range_min`
  kFree,     ///< +inf, `range_max` or beyond it: nothing up to `range_max`
};
#pragma GCC diagnostic pop

/// An interpreted range: `distance` [m] is where the surface is (kHit, kTooNear) or how far the beam is free (kFree); 0
/// if invalid.
struct RangeReading {
  RangeKind kind = RangeKind::kInvalid;
  double distance = 0.0;
};

/// Interprets a raw range by the conventions of sensor_msgs/LaserScan and REP 117. `range_max` itself is no return,
/// because some drivers clamp ranges to it. [AVO-2]
RangeReading readRange(float range, double range_min, double range_max);

/// `scan` with only every n-th beam, n being the smallest number that leaves at most `most` > 0 of them; unchanged if
/// it has no more than that.
LaserScan2 withAtMost(std::size_t most, LaserScan2 scan);

/// Whether the scan shows enough of what lies ahead to drive by it: some beams are within 30 degrees of straight ahead,
/// more than a tenth of those are numbers, and `range_max` is at least 0.5 m. 0 counts as a number, because many
/// drivers report it where there was no return.
bool looksAhead(const LaserScan2& scan);

/// The reading of beam `beam`.
inline RangeReading readBeam(const LaserScan2& scan, std::size_t beam) {
  return readRange(scan.ranges[beam], scan.range_min, scan.range_max);
}

/// Determines the time between two beams: the one set for the robot, otherwise the driver's, if that is credible. The
/// time between the stamps of scans tells: all beams together cannot take longer than that, nor, if the scanner turns,
/// much less than the time in which it turns by its field of view; of the latter it only warns, because scans may be
/// missing. [SCN-2] As stamps may be anything, all beams together never take longer than 1 s. [FLT-1]
class BeamTiming {
 public:
  /// By `time_increment`, `rolling` and `reversed` of the scanner.
  explicit BeamTiming(const ScannerModel& scanner);

  /// Sets the time increment of `scan`, which holds the driver's, and the order of its beams; scans must be given in
  /// the order of their stamps. An increment that is too long is replaced by 0: all at once.
  void apply(LaserScan2& scan);
  /// What is wrong with the driver's time increment of `scan`, of which one comes every `period` [s], and what to set;
  /// empty if nothing is. `rolling`: whether the robot's file says that the beams are measured one after the other.
  static std::string problemOf(const LaserScan2& scan, double period, bool rolling);
  /// That of the last scan; of a time increment that the robot's file gives, only that it is too long.
  const std::string& problem() const { return problem_; }
  /// The time between two scans, by the median of the last ones [s]; nothing as long as too few are known.
  std::optional<double> period() const;

 private:
  void notePeriod(Time stamp);
  static std::string problemOfFixed(const LaserScan2& scan);

  double fixed_;  ///< [s]; negative: the driver's
  bool rolling_, reversed_;
  std::optional<Time> last_;
  std::deque<double> periods_;  ///< between the last scans [s]
  std::string problem_;
};

// A scoped enumerator shadows nothing, see above.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
/// The time that a rolling scan is referred to.
enum class ScanReference {
  kMiddle,  ///< for matching: the errors of odometry within the scan then cancel out in the mean of its beams
  kEnd,     ///< for driving: as near to the present as odometry reaches
};
#pragma GCC diagnostic pop

/// Puts each beam of a rolling scan where the robot was at its time, by odometry, and refers the scan to the time of
/// its middle or its end; instead of the end to the last pose of odometry, if that is older. Where odometry does not
/// cover a beam it takes the nearest pose; without any pose the beams are taken to be measured at once, at that time. A
/// scan measured at once stays as it is. Returns whether odometry covers every beam, within 0.1 s. This is the only
/// place that corrects for motion. [SCN-1]
bool placeBeams(const PoseTrack& T_odom_base, ScanReference reference, LaserScan2& scan);

/// `placeBeams` with the odometry and the timing that it needs, for those who use a scan as soon as it arrives.
class ScanPlacer {
 public:
  explicit ScanPlacer(const ScannerModel& scanner) : timing_(scanner) {}

  /// Odometry that jumps farther than a robot drives between two messages restarts its track.
  void addOdometry(Time stamp, const Pose2& T_odom_base);
  /// Corrects a scan as its driver gave it; see `placeBeams`.
  bool place(ScanReference reference, LaserScan2& scan);
  /// Forgets odometry, after a jump of the clock.
  void clear() { track_.clear(); }

  const PoseTrack& track() const { return track_; }
  const BeamTiming& timing() const { return timing_; }

 private:
  PoseTrack track_;  ///< T_odom_base
  BeamTiming timing_;
};

}  // namespace frontier_pilot
