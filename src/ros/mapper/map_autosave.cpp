#include <ros/this_node.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <thread>
#include <utility>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/map_files/map_io.h"
#include "ros/common/clock.h"
#include "ros/common/master/ros_sessions.h"
#include "ros/common/memory/disk.h"
#include "ros/mapper/map_autosave.h"

namespace frontier_pilot {
namespace {

namespace fs = std::filesystem;

constexpr Duration kMadeAnew = std::chrono::minutes(1);

/// Records that the copy which is on the disk is of a map that was replaced. Returns what follows if that cannot be.
std::string disown(const SessionMemory& replaced) {
  return replaced.remember("replaced").empty() ? "" : "the previous map would come back";
}

std::string joined(const std::string& problem, const std::string& more) {
  return more.empty() ? problem : problem + "; " + more;
}

/// Moves the copy of the previous map to the folder `lost`, so that no mapper continues with it after the loaded map
/// could not be saved. Returns what to add to the problem.
std::string setPreviousAside(const SessionMemory& memory, const SessionMemory& replaced) {
  std::string words;
  for (const fs::path& base : memory.files()) {
    if (!kept_map::exists(base)) continue;
    const std::string lost = kept_map::setAside(base);
    if (lost.empty()) return disown(replaced);
    words = "the copy of the previous map is kept: " + kept_map::whereItIs(lost);
  }
  memory.forget();
  return words;
}

/// Returns why it could not be saved; empty if it was. If the copy that is there is of the previous map, `lost` is the
/// pose, marked as one at which the robot has to be looked for; else it is empty.
std::string save(const map_files::MapSnapshot& map, const SavedPose& pose, const std::string& lost,
                 const SessionMemory& memory, const SessionMemory& replaced, const std::atomic<bool>& wanted) {
  if (memory.files().empty()) return "the ROS session has no name";
  const fs::path base = memory.files().front();
  std::error_code error;
  fs::create_directories(base.parent_path(), error);
  if (!lost.empty() && kept_map::exists(base)) {
    // With whichever of the two maps a mapper begins, its pose is not that of the other one.
    const std::string problem = kept_map::tryForAWhile([&] { return memory.remember(lost); });
    if (!problem.empty()) return joined(problem, setPreviousAside(memory, replaced));
  }
  const map_files::MapIoResult result = map_files::saveMap(map, base.string(), Survives::kProcessDeath);
  if (!result.ok()) return lost.empty() ? result.text : joined(result.text, setPreviousAside(memory, replaced));
  kept_map::removeOldest(base);
  // Once the map is not wanted any more, a pose would have the next mapper continue with it.
  return kept_map::tryForAWhile([&] { return wanted ? pose.keepIn(memory) : std::string(); });
}

/// What `job` says that went wrong, or the exception that it threw; empty if nothing did.
std::string tried(const std::function<std::string()>& job) {
  try {
    return job();
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "an exception of unknown type";
  }
}

/// Returns why the pose could not be removed; empty if it was.
std::string discard(const SessionMemory& memory) {
  for (const fs::path& base : memory.files()) kept_map::removeFiles(base);
  return memory.forgetPatiently();
}

}  // namespace

MapAutosave::MapAutosave(const std::string& map_file) : MapAutosave(map_file, rosSessions()) {}

MapAutosave::MapAutosave(const std::string& map_file, const std::vector<std::string>& sessions)
    : map_file_(mapFileName(map_file)),
      memory_(rosHome(), sessions, "kept_map", ros::this_node::getName(), SessionMemory::Owner::kNode),
      replaced_({}, sessions, "replaced_map", ros::this_node::getName(), SessionMemory::Owner::kLastingNode,
                spareFolder()),
      wanted_(std::make_shared<std::atomic<bool>>(true)),
      current_(std::make_shared<std::atomic<bool>>(true)),
      done_(std::make_shared<Mailbox<Saved>>()) {}

std::optional<std::filesystem::path> MapAutosave::find() const {
  // The map lies beside the pose for the first name that the session had when it was saved.
  std::vector<fs::path> bases = memory_.findAll();
  const std::vector<fs::path>& own = memory_.files();
  bases.insert(bases.end(), own.begin(), own.end());
  const auto found = std::find_if(bases.begin(), bases.end(), kept_map::exists);
  return found == bases.end() ? std::nullopt : std::make_optional(*found);
}

std::optional<KeptPose> MapAutosave::recall() const {
  for (const std::string& text : memory_.recallAll()) {
    if (auto pose = toKeptPose(text)) return pose;
  }
  return std::nullopt;
}

std::optional<std::string> MapAutosave::otherMapFile() const {
  const std::optional<KeptPose> pose = recall();
  const bool is_of_another = pose && pose->map_file && *pose->map_file != map_file_;
  return is_of_another && find() ? pose->map_file : std::nullopt;
}

/// Moves the files, not the pose. Returns their new base; empty if they could not be moved.
std::string MapAutosave::moveAside() {
  const std::optional<fs::path> base = find();
  std::string lost = base ? kept_map::setAside(*base) : std::string();
  if (!lost.empty()) replaced_.forget();
  return lost;
}

std::string MapAutosave::putAside() {
  std::string lost = moveAside();
  if (!lost.empty()) memory_.forget();
  return lost;
}

std::optional<LeftCopy> MapAutosave::leave(Duration patience) {
  noteEnd();
  if (superseded_ || unwanted_) return LeftCopy{};  // it is of a map that was replaced
  *current_ = false;                                // so that a save which is under way does not take back what follows
  disown(replaced_);                                // wherever it is, no mapper goes on with it by itself
  if (isSaving() && !memory_.files().empty()) return LeftCopy{memory_.files().front().string(), true};
  return PatientThread(patience).run<LeftCopy>([own = *this]() mutable {
    std::string lost = own.putAside();
    const std::optional<fs::path> base = own.find();  // on a disk that is full
    return LeftCopy{lost.empty() && base ? base->string() : lost, false};
  });
}

std::optional<MapPose> MapAutosave::restore(occupancy::OccupancyMap& map) const {
  const std::optional<fs::path> base = find();
  if (!base && memory_.recallAll().empty()) return std::nullopt;
  if (base && replaced_.recall()) throw std::runtime_error("what is kept is not the map to go on with");
  const std::optional<KeptPose> pose = recall();
  if (!pose) throw std::runtime_error("the pose that was saved with it cannot be read");
  if (!base) throw std::runtime_error("its files are gone" + keptBefore());
  const map_files::MapIoResult result = map_files::loadMap(base->string(), map);
  if (!result.ok()) throw std::runtime_error(result.text);
  return *pose;
}

/// Where an earlier map is that was put aside, and that nobody has confirmed to be lost.
std::string MapAutosave::keptBefore() const {
  for (const fs::path& base : memory_.files()) {
    const std::string lost = kept_map::lastSetAside(base);
    if (!lost.empty()) return "; those of the one before it are kept: " + kept_map::whereItIs(lost);
  }
  return {};
}

void MapAutosave::save(occupancy::OccupancyMap& map, const MapPose& pose, MapContent has, const Run& run) {
  const SteadyTime now = steadyNow();
  const std::uint64_t content = has.scans + has.rendered;
  noteMapping(content, now);
  if (!discardUnwanted()) {  // removed later on, it would take what is saved now with it
    problem_ = "the copy of a map that was given up cannot be removed: the disk does not answer";
    return;
  }
  remember(pose, has.rendered);
  if (map.isBlank()) problem_ = memory_.problem();
  if (map.isBlank() || !schedule_.isDue(content, now)) return;
  ended_ = std::make_shared<std::atomic<bool>>(false);
  saved_pose_ = std::make_shared<SavedPose>(textOf(pose), has.rendered);
  run([snapshot = map_files::takeSnapshot(map), kept = saved_pose_, memory = memory_, replaced = replaced_,
       wanted = wanted_, current = current_, done = done_, ended = ended_, rendered = has.rendered,
       lost = superseded_ ? textOf({pose.T_map_odom, false}) : std::string()] {
    const SteadyTime begun = steadyNow();
    std::string problem = tried([&] {
      std::string why;
      if (*wanted) why = frontier_pilot::save(snapshot, *kept, lost, memory, replaced, *wanted);
      if (*wanted) return why;
      discard(memory);  // its files may have been removed while they were read back, which is no problem
      return std::string();
    });
    const SteadyTime at = steadyNow();
    const bool is_kept = problem.empty() && *current;
    done->put({std::move(problem), at, at - begun, rendered});
    if (is_kept) replaced.forget();
    *ended = true;
  });
  schedule_.begin(content, now);
}

void MapAutosave::noteEnd() {
  auto done = done_->take();
  if (!done) return;
  problem_ = std::move(done->problem);
  schedule_.end(problem_.empty(), done->at, done->took);
  if (!problem_.empty()) return;
  rendered_ = done->rendered;
  if (schedule_.hasCopy()) superseded_ = false;
}

std::string MapAutosave::whyNotSaved() {
  const auto is_saved = [this] { return noteEnd(), schedule_.hasCopy(); };
  if (is_saved()) return {};
  if (!isSaving() && !problem_.empty()) return problem_;
  const std::string comes_back = disown(replaced_);
  if (!is_saved()) return joined("it is still being saved", comes_back);
  replaced_.forget();  // the save may have ended before that was recorded
  return {};
}

void MapAutosave::remember(const MapPose& pose, std::uint64_t rendered) {
  noteEnd();
  if (saved_pose_) saved_pose_->renew(textOf(pose), rendered);  // of a save under way, which would write an older one
  // Without a map the pose would be that of a map that was lost, and on one of before a closed loop the robot is
  // elsewhere: the pose of the copy stays, but not the time by which a mapper in another session recognises it.
  if (!schedule_.hasCopy()) {
    pose_problem_.clear();
  } else if (rendered == rendered_) {
    pose_problem_ = memory_.remember(textOf(pose));
  } else {
    pose_problem_ = onDisk([poses = memory_.files()] { return kept_map::renew(poses); });
  }
}

void MapAutosave::noteMapping(std::uint64_t content, SteadyTime now) {
  if (loss_.empty() || content == 0) return;
  if (!mapping_since_) mapping_since_ = now;
  if (now - *mapping_since_ >= kMadeAnew) loss_.clear();
}

void MapAutosave::lose(const std::string& why) {
  const std::string lost = moveAside();
  loss_ = lost.empty() ? why
                       : why + "; its files are kept, of which the picture is read if the .bt is moved away: " +
                             kept_map::whereItIs(lost);
  mapping_since_.reset();
}

std::string MapAutosave::tell(MemoryReport& report) const {
  const std::string delay = problem().empty() ? schedule_.delay(steadyNow()) : std::string();
  const std::string counts = report.setProblem("the map", delay.empty() ? problem() : delay);
  report.setLoss("the map that the mapper had when it died", loss_);
  return delay.empty() ? counts : std::string();
}

void MapAutosave::supersede() {
  loss_.clear();
  schedule_.discard();
  superseded_ = true;
  saved_pose_.reset();
  *current_ = false;
  current_ = std::make_shared<std::atomic<bool>>(true);
}

std::string MapAutosave::forget(Duration patience) {
  supersede();
  *wanted_ = false;
  wanted_ = std::make_shared<std::atomic<bool>>(true);
  unwanted_ = memory_;
  std::string comes_back = disown(replaced_);
  const SteadyTime end = steadyNow() + patience;
  std::optional<std::string> problem;
  while (!(problem = discardUnwanted()) && steadyNow() < end) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  return problem && problem->empty() ? std::string() : comes_back;
}

std::optional<std::string> MapAutosave::discardUnwanted() {
  if (!unwanted_) return std::string();
  // The jobs on the disk follow each other: when this one has ended, those before it that were late have as well.
  auto problem = diskThread().run<std::string>([memory = *unwanted_] { return discard(memory); });
  if (problem) unwanted_.reset();
  if (problem && problem->empty()) replaced_.forget();
  return problem;
}

void MapAutosave::enter(const std::vector<std::string>& sessions) {
  replaced_.enter(sessions);
  if (memory_.enter(sessions)) schedule_.discard();
}

}  // namespace frontier_pilot
