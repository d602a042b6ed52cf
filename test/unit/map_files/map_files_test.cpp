#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "frontier_pilot/core/text.h"
#include "frontier_pilot/map_files/map_io.h"
#include "frontier_pilot/sim/simulator.h"
#include "support/temporary_folder.h"

namespace frontier_pilot {
namespace {

namespace fs = std::filesystem;

/// A small map, saved as `floor`, and what somebody may do to its files.
class MapFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directory(directory / "maps");
    ASSERT_EQ(map.reserve({-3.0, -1.0}, {2.0, 11.0}), occupancy::MapRoom::kEnough);
    map.beginScan();
    for (int i = 0; i < 100; ++i) map.miss({10 + i, 20 + i / 2});
    for (int i = 0; i < 50; ++i) map.hit({17, 100 + i});
    const map_files::MapIoResult saved = map_files::saveMap(map, path("floor"));
    ASSERT_TRUE(saved.ok()) << saved.text;
  }

  std::string path(const std::string& name) const { return (directory / "maps" / name).string(); }
  std::string read(const std::string& name) const {
    std::ifstream file(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }
  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
  }
  std::size_t files() const {
    const fs::directory_iterator entries(directory / "maps");
    return static_cast<std::size_t>(std::distance(begin(entries), end(entries)));
  }
  /// Loads `bytes` as a .bt without a YAML beside it: what came of it, after a look at the map.
  map_files::MapIoResult load(const std::string& bytes) {
    write("other.bt", bytes);
    occupancy::OccupancyMap loaded = occupancy::OccupancyMap();
    EXPECT_EQ(loaded.reserve({0.0, 0.0}, {1.0, 1.0}), occupancy::MapRoom::kEnough);
    loaded.beginScan();
    loaded.hit({3, 3});
    const auto before = loaded.grid().cells();
    const map_files::MapIoResult result = map_files::loadOctree(path("other.bt"), loaded);
    EXPECT_TRUE(result.ok() || loaded.grid().cells() == before) << "a map that was not loaded stays as it was";
    return result;
  }
  /// What is said of a map that another program saved, with these bytes in its YAML.
  std::string refusalOf(const std::string& yaml) const {
    write("other.yaml", yaml);
    occupancy::OccupancyMap loaded;
    return map_files::loadMap(path("other"), loaded).text;
  }
  /// The .bt's header with another tree behind it.
  std::string withTree(const std::string& size, const std::string& tree) const {
    return "# Octomap OcTree binary file\nid OcTree\nsize " + size + "\nres 0.05\ndata\n" + tree;
  }

  const test::TemporaryFolder temporary;
  const fs::path directory = temporary.path();
  occupancy::OccupancyMap map;
};

// [FLT-1] An answer in Python cannot be read otherwise.
TEST_F(MapFiles, AreRefusedInWordsThatCanBePrintedWhateverBytesTheYamlHolds_FLT_1) {
  for (const std::string yaml :
       {"a: \"\\\xcf\"", "\xff\x02: 1\n\xff\x02: 2\n", "mode: \"\xfe\\x1b\"\n", "\x80\x81[", "image: \xc3\x28\n"}) {
    const std::string text = refusalOf(yaml);
    EXPECT_FALSE(text.empty());
    EXPECT_EQ(printable(text, 10000), text);
  }
  EXPECT_NE(refusalOf("mode: \xfe\n").find("\\xfe"), std::string::npos);
}

// [FLT-1] [MAP-5] OctoMap's reader follows such a file until the stack is gone.
TEST_F(MapFiles, RefusesATreeThatIsDeeperThanSixteenLevels_FLT_1_MAP_5) {
  const std::string only_first_child("\x03\x00", 2);
  std::string deep;
  for (int i = 0; i < 2000000; ++i) deep += only_first_child;
  const map_files::MapIoResult result = load(withTree("2000001", deep));
  EXPECT_EQ(result.status, map_files::MapIoStatus::kBroken);
  EXPECT_NE(result.text.find("deep"), std::string::npos) << result.text;
}

// [FLT-1] [MAP-5]
TEST_F(MapFiles, RefusesATreeThatIsNotAllThere_FLT_1_MAP_5) {
  const std::string whole = read("floor.bt");
  ASSERT_TRUE(load(whole).ok());
  for (std::size_t missing = 1; missing <= 40; ++missing) {
    EXPECT_EQ(load(whole.substr(0, whole.size() - missing)).status, map_files::MapIoStatus::kBroken) << missing;
  }
  EXPECT_EQ(load(whole + '\0').status, map_files::MapIoStatus::kBroken) << "nor one with something behind it";
  EXPECT_EQ(load("").status, map_files::MapIoStatus::kBroken);
}

// [FLT-1]
TEST_F(MapFiles, RefusesAHeaderThatDoesNotHold_FLT_1) {
  const std::string whole = read("floor.bt");
  const std::string tree = whole.substr(whole.find("data\n") + 5);
  for (const char* size : {"0", "1", "-1", "4294967295", "99999999999999999999", "nan", ""}) {
    EXPECT_EQ(load(withTree(size, tree)).status, map_files::MapIoStatus::kBroken) << size;
  }
  for (const char* resolution : {"nan", "inf", "-0.05", "0", "0.0500021", "1e-300", ""}) {
    std::string other = whole;
    const std::size_t at = other.find("res ") + 4;
    EXPECT_EQ(load(other.replace(at, other.find('\n', at) - at, resolution)).status, map_files::MapIoStatus::kBroken)
        << resolution;
  }
  EXPECT_EQ(load(withTree("2", std::string("\0\0", 2))).status, map_files::MapIoStatus::kBroken);
}

// [FLT-1] A node of the first level stands for 32,768 x 32,768 cells.
TEST_F(MapFiles, RefusesATreeThatCoversTooMuch_FLT_1) {
  EXPECT_EQ(load(withTree("9", "\x55\x55")).status, map_files::MapIoStatus::kBroken);
  EXPECT_EQ(load(withTree("2", std::string("\x01\x00", 2))).status, map_files::MapIoStatus::kBroken);
}

// [FLT-1] [MAP-5] Whatever was done to its bytes, a file is refused, or is a tree; no map is lost to it.
TEST_F(MapFiles, AreLoadedWholeOrNotAtAllWhateverTheyHold_FLT_1_MAP_5) {
  const std::string whole = read("floor.bt");
  std::mt19937 random(20);
  const auto below = [&](std::size_t limit) {
    return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random);
  };
  std::size_t refused = 0;
  constexpr int kCases = 1500;
  for (int i = 0; i < kCases; ++i) {
    std::string bytes = whole;
    for (std::size_t flips = below(8); flips > 0; --flips) {
      bytes[below(bytes.size())] ^= static_cast<char>(1U << below(8));
    }
    if (below(3) == 0) bytes.resize(below(bytes.size()));
    if (below(3) == 0) bytes.insert(below(bytes.size() + 1), whole, below(whole.size()), below(300));
    if (below(5) == 0) bytes.insert(below(bytes.size() + 1), below(200), static_cast<char>(below(256)));
    if (!load(bytes).ok()) ++refused;
  }
  EXPECT_GT(refused, static_cast<std::size_t>(kCases / 2));
}

// [FLT-1] A pipe would keep the mapper waiting for a writer.
TEST_F(MapFiles, AreFilesAndNothingElse_FLT_1) {
  for (const char* extension : {".bt", ".yaml"}) {
    write("odd.bt", read("floor.bt"));
    write("odd.yaml", read("floor.yaml"));
    fs::remove(path("odd") + extension);
    ASSERT_EQ(mkfifo((path("odd") + extension).c_str(), 0600), 0);
    EXPECT_EQ(map_files::loadMap(path("odd"), map).status, map_files::MapIoStatus::kBroken) << extension;
    fs::remove(path("odd") + extension);
    fs::create_directory(path("odd") + extension);
    EXPECT_EQ(map_files::loadMap(path("odd"), map).status, map_files::MapIoStatus::kBroken) << extension;
    fs::remove(path("odd") + extension);
    fs::create_symlink("/dev/zero", path("odd") + extension);
    EXPECT_EQ(map_files::loadMap(path("odd"), map).status, map_files::MapIoStatus::kBroken) << extension;
    fs::remove(path("odd") + extension);
  }
}

// [FLT-1] [MAP-5]
TEST_F(MapFiles, AreNamedWhereOneCannotBeRead_FLT_1_MAP_5) {
  write("deep.yaml", std::string(100000, '['));
  ASSERT_EQ(mkfifo(path("pipe.yaml").c_str(), 0600), 0);
  std::filesystem::create_symlink("loop.yaml", path("loop.yaml"));
  for (const char* name : {"deep", "pipe", "loop"}) {
    const map_files::MapIoResult result = map_files::loadMap(path(name), map);
    EXPECT_EQ(result.status, map_files::MapIoStatus::kBroken) << result.text;
    EXPECT_NE(result.text.find(std::string(name) + ".yaml: "), std::string::npos) << result.text;
  }
}

// [MAP-5]
TEST_F(MapFiles, BelongTogether_MAP_5) {
  occupancy::OccupancyMap loaded;
  EXPECT_EQ(map_files::loadMap(path("floor"), loaded).text.find("not verified"), std::string::npos);
  const std::string whole = read("floor.bt");
  const std::string tree_begins = "data\n";
  std::string other = whole;
  other[whole.find(tree_begins) + tree_begins.size() + 40] ^= 0x03;  // still a tree, or not: another one at any rate
  write("floor.bt", other);
  const map_files::MapIoResult changed = map_files::loadMap(path("floor"), loaded);
  EXPECT_EQ(changed.status, map_files::MapIoStatus::kBroken);
  EXPECT_NE(changed.text.find("remove the entry 'octree' from " + path("floor.yaml")), std::string::npos)
      << changed.text;
  write("floor.bt", whole);
  EXPECT_TRUE(map_files::loadMap(path("floor"), loaded).ok());
}

// [MAP-5] as somebody else's map is
TEST_F(MapFiles, AreLoadedWithoutAYamlAndSaySo_MAP_5) {
  occupancy::OccupancyMap loaded;
  fs::remove(path("floor.yaml"));
  const map_files::MapIoResult alone = map_files::loadMap(path("floor"), loaded);
  EXPECT_TRUE(alone.ok()) << alone.text;
  EXPECT_NE(alone.text.find("not verified"), std::string::npos) << alone.text;
  write("floor.yaml", "image: missing.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n");
  const map_files::MapIoResult unsigned_yaml = map_files::loadMap(path("floor"), loaded);
  EXPECT_TRUE(unsigned_yaml.ok()) << unsigned_yaml.text;
  EXPECT_NE(unsigned_yaml.text.find("not verified"), std::string::npos) << unsigned_yaml.text;
}

// [FLT-1] [MAP-5] What is answered with success can be read again.
TEST_F(MapFiles, MayHaveAnyNameThatAFileMayHave_FLT_1_MAP_5) {
  for (const char* name : {"a: b",  "a #1", "[a]", "{a}",  "'a'",
                           "\"a\"", "a\\b", "- a", "-a",   "%a",
                           "@a",    "`a",   "~",   "&a",   "*a",
                           "!a",    "|",    ">",   "? a",  ", a",
                           "a b ",  " a",   "1e5", "null", "étage 1 – été",
                           "楼层"}) {
    SCOPED_TRACE(name);
    const map_files::MapIoResult saved = map_files::saveMap(map, path(name));
    ASSERT_TRUE(saved.ok()) << saved.text;
    const OccupancyGrid grid = sim::loadWorld(path(name) + ".yaml").map;
    EXPECT_TRUE(grid.cells() == map.grid().cells());
    occupancy::OccupancyMap loaded;
    const map_files::MapIoResult result = map_files::loadMap(path(name), loaded);
    EXPECT_TRUE(result.ok()) << result.text;
    EXPECT_EQ(result.text.find("not verified"), std::string::npos) << result.text;
  }
}

// [FLT-1]
TEST_F(MapFiles, AreNotWrittenUnderANameThatCannotBeRead_FLT_1) {
  const std::string nothing("a\0b", 3);
  for (const std::string& name :
       {std::string("a\nimage: b"), std::string("a\tb"), nothing, std::string("a\x7f"), std::string("a\xff"),
        std::string("a\xc3"), std::string(252, 'x'), std::string(".."), std::string("."), std::string("\xed\xa0\x80"),
        std::string("\xc0\xaf"), std::string("a\u0085b"), std::string("a\u009bb"), std::string("a\u2028b"),
        std::string("a\u2029b")}) {
    const map_files::MapIoResult saved = map_files::saveMap(map, path(name));
    EXPECT_EQ(saved.status, map_files::MapIoStatus::kBadPath) << name << ": " << saved.text;
    EXPECT_EQ(saved.text.find_first_of("\n\t\x7f"), std::string::npos) << "nor does the text hold such a character";
  }
  EXPECT_EQ(files(), 3U);
}

// [FLT-1] Somebody who may write into the folder must not choose which file is overwritten.
TEST_F(MapFiles, ReplaceLinksInsteadOfFollowingThem_FLT_1) {
  const fs::path victim = directory / "victim";
  std::ofstream(victim) << "precious";
  for (const char* name : {"link.pgm", "link.yaml", "link.bt", "link.pgm.part", "link.yaml.part", "link.bt.part"}) {
    fs::create_symlink(victim, path(name));
  }
  ASSERT_TRUE(map_files::saveMap(map, path("link")).ok());
  std::ifstream file(victim);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), "precious");
  EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(path("link.bt"))));
  occupancy::OccupancyMap loaded;
  EXPECT_TRUE(map_files::loadMap(path("link"), loaded).ok());
}

// [FLT-1] [MAP-5]
TEST_F(MapFiles, StayAsTheyWereWhenSavingFails_FLT_1_MAP_5) {
  const std::string pgm = read("floor.pgm");
  const std::string bt = read("floor.bt");
  fs::remove(path("floor.yaml"));
  fs::create_directory(path("floor.yaml"));
  map.hit({1, 1});
  const map_files::MapIoResult result = map_files::saveMap(map, path("floor"));
  EXPECT_EQ(result.status, map_files::MapIoStatus::kCannotWrite);
  EXPECT_NE(result.text.find("floor.yaml"), std::string::npos) << result.text;
  EXPECT_EQ(read("floor.pgm"), pgm);
  EXPECT_EQ(read("floor.bt"), bt);
  EXPECT_EQ(files(), 3U) << "nothing is left lying around";
}

}  // namespace
}  // namespace frontier_pilot
