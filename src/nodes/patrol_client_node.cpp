#include "ros/patrol_client/patrol_client_adapter.h"

int main(int argc, char** argv) { return frontier_pilot::runPatrolClient(argc, argv); }
