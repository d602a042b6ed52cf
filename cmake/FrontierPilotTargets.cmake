# Functions that define the libraries, tests and benchmarks of the project, with their flags, links and install rules.

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

# The version is that of package.xml. As long as it begins with 0, each second number has a binary interface of its own.
file(STRINGS ${PROJECT_SOURCE_DIR}/package.xml version_element REGEX "<version>")
string(REGEX MATCH "[0-9]+\\.[0-9]+\\.[0-9]+" FRONTIER_PILOT_VERSION "${version_element}")
string(REGEX MATCH "^[0-9]+\\.[0-9]+" FRONTIER_PILOT_SOVERSION "${FRONTIER_PILOT_VERSION}")

find_package(Eigen3 REQUIRED)
if(WITH_TESTS)
  find_package(GTest REQUIRED)
endif()
if(WITH_BENCHMARKS)
  find_package(benchmark REQUIRED)
endif()
enable_testing()
if(WITH_ROS)
  set(FRONTIER_PILOT_LIBRARY_DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION})
  set(FRONTIER_PILOT_INCLUDE_DESTINATION ${CATKIN_GLOBAL_INCLUDE_DESTINATION})
else()
  include(GNUInstallDirs)
  set(FRONTIER_PILOT_LIBRARY_DESTINATION ${CMAKE_INSTALL_LIBDIR})
  set(FRONTIER_PILOT_INCLUDE_DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endif()
# Tests and benchmarks are not put into the folder that rosrun searches.
set(FRONTIER_PILOT_TEST_DIRECTORY ${CMAKE_BINARY_DIR}/bin)

function(frontier_pilot_target_options target)
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
    PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wshadow
    $<$<BOOL:${WARNINGS_AS_ERRORS}>:-Werror>)
endfunction()

# frontier_pilot_compile_together(<target> <batch>): <batch> of its files are compiled as one, 0 for all, because compiling
# the headers takes most of the time: a fifth of it is left. The files of a target therefore share one anonymous namespace,
# and GCC takes them for headers, where it warns of a class with a member of a type from an anonymous namespace.
function(frontier_pilot_compile_together target batch)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${batch})
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endfunction()

# frontier_pilot_optimise(<target> <flag>): less than -O3, which is for the modules: what computes lies in them. -O2 for what
# converts messages and draws, which takes a third less time to compile; -O1 for tests, which run once for each time that they are
# compiled.
function(frontier_pilot_optimise target flag)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:${flag}>)
endfunction()

# frontier_pilot_shared_library(<target>): the version that programs look for, and no undefined symbol, which would fail the
# build: a missing dependency is found at once.
function(frontier_pilot_shared_library target)
  target_link_options(${target} PRIVATE -Wl,--no-undefined)
  set_target_properties(${target} PROPERTIES VERSION ${FRONTIER_PILOT_VERSION} SOVERSION ${FRONTIER_PILOT_SOVERSION})
endfunction()

# frontier_pilot_module(<name> SOURCES <files> [DEPENDS <modules>] [LIBRARIES <others, linked privately>] [PROGRAM]):
# the library frontier_pilot_<name>. Other packages link it as frontier_pilot::<name>, unless it is the library of a
# PROGRAM, which has no public headers and nothing to link it by.
function(frontier_pilot_module name)
  cmake_parse_arguments(ARG "PROGRAM" "" "SOURCES;DEPENDS;LIBRARIES" ${ARGN})
  set(target frontier_pilot_${name})
  set(kind SHARED)
  if(WITH_FUZZERS)
    set(kind STATIC)
  endif()
  add_library(${target} ${kind} ${ARG_SOURCES})
  frontier_pilot_target_options(${target})
  frontier_pilot_compile_together(${target} 12)
  list(TRANSFORM ARG_DEPENDS PREPEND frontier_pilot_)
  target_link_libraries(${target} PUBLIC ${ARG_DEPENDS} PRIVATE ${ARG_LIBRARIES})
  frontier_pilot_shared_library(${target})
  set_target_properties(${target} PROPERTIES INSTALL_RPATH "$ORIGIN")  # installed libraries find each other in any folder
  if(ARG_PROGRAM)
    install(TARGETS ${target} LIBRARY DESTINATION ${FRONTIER_PILOT_LIBRARY_DESTINATION} NAMELINK_SKIP)
    return()
  endif()
  add_library(frontier_pilot::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(${target} INTERFACE $<INSTALL_INTERFACE:${FRONTIER_PILOT_INCLUDE_DESTINATION}>)
  target_compile_features(${target} INTERFACE cxx_std_17)
  install(TARGETS ${target} EXPORT frontier_pilotTargets LIBRARY DESTINATION ${FRONTIER_PILOT_LIBRARY_DESTINATION})
endfunction()

# frontier_pilot_add_test(<target>): registers a gtest with ctest and, under catkin, with `catkin_make run_tests`. The
# results are written as JUnit XML to test_results/.
function(frontier_pilot_add_test target)
  set_target_properties(${target} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${FRONTIER_PILOT_TEST_DIRECTORY})
  if(WITH_ROS AND COMMAND catkin_run_tests_target AND (CATKIN_ENABLE_TESTING OR NOT DEFINED CATKIN_ENABLE_TESTING))
    set(results ${CATKIN_TEST_RESULTS_DIR}/${PROJECT_NAME}/gtest-${target}.xml)
    catkin_run_tests_target(gtest ${target} gtest-${target}.xml
      COMMAND "${FRONTIER_PILOT_TEST_DIRECTORY}/${target} --gtest_output=xml:${results}" DEPENDENCIES ${target})
    set(name _ctest_${PROJECT_NAME}_gtest_${target})
  else()
    set(name ${target})
    add_test(NAME ${name}
      COMMAND ${target} --gtest_output=xml:${CMAKE_BINARY_DIR}/test_results/${PROJECT_NAME}/gtest-${target}.xml)
  endif()
  set_tests_properties(${name} PROPERTIES TIMEOUT ${FRONTIER_PILOT_UNIT_TIMEOUT} LABELS unit)
  if(NOT TARGET unit_tests)
    add_custom_target(unit_tests)
  endif()
  add_dependencies(unit_tests ${target})
endfunction()

# frontier_pilot_unit_test(<module> [DEPENDS <modules>] [LIBRARIES <others>]): test/unit/<module>/*_test.cpp as one
# gtest.
function(frontier_pilot_unit_test module)
  cmake_parse_arguments(ARG "" "" "DEPENDS;LIBRARIES" ${ARGN})
  if(NOT WITH_TESTS)
    return()
  endif()
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/test/unit/${module}/*_test.cpp)
  set(target ${module}_unit_tests)
  add_executable(${target} ${sources})
  frontier_pilot_target_options(${target})
  frontier_pilot_compile_together(${target} 12)
  frontier_pilot_optimise(${target} -O1)
  list(TRANSFORM ARG_DEPENDS PREPEND frontier_pilot_)
  target_link_libraries(${target} PRIVATE frontier_pilot_${module} ${ARG_DEPENDS} frontier_pilot_test_support
    ${ARG_LIBRARIES} GTest::gtest_main)
  frontier_pilot_add_test(${target})
endfunction()

# frontier_pilot_bench_program(<name> [DEPENDS <modules>] [SUPPORT <files>]): bench/<name>.cpp with a main of its own.
function(frontier_pilot_bench_program name)
  cmake_parse_arguments(ARG "" "" "DEPENDS;SUPPORT" ${ARGN})
  add_executable(${name} ${name}.cpp ${ARG_SUPPORT})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${FRONTIER_PILOT_TEST_DIRECTORY})
  frontier_pilot_target_options(${name})
  frontier_pilot_compile_together(${name} 12)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/bench)
  target_compile_definitions(${name} PRIVATE FRONTIER_PILOT_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  list(TRANSFORM ARG_DEPENDS PREPEND frontier_pilot_)
  target_link_libraries(${name} PRIVATE ${ARG_DEPENDS})
endfunction()

# frontier_pilot_benchmark(<name> [DEPENDS <modules>] [SUPPORT <files>]): the same with Google Benchmark.
function(frontier_pilot_benchmark name)
  frontier_pilot_bench_program(${name} ${ARGN})
  target_sources(${name} PRIVATE support/benchmark_main.cpp)
  target_link_libraries(${name} PRIVATE frontier_pilot_tools benchmark::benchmark)
endfunction()

# frontier_pilot_ros_target(<target>): flags and includes of a target that uses ROS. ROS' headers are system headers, so
# that their warnings are not reported.
function(frontier_pilot_ros_target target)
  frontier_pilot_target_options(${target})
  frontier_pilot_compile_together(${target} 0)
  frontier_pilot_optimise(${target} -O2)
  target_include_directories(${target} SYSTEM PUBLIC
    ${catkin_INCLUDE_DIRS} ${CATKIN_DEVEL_PREFIX}/${CATKIN_GLOBAL_INCLUDE_DESTINATION})
  add_dependencies(${target} ${PROJECT_NAME}_generate_messages_cpp)
endfunction()
