#include "frontier_pilot/fleet/claims.h"

#include <algorithm>
#include <cmath>

#include "fleet/message_bounds.h"

namespace frontier_pilot::fleet {
namespace {

constexpr double kCostliest = 24 * 3600.0;  // [s]

bool isSound(const ClaimsMessage& message) {
  if (!isName(message.robot) || !isPlace(message.position)) return false;
  if (!(message.valid_for > 0.0 && message.valid_for <= kLongestValid)) return false;
  return std::all_of(message.claims.begin(), message.claims.end(), [](const exploration::Claim& claim) {
    return isPlace(claim.place) && claim.cost >= 0.0 && claim.cost <= kCostliest;
  });
}

}  // namespace

const char* toString(ClaimsVerdict verdict) {
  switch (verdict) {
    case ClaimsVerdict::kTaken:
      return "taken";
    case ClaimsVerdict::kOwn:
      return "its own";
    case ClaimsVerdict::kOtherVersion:
      return "another version of the protocol";
    case ClaimsVerdict::kMalformed:
      return "a name that is empty or too long, or a number that is not finite or out of range";
    case ClaimsVerdict::kTooMany:
      return "too many claims, or too many robots";
  }
  return "?";
}

ClaimsMessage makeClaimsMessage(const std::string& robot, const Pose2& T_map_base,
                                const std::vector<exploration::Claim>& claims, const Pose2& T_common_map) {
  ClaimsMessage message;
  message.robot = robot;
  message.position = T_common_map * T_map_base.position();
  message.claims = claims;
  std::stable_sort(message.claims.begin(), message.claims.end(),
                   [](const exploration::Claim& a, const exploration::Claim& b) { return a.cost < b.cost; });
  if (message.claims.size() > ClaimsMessage::kMostClaims) message.claims.resize(ClaimsMessage::kMostClaims);
  for (exploration::Claim& claim : message.claims) claim.place = T_common_map * claim.place;
  return message;
}

ClaimsVerdict ClaimBook::take(const ClaimsMessage& message, Time now) {
  if (message.version != ClaimsMessage::kVersion) return ClaimsVerdict::kOtherVersion;
  if (message.claims.size() > ClaimsMessage::kMostClaims) return ClaimsVerdict::kTooMany;
  if (!isSound(message)) return ClaimsVerdict::kMalformed;
  if (message.robot == own_name_) return ClaimsVerdict::kOwn;
  forgetSilent(now);
  if (heard_.size() >= kMostHeard && heard_.count(message.robot) == 0) return ClaimsVerdict::kTooMany;
  heard_[message.robot] = {message, now};
  double& valid_for = heard_[message.robot].message.valid_for;
  valid_for = std::min(valid_for, ClaimsMessage::kValidFor);  // no robot may be trusted for longer after it has died
  return ClaimsVerdict::kTaken;
}

/// A clock that jumped back would keep silent robots for ever.
void ClaimBook::forgetSilent(Time now) {
  for (auto it = heard_.begin(); it != heard_.end();) {
    const double age = toSeconds(now - it->second.at);
    it = age < 0.0 || age > it->second.message.valid_for ? heard_.erase(it) : std::next(it);
  }
}

std::vector<exploration::Teammate> ClaimBook::others(const Pose2& T_map_common, Time now) {
  forgetSilent(now);
  std::vector<exploration::Teammate> others;
  for (const auto& [name, heard] : heard_) {
    exploration::Teammate other;
    other.name = name;
    other.precedes = name < own_name_;
    other.position = T_map_common * heard.message.position;
    const double age = toSeconds(now - heard.at);
    for (const exploration::Claim& claim : heard.message.claims) {
      other.claims.push_back({T_map_common * claim.place, std::max(0.0, claim.cost - age)});
    }
    others.push_back(std::move(other));
  }
  return others;
}

}  // namespace frontier_pilot::fleet
