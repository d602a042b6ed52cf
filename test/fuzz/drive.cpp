// A log in any format, with what map_log makes of it.

#include <sstream>

#include "frontier_pilot/logs/scan_log.h"
#include "frontier_pilot/logs/trajectory.h"
#include "frontier_pilot/mapping/mapper.h"
#include "fuzz/check_log.h"
#include "fuzz/fuzz.h"
#include "tools/log_mapping.h"

namespace {

using namespace frontier_pilot;  // NOLINT(google-build-using-namespace): a program of its own

bool isShort(const logs::ScanLog& log) {
  constexpr std::size_t kMostRecords = 20;
  constexpr std::size_t kMostRanges = 400;
  std::size_t ranges = 0;
  for (const logs::LogRecord& record : log.records) ranges += record.scan.ranges.size();
  return log.records.size() <= kMostRecords && ranges <= kMostRanges;
}

void map(const logs::ScanLog& log) {
  mapping::MapperParameters parameters;
  parameters.map.max_side = 50.0;
  parameters.map.max_memory = 4.0;
  mapping::Mapper mapper(parameters);
  const tools::MappedDrive drive = tools::mapLog(log, mapper);
  fuzz::require(drive.corrected.size() == log.records.size(), "each scan has its place in the corrected trajectory");
  for (const StampedPose2& entry : drive.corrected) fuzz::require(fuzz::isFinite(entry.pose), "poses stay finite");
  std::ostringstream tum;
  logs::writeTum(tum, drive.corrected);
  std::ostringstream octree;
  fuzz::require(mapper.map().isBlank() || mapper.map().write(octree), "the map can be written");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream file(fuzz::textOf(data, size));
  try {
    const logs::ScanLog log = logs::readScanLog(file, "log");
    fuzz::checkLog(log);
    if (isShort(log)) map(log);
  } catch (const logs::LogError&) {
  }
  return 0;
}
