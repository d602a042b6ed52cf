#include "ros/common/help/usages.h"
#include "ros/common/master/namesake.h"
#include "ros/common/names.h"
#include "ros/common/node_main.h"
#include "ros/map_merger/map_merger_adapter.h"

int main(int argc, char** argv) {
  return frontier_pilot::runNode<frontier_pilot::MapMergerAdapter>(argc, argv, frontier_pilot::mapMergerUsage(), [] {
    frontier_pilot::refuseASecondProvider(frontier_pilot::names::kSaveMergedMap);
  });
}
