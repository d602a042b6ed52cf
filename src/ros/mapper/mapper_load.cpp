#include <Eigen/Core>
#include <array>
#include <chrono>
#include <filesystem>
#include <iomanip>
#include <optional>
#include <thread>
#include <utility>

#include "frontier_pilot/core/bounds.h"
#include "ros/common/clock.h"
#include "ros/common/messages/conversions.h"
#include "ros/common/parameters.h"
#include "ros/common/tf/frame_name.h"
#include "ros/common/throttled_log.h"
#include "ros/mapper/mapper_adapter.h"

namespace frontier_pilot {
namespace {

/// The covariance of x, y and yaw from the 6 x 6 matrix of a geometry_msgs/PoseWithCovariance [m^2, m rad, rad^2];
/// nothing if it is not finite or a variance is negative.
std::optional<Eigen::Matrix3d> covarianceOf(const geometry_msgs::PoseWithCovariance& msg) {
  using Covariance6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
  const std::array<int, 3> axes = {0, 1, 5};
  const Eigen::Matrix3d covariance = Eigen::Map<const Covariance6>(msg.covariance.data())(axes, axes);
  const bool usable = covariance.allFinite() && covariance.diagonal().minCoeff() >= 0.0;
  return usable ? std::optional<Eigen::Matrix3d>(covariance) : std::nullopt;
}

void sayLoaded(const map_files::MapIoResult& result) {
  if (result.doubtful) {
    THROTTLED_WARN(result.text);
  } else {
    THROTTLED_INFO(result.text);
  }
}

}  // namespace

/// Loads `map_file` and then the copy of the map that this mapper had when it died, which replaces it before anybody
/// has seen it. With a copy, a file that cannot be read any more is no reason not to start. A copy of a mapper that
/// began with another file is put aside. [FLT-2]
void MapperAdapter::loadFirstMap(const ros::NodeHandle& private_node) {
  std::string problem;
  if (!parameters_.map_file.empty()) {
    const map_files::MapIoResult result = load(parameters_.map_file);
    if (result.ok()) sayLoaded(result);
    if (!result.ok()) problem = "map_file: " + result.text;
  }
  const auto other = parameters_.autosave_period > 0.0 ? autosave_.otherMapFile() : std::nullopt;
  if (parameters_.autosave_period > 0.0 && !other) restore();
  if (problem.empty() && other) putAside(*other);
  if (problem.empty()) return;
  if (!restored_) throw ConfigurationError(private_node.getNamespace(), {problem});
  ROS_ERROR_STREAM("not loaded, " << problem
                                  << "; the mapper goes on with the copy of the map that it had when it died");
}

map_files::MapIoResult MapperAdapter::load(const std::string& path) {
  occupancy::OccupancyMap loaded(parameters_.mapper.map);
  map_files::MapIoResult result = map_files::loadMap(path, loaded);
  if (result.ok() && !mapper_.load(loaded))
    return {map_files::MapIoStatus::kBroken, path + ": too large, see docs/limits.md"};
  if (!result.ok()) return result;
  looked_for_ = true;
  return result;
}

bool MapperAdapter::handleLoad(LoadMap::Request& request, LoadMap::Response& response) {
  // So that an answer names the folder that a relative path begins in.
  const std::string path = request.path.empty() ? "" : std::filesystem::absolute(request.path).string();
  const map_files::MapIoResult result = load(path);
  response.success = static_cast<std::uint8_t>(result.ok());
  response.message = result.text;
  if (result.ok()) {
    publisher_.announceReplacement(result.text);
    sayLoaded(result);
    response.message += afterDeath("the map that was loaded", keepLoaded());
  } else {
    THROTTLED_ERROR("map not loaded, " << toString(result.status) << ": " << result.text);
  }
  return true;
}

/// A mapper that dies after its answer has the map that was loaded. Returns why it would not; empty if it would, or if
/// no map is to be kept.
std::string MapperAdapter::keepLoaded() {
  restored_.reset();  // a map that was kept is not wanted any more
  if (parameters_.autosave_period == 0.0 || mapper_.map().isBlank()) {
    std::string problem = autosave_.forget();  // nothing will replace the copy
    awaitAutosave();
    return problem;
  }
  autosave_.supersede();
  awaitAutosave();  // that of the map of before, which may be under way
  autosave();
  awaitAutosave();
  return autosave_.whyNotSaved();
}

std::string MapperAdapter::afterDeath(const std::string& what, const std::string& problem) {
  if (problem.empty()) return {};
  THROTTLED_WARN(what << " would not survive this node: " << problem);
  return "; would not survive this node: " + problem;
}

void MapperAdapter::awaitAutosave(Duration patience) {
  const SteadyTime end = steadyNow() + patience;
  while (autosave_.isSaving() && steadyNow() < end) {
    saver_.provide(mapper_.map());  // for a call of save_map meanwhile
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

void MapperAdapter::handleInitialPose(const geometry_msgs::PoseWithCovarianceStamped& msg) {
  std::string why = "frame '" + msg.header.frame_id + "' is not '" + parameters_.map_frame + "'";
  const bool in_map = isSameFrame(msg.header.frame_id, parameters_.map_frame);
  const auto pose = in_map ? toPose(msg.pose.pose, &why) : std::nullopt;
  const auto covariance = covarianceOf(msg.pose);
  if (pose && !covariance) why = "invalid covariance";
  if (!pose || !covariance) return bad_initial_poses_.add(why);
  // From there the transform to odom, which is another pose, could lie beyond the bound on coordinates.
  if (!bounds::isWithin(pose->position().cwiseAbs().maxCoeff(), bounds::kMostCoordinate / 2))
    return bad_initial_poses_.add("farther than 500 km from the map's origin");
  if (!mapper_.locate({*pose, *covariance})) return bad_initial_poses_.add(mapper_.whyNotFound());
  looked_for_ = true;
  rememberPose();
  THROTTLED_INFO("looking for the robot around " << std::fixed << std::setprecision(2) << pose->x << ", " << pose->y);
}

/// Once after each time that the robot had to be looked for on a known map.
void MapperAdapter::sayWhereLocalised(mapping::ScanVerdict verdict, const Pose2& T_map_base) {
  using mapping::ScanVerdict;
  const bool is_lost = verdict == ScanVerdict::kNotLocated;
  if (is_lost && !std::exchange(looked_for_, true)) rememberPose();  // so that a respawned mapper looks for it as well
  const bool fits = verdict == ScanVerdict::kInserted || verdict == ScanVerdict::kLocalized;
  if (!fits || !std::exchange(looked_for_, false)) return;
  rememberPose();
  THROTTLED_INFO("localised: the robot is at " << std::fixed << std::setprecision(2) << T_map_base.x << ", "
                                               << T_map_base.y << ", " << std::setprecision(0)
                                               << T_map_base.yaw * 180.0 / kPi << " deg on the map");
}

}  // namespace frontier_pilot
