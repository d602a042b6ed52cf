#pragma once

#include <string>

/// The examples of docs/api, one for each module. Each gives whether it came out as it must.
namespace examples {

bool arbiter();
bool avoid();
bool behavior();
bool core();
bool exploration();
bool fleet();
bool grids();
bool localization();
bool logs();
/// Writes files into `folder`.
bool mapFiles(const std::string& folder);
bool mapping();
bool navigation();
bool occupancy();
bool patrol();
bool planning();
bool scanMatching();
bool sim();
bool slam();
bool surfaces();
bool system();

}  // namespace examples
