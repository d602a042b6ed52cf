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
  const auto map = thread_.ask<OccupancyGrid>([](const OccupancyGrid& common) { return common; });
  const map_files::MapIoResult none{map_files::MapIoStatus::kCannotWrite,
                                    thread_.whyNot("map merger", "hand over its map")};
  answerSave(map ? map_files::saveGrid(*map, request.path) : none, response);
  return true;
}

}  // namespace frontier_pilot
