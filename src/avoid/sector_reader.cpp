#include "avoid/sector_reader.h"

#include <algorithm>
#include <cmath>

namespace frontier_pilot::avoid {
namespace {

/// A beam on the border of two sectors belongs to both, even after rounding to single precision.
constexpr double kBorderTolerance = 1e-4;  // [rad]

/// A wider hole between two beams may hide something. Coarse scanners have a beam each 4 degrees, and lose one at
/// times.
constexpr double kWidestHole = 10.0 * kPi / 180.0;  // [rad]

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

bool sameLayout(const LaserScan2& a, const LaserScan2& b) {
  return a.angle_min == b.angle_min && a.angle_increment == b.angle_increment && a.T_base_sensor == b.T_base_sensor;
}

const char* malformation(const LaserScan2& scan) {
  if (scan.ranges.empty()) return "empty scan";
  if (!std::isfinite(scan.angle_min) || !std::isfinite(scan.angle_increment) || scan.angle_increment == 0.0) {
    return "malformed scan: angles";
  }
  if (!(scan.range_min >= 0.0) || !(scan.range_max > scan.range_min)) return "malformed scan: range limits";
  if (!scan.T_base_sensor.isFinite()) return "malformed scan: mount";
  return nullptr;
}

std::size_t countInvalid(const LaserScan2& scan) {
  std::size_t invalid = 0;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    if (readBeam(scan, i).kind == RangeKind::kInvalid) ++invalid;
  }
  return invalid;
}

}  // namespace

SectorReader::SectorReader(const AvoiderParameters& parameters)
    : outline_(parameters.robot.drivenOutline()),
      half_lane_(AvoiderDistances(parameters).half_lane),
      most_too_near_(AvoiderDistances(parameters).stop / 2.0),
      max_invalid_share_(parameters.max_invalid_share),
      front_left_(bordersOf(parameters.front_left)),
      front_right_(bordersOf(parameters.front_right)),
      rear_(bordersOf(parameters.rear)) {}

SectorReader::Borders SectorReader::bordersOf(const Sector& sector) {
  return {direction(sector.from - kBorderTolerance), direction(sector.to + kBorderTolerance)};
}

bool SectorReader::Borders::contains(const Vec2& point) const {
  return cross(from, point) >= 0.0 && cross(point, to) >= 0.0;
}

const std::vector<Vec2>& SectorReader::directionsOf(const LaserScan2& scan) {
  if (directions_.size() == scan.ranges.size() && sameLayout(scan, layout_)) return directions_;
  layout_.angle_min = scan.angle_min;
  layout_.angle_increment = scan.angle_increment;
  layout_.T_base_sensor = scan.T_base_sensor;
  directions_.clear();
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    directions_.push_back(direction(scan.T_base_sensor.yaw + scan.angle(i)));
  }
  return directions_;
}

SectorDistances SectorReader::read(const LaserScan2& scan) {
  SectorDistances around;
  around.fault = judge(scan);
  if (!around.fault.empty()) return around;
  const std::vector<Vec2>& directions = directionsOf(scan);
  around.sees_rear = seesLaneBehind(scan);
  const Vec2 sensor = scan.T_base_sensor.position();
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const RangeReading reading = readBeam(scan, i);
    if (reading.kind != RangeKind::kHit && reading.kind != RangeKind::kTooNear) continue;
    // What is too near for a scanner with a large range_min may be anywhere before that, also within the stop distance.
    const bool too_near = reading.kind == RangeKind::kTooNear;
    const double distance = too_near ? std::min(reading.distance, most_too_near_) : reading.distance;
    add(scan.isMoving() ? scan.point(i, distance) : Vec2(sensor + distance * directions[i]), around);
  }
  return around;
}

bool SectorReader::seesLaneBehind(const LaserScan2& scan) {
  const std::vector<Vec2>& directions = directionsOf(scan);
  const auto toTail = [&](double y) { return bearing(Vec2(-outline_.rear(), y) - scan.T_base_sensor.position()); };
  const Sector lane{toTail(half_lane_), toTail(-half_lane_)};
  // Where valid beams look, from half a hole before the lane to half a hole beyond it: its edges may lie within one.
  const double end = lane.width() + kWidestHole;
  std::vector<double> looks{0.0, end};
  for (std::size_t i = 0; i < directions.size(); ++i) {
    if (readBeam(scan, i).kind == RangeKind::kInvalid) continue;
    const double look = Sector{lane.from - kWidestHole / 2.0, bearing(directions[i])}.width();
    if (look < end) looks.push_back(look);
  }
  std::sort(looks.begin(), looks.end());
  const auto isHole = [](double one, double next) { return next - one > kWidestHole + kBorderTolerance; };
  return std::adjacent_find(looks.begin(), looks.end(), isHole) == looks.end();
}

void SectorReader::add(const Vec2& point, SectorDistances& around) const {
  const double distance = point.norm();
  around.nearest = std::min(around.nearest, distance);
  const bool left = front_left_.contains(point);
  const bool right = front_right_.contains(point);
  const bool in_lane = std::abs(point.y()) < half_lane_;
  if (left) around.front_left = std::min(around.front_left, distance);
  if (right) around.front_right = std::min(around.front_right, distance);
  if (rear_.contains(point)) around.rear = std::min(around.rear, distance);
  if (!in_lane || point.x() == 0.0) return;
  // The corners of a body that is no disc are as far ahead or behind as its middle is.
  const double along = outline_.isDisc() ? distance : std::abs(point.x());
  double& lane_ahead = point.y() > 0.0 ? around.lane_left : around.lane_right;
  double& lane = point.x() < 0.0 ? around.rear : lane_ahead;
  lane = std::min(lane, along);
}

std::string SectorReader::judge(const LaserScan2& scan) {
  if (const char* problem = malformation(scan)) return problem;
  const std::size_t beams = scan.ranges.size();
  const std::size_t invalid = countInvalid(scan);
  if (static_cast<double>(invalid) > max_invalid_share_ * static_cast<double>(beams)) {
    return std::to_string(invalid) + " of " + std::to_string(beams) + " beams are invalid";
  }
  const std::vector<Vec2>& directions = directionsOf(scan);
  bool sees_left = false, sees_right = false;
  for (std::size_t i = 0; i < beams && !(sees_left && sees_right); ++i) {
    if (readBeam(scan, i).kind == RangeKind::kInvalid) continue;
    sees_left = sees_left || front_left_.contains(directions[i]);
    sees_right = sees_right || front_right_.contains(directions[i]);
  }
  if (!sees_left) return "no valid beam looks ahead on the left";
  if (!sees_right) return "no valid beam looks ahead on the right";
  return {};
}

}  // namespace frontier_pilot::avoid
