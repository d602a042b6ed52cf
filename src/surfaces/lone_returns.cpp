#include "surfaces/lone_returns.h"

#include <algorithm>
#include <cmath>

namespace frontier_pilot::surfaces {
namespace {

constexpr double kBehind = 1.0;           ///< least distance behind both neighbours [m]
constexpr std::size_t kAround = 4;        ///< beams on either side that may support a return
constexpr std::size_t kMostBetween = 3;   ///< invalid beams between a return and its neighbour
constexpr double kSteepestSupport = 5.0;  ///< returns at most this many beam spacings apart support each other
constexpr double kSupportSlack = 0.1;     ///< tolerance added to that, for noise [m]

/// The returns of a scan, and whether one of them is alone.
class Neighbourhood {
 public:
  explicit Neighbourhood(const LaserScan2& scan) : scan_(scan) {
    for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
      const RangeReading reading = readBeam(scan, beam);
      if (reading.kind == RangeKind::kHit) returns_.push_back({beam, reading.distance, !open_});
      if (reading.kind != RangeKind::kInvalid) open_ = reading.kind != RangeKind::kHit;
    }
  }

  std::size_t size() const { return returns_.size(); }
  bool isLone(std::size_t i) const {
    if (i == 0 || i + 1 == size() || !areNeighbours(i - 1, i) || !areNeighbours(i, i + 1)) return false;
    const double nearer = std::max(returns_[i - 1].distance, returns_[i + 1].distance);
    return returns_[i].distance > nearer + kBehind && !isSupported(i);
  }

 private:
  struct Return {
    std::size_t beam;
    double distance;  ///< [m]
    bool follows;     ///< all beams between the last return and this one, if any, are invalid
  };

  bool areNeighbours(std::size_t a, std::size_t b) const {
    return returns_[b].follows && returns_[b].beam - returns_[a].beam <= kMostBetween + 1;
  }
  bool isSupported(std::size_t i) const {
    for (std::size_t k = i; k-- > 0 && returns_[i].beam - returns_[k].beam <= kAround;) {
      if (supportEachOther(returns_[k], returns_[i])) return true;
    }
    for (std::size_t k = i + 1; k < size() && returns_[k].beam - returns_[i].beam <= kAround; ++k) {
      if (supportEachOther(returns_[i], returns_[k])) return true;
    }
    return false;
  }
  bool supportEachOther(const Return& a, const Return& b) const {
    const double angle = static_cast<double>(b.beam - a.beam) * std::abs(scan_.angle_increment);
    const double spacing = angle * std::min(a.distance, b.distance);
    const Vec2 apart = scan_.point(b.beam, b.distance) - scan_.point(a.beam, a.distance);
    return apart.norm() <= kSteepestSupport * spacing + kSupportSlack;
  }

  const LaserScan2& scan_;
  std::vector<Return> returns_;
  bool open_ = true;  ///< the last beam that was not invalid was no return
};

}  // namespace

std::vector<std::size_t> loneReturns(const LaserScan2& scan) {
  const Neighbourhood neighbourhood(scan);
  std::vector<std::size_t> lone;
  for (std::size_t i = 0; i < neighbourhood.size(); ++i) {
    if (neighbourhood.isLone(i)) lone.push_back(i);
  }
  return lone;
}

}  // namespace frontier_pilot::surfaces
