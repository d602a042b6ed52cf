#include <algorithm>
#include <cmath>
#include <sstream>

#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/core/robot_model.h"

namespace frontier_pilot {
namespace {

constexpr std::size_t kPeriods = 9;  // of which the median is taken
constexpr std::size_t kEnough = 3;   // periods that have to be known
constexpr double kLongest = 1.0;     // [s], that all beams may take before the period is known
constexpr double kTolerance = 1.1;   // of the period: its stamps jitter
constexpr double kAtOnce = 0.05;     // of the period: less is a wrong unit, or no time at all
constexpr double kJump = 0.5;        // [m] and [rad], between two messages of odometry
const Duration kCovered = fromSeconds(0.1);

double sweepOf(const LaserScan2& scan) { return scan.time_increment * static_cast<double>(scan.ranges.size()); }

/// The time increment of a scanner that turns at an even rate, once per scan [s].
double spinning(const LaserScan2& scan, double period) { return period * std::abs(scan.angle_increment) / (2.0 * kPi); }

}  // namespace

bool placeBeams(const PoseTrack& T_odom_base, ScanReference reference, LaserScan2& scan) {
  if (!(scan.time_increment > 0.0) || scan.isMoving() || scan.ranges.empty()) return true;
  const Time first = scan.stamp;
  const Time end = scan.end();
  scan.stamp = reference == ScanReference::kEnd ? end : first + (end - first) / 2;
  const std::optional<Pose2> T_odom_reference = T_odom_base.nearest(scan.stamp);
  if (!T_odom_reference) return false;
  const Pose2 T_reference_odom = T_odom_reference->inverse();
  bool covered = true;
  scan.moving_mounts.reserve(scan.ranges.size());
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    const Time time = first + fromSeconds(scan.time_increment * static_cast<double>(beam));
    scan.moving_mounts.push_back(T_reference_odom * *T_odom_base.nearest(time) * scan.T_base_sensor);
    covered = covered && T_odom_base.away(time, 2 * kCovered) <= kCovered;
  }
  return covered;
}

void ScanPlacer::addOdometry(Time stamp, const Pose2& T_odom_base) {
  if (!track_.empty() && isJump(track_.poses().back().pose, T_odom_base, kJump, kJump)) track_.clear();
  track_.add(stamp, T_odom_base);
}

LaserScan2 ScanPlacer::place(LaserScan2 scan, ScanReference reference) {
  timing_.apply(scan);
  if (!placeBeams(track_, reference, scan)) ++uncovered_;
  return scan;
}

BeamTiming::BeamTiming(const ScannerModel& scanner) : fixed_(scanner.time_increment), rolling_(scanner.rolling) {}

void BeamTiming::apply(LaserScan2& scan) {
  notePeriod(scan.stamp);
  if (fixed_ >= 0.0) {
    scan.time_increment = fixed_;
    return;
  }
  const std::optional<double> known = period();
  problem_ = known ? problemOf(scan, *known, rolling_) : std::string();
  const bool is_time = std::isfinite(scan.time_increment) && scan.time_increment >= 0.0;
  const double most = known ? kTolerance * *known : kLongest;
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

std::string BeamTiming::problemOf(const LaserScan2& scan, double period, bool rolling) {
  std::ostringstream text;
  text.precision(3);
  text << "scans come every " << period << " s, but with the driver's time_increment of " << scan.time_increment
       << " s their " << scan.ranges.size() << " beams ";
  if (!std::isfinite(scan.time_increment) || scan.time_increment < 0.0) {
    text << "have no time";
  } else if (sweepOf(scan) > kTolerance * period) {
    text << "take " << sweepOf(scan) << " s";
  } else if (rolling && sweepOf(scan) < kAtOnce * period) {
    text << "are measured at once";
  } else {
    return {};
  }
  text << ": set robot/scanner/time_increment, to " << spinning(scan, period)
       << " if the scanner turns once per scan, or to 0 if all beams are measured at once";
  return text.str();
}

}  // namespace frontier_pilot
