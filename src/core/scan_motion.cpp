#include <algorithm>
#include <cmath>
#include <sstream>

#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/core/robot_model.h"

namespace frontier_pilot {
namespace {

constexpr std::size_t kPeriods = 9;  // of which the median is taken
constexpr std::size_t kEnough = 3;   // periods that have to be known
constexpr double kLongest = 1.0;     // [s], that all beams may take, whatever the stamps say [FLT-1]
constexpr double kTolerance = 1.1;   // of the period: its stamps jitter
constexpr double kLeast = 0.5;       // of the time in which a scanner turns by its field of view
constexpr double kJump = 0.5;        // [m] and [rad], between two messages of odometry
const Duration kCovered = fromSeconds(0.1);

double sweepOf(const LaserScan2& scan) { return scan.time_increment * static_cast<double>(scan.ranges.size()); }

/// The time increment of a scanner that turns at an even rate, once per scan [s].
double spinning(const LaserScan2& scan, double period) { return period * std::abs(scan.angle_increment) / (2.0 * kPi); }

/// The time that all beams may take [s]; `period`: from scan to scan, if it is known [s].
double mostOf(std::optional<double> period) { return period ? std::min(kTolerance * *period, kLongest) : kLongest; }

/// The time that the beams of a scanner that turns take at least [s].
double leastOf(const LaserScan2& scan, double period) {
  return kLeast * std::min(spinning(scan, period) * static_cast<double>(scan.ranges.size()), period);
}

/// The time to which a scan from `first` to `end` is referred that is used for driving: the pose of the base at that
/// time must be the one from which its beams are placed, so that it cannot be later than odometry.
Time lastCovered(const PoseTrack& T_odom_base, Time first, Time end) {
  if (T_odom_base.empty()) return end;
  return std::max(first, std::min(end, T_odom_base.poses().back().stamp));
}

}  // namespace

bool placeBeams(const PoseTrack& T_odom_base, ScanReference reference, LaserScan2& scan) {
  if (!(scan.time_increment > 0.0) || scan.isMoving() || scan.ranges.empty()) return true;
  const Time first = scan.stamp;
  const Time end = scan.end();
  scan.stamp = reference == ScanReference::kEnd ? lastCovered(T_odom_base, first, end) : first + (end - first) / 2;
  const std::optional<Pose2> T_odom_reference = T_odom_base.nearest(scan.stamp);
  if (!T_odom_reference) return false;
  const Pose2 T_reference_odom = T_odom_reference->inverse();
  bool covered = true;
  scan.moving_mounts.reserve(scan.ranges.size());
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    const std::size_t before = scan.reversed ? scan.ranges.size() - 1 - beam : beam;
    const Time time = first + fromSeconds(scan.time_increment * static_cast<double>(before));
    scan.moving_mounts.push_back(T_reference_odom * *T_odom_base.nearest(time) * scan.T_base_sensor);
    covered = covered && T_odom_base.away(time, 2 * kCovered) <= kCovered;
  }
  return covered;
}

void ScanPlacer::addOdometry(Time stamp, const Pose2& T_odom_base) {
  if (!track_.empty() && isJump(track_.poses().back().pose, T_odom_base, kJump, kJump)) track_.clear();
  track_.add(stamp, T_odom_base);
}

bool ScanPlacer::place(ScanReference reference, LaserScan2& scan) {
  timing_.apply(scan);
  return placeBeams(track_, reference, scan);
}

BeamTiming::BeamTiming(const ScannerModel& scanner)
    : fixed_(scanner.time_increment), rolling_(scanner.rolling), reversed_(scanner.reversed) {}

void BeamTiming::apply(LaserScan2& scan) {
  notePeriod(scan.stamp);
  scan.reversed = reversed_;
  const std::optional<double> known = fixed_ >= 0.0 ? std::nullopt : period();
  if (fixed_ >= 0.0) {
    scan.time_increment = fixed_;
    problem_ = problemOfFixed(scan);
  } else {
    problem_ = known ? problemOf(scan, *known, rolling_) : std::string();
  }
  const bool is_time = std::isfinite(scan.time_increment) && scan.time_increment >= 0.0;
  const double most = mostOf(known);
  if (!is_time || sweepOf(scan) > most) scan.time_increment = 0.0;
}

void BeamTiming::notePeriod(Time stamp) {
  if (last_ && stamp > *last_) periods_.push_back(toSeconds(stamp - *last_));
  if (last_ && stamp < *last_) periods_.clear();
  if (periods_.size() > kPeriods) periods_.pop_front();
  last_ = stamp;
}

std::optional<double> BeamTiming::period() const {
  if (periods_.size() < kEnough) return std::nullopt;
  std::deque<double> sorted = periods_;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return *middle;
}

std::string BeamTiming::problemOfFixed(const LaserScan2& scan) {
  if (sweepOf(scan) <= kLongest) return {};
  std::ostringstream text;
  text.precision(3);
  text << "robot/scanner/time_increment of " << scan.time_increment << " s is not used: " << scan.ranges.size()
       << " beams would take " << sweepOf(scan) << " s, and " << kLongest << " s is the most";
  return text.str();
}

std::string BeamTiming::problemOf(const LaserScan2& scan, double period, bool rolling) {
  std::ostringstream text;
  text.precision(3);
  text << "scans come every " << period << " s, but with the driver's time_increment of " << scan.time_increment
       << " s their " << scan.ranges.size() << " beams ";
  if (!std::isfinite(scan.time_increment) || scan.time_increment < 0.0) {
    text << "have no time";
  } else if (sweepOf(scan) > mostOf(period)) {
    text << "take " << sweepOf(scan) << " s";
  } else if (rolling && sweepOf(scan) < leastOf(scan, period)) {
    text << "take only " << sweepOf(scan) << " s, although by the robot's file the scanner turns (rolling: true)";
  } else {
    return {};
  }
  text << ": set robot/scanner/time_increment, to " << spinning(scan, period)
       << " if the scanner turns once per scan, or to 0 if all beams are measured at once";
  return text.str();
}

}  // namespace frontier_pilot
