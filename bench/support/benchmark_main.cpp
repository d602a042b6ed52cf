// The main of the programs with Google Benchmark.

#include "support/benchmark_main.h"

#include <benchmark/benchmark.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "tools/program.h"

int main(int argc, char** argv) {
  const std::string name = std::filesystem::path(argv[0]).filename();
  const std::string usage = "usage: " + name + " [--benchmark_filter=REGEX] [--benchmark_...]\n" +
                            frontier_pilot::bench::kPurpose +
                            "  --benchmark_list_tests=true  lists what it measures\n"
                            "  --benchmark_filter=REGEX     measures only those whose names match\n"
                            "  --benchmark_...              as Google Benchmark describes them\n"
                            "Example:\n  " +
                            name + " --benchmark_min_time=0.1\n";
  const auto run = [&](const std::vector<std::string>&) {
    benchmark::Initialize(&argc, argv);  // takes its own options out of argv
    if (argc > 1) throw std::invalid_argument("unknown option " + std::string(argv[1]));
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
  };
  return frontier_pilot::tools::runProgram(name, {argv + 1, argv + argc}, usage.c_str(), run);
}
