#include "frontier_pilot/logs/trajectory.h"

#include <cmath>
#include <iomanip>
#include <ostream>

namespace frontier_pilot::logs {
void writeTum(std::ostream& out, const Trajectory& trajectory) {
  out << std::fixed << std::setprecision(6);
  for (const StampedPose2& entry : trajectory) {
    const double half = 0.5 * entry.pose.yaw;
    out << toSeconds(entry.stamp) << " " << entry.pose.x << " " << entry.pose.y << " 0 0 0 " << std::sin(half) << " "
        << std::cos(half) << "\n";
  }
}

}  // namespace frontier_pilot::logs
