#pragma once

#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include "ros/common/memory/process_identity.h"

namespace frontier_pilot {

/// What this process writes into a file of a SessionMemory: the text on one line, cut if it is longer than 128 KiB and
/// with what is not printable escaped, and on the next one who has written it.
std::string memoryFileWith(const std::string& text);
/// The text in such a file. One that cannot be read gives an empty text, but it still counts as remembered.
std::string textIn(const std::filesystem::path& file);
/// The texts of these files; those of files that cannot be read are empty and come last.
std::vector<std::string> textsIn(const std::vector<std::filesystem::path>& files);
/// The process that wrote `file`; none if that cannot be read.
ProcessIdentity writerOf(const std::filesystem::path& file);
/// When `file` was written [s since 1970]; 0 if it is not there.
std::time_t timeOf(const std::filesystem::path& file);

}  // namespace frontier_pilot
