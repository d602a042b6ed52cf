# Exports the modules as targets for other packages: find_package(frontier_pilot) gives frontier_pilot::scan_matching etc.
if(WITH_ROS)
  export(EXPORT frontier_pilotTargets NAMESPACE frontier_pilot::
    FILE ${CATKIN_DEVEL_PREFIX}/share/${PROJECT_NAME}/cmake/frontier_pilotTargets.cmake)
  set(config_destination ${CATKIN_PACKAGE_SHARE_DESTINATION}/cmake)
else()
  set(config_destination ${CMAKE_INSTALL_LIBDIR}/cmake/frontier_pilot)
  install(FILES ${PROJECT_SOURCE_DIR}/cmake/frontier_pilot-extras.cmake.in DESTINATION ${config_destination}
    RENAME frontier_pilotConfig.cmake)
  # catkin reads the version from package.xml itself.
  file(STRINGS ${PROJECT_SOURCE_DIR}/package.xml version_element REGEX "<version>")
  string(REGEX MATCH "[0-9]+\\.[0-9]+\\.[0-9]+" version "${version_element}")
  include(CMakePackageConfigHelpers)
  write_basic_package_version_file(${CMAKE_BINARY_DIR}/frontier_pilotConfigVersion.cmake
    VERSION ${version} COMPATIBILITY SameMinorVersion)
  install(FILES ${CMAKE_BINARY_DIR}/frontier_pilotConfigVersion.cmake DESTINATION ${config_destination})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/frontier_pilot DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endif()
install(EXPORT frontier_pilotTargets NAMESPACE frontier_pilot:: DESTINATION ${config_destination})
