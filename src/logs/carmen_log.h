#pragma once

#include <istream>
#include <string>

#include "frontier_pilot/logs/scan_log.h"

namespace frontier_pilot::logs {

/// Reads the FLASER or ROBOTLASER1 lines of a log of the Carnegie Mellon Robot Navigation Toolkit, whichever come
/// first; every other line is passed over.
///
///   FLASER n r_1 ... r_n laser_x laser_y laser_yaw robot_x robot_y robot_yaw stamp host logger_stamp
///   ROBOTLASER1 type start fov step max_range accuracy remission_mode n r_1 ... r_n m s_1 ... s_m
///     laser_x laser_y laser_yaw robot_x robot_y robot_yaw tv rv forward_safety side_safety turn_axis
///     stamp host logger_stamp
///
/// FLASER says nothing about angles: as in CARMEN they follow from the number of ranges. Where the scanner sits is
/// where the laser's pose lies seen from the robot's, if that is always the same place; logs whose laser poses were
/// corrected by a SLAM program get it at the base's centre, with a note. Throws a LogError naming `name` and the line.
ScanLog readCarmenLog(std::istream& file, const std::string& name, const LogScanner& scanner = {});

}  // namespace frontier_pilot::logs
