#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "frontier_pilot/core/time.h"
#include "frontier_pilot/map_files/map_io.h"

namespace frontier_pilot {

/// The saves of a map that are under way, each on a thread of its own: a disk that hangs holds up no save to another
/// one, and is waited for only so long. Safe to use from several threads. [FLT-1]
class MapSaves {
 public:
  /// That are under way at once, each of which may hold a copy of the map.
  static constexpr std::size_t kMost = 3;

  explicit MapSaves(Duration patience = std::chrono::seconds(20)) : patience_(patience) {}

  /// Why no map is saved to `path` now: one to the same folder hangs, or too many are under way. Empty if one is.
  std::string refusal(const std::string& path) const;
  /// A map is to be saved to `path`: until that is begun, or refused, it is not saved.
  void expect(const std::string& path);
  /// What `save` gives, which writes the map to `path` and owns all that it uses; or that it has not ended in time,
  /// and goes on. A save to the same path that is under way is waited for, as long.
  map_files::MapIoResult run(const std::string& path, const std::function<map_files::MapIoResult()>& save);
  /// Which save has not ended, and for how long; empty if none takes longer than five seconds at `now`.
  std::string delay(SteadyTime now) const;
  /// A map was to be saved, and is not, because of `why`: the answer to that.
  map_files::MapIoResult refuse(const std::string& why);
  /// Why the map that was to be saved last is not; empty if it is, or if there was none.
  std::string whyNotSaved() const;

 private:
  struct Save {
    std::string path;
    SteadyTime begun;
  };
  /// Also of the saves that hang when this object is destroyed.
  struct State {
    std::mutex mutex;
    std::condition_variable ended;
    std::uint64_t begun = 0;                  ///< saves, and those that were expected or refused
    std::map<std::uint64_t, Save> under_way;  ///< by number, so that the oldest is the first
    std::string last;                         ///< why the last one is not saved; empty if it is
  };

  /// With the state locked.
  bool isBeingSaved(const std::string& path) const;
  std::string refusal(const std::string& path, SteadyTime now) const;

  const Duration patience_;
  const std::shared_ptr<State> state_ = std::make_shared<State>();
};

/// Saves to `path` the copy of the map that the node's thread hands over, on one of the threads of its service, a
/// ServiceThread; `node` names it in words.
template <class Copy, class Subject, class Thread>
map_files::MapIoResult saveCopy(Thread& thread, MapSaves& saves, const std::string& path, const std::string& node,
                                Copy (*copy)(const Subject&),
                                const std::function<map_files::MapIoResult(const Copy&)>& save) {
  const std::string refusal = saves.refusal(path);  // before a large map is copied
  if (!refusal.empty()) return saves.refuse(refusal);
  saves.expect(path);  // the node may end before it takes the question up
  using Shared = std::shared_ptr<const Copy>;
  const auto copied =
      thread.template ask<Shared>([copy](Subject& subject) { return std::make_shared<const Copy>(copy(subject)); });
  if (copied) return saves.run(path, [map = *copied, save] { return save(*map); });
  return saves.refuse(thread.whyNot(node, "hand over its map"));
}

}  // namespace frontier_pilot
