#include "sim/lidar.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frontier_pilot::sim {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kFullTurn = 2.0 * kPi - 1e-6;

// The sector that a direction lies in, counter-clockwise from -y. The sectors are equal parts of the diamond
// |x| + |y| = 1, so that no arc tangent is needed.
std::size_t sectorOf(const Vec2& v, std::size_t sectors) {
  const double along_y = v.y() / (std::abs(v.x()) + std::abs(v.y()));
  const double quadrants = v.x() >= 0.0 ? 1.0 + along_y : 3.0 - along_y;  // [0, 4]
  return static_cast<std::size_t>(quadrants * 0.25 * static_cast<double>(sectors)) % sectors;
}

double incrementOf(const ScannerModel& scanner) {
  const bool full_turn = scanner.field_of_view > kFullTurn;
  return scanner.field_of_view / std::max(1, full_turn ? scanner.beams : scanner.beams - 1);
}

/// The disc as a scanner at `from` sees it.
Disc seenFrom(const Vec2& from, const Disc& disc) {
  const double square = (disc.centre - from).squaredNorm();
  const bool is_within = square < disc.radius * disc.radius && square > disc.inner * disc.inner;
  return is_within && disc.inner > 0.0 ? Disc{disc.centre, disc.inner} : disc;
}

}  // namespace

Lidar::Lidar(const ScannerModel& scanner, const LidarNoise& noise)
    : scanner_(scanner), noise_(noise), increment_(incrementOf(scanner)) {
  for (int i = 0; i < scanner.beams; ++i) beams_.push_back(direction(scanner.angle_min + i * increment_));
  turned_ = beams_;
  for (std::size_t i = 0; i < beams_.size(); ++i) {
    const std::size_t sector = sectorOf(beams_[i], kSectors);
    if (i == 0 || sector != runs_.back().sector) runs_.push_back({sector, i, i});
    runs_.back().end = i + 1;
  }
  ranges_.resize(beams_.size());
}

void Lidar::scan(const Pose2& T_world_base, const grids::RayCaster& walls, const DiscIndex& discs,
                 std::optional<DiscIndex::Id> own, Random& random, LaserScan2& scan) {
  const Pose2 T_world_sensor = T_world_base * scanner_.T_base_sensor();
  const Vec2 from = T_world_sensor.position();
  turnBeams(T_world_sensor.yaw);
  std::fill(ranges_.begin(), ranges_.end(), scanner_.range_max);
  walls.castAll(from, turned_, ranges_);
  measureSight();
  const Vec2 ahead = direction(T_world_sensor.yaw);
  discs.visitNear(from, scanner_.range_max, [&](DiscIndex::Id id, const Disc& disc) {
    const Vec2 to = disc.centre - from;
    if (id != own) meetDisc({ahead.dot(to), ahead.x() * to.y() - ahead.y() * to.x()}, seenFrom(from, disc).radius);
  });
  describe(scan);
  for (std::size_t i = 0; i < ranges_.size(); ++i) scan.ranges[i] = reading(ranges_[i], random);
}

void Lidar::describe(LaserScan2& scan) const {
  scan.angle_min = scanner_.angle_min;
  scan.angle_increment = increment_;
  scan.time_increment = scanner_.rolling ? 1.0 / scanner_.rate / static_cast<double>(beams_.size()) : 0.0;
  scan.reversed = scanner_.reversed;
  scan.range_min = scanner_.range_min;
  scan.range_max = scanner_.range_max;
  scan.T_base_sensor = scanner_.T_base_sensor();
  scan.ranges.resize(beams_.size());
}

void Lidar::measure(const Sweep& sweep, const grids::RayCaster& walls, const DiscIndex& discs,
                    std::optional<DiscIndex::Id> own, Random& random, LaserScan2& scan) {
  aim(sweep);
  swept_ranges_.assign(swept_.size(), scanner_.range_max);
  walls.castEach(swept_from_, swept_, swept_ranges_);
  // Only what lies in the box around the beams can shorten one, and the few of a sweep usually point the same way.
  Vec2 low = swept_from_.front(), high = low;
  for (std::size_t i = 0; i < swept_.size(); ++i) {
    const Vec2 end = swept_from_[i] + swept_ranges_[i] * swept_[i];
    low = low.cwiseMin(end).cwiseMin(swept_from_[i]);
    high = high.cwiseMax(end).cwiseMax(swept_from_[i]);
  }
  discs.visitIn(low, high, [&](DiscIndex::Id id, const Disc& disc) {
    if (id != own) meetMoving(seenFrom(swept_from_.front(), disc));
  });
  for (std::size_t i = 0; i < swept_ranges_.size(); ++i)
    scan.ranges[beamOf(sweep.first + i)] = reading(swept_ranges_[i], random);
}

void Lidar::aim(const Sweep& sweep) {
  const Rotation2 turn(sweep.turn);
  const Vec2 mount = scanner_.T_base_sensor().position();
  Vec2 base = sweep.T_world_base.position();
  // The headings of the base and of the scanner, turned on from beam to beam, which is cheaper than sine and cosine.
  Vec2 heading = direction(sweep.T_world_base.yaw);
  const Vec2 yaw = direction(scanner_.yaw);
  swept_from_.resize(sweep.end - sweep.first);
  swept_.resize(sweep.end - sweep.first);
  const auto turnedBy = [](const Vec2& by, const Vec2& v) {
    return Vec2(by.x() * v.x() - by.y() * v.y(), by.y() * v.x() + by.x() * v.y());
  };
  for (std::size_t i = 0; i < swept_.size(); ++i) {
    swept_from_[i] = base + turnedBy(heading, mount);
    swept_[i] = turnedBy(turnedBy(heading, yaw), beams_[beamOf(sweep.first + i)]);
    base += sweep.step;
    heading = turn * heading;
  }
}

// Shortens the beams of the sweep that meet the disc.
void Lidar::meetMoving(const Disc& disc) {
  for (std::size_t i = 0; i < swept_.size(); ++i) {
    const Vec2 centre = disc.centre - swept_from_[i];
    const double along = swept_[i].dot(centre);
    const double outside = centre.squaredNorm() - disc.radius * disc.radius;
    const double square = along * along - outside;
    if (outside <= 0.0) {
      swept_ranges_[i] = 0.0;
    } else if (square >= 0.0 && along >= 0.0) {
      swept_ranges_[i] = std::min(swept_ranges_[i], along - std::sqrt(square));
    }
  }
}

void Lidar::turnBeams(double yaw) {
  const Rotation2 rotation(yaw);
  for (std::size_t i = 0; i < beams_.size(); ++i) turned_[i] = rotation * beams_[i];
}

// The farthest distance to a wall in each sector and the two next to it.
void Lidar::measureSight() {
  std::array<double, kSectors> reach{};
  for (const Run& run : runs_) {
    for (std::size_t i = run.begin; i < run.end; ++i) reach[run.sector] = std::max(reach[run.sector], ranges_[i]);
  }
  for (std::size_t i = 0; i < kSectors; ++i) {
    sight_[i] = std::max({reach[i], reach[(i + 1) % kSectors], reach[(i + kSectors - 1) % kSectors]});
  }
}

void Lidar::meetDisc(const Vec2& centre, double radius) {
  const double square = centre.squaredNorm();
  if (square <= radius * radius) return std::fill(ranges_.begin(), ranges_.end(), 0.0);
  // A sector is at least 4 / kSectors [rad] wide: a disc more than kFarRadii radii away extends no farther than into
  // the sectors next to its centre's, and is invisible if all walls in these are nearer than the disc.
  constexpr double kFarRadii = kSectors / 4.0 + 1.0;
  const double sight = sight_[sectorOf(centre, kSectors)] + radius;
  if (square > kFarRadii * kFarRadii * radius * radius && square > sight * sight) return;
  // The tangent of half the angle that the disc subtends: slightly larger than that angle, and cheaper to compute.
  const double half = radius / std::sqrt(square - radius * radius);
  const double middle = normalizeAngle(bearing(centre) - scanner_.angle_min);
  // Counted from the first beam, beams lie in [0, field of view], up to a full turn: try the disc's angle in [-pi, pi)
  // and a turn on.
  meetDisc(centre, radius, middle - half, middle + half);
  meetDisc(centre, radius, middle - half + 2.0 * kPi, middle + half + 2.0 * kPi);
}

void Lidar::meetDisc(const Vec2& centre, double radius, double first_angle, double last_angle) {
  const double count = static_cast<double>(ranges_.size());
  const auto first = static_cast<std::size_t>(std::clamp(first_angle / increment_, 0.0, count));
  const auto end = static_cast<std::size_t>(std::clamp(last_angle / increment_ + 1.0, 0.0, count));
  const double outside = centre.squaredNorm() - radius * radius;
  for (std::size_t i = first; i < end; ++i) {
    const double along = beams_[i].dot(centre);
    const double square = along * along - outside;
    if (square < 0.0 || along < 0.0) continue;
    ranges_[i] = std::min(ranges_[i], along - std::sqrt(square));
  }
}

float Lidar::reading(double range, Random& random) const {
  if (noise_.dropout > 0.0 && random.uniform() < noise_.dropout) return std::numeric_limits<float>::quiet_NaN();
  if (range >= scanner_.range_max) return static_cast<float>(kInf);
  const double measured = noise_.noise_stddev > 0.0 ? range + noise_.noise_stddev * random.gaussian() : range;
  if (measured < scanner_.range_min) return static_cast<float>(-kInf);
  return static_cast<float>(measured > scanner_.range_max ? kInf : measured);
}

}  // namespace frontier_pilot::sim
