#include "frontier_pilot/ros/patrol_client_adapter.h"

int main(int argc, char** argv) { return frontier_pilot::runPatrolClient(argc, argv); }
