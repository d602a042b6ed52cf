// Writes the floor plans of support/floor_plan.h as worlds in map_server's format.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "frontier_pilot/core/files.h"
#include "frontier_pilot/map_files/map_image.h"
#include "support/floor_plan.h"
#include "tools/arguments.h"
#include "tools/program.h"

namespace frontier_pilot::bench {
namespace {

constexpr const char* kUsage =
    "usage: floor_plans --out DIRECTORY [--plans A-B]\n"
    "Writes plan_01.yaml, plan_01.pgm and so on. There are 40 plans: the odd ones for tuning, the even ones for\n"
    "reporting.\n"
    "  --out DIRECTORY  where to write them\n"
    "  --plans A-B      which of them (1-40)\n"
    "Example:\n"
    "  floor_plans --out /tmp/plans --plans 1-10\n";

struct Options {
  std::string out;
  std::vector<int> plans;
};

Options parse(const std::vector<std::string>& words) {
  Options options;
  for (int i = 1; i <= kFloorPlans; ++i) options.plans.push_back(i);
  tools::Arguments arguments(words);
  while (!arguments.atEnd()) {
    const std::string word = arguments.next();
    if (word == "--out") {
      options.out = arguments.text();
    } else if (word == "--plans") {
      options.plans = arguments.range();
    } else {
      throw std::invalid_argument("unknown option " + word);
    }
  }
  if (options.out.empty()) throw std::invalid_argument("--out is missing");
  return options;
}

std::string yamlOf(const FloorPlan& plan, const std::string& name) {
  char text[600];
  std::snprintf(text, sizeof(text),
                "# Floor plan %d: %s.\n"
                "image: %s.pgm\n"
                "resolution: 0.05\n"
                "origin: [0.0, 0.0, 0.0]\n"
                "negate: 0\n"
                "occupied_thresh: 0.65\n"
                "free_thresh: 0.196\n"
                "start: [%.3f, %.3f, %.4f]\n",
                plan.number, toString(plan.kind), name.c_str(), plan.start.x, plan.start.y, plan.start.yaw);
  return text;
}

void write(const std::filesystem::path& file, const std::string& content) {
  const std::string problem = writeFile(file, content, Survives::kProcessDeath);
  if (!problem.empty()) throw std::runtime_error(file.string() + ": " + problem);
}

void writePlan(const FloorPlan& plan, const std::filesystem::path& folder) {
  char name[32];
  std::snprintf(name, sizeof(name), "plan_%02d", plan.number);
  write(folder / (std::string(name) + ".pgm"), map_files::pgmOf(plan.map));
  write(folder / (std::string(name) + ".yaml"), yamlOf(plan, name));
  const auto free = std::count(plan.map.cells().begin(), plan.map.cells().end(), kFree);
  std::printf("%s  %-9s  %4zu rooms  %5.0f m^2 of free floor\n", name, toString(plan.kind), plan.rooms.size(),
              static_cast<double>(free) * plan.map.resolution() * plan.map.resolution());
}

void run(const Options& options) {
  std::filesystem::create_directories(options.out);
  for (const int number : options.plans) writePlan(floorPlan(number), options.out);
}

}  // namespace
}  // namespace frontier_pilot::bench

int main(int argc, char** argv) {
  namespace bench = frontier_pilot::bench;
  return frontier_pilot::tools::runProgram("floor_plans", {argv + 1, argv + argc}, bench::kUsage,
                                           [](const auto& words) {
                                             bench::run(bench::parse(words));
                                             return 0;
                                           });
}
