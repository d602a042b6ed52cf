#include "ros/check_robot/check_robot_adapter.h"

int main(int argc, char** argv) { return frontier_pilot::runCheckRobot(argc, argv); }
