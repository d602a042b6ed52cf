#include "frontier_pilot/ros/bag_log.h"
#include "frontier_pilot/tools/map_log.h"

int main(int argc, char** argv) {
  return frontier_pilot::runMapLog({argv + 1, argv + argc},
                                   [](const std::string& path, const frontier_pilot::BagTopics& topics) {
                                     return frontier_pilot::readBagLogApart(path, topics);
                                   });
}
