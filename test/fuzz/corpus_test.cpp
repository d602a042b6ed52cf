// Every file of the corpus, and so the input of every defect that fuzzing has found, is given to its parser.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#define FUZZ_TARGET(name) extern "C" int fuzz_##name(const std::uint8_t* data, std::size_t size);
#include "fuzz_targets.inc"
#undef FUZZ_TARGET

namespace frontier_pilot::fuzz {
namespace {

namespace fs = std::filesystem;

struct Target {
  const char* name;
  int (*run)(const std::uint8_t* data, std::size_t size);
};

void PrintTo(const Target& target, std::ostream* out) { *out << target.name; }

#define FUZZ_TARGET(name) {#name, fuzz_##name},
const std::vector<Target> kTargets = {
#include "fuzz_targets.inc"
};
#undef FUZZ_TARGET

std::vector<fs::path> inputsOf(const std::string& target) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(fs::path(FUZZ_CORPUS) / target)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

class Corpus : public ::testing::TestWithParam<Target> {};

// [FLT-1]
TEST_P(Corpus, IsReadOrRefusedByItsParser_FLT_1) {
  const std::vector<fs::path> files = inputsOf(GetParam().name);
  ASSERT_FALSE(files.empty());
  for (const fs::path& path : files) {
    std::cout << path.filename().string() << std::endl;  // if the process ends, the last one is the reason
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
    EXPECT_EQ(GetParam().run(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()), 0);
  }
  EXPECT_EQ(GetParam().run(nullptr, 0), 0);
}

INSTANTIATE_TEST_SUITE_P(Parsers, Corpus, ::testing::ValuesIn(kTargets),
                         [](const auto& target) { return std::string(target.param.name); });

/// The unit tests of the ROS adapters read the bags; without ROS there may be no xmlrpcpp.
bool isElsewhere(const std::string& folder) { return folder == "bags" || folder == "xml_rpc_parameters"; }

TEST(CorpusFolder, BelongsToTheTargetsAndIsSmall) {
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(FUZZ_CORPUS)) {
    if (entry.is_regular_file()) bytes += entry.file_size();
    const std::string name = entry.path().filename().string();
    if (!entry.is_directory() || isElsewhere(name)) continue;
    EXPECT_TRUE(std::any_of(kTargets.begin(), kTargets.end(), [&](const Target& t) { return name == t.name; })) << name;
  }
  EXPECT_LT(bytes, 100'000U);
}

}  // namespace
}  // namespace frontier_pilot::fuzz
