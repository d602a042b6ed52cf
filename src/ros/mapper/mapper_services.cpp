#include "ros/common/clock.h"
#include "ros/common/messages/conversions.h"
#include "ros/mapper/mapper_adapter.h"

namespace frontier_pilot {

void MapperAdapter::advertiseServices() {
  connections_.serve(names::kDynamicMap, &MapperAdapter::handleGet, this);
  connections_.serve(names::kLoadMap, &MapperAdapter::handleLoad, this);
  saver_.serve(connections_);
  searcher_.serve(connections_);
  connections_.serve(names::kResetMap, &MapperAdapter::handleReset, this);
}

bool MapperAdapter::handleGet(nav_msgs::GetMap::Request&, nav_msgs::GetMap::Response& response) {
  // The response has no field for an error, so the call fails while there is no map.
  const occupancy::OccupancyMap& map = restored_ ? restored_->map : mapper_.map();
  if (map.empty()) return false;
  response.map = toOccupancyGridMsg(map.projection(), parameters_.map_frame, rosNow());
  return true;
}

bool MapperAdapter::handleReset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  if (parameters_.mapper.localize_only) {
    response.success = 0U;
    response.message = "refused: localize_only keeps the map as it is";
    return true;
  }
  mapper_.reset();
  const std::string problem = autosave_.forget();
  restored_.reset();
  anchor_.reset();
  pairing_.clear();
  looked_for_ = false;
  response.success = 1U;
  response.message = "the map is cleared";
  publisher_.announceReplacement(response.message);
  response.message += afterDeath("the reset", problem);
  return true;
}

}  // namespace frontier_pilot
