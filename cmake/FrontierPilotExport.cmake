# Exports the modules as targets for other packages: find_package(frontier_pilot) gives frontier_pilot::scan_matching etc.
if(WITH_ROS)
  export(EXPORT frontier_pilotTargets NAMESPACE frontier_pilot::
    FILE ${CATKIN_DEVEL_PREFIX}/share/${PROJECT_NAME}/cmake/frontier_pilotTargets.cmake)
  # It lies beside the file of catkin that reads it: Debian's catkin puts that elsewhere when it installs into /usr.
  set(config_destination ${CATKIN_PACKAGE_SHARE_DESTINATION}/cmake)
  if(CMAKE_INSTALL_PREFIX STREQUAL "/usr" AND CMAKE_LIBRARY_ARCHITECTURE)
    set(config_destination ${CATKIN_GLOBAL_LIB_DESTINATION}/cmake/${PROJECT_NAME})
  endif()
else()
  set(config_destination ${CMAKE_INSTALL_LIBDIR}/cmake/frontier_pilot)
  install(FILES ${PROJECT_SOURCE_DIR}/cmake/frontier_pilot-extras.cmake.in DESTINATION ${config_destination}
    RENAME frontier_pilotConfig.cmake)
  include(CMakePackageConfigHelpers)  # catkin writes this file itself
  write_basic_package_version_file(${CMAKE_BINARY_DIR}/frontier_pilotConfigVersion.cmake
    VERSION ${FRONTIER_PILOT_VERSION} COMPATIBILITY SameMinorVersion)
  install(FILES ${CMAKE_BINARY_DIR}/frontier_pilotConfigVersion.cmake DESTINATION ${config_destination})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/frontier_pilot DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endif()
install(EXPORT frontier_pilotTargets NAMESPACE frontier_pilot:: DESTINATION ${config_destination})
