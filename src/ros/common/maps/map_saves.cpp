#include "ros/common/maps/map_saves.h"

#include <exception>
#include <filesystem>
#include <utility>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/text.h"
#include "ros/common/clock.h"
#include "ros/common/threads/patient_thread.h"

namespace frontier_pilot {
namespace {

using map_files::MapIoResult;
using map_files::MapIoStatus;

constexpr Duration kWorthSaying = std::chrono::seconds(5);

std::filesystem::path folderOf(const std::string& path) {
  std::error_code error;
  return std::filesystem::absolute(path, error).lexically_normal().parent_path();
}

std::string unended(const std::string& path, Duration took) {
  return "saving to " + printable(path, bounds::kMostLine) + " has not ended for " +
         std::to_string(std::chrono::duration_cast<std::chrono::seconds>(took).count()) + " s";
}

MapIoResult tried(const std::function<MapIoResult()>& save) {
  try {
    return save();
  } catch (const std::exception& error) {
    return {MapIoStatus::kCannotWrite, error.what()};
  }
}

}  // namespace

std::string MapSaves::refusal(const std::string& path) const {
  const std::lock_guard<std::mutex> lock(state_->mutex);
  return refusal(path, steadyNow());
}

std::string MapSaves::refusal(const std::string& path, SteadyTime now) const {
  const std::map<std::uint64_t, Save>& under_way = state_->under_way;
  const std::filesystem::path folder = folderOf(path);
  for (const auto& [number, save] : under_way) {
    if (now - save.begun < patience_ || folderOf(save.path) != folder) continue;
    return unended(save.path, now - save.begun) + ": until it does, no other map is saved in that folder";
  }
  if (under_way.size() < kMost) return {};
  const Save& oldest = under_way.begin()->second;
  return unended(oldest.path, now - oldest.begun) + ", and " + std::to_string(kMost) +
         " maps are being saved already: no other one is meanwhile";
}

MapIoResult MapSaves::run(const std::string& path, const std::function<MapIoResult()>& save) {
  std::uint64_t number = 0;
  {
    const std::lock_guard<std::mutex> lock(state_->mutex);
    std::string refused = refusal(path, steadyNow());
    if (!refused.empty()) return {MapIoStatus::kCannotWrite, std::move(refused)};
    number = ++state_->begun;
    state_->under_way[number] = {path, steadyNow()};
    state_->last = "saving to " + printable(path, bounds::kMostLine) + " has not ended";
  }
  PatientThread thread(patience_);
  const auto result = thread.run<MapIoResult>([state = state_, number, save] {
    MapIoResult saved = tried(save);
    const std::lock_guard<std::mutex> lock(state->mutex);
    state->under_way.erase(number);
    if (number == state->begun) state->last = saved.ok() ? std::string() : saved.text;
    return saved;
  });
  return result ? *result
                : MapIoResult{MapIoStatus::kCannotWrite,
                              unended(path, patience_) + ": its disk is slow or does not answer"};
}

std::string MapSaves::delay(SteadyTime now) const {
  const std::lock_guard<std::mutex> lock(state_->mutex);
  if (state_->under_way.empty()) return {};
  const Save& oldest = state_->under_way.begin()->second;
  return now - oldest.begun < kWorthSaying
             ? std::string()
             : unended(oldest.path, now - oldest.begun) + ": its disk is slow or does not answer";
}

std::string MapSaves::whyNotSaved() const {
  const std::lock_guard<std::mutex> lock(state_->mutex);
  return state_->last;
}

}  // namespace frontier_pilot
