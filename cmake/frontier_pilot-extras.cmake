# Read by find_package(frontier_pilot), under catkin and without it: the modules as frontier_pilot::<module>, and what
# their headers need.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3)
include(${CMAKE_CURRENT_LIST_DIR}/frontier_pilotTargets.cmake)
