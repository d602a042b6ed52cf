#include <ros/init.h>

#include "ros/map_log/bag_log.h"
#include "tools/map_log.h"

int main(int argc, char** argv) {
  std::vector<std::string> words;
  ros::removeROSArgs(argc, argv, words);
  return frontier_pilot::tools::runMapLog({words.begin() + 1, words.end()},
                                          [](const std::string& path, const frontier_pilot::tools::BagTopics& topics) {
                                            return frontier_pilot::readBagLogApart(path, topics);
                                          });
}
