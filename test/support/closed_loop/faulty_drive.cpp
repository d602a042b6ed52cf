#include "support/closed_loop/faulty_drive.h"
#include "sim/solid_cells.h"

#include <cmath>
#include <map>
#include <stdexcept>

namespace frontier_pilot::test {
namespace {

constexpr double kPeriod = 30.0;        // [s], from one fault to the next
constexpr double kKidnapped = 3.0;      // [s]
constexpr double kNoOdometry = 1.0;     // [s]
constexpr double kPersonRadius = 0.25;  // [m]
constexpr double kPersonAhead = 1.2;    // [m]
constexpr double kPersonSpeed = 1.0;    // [m/s]
constexpr double kPersonReach = 2.0;    // [m], to either side
constexpr double kDropout = 0.3;
constexpr const char* kPerson = "person";

sim::SimulatorParameters withFault(sim::SimulatorParameters parameters, SensorFault fault) {
  if (fault == SensorFault::kDropout) parameters.lidar.dropout = kDropout;
  return parameters;
}

}  // namespace

SensorFault sensorFaultNamed(const std::string& name) {
  static const std::map<std::string, SensorFault> kFaults = {{"none", SensorFault::kNone},
                                                             {"kidnap", SensorFault::kKidnap},
                                                             {"dropout", SensorFault::kDropout},
                                                             {"person", SensorFault::kPerson},
                                                             {"odom-frozen", SensorFault::kOdomFrozen},
                                                             {"odom-missing", SensorFault::kOdomMissing}};
  const auto found = kFaults.find(name);
  if (found != kFaults.end()) return found->second;
  throw std::invalid_argument("--fault: none, kidnap, dropout, person, odom-frozen or odom-missing");
}

FaultyDrive::FaultyDrive(sim::World world, sim::SimulatorParameters parameters, double distance, SensorFault fault)
    : fault_(fault),
      drive_(std::move(world), withFault(parameters, fault), distance),
      lidar_(parameters.robot.scanner, parameters.lidar),
      rays_(sim::solidCells(drive_.simulator().map(), parameters.unknown_is_free)),
      nobody_(drive_.simulator().map().geometry()) {}

const LaserScan2* FaultyDrive::nextScan() {
  const LaserScan2* scan = drive_.nextScan();
  if (scan == nullptr) return nullptr;
  movePerson();
  freezeOdometry();
  return fault_ == SensorFault::kKidnap && isFaulty(kKidnapped) ? seenElsewhere(*scan) : scan;
}

std::optional<Pose2> FaultyDrive::T_odom_base(Time stamp) const {
  if (fault_ == SensorFault::kOdomMissing && isFaulty(kNoOdometry)) return std::nullopt;
  const std::optional<Pose2> T_odom_base = drive_.odometry().nearest(stamp);
  if (!T_odom_base) return std::nullopt;
  return T_reported_odom_ * *T_odom_base;
}

double FaultyDrive::sinceFault() const { return std::fmod(toSeconds(drive_.now()), kPeriod) - 0.5 * kPeriod; }

bool FaultyDrive::isFaulty(double seconds) const { return sinceFault() >= 0.0 && sinceFault() < seconds; }

void FaultyDrive::movePerson() {
  if (fault_ != SensorFault::kPerson) return;
  drive_.simulator().removeObstacle(kPerson);
  const double left = kPersonReach - kPersonSpeed * sinceFault();
  if (!isFaulty(2.0 * kPersonReach / kPersonSpeed)) return;
  const Vec2 at = drive_.simulator().pose(0) * Vec2(kPersonAhead, left);
  drive_.simulator().spawnObstacle(kPerson, {at, 0.0}, kPersonRadius);
}

void FaultyDrive::freezeOdometry() {
  const Pose2 odometry = drive_.T_odom_base();
  if (fault_ == SensorFault::kOdomFrozen && isFaulty(kNoOdometry)) {
    T_reported_odom_ = T_reported_odom_ * last_odometry_ * odometry.inverse();
  }
  last_odometry_ = odometry;
}

const LaserScan2* FaultyDrive::seenElsewhere(const LaserScan2& scan) {
  elsewhere_.stamp = scan.stamp;
  lidar_.scan(drive_.simulator().startPose(0), rays_, nobody_, std::nullopt, random_, elsewhere_);
  return &elsewhere_;
}

}  // namespace frontier_pilot::test
