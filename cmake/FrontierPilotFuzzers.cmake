# WITH_FUZZERS: everything is compiled for libFuzzer, with the sanitizers that find what a parser does wrong. The modules
# are static libraries then, because clang links its runtime to programs only.
include(CheckCXXSourceCompiles)
set(CMAKE_REQUIRED_FLAGS -fsanitize=fuzzer,address,undefined)
set(CMAKE_REQUIRED_QUIET ON)
check_cxx_source_compiles("#include <cstddef>\n#include <cstdint>\n
  extern \"C\" int LLVMFuzzerTestOneInput(const std::uint8_t*, std::size_t) { return 0; }" HAS_LIBFUZZER)
unset(CMAKE_REQUIRED_FLAGS)
unset(CMAKE_REQUIRED_QUIET)
if(NOT HAS_LIBFUZZER)
  message(FATAL_ERROR "WITH_FUZZERS needs clang with libFuzzer, which ${CMAKE_CXX_COMPILER} is not: "
    "scripts/setup installs it, and -DCMAKE_CXX_COMPILER=clang++ selects it")
endif()
# Of the checks, the first is in neither of the two sanitizers. A finding ends the program, so that its input is kept.
add_compile_options(-fsanitize=fuzzer-no-link,address,undefined,float-cast-overflow -fno-sanitize-recover=all
  -fno-omit-frame-pointer -g -O1)
add_compile_definitions(_GLIBCXX_ASSERTIONS)
add_link_options(-fsanitize=address,undefined)
