# SANITIZER: instruments of the compiler that everything is built with, for scripts/sanitize. Such a build is neither
# installed nor measured. Without Release there is no NDEBUG: the assertions of Eigen and of the standard library hold.
set(SANITIZER "" CACHE STRING "address;undefined, or thread, or coverage (of Clang)")
set(FRONTIER_PILOT_UNIT_TIMEOUT 600)  # [s]
if(NOT SANITIZER)
  return()
endif()
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE None CACHE STRING "Build type" FORCE)
endif()
set(FRONTIER_PILOT_UNIT_TIMEOUT 3600)
if(SANITIZER STREQUAL coverage)
  # Clang counts the conditions of the source, whatever the optimizer makes of them.
  add_compile_options(-O1 -g1 -fprofile-instr-generate -fcoverage-mapping)
  add_link_options(-fprofile-instr-generate)
else()
  list(JOIN SANITIZER "," sanitizers)
  add_compile_options(-O1 -g1 -fno-omit-frame-pointer -fsanitize=${sanitizers} -D_GLIBCXX_ASSERTIONS)
  if(undefined IN_LIST SANITIZER)
    # A number that does not fit into an integer type is not part of `undefined`.
    add_compile_options(-fsanitize=float-cast-overflow -fno-sanitize-recover=undefined,float-cast-overflow)
    # Beside AddressSanitizer's library the shared one of GCC 12 writes to stderr, whatever its log_path is: the two have
    # functions of the same names.
    add_link_options(-static-libubsan -Wl,--exclude-libs,libubsan.a)
  endif()
  add_link_options(-fsanitize=${sanitizers})
endif()
