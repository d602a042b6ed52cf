#include "frontier_pilot/slam/scan_tracker.h"

#include <algorithm>
#include <cmath>

#include "frontier_pilot/core/motion.h"
#include "slam/front_end/odometry_model.h"
#include "slam/front_end/scan_placement.h"

namespace frontier_pilot::slam {
namespace {

// The error of odometry that does not depend on motion: its resolution, and the inaccuracy of its stamps.
constexpr PoseSigma kLeast{0.003, 0.002};

// The same while the wheels do not turn: any motion that a scan seems to show is then mostly noise.
constexpr PoseSigma kStanding{0.0003, 0.0003};
constexpr double kTurningWheels = 0.0001;  ///< the wheels turn if odometry moves by more than this [m, rad]

// A robot that is carried shows nothing known for a while in which its wheels hardly turn.
constexpr double kCarrying = 1.0;      ///< [s]
constexpr double kHardlyDriven = 0.1;  ///< [m, rad]

PoseSigma sumOf(const PoseSigma& a, const PoseSigma& b) {
  return {std::hypot(a.position, b.position), std::hypot(a.yaw, b.yaw)};
}

/// A pose of the robot, by odometry and by the match of a scan.
struct Fix {
  Pose2 T_odom_base;
  Pose2 T_local_base;
};

/// The last scan.
struct Last {
  Time stamp;
  Fix fix;
  Time matched;      ///< when a scan was placed last
  Pose2 matched_at;  ///< T_odom_base then
  PoseSigma sigma;   ///< the uncertainty that odometry has added since the last match
  bool carried;      ///< odometry carries the pose, because there was little to match
  bool kidnapped;    ///< since the last match the robot was carried
};

}  // namespace

const char* toString(MatchVerdict verdict) {
  switch (verdict) {
    case MatchVerdict::kFirst:
      return "first scan";
    case MatchVerdict::kMatched:
      return "matched";
    case MatchVerdict::kContradicts:
      return "matched, contradicts odometry";
    case MatchVerdict::kExtended:
      return "extends the map, position mostly from odometry";
    case MatchVerdict::kCarried:
      return "little to match, position from odometry";
    case MatchVerdict::kTooFew:
      return "too few returns";
    case MatchVerdict::kPoor:
      return "does not fit the map";
    case MatchVerdict::kAmbiguous:
      return "ambiguous";
    case MatchVerdict::kKidnapped:
      return "not localised: what the scanner shows changed while the robot stood, as if it was carried; give a pose, "
             "or call mapper/localize";
    case MatchVerdict::kLost:
      return "lost, new submap begun";
  }
  return "unknown";
}

const char* describe(const Track& track) {
  if (track.verdict == MatchVerdict::kMatched && track.slides) return "matched, position along the walls from odometry";
  return toString(track.verdict);
}

struct ScanTracker::Impl {
  explicit Impl(const ScanTrackerParameters& given) : parameters(given), placement(given), odometry(given.odometry) {}

  Pose2 expected(const Pose2& T_odom_base) const;
  PoseSigma grown(const Pose2& T_odom_base) const;
  Prediction predict(Time stamp, const Pose2& T_odom_base, const Pose2& T_local_map) const;
  Track place(const surfaces::SurfacePoints& points, Time stamp, const Pose2& T_odom_base, const MatchTarget& target,
              bool open) const;
  bool turnedTo(const Pose2& T_odom_base) const;
  MatchVerdict unmatched(MatchVerdict verdict, Time stamp, const Pose2& T_odom_base) const;
  void learn(const Fix& fix, const Track& track);
  void remember(Time stamp, const Pose2& T_odom_base, const Track& track, bool open);

  ScanTrackerParameters parameters;
  ScanPlacement placement;
  OdometryModel odometry;
  Pose2 T_local_odom;
  std::optional<Last> last;
  std::optional<Fix> anchor;  ///< the match from which the next motion is learnt
  bool drives = false;        ///< odometry has shown motion; if it never does, it does not show that the robot stands
};

ScanTracker::ScanTracker(const ScanTrackerParameters& parameters) : impl_(std::make_unique<Impl>(parameters)) {}
ScanTracker::~ScanTracker() = default;
ScanTracker::ScanTracker(ScanTracker&&) noexcept = default;
ScanTracker& ScanTracker::operator=(ScanTracker&&) noexcept = default;

Pose2 ScanTracker::Impl::expected(const Pose2& T_odom_base) const {
  if (!last) return T_local_odom * T_odom_base;
  return last->fix.T_local_base * odometry.corrected(last->fix.T_odom_base.inverse() * T_odom_base);
}

PoseSigma ScanTracker::Impl::grown(const Pose2& T_odom_base) const {
  return sumOf(last->sigma, odometry.sigma(last->fix.T_odom_base.inverse() * T_odom_base));
}

Prediction ScanTracker::Impl::predict(Time stamp, const Pose2& T_odom_base, const Pose2& T_local_map) const {
  const Pose2 T_map_base = T_local_map.inverse() * expected(T_odom_base);
  if (!last) return {T_map_base, kLeast, kLeast};
  const bool stands = last->matched == last->stamp && !last->carried && !turnedTo(T_odom_base);
  const PoseSigma sigma = stands ? kStanding : sumOf(grown(T_odom_base), kLeast);
  const double silence = std::max(0.0, toSeconds(stamp - last->matched));
  const PoseSigma unseen{sigma.position + parameters.odometry.unmeasured_speed * silence,
                         sigma.yaw + parameters.odometry.unmeasured_turn * silence};
  const bool late = toSeconds(stamp - last->stamp) > parameters.sparse_period;
  const bool sparse =
      late && isJump(last->fix.T_odom_base, T_odom_base, parameters.sparse_distance, parameters.sparse_angle);
  return {T_map_base, sigma, unseen, sparse, false, last->carried};
}

Track ScanTracker::track(const surfaces::SurfacePoints& points, Time stamp, const Pose2& T_odom_base,
                         const std::optional<MatchTarget>& target, bool open) {
  // The clock was set back: the time without a match counts from now.
  if (impl_->last && stamp < impl_->last->stamp) impl_->last->matched = stamp;
  Track track;
  track.T_local_base.pose = impl_->expected(T_odom_base);
  if (target) track = impl_->place(points, stamp, T_odom_base, *target, open);
  impl_->remember(stamp, T_odom_base, track, open);
  return track;
}

Track ScanTracker::Impl::place(const surfaces::SurfacePoints& points, Time stamp, const Pose2& T_odom_base,
                               const MatchTarget& target, bool open) const {
  Prediction prediction = predict(stamp, T_odom_base, target.T_local_map);
  prediction.open = open;
  Track track = placement.place(points, target, prediction);
  if (!isPlaced(track.verdict) || track.verdict == MatchVerdict::kCarried) {
    track.slides = false;
    track.T_local_base = beliefOf(expected(T_odom_base), prediction.odometry);
  }
  if (track.verdict == MatchVerdict::kPoor || track.verdict == MatchVerdict::kAmbiguous)
    track.verdict = unmatched(track.verdict, stamp, T_odom_base);
  return track;
}

bool ScanTracker::Impl::turnedTo(const Pose2& T_odom_base) const {
  return isJump(last->fix.T_odom_base, T_odom_base, kTurningWheels, kTurningWheels);
}

/// What it means that a scan could not be matched, after all the time without a match.
MatchVerdict ScanTracker::Impl::unmatched(MatchVerdict verdict, Time stamp, const Pose2& T_odom_base) const {
  if (!last) return verdict;
  const double silence = toSeconds(stamp - last->matched);
  const bool stands = drives && !isJump(last->matched_at, T_odom_base, kHardlyDriven, kHardlyDriven);
  if (last->kidnapped || (stands && silence > kCarrying)) return MatchVerdict::kKidnapped;
  return silence > parameters.max_silence ? MatchVerdict::kLost : verdict;
}

scan_matching::SearchWindow ScanTracker::usualWindow() const {
  constexpr double kUsualGap = 0.3;
  constexpr double kSigmas = 3.0;
  const double reach = impl_->parameters.odometry.unmeasured_speed * kUsualGap +
                       kSigmas * impl_->parameters.odometry.distance * std::sqrt(kUsualGap);
  return {reach, reach, impl_->parameters.odometry.unmeasured_turn * kUsualGap};
}

void ScanTracker::Impl::learn(const Fix& fix, const Track& track) {
  constexpr double kDriven = 0.5;  // [m]: shorter motions show the errors of the matches, not those of odometry
  constexpr double kTurned = 0.3;  // [rad]
  if (!isMatched(track.verdict) || track.slides) return anchor.reset();
  if (!anchor) return void(anchor = fix);
  const Pose2 motion = anchor->T_odom_base.inverse() * fix.T_odom_base;
  if (!isJump(Pose2(), motion, kDriven, kTurned)) return;
  odometry.learn(motion, anchor->T_local_base.inverse() * fix.T_local_base);
  anchor = fix;
}

void ScanTracker::Impl::remember(Time stamp, const Pose2& T_odom_base, const Track& track, bool open) {
  const bool known =
      isPlaced(track.verdict) || !last || track.verdict == MatchVerdict::kFirst || track.verdict == MatchVerdict::kLost;
  const bool extrapolated = track.verdict == MatchVerdict::kCarried && last;
  const PoseSigma sigma = known && !extrapolated ? PoseSigma{} : grown(T_odom_base);
  // A map that begins on open ground shows nothing that later scans could match.
  const bool carried = track.verdict == MatchVerdict::kCarried || (track.verdict == MatchVerdict::kFirst && open);
  const bool kidnapped = track.verdict == MatchVerdict::kKidnapped || (!known && last->kidnapped);
  const Fix fix{T_odom_base, track.T_local_base.pose};
  learn(fix, track);
  drives = drives || (last && turnedTo(T_odom_base));
  last = Last{stamp,
              fix,
              known ? stamp : last->matched,
              known ? T_odom_base : last->matched_at,
              sigma,
              carried || (!known && last->carried),
              kidnapped};
  T_local_odom = fix.T_local_base * T_odom_base.inverse();
}

const Pose2& ScanTracker::T_local_odom() const { return impl_->T_local_odom; }
Pose2 ScanTracker::withoutErrors(const Pose2& motion) const { return impl_->odometry.corrected(motion); }

void ScanTracker::reset(const Pose2& T_local_odom) {
  impl_->T_local_odom = T_local_odom;
  impl_->last.reset();
  impl_->anchor.reset();
}

}  // namespace frontier_pilot::slam
