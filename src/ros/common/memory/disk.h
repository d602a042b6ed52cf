#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "frontier_pilot/core/time.h"
#include "ros/common/threads/patient_thread.h"

namespace frontier_pilot {

/// ROS_HOME, or ROS' default, ~/.ros.
std::filesystem::path rosHome();
/// A folder of this user's own in memory, which can be written when the disk cannot: XDG_RUNTIME_DIR, or one below
/// /dev/shm if that is not set. Empty if there is none, or if it belongs to somebody else.
std::filesystem::path spareFolder();

/// What lies in `folder`, as far as it can be read: a loop over directory_iterator throws where it no longer can be.
std::vector<std::filesystem::path> entriesOf(const std::filesystem::path& folder);

/// For what a node does on a disk while it works: a disk that hangs is waited for 50 ms, and not again before it
/// answers. A process that was forked gets a thread of its own.
PatientThread& diskThread();
/// Waits longer for the disk from now on, for a unit test on a machine that may give its threads no time for 50 ms.
void setDiskPatience(Duration patience);
/// What is said of a disk that does not answer in time.
constexpr const char* kSilentDisk = "the disk does not answer";
/// What `job`, which owns all that it uses, says that went wrong on the disk; empty if nothing did.
std::string onDisk(const std::function<std::string()>& job);

}  // namespace frontier_pilot
