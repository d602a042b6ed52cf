#include <ros/this_node.h>

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/map_files/map_io.h"
#include "ros/common/clock.h"
#include "ros/common/master/ros_sessions.h"
#include "ros/common/memory/disk.h"
#include "ros/common/messages/message_problems.h"
#include "ros/mapper/kept_map.h"
#include "ros/mapper/map_autosave.h"

namespace frontier_pilot {
namespace {

namespace fs = std::filesystem;

constexpr Duration kMadeAnew = std::chrono::minutes(1);
constexpr int kRest = 20;  // pause after saving, in multiples of the time that saving took

/// With all digits, so that exactly the same pose is read back.
std::string toText(const Pose2& pose) {
  std::ostringstream text;
  text << std::setprecision(std::numeric_limits<double>::max_digits10) << pose.x << ' ' << pose.y << ' ' << pose.yaw;
  return text.str();
}

/// Nothing if it is no pose, or one that no robot can have.
std::optional<Pose2> toPose(const std::string& text) {
  std::istringstream in(text);
  Pose2 pose;
  if (!(in >> pose.x >> pose.y >> pose.yaw)) return std::nullopt;
  const bool has_place = problemOfPlace(pose.x, pose.y, 0.0).empty();
  return has_place && bounds::isWithin(pose.yaw, 2.0 * kPi) ? std::make_optional(pose) : std::nullopt;
}

/// Returns why it could not be saved; empty if it was.
std::string save(const map_files::MapSnapshot& map, const Pose2& T_map_odom, const SessionMemory& memory) {
  if (memory.files().empty()) return "the ROS session has no name";
  const fs::path base = memory.files().front();
  std::error_code error;
  fs::create_directories(base.parent_path(), error);
  const map_files::MapIoResult result = map_files::saveMap(map, base.string(), Survives::kProcessDeath);
  if (!result.ok()) return result.text;
  kept_map::removeOldest(base);
  return memory.remember(toText(T_map_odom));
}

void discard(const SessionMemory& memory) {
  for (const fs::path& base : memory.files()) kept_map::removeFiles(base);
  memory.forget();
}

}  // namespace

MapAutosave::MapAutosave()
    : memory_(rosHome(), rosSessions(), "kept_map", ros::this_node::getName(), SessionMemory::Owner::kNode),
      wanted_(std::make_shared<std::atomic<bool>>(true)),
      done_(std::make_shared<Mailbox<Saved>>()) {}

std::optional<std::filesystem::path> MapAutosave::find() const {
  // The map lies beside the pose for the first name that the session had when it was saved.
  std::vector<fs::path> bases = memory_.findAll();
  const std::vector<fs::path>& own = memory_.files();
  bases.insert(bases.end(), own.begin(), own.end());
  const auto found = std::find_if(bases.begin(), bases.end(), kept_map::exists);
  return found == bases.end() ? std::nullopt : std::make_optional(*found);
}

std::optional<Pose2> MapAutosave::restore(occupancy::OccupancyMap& map) const {
  const std::optional<fs::path> base = find();
  const std::vector<std::string> texts = memory_.recallAll();
  if (!base && texts.empty()) return std::nullopt;
  std::optional<Pose2> T_map_odom;
  for (auto text = texts.begin(); !T_map_odom && text != texts.end(); ++text) T_map_odom = toPose(*text);
  if (!T_map_odom) throw std::runtime_error("the pose that was saved with it cannot be read");
  if (!base) throw std::runtime_error("its files are gone" + keptBefore());
  const map_files::MapIoResult result = map_files::loadMap(base->string(), map);
  if (!result.ok()) throw std::runtime_error(result.text);
  return T_map_odom;
}

/// Where an earlier map is that was put aside, and that nobody has confirmed to be lost.
std::string MapAutosave::keptBefore() const {
  for (const fs::path& base : memory_.files()) {
    const std::string lost = kept_map::lastSetAside(base);
    if (!lost.empty()) return "; those of the one before it are kept, mapper/load_map may still read " + lost;
  }
  return {};
}

void MapAutosave::save(occupancy::OccupancyMap& map, const Pose2& T_map_odom, std::uint64_t content, MapSaver& saver) {
  const SteadyTime now = steadyNow();
  if (auto done = done_->take()) {
    problem_ = std::move(done->problem);
    next_ = done->at + kRest * done->took;
    saving_ = false;
    if (!problem_.empty()) saved_content_.reset();
  }
  noteMapping(content, now);
  if (saving_) return;
  if (content == saved_content_) {  // renews the time stamp, by which a mapper in another session recognises it
    problem_ = memory_.remember(toText(T_map_odom));
    return;
  }
  if (map.empty()) problem_ = memory_.problem();
  if (now < next_ || map.empty()) return;
  saving_ = true;
  saved_content_ = content;
  saver.run([snapshot = map_files::takeSnapshot(map), T_map_odom, memory = memory_, wanted = wanted_, done = done_] {
    const SteadyTime begun = steadyNow();
    std::string problem = *wanted ? frontier_pilot::save(snapshot, T_map_odom, memory) : std::string();
    if (!*wanted) discard(memory);
    const SteadyTime at = steadyNow();
    done->put({std::move(problem), at, at - begun});
  });
}

void MapAutosave::noteMapping(std::uint64_t content, SteadyTime now) {
  if (loss_.empty() || content == 0) return;
  if (!mapping_since_) mapping_since_ = now;
  if (now - *mapping_since_ >= kMadeAnew) loss_.clear();
}

void MapAutosave::replace() {
  saved_content_.reset();
  loss_.clear();
}

void MapAutosave::lose(const std::string& why) {
  const std::optional<fs::path> base = find();
  const std::string lost = base ? kept_map::setAside(*base) : std::string();
  loss_ = lost.empty() ? why
                       : why + "; its files are kept: mapper/load_map may still read " + lost +
                             ", or its picture if the .bt is moved away";
  mapping_since_.reset();
}

void MapAutosave::tell(MemoryReport& report) const {
  report.setProblem("the map", problem_);
  report.setLoss("the map that the mapper had when it died", loss_);
}

void MapAutosave::forget() {
  loss_.clear();
  saved_content_.reset();  // or the pose alone would be kept, without a map
  *wanted_ = false;
  wanted_ = std::make_shared<std::atomic<bool>>(true);
  discard(memory_);
}

void MapAutosave::enter(const std::vector<std::string>& sessions) {
  if (memory_.enter(sessions)) saved_content_.reset();
}

}  // namespace frontier_pilot
