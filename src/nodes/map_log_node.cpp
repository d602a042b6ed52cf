#include "frontier_pilot/ros/bag_log.h"
#include "frontier_pilot/tools/map_log.h"

int main(int argc, char** argv) {
  return frontier_pilot::runMapLog({argv + 1, argv + argc}, frontier_pilot::readBagLog);
}
