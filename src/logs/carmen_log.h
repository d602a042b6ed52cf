#pragma once

#include <istream>
#include <string>

#include "frontier_pilot/logs/scan_log.h"

namespace frontier_pilot::logs {

/// Reads the FLASER or the ROBOTLASER1 lines of a log of the Carnegie Mellon Robot Navigation Toolkit (CARMEN),
/// whichever kind comes first; every other line is skipped.
///
///   FLASER n r_1 ... r_n laser_x laser_y laser_yaw robot_x robot_y robot_yaw stamp host logger_stamp
///   ROBOTLASER1 type start fov step max_range accuracy remission_mode n r_1 ... r_n m s_1 ... s_m
///     laser_x laser_y laser_yaw robot_x robot_y robot_yaw tv rv forward_safety side_safety turn_axis
///     stamp host logger_stamp
///
/// FLASER does not record angles: as in CARMEN they follow from the number of ranges. The scanner's mount is the
/// laser's pose relative to the robot's, if that is the same in every line. If it varies, as in logs whose laser poses
/// a SLAM program has corrected, the mount is taken to be the base's centre, with a note. Throws a LogError naming
/// `name` and the line.
ScanLog readCarmenLog(std::istream& file, const std::string& name, const LogScanner& scanner = {});

}  // namespace frontier_pilot::logs
