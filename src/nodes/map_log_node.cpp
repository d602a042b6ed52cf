#include "ros/map_log/bag_log.h"
#include "tools/map_log.h"

int main(int argc, char** argv) {
  return frontier_pilot::tools::runMapLog({argv + 1, argv + argc},
                                          [](const std::string& path, const frontier_pilot::tools::BagTopics& topics) {
                                            return frontier_pilot::readBagLogApart(path, topics);
                                          });
}
