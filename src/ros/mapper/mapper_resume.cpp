// A mapper that is restarted after it died continues with the map that it had. [FLT-2]
#include <ros/console.h>

#include <chrono>
#include <cstdlib>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/text.h"
#include "ros/common/clock.h"
#include "ros/common/master/registration.h"
#include "ros/common/node_main.h"
#include "ros/common/throttled_log.h"
#include "ros/mapper/mapper_adapter.h"

namespace frontier_pilot {
namespace {

/// For the last copy: with what follows a node ends within the 15 s after which roslaunch ends it.
constexpr Duration kLastCopy = std::chrono::seconds(8);

/// Why the map is only in the copy although it was wanted elsewhere: somebody had it saved in vain, or scripts/run,
/// which saves it before it ends this node, did not come to that. Empty if it was saved, or nobody wanted it.
std::string whyUnsaved(MapSaver& saver) {
  std::string why = saver.saves().whyNotSaved();
  const bool is_promised = std::getenv("FRONTIER_PILOT_RUN") != nullptr;  // set by scripts/run
  if (!why.empty() || !is_promised) return why;
  if (!saver.way().wasSaved()) return "because the mapper ended before that";
  if (!saver.way().hasGoneOn(steadyNow())) return {};
  return "because the mapper ended before it was saved once more, with what was mapped since";
}

std::string whereItIs(const std::optional<LeftCopy>& copy) {
  if (!copy) return "nor can its copy be put aside, because the disk of ROS_HOME does not answer";
  const std::string argument = "map_file:=" + copy->base + ".yaml begins with it";
  if (!copy->is_being_written) return "its copy is kept: " + argument;
  return "its copy is still being written, because the disk of ROS_HOME is slow or does not answer: " + argument +
         ", or with an older one";
}

}  // namespace

void MapperAdapter::restore() {
  Restored restored{occupancy::OccupancyMap(parameters_.mapper.map), {}};
  try {
    const std::optional<MapPose> pose = autosave_.restore(restored.map);
    if (!pose) return;
    restored.pose = *pose;
    restored_.emplace(std::move(restored));
  } catch (const std::exception& error) {
    autosave_.lose(error.what());
    ROS_ERROR_STREAM("the map that the mapper had when it died is lost: " << autosave_.loss());
  }
}

/// A map of another launch at the same master is not what this one is to begin with.
void MapperAdapter::putAside(const std::string& other_map_file) {
  const auto beginning = [](const std::string& map_file) {
    return map_file.empty() ? std::string("without a map_file") : "with the map_file " + map_file;
  };
  const std::string lost = autosave_.putAside();
  ROS_WARN_STREAM(
      "the mapper does not continue with the map of one that died, because that one began "
      << beginning(other_map_file) << ", and this one begins " << beginning(mapFileName(parameters_.map_file))
      << "; its files "
      << (lost.empty() ? "could not be put aside, and will be replaced" : "are kept: " + kept_map::whereItIs(lost)));
}

/// Continues with that map, once the first odometry message has come.
void MapperAdapter::resume(const Pose2& T_odom_base) {
  if (!restored_) return;
  const MapPose& pose = restored_->pose;
  if (mapper_.resume(restored_->map, pose.T_map_odom, T_odom_base, pose.localized)) {
    ROS_WARN("continuing with the map that the mapper had when it died");
  } else {
    autosave_.lose("it is too large");
    ROS_ERROR_STREAM("the map that the mapper had when it died is lost: " << autosave_.loss());
  }
  restored_.reset();
}

void MapperAdapter::sayLastWords() {
  if (restored_) {
    ROS_WARN("the map that the mapper had when it died is kept: no odometry came by which it could continue with it");
    return;
  }
  if (nameIsTaken()) {
    ROS_WARN("another process took this node's name: the map is left for the mapper that is started after it");
    return;
  }
  const bool is_kept = leaveUnsaved();
  if (!is_kept) autosave_.forget(std::chrono::seconds(5));
  // The threads that save may hang; but one that saves a map of which there is no copy is waited for.
  if (is_kept || autosave_.isForgetting()) limitTheEndAnyway();
}

/// A map that could not be saved where somebody wanted it stays in the copy, put aside so that no mapper goes on with
/// it by itself. Returns whether there is such a copy.
bool MapperAdapter::leaveUnsaved() {
  if (whyUnsaved(saver_).empty()) return false;
  if (ros::ok()) {  // else the threads that save have ended
    const SteadyTime end = steadyNow() + kLastCopy;
    awaitAutosave(kLastCopy);  // one that is under way lacks what came since
    autosave_.hurry();
    autosave();
    awaitAutosave(end - steadyNow());
  }
  const std::string why = whyUnsaved(saver_);
  if (why.empty()) return false;  // it has been saved meanwhile
  const auto lost = autosave_.leave(std::chrono::seconds(3));
  if (lost && lost->base.empty()) return false;
  ROS_WARN_STREAM("the map was not saved, " << printable(why, bounds::kMostLine) << "; " << whereItIs(lost));
  return true;
}

void MapperAdapter::rememberPose() {
  autosave_.remember({T_map_odom(), mapper_.isLocalized()}, mapper_.revisions().rendered);
}

void MapperAdapter::autosave() {
  if (parameters_.autosave_period == 0.0) return;
  if (const auto session = session_.take()) autosave_.enter(*session);
  if (restored_) return;  // the copy that is there is worth more than what the mapper has until it continues with it
  const MapContent content{mapper_.counts()[mapping::ScanVerdict::kInserted], mapper_.revisions().rendered};
  autosave_.save(mapper_.map(), {T_map_odom(), mapper_.isLocalized()}, content,
                 [this](std::function<void()> job) { saver_.run(std::move(job)); });
  const std::string problem = autosave_.tell(connections_.memory());
  if (problem == std::exchange(warned_of_, problem) || problem.empty()) return;
  THROTTLED_WARN("the map would not survive this node: " << problem);
}

}  // namespace frontier_pilot
