#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "fuzz/fuzz.h"
#include "support/temporary_folder.h"

namespace frontier_pilot::fuzz {

/// A folder for parsers that read files. It lives as long as the program; scripts/fuzz puts it into memory (TMPDIR).
inline const std::filesystem::path& scratch() {
  static const test::TemporaryFolder folder;
  return folder.path();
}

inline std::string writeScratch(const char* name, const std::string& content) {
  const std::filesystem::path path = scratch() / name;
  std::ofstream file(path, std::ios::binary);
  file << content;
  require(static_cast<bool>(file.flush()), "the input can be put into a file");
  return path.string();
}

}  // namespace frontier_pilot::fuzz
