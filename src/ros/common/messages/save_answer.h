#pragma once

#include <frontier_pilot/SaveMap.h>

#include "frontier_pilot/map_files/map_io.h"
#include "ros/common/throttled_log.h"

namespace frontier_pilot {

/// Logs how saving a map went, and makes it the answer.
inline void answerSave(const map_files::MapIoResult& result, SaveMap::Response& response) {
  response.success = static_cast<std::uint8_t>(result.ok());
  response.message = result.text;
  if (result.ok()) {
    THROTTLED_INFO(result.text);
  } else {
    THROTTLED_ERROR("map not saved, " << toString(result.status) << ": " << result.text);
  }
}

}  // namespace frontier_pilot
