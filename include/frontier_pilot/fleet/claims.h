#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/time.h"
#include "frontier_pilot/exploration/explorer_types.h"

namespace frontier_pilot::fleet {

/// What a robot tells the others of its team twice a second: where it is, and what it is going to look at, in a
/// frame that they have in common. No one collects these messages: each robot decides for itself by the last one of
/// each other. [MUL-2]
struct ClaimsMessage {
  static constexpr std::uint8_t kVersion = 1;
  static constexpr std::size_t kMostClaims = 40;  ///< what a robot sends; with 12 bytes each, half a kilobyte
  static constexpr double kValidFor = 10.0;       ///< [s]

  std::uint8_t version = kVersion;
  std::string robot;                       ///< unique in the team
  Vec2 position = Vec2::Zero();            ///< in the common frame [m]
  std::vector<exploration::Claim> claims;  ///< in the common frame, with the time that is left when it is sent
  double valid_for = kValidFor;            ///< after the next message it holds no more, or after this time [s]
};

/// The message of a robot whose map frame is at `T_common_map`, with the soonest of its claims, which are in its map
/// frame like its pose.
ClaimsMessage makeClaimsMessage(const std::string& robot, const Pose2& T_map_base,
                                const std::vector<exploration::Claim>& claims, const Pose2& T_common_map);

/// What has become of a message.
enum class ClaimsVerdict {
  kTaken,
  kOwn,           ///< of the robot itself, as every message comes back on a common topic
  kOtherVersion,  ///< refused: its fields may mean something else
  kMalformed,     ///< refused: a number that is not finite or makes no sense, or no name
  kTooMany,       ///< refused: too many claims, or robots
};
const char* toString(ClaimsVerdict verdict);

/// The last messages of the other robots. One that falls silent is forgotten with all its claims, by the clock of the
/// robot that listens, so that the clocks of several computers need not agree; one that is heard again counts again.
/// [MUL-2]
class ClaimBook {
 public:
  /// `own_name` is that of the robot that listens.
  explicit ClaimBook(std::string own_name) : own_name_(std::move(own_name)) {}

  /// Takes a message that has arrived at `now`. What is refused leaves what is known of its sender as it was. [FLT-1]
  ClaimsVerdict take(const ClaimsMessage& message, Time now);
  /// The robots of which something is known that is valid at `now`, by name, in a map frame; `T_map_common` is the pose
  /// of the common frame in it.
  std::vector<exploration::Teammate> others(const Pose2& T_map_common, Time now);

 private:
  struct Heard {
    ClaimsMessage message;
    Time at;
  };
  void forgetSilent(Time now);

  std::string own_name_;
  std::map<std::string, Heard> heard_;
};

}  // namespace frontier_pilot::fleet
