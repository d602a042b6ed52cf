#include "ros/map_merger/merged_map_saver.h"

#include "frontier_pilot/map_files/map_io.h"
#include "ros/common/messages/save_answer.h"
#include "ros/common/names.h"

namespace frontier_pilot {

void MergedMapSaver::serve(NodeConnections& connections) {
  thread_.serve<SaveMap::Request, SaveMap::Response>(
      connections, names::kSaveMergedMap,
      [this](SaveMap::Request& request, SaveMap::Response& response) { return handle(request, response); });
}

bool MergedMapSaver::handle(SaveMap::Request& request, SaveMap::Response& response) {
  const auto copy = [](const OccupancyGrid& common) { return common; };
  const auto save = [path = request.path](const OccupancyGrid& map) { return map_files::saveGrid(map, path); };
  answerSave(saveCopy<OccupancyGrid, const OccupancyGrid>(thread_, saves_, request.path, "map merger", copy, save),
             response);
  return true;
}

}  // namespace frontier_pilot
