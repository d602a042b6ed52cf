#include "ros/common/messages/message_problems.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "frontier_pilot/core/bounds.h"

namespace frontier_pilot {
namespace {

/// The parts joined to one text.
template <class... Parts>
std::string text(const Parts&... parts) {
  std::ostringstream out;
  (out << ... << parts);
  return out.str();
}

std::string problemOfAngles(const sensor_msgs::LaserScan& msg) {
  if (!std::isfinite(msg.angle_min) || !std::isfinite(msg.angle_max)) return "angles not finite";
  if (!std::isfinite(msg.angle_increment) || msg.angle_increment == 0.0F) return "angle increment zero or not finite";
  const auto increment = static_cast<double>(msg.angle_increment);
  if (std::abs(increment) < bounds::kLeastAngleIncrement) return "angle increment too small";
  for (const float angle : {msg.angle_min, msg.angle_max}) {
    if (!bounds::isWithin(static_cast<double>(angle), bounds::kMostAngle)) return "angles beyond two turns";
  }
  const double steps = (static_cast<double>(msg.angle_max) - msg.angle_min) / msg.angle_increment;
  // Drivers disagree on whether angle_max is the last beam or one past it, and errors of single precision accumulate.
  const double expected = static_cast<double>(msg.ranges.size()) - 1.0;
  if (steps < expected - 1.5 || steps > expected + 1.5) return "number of ranges does not match the angles";
  return {};
}

}  // namespace

bool isFinite(const geometry_msgs::Vector3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

std::string problemOfPlace(double x, double y, double z) {
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) return "position not finite";
  const double farthest = std::max({std::abs(x), std::abs(y), std::abs(z)});
  if (bounds::isWithin(farthest, bounds::kMostCoordinate)) return {};
  return text("position farther than ", bounds::kMostCoordinate / 1000.0, " km from the origin");
}

std::string problemOf(const Twist2& measured) {
  const bool near =
      bounds::isWithin(measured.linear, bounds::kMostSpeed) && bounds::isWithin(measured.angular, bounds::kMostSpeed);
  return near ? "" : text("faster than ", bounds::kMostSpeed, " m/s or rad/s");
}

std::string problemOfMount(const Eigen::Isometry3d& T_base_sensor) {
  if (!T_base_sensor.matrix().allFinite()) return "mount not finite";
  if (bounds::isWithin(T_base_sensor.translation().norm(), bounds::kMostMount)) return {};
  return text("scanner mounted farther than ", bounds::kMostMount, " m from the base");
}

std::string problemOf(const sensor_msgs::LaserScan& msg) {
  if (msg.ranges.empty()) return "no ranges";
  if (msg.ranges.size() > bounds::kMostRanges) return text("more than ", bounds::kMostRanges, " ranges");
  if (!std::isfinite(msg.range_min) || !std::isfinite(msg.range_max)) return "range limits not finite";
  if (msg.range_min < 0.0F || msg.range_max <= msg.range_min) return "range limits not in order";
  if (static_cast<double>(msg.range_max) > bounds::kMostRange)
    return text("range limit beyond ", bounds::kMostRange, " m");
  if (static_cast<double>(msg.range_min) >= bounds::kUsedRange) return text("blind within ", bounds::kUsedRange, " m");
  return problemOfAngles(msg);
}

std::string problemOf(const nav_msgs::MapMetaData& info) {
  if (info.width > static_cast<std::uint32_t>(bounds::kMostSide) ||
      info.height > static_cast<std::uint32_t>(bounds::kMostSide)) {
    return text("map of more than ", bounds::kMostSide, " cells along a side");
  }
  if (static_cast<std::size_t>(info.width) * info.height > bounds::kMostMapCells) {
    return text("map of more than ", bounds::kMostMapCells,
                " cells: make its cells larger, or leave out what nobody drives in");
  }
  // Compared in single precision, in which the lower bound cannot be represented exactly.
  const bool usable = info.resolution >= static_cast<float>(bounds::kLeastResolution) &&
                      info.resolution <= static_cast<float>(bounds::kMostResolution);
  if (usable) return {};
  return text("resolution not within ", bounds::kLeastResolution, " m ... ", bounds::kMostResolution, " m");
}

}  // namespace frontier_pilot
