#include "examples.h"

#include <cmath>
#include <sstream>

#include "frontier_pilot/logs/scan_log.h"
#include "frontier_pilot/logs/trajectory.h"

namespace fp = frontier_pilot;

bool examples::logs() {
  //! [example]
  std::istringstream file("1.0, 0.0, 0.0, 0.0, 2.0, 3.0, 2.0\n1.1, 0.1, 0.0, 0.0, 1.9, 2.9, 1.9\n");
  const fp::logs::ScanLog log = fp::logs::readScanLog(file, "drive.csv");
  std::vector<fp::Pose2> trajectory;
  for (const fp::logs::LogRecord& record : log.records) trajectory.push_back(record.T_odom_base);
  const fp::logs::PoseRelation measured{0, 1, fp::Pose2(0.12, 0.0, 0.0)};
  const fp::logs::RelationError error = fp::logs::relationError(trajectory, {measured});
  return log.records.size() == 2 && std::abs(error.translation.mean - 0.02) < 1e-9;
  //! [example]
}
