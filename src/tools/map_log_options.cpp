#include "tools/map_log_options.h"

#include <cmath>
#include <regex>
#include <stdexcept>

#include "frontier_pilot/core/bounds.h"
#include "tools/arguments.h"

namespace frontier_pilot::tools {
namespace {

double positiveNumber(Arguments& arguments, const std::string& option) {
  const double value = arguments.number();
  if (value <= 0.0) throw std::invalid_argument(option + " must be positive");
  return value;
}

double resolutionOf(Arguments& arguments, const std::string& option) {
  const double value = arguments.number();
  if (value >= bounds::kLeastResolution && value <= bounds::kMostResolution) return value;
  throw std::invalid_argument(option + " must be between 0.01 and 10 m");
}

double fieldOfView(Arguments& arguments, const std::string& option) {
  const double degrees = positiveNumber(arguments, option);
  if (degrees > 360.0) throw std::invalid_argument(option + " must be at most 360 degrees");
  return degrees * kPi / 180.0;
}

Pose2 mountOf(Arguments& arguments, const std::string& option) {
  const double x = arguments.number();
  const double y = arguments.number();
  if (!bounds::isWithin(std::hypot(x, y), bounds::kMostMount))
    throw std::invalid_argument(option + " must be within 10 m of the base");
  const double yaw = arguments.number();
  if (!bounds::isWithin(yaw, 2.0 * kPi)) throw std::invalid_argument(option + " must have a yaw within 2 pi");
  return {x, y, normalizeAngle(yaw)};
}

/// A ROS name of a topic or frame: letters, digits and underscores, with slashes between them.
std::string rosName(Arguments& arguments, const std::string& option, const std::string& what) {
  static const std::regex pattern("/?[A-Za-z][A-Za-z0-9_]*(/[A-Za-z0-9_]+)*");
  std::string name = arguments.text();
  if (name.size() < 256 && std::regex_match(name, pattern)) return name;
  throw std::invalid_argument(option + " needs the name of a " + what + ", not '" + name + "'");
}

void takeOption(const std::string& word, Arguments& arguments, MapLogOptions& o) {
  if (word == "--out") return void(o.out = arguments.text());
  if (word == "--relations") return void(o.relations = arguments.text());
  if (word == "--resolution") return void(o.mapper.map.resolution = resolutionOf(arguments, word));
  if (word == "--range") return void(o.scanner.range_max = positiveNumber(arguments, word));
  if (word == "--fov") return void(o.scanner.field_of_view = fieldOfView(arguments, word));
  if (word == "--mount") return void(o.scanner.T_base_sensor = mountOf(arguments, word));
  if (word == "--scan") return void(o.topics.scan = rosName(arguments, word, "topic"));
  if (word == "--odom") return void(o.topics.odom = rosName(arguments, word, "topic"));
  if (word == "--base") return void(o.topics.base_frame = rosName(arguments, word, "frame"));
  if (Arguments::isOption(word)) throw std::invalid_argument("unknown option " + word);
  if (!o.log.empty()) throw std::invalid_argument("more than one log: " + o.log + " and " + word);
  o.log = word;
}

}  // namespace

MapLogOptions parseMapLogOptions(const std::vector<std::string>& words) {
  Arguments arguments(words);
  MapLogOptions options;
  while (!arguments.atEnd()) {
    const std::string word = arguments.next();
    takeOption(word, arguments, options);
  }
  if (options.log.empty()) throw std::invalid_argument("no log given");
  if (options.out.empty()) throw std::invalid_argument("--out is missing: where should the map go?");
  return options;
}

const char* mapLogUsage() {
  return R"(usage: map_log LOG --out PREFIX [options]

Makes a map of a recorded drive. LOG is a CSV file (stamp, odometry x, y, yaw,
ranges from right to left), a CARMEN log (FLASER or ROBOTLASER1) or a rosbag.

  --out PREFIX         where the results go:
                         PREFIX.pgm .yaml   the map, for map_server
                         PREFIX.bt          the map, for OctoMap
                         PREFIX.tum         the corrected trajectory of all scans
                         PREFIX_odom.tum    the odometry
                         PREFIX.png         a picture: map, odometry (red),
                                            trajectory (blue), closures (green)
  --relations FILE     lines "i j dx dy dyaw": prints how far odometry and the
                       corrected trajectory are from them
  --resolution METRES  side of the map's cells, 0.01 to 10 (0.05)
  --range METRES       longer ranges are no returns (as the log says; CSV, FLASER: 80)
  --fov DEGREES        field of view, where the log does not say (180)
  --mount X Y YAW      where the scanner sits on the base [m m rad] (as the log
                       says; CSV: 0.78 0 0). A rosbag says this and the field of
                       view itself: with one of them it is refused
  --scan TOPIC, --odom TOPIC, --base FRAME
                       of a rosbag (it chooses the topics, and says which where
                       there are several; base_footprint)
  -h, --help           this text

Exit code: 0 done, 1 a file cannot be read or written, 2 wrong arguments.

Example:
  map_log drive.csv --out /tmp/drive --relations drive.relations
)";
}

}  // namespace frontier_pilot::tools
