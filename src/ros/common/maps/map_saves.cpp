#include "ros/common/maps/map_saves.h"

#include <algorithm>
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

std::filesystem::path pathOf(const std::string& path) {
  std::error_code error;
  return std::filesystem::absolute(path, error).lexically_normal();
}

std::string unended(const std::string& path) {
  return "saving to " + printable(path, bounds::kMostLine) + " has not ended";
}

std::string unended(const std::string& path, Duration took) {
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(took).count();
  return unended(path) + " for " + std::to_string(seconds) + " s: its disk is slow or does not answer";
}

MapIoResult tried(const std::function<MapIoResult()>& save) {
  try {
    return save();
  } catch (const std::exception& error) {
    return {MapIoStatus::kCannotWrite, error.what()};
  }
}

}  // namespace

bool MapSaves::isBeingSaved(const std::string& path) const {
  const auto& under_way = state_->under_way;
  const std::filesystem::path wanted = pathOf(path);
  return std::any_of(under_way.begin(), under_way.end(),
                     [&](const auto& save) { return pathOf(save.second.path) == wanted; });
}

std::string MapSaves::refusal(const std::string& path) const {
  const std::lock_guard<std::mutex> lock(state_->mutex);
  return refusal(path, steadyNow());
}

/// Says the same each time that it is asked, so that nobody who tries again and again logs it as news.
std::string MapSaves::refusal(const std::string& path, SteadyTime now) const {
  const std::map<std::uint64_t, Save>& under_way = state_->under_way;
  const std::filesystem::path folder = pathOf(path).parent_path();
  for (const auto& [number, save] : under_way) {
    if (now - save.begun < patience_ || pathOf(save.path).parent_path() != folder) continue;
    return unended(save.path) + ": until it does, no other map is saved in that folder";
  }
  if (under_way.size() < kMost) return {};
  return unended(under_way.begin()->second.path) + ", and " + std::to_string(kMost) +
         " maps are being saved already: no other one is meanwhile";
}

MapIoResult MapSaves::refuse(const std::string& why) {
  const std::lock_guard<std::mutex> lock(state_->mutex);
  ++state_->begun;  // one that ended later would be of an earlier map
  state_->last = why;
  return {MapIoStatus::kCannotWrite, why};
}

void MapSaves::expect(const std::string& path) {
  refuse("saving to " + printable(path, bounds::kMostLine) + " was not begun");
}

MapIoResult MapSaves::run(const std::string& path, const std::function<MapIoResult()>& save) {
  PatientThread thread(patience_);
  std::unique_lock<std::mutex> lock(state_->mutex);
  const bool is_free = state_->ended.wait_for(lock, patience_, [&] { return !isBeingSaved(path); });
  const std::string refused = is_free ? refusal(path, steadyNow()) : unended(path, patience_);
  if (!refused.empty()) {
    lock.unlock();
    return refuse(refused);
  }
  const std::uint64_t number = ++state_->begun;
  state_->under_way[number] = {path, steadyNow()};
  state_->last = unended(path);
  lock.unlock();
  const auto result = thread.run<MapIoResult>([state = state_, number, save] {
    MapIoResult saved = tried(save);
    const std::lock_guard<std::mutex> state_lock(state->mutex);
    state->under_way.erase(number);
    if (number == state->begun) state->last = saved.ok() ? std::string() : saved.text;
    state->ended.notify_all();
    return saved;
  });
  return result ? *result : MapIoResult{MapIoStatus::kCannotWrite, unended(path, patience_)};
}

std::string MapSaves::delay(SteadyTime now) const {
  const std::lock_guard<std::mutex> lock(state_->mutex);
  if (state_->under_way.empty()) return {};
  const Save& oldest = state_->under_way.begin()->second;
  return now - oldest.begun < kWorthSaying ? std::string() : unended(oldest.path, now - oldest.begun);
}

std::string MapSaves::whyNotSaved() const {
  const std::lock_guard<std::mutex> lock(state_->mutex);
  return state_->last;
}

}  // namespace frontier_pilot
