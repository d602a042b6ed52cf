#include "frontier_pilot/map_files/map_io.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "frontier_pilot/sim/simulator.h"
#include "support/temporary_folder.h"

namespace frontier_pilot {
namespace {

namespace fs = std::filesystem;

class MapIo : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(map.reserve({-3.0, -1.0}, {2.0, 11.0}), occupancy::MapRoom::kEnough);
    map.beginScan();
    for (int i = 0; i < 100; ++i) map.miss({10 + i, 20 + i / 2});
    for (int i = 0; i < 50; ++i) map.hit({17, 100 + i});
  }
  std::string path(const std::string& name) const { return (directory / name).string(); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(path(name)) << text; }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(directory), fs::directory_iterator()));
  }

  const test::TemporaryFolder temporary;
  const fs::path directory = temporary.path();
  occupancy::OccupancyMap map;
};

TEST_F(MapIo, AnswersWithTheAbsolutePath) {
  const fs::path relative = fs::relative(path("floor"), fs::current_path());
  ASSERT_TRUE(relative.is_relative());
  const map_files::MapIoResult saved = map_files::saveMap(map, relative.string());
  EXPECT_EQ(saved.text, "saved " + fs::weakly_canonical(path("floor")).string() + ".pgm, .yaml and .bt");
}

TEST_F(MapIo, SavesAGridOfClassesThatLoadsAgain) {
  OccupancyGrid grid(GridGeometry{0.05, Vec2(-1.23, 0.4), 40, 30}, kUnknown);
  for (int y = 5; y < 25; ++y) std::fill_n(grid.row(y) + 5, 20, y == 24 ? kOccupied : kFree);
  const map_files::MapIoResult saved = map_files::saveGrid(grid, path("merged"));
  ASSERT_TRUE(saved.ok()) << saved.text;
  EXPECT_EQ(files(), 3U);
  occupancy::OccupancyMap loaded;
  ASSERT_TRUE(map_files::loadMap(path("merged"), loaded).ok());
  EXPECT_EQ(loaded.grid().get(loaded.geometry().cellAt({-0.7, 0.9}), kUnknown), kFree);
  EXPECT_EQ(loaded.grid().get(loaded.geometry().cellAt({-0.7, 1.6}), kUnknown), kOccupied) << "24 cells up: a wall";
  EXPECT_EQ(loaded.grid().get(loaded.geometry().cellAt({0.5, 1.6}), kUnknown), kUnknown);
  EXPECT_EQ(map_files::saveGrid(OccupancyGrid(grid.geometry(), kUnknown), path("blank")).status,
            map_files::MapIoStatus::kEmptyMap);
}

TEST_F(MapIo, SavesThreeFilesThatLoadAgain) {
  const map_files::MapIoResult saved = map_files::saveMap(map, path("floor"));
  ASSERT_TRUE(saved.ok()) << saved.text;
  EXPECT_EQ(files(), 3U);
  const OccupancyGrid grid = sim::loadWorld(path("floor.yaml")).map;
  EXPECT_EQ(grid.geometry(), map.geometry());
  EXPECT_TRUE(grid.cells() == map.grid().cells());
  occupancy::OccupancyMap tree;
  const map_files::MapIoResult octree = map_files::loadOctree(path("floor.bt"), tree);
  ASSERT_TRUE(octree.ok()) << octree.text;
  for (std::size_t i = 0; i < map.grid().size(); ++i) {
    const Vec2 centre = map.geometry().centre(map.geometry().cell(i));
    ASSERT_EQ(tree.grid().get(tree.geometry().cellAt(centre), kUnknown), map.grid()[i]);
  }
}

TEST_F(MapIo, WritesMapServersTrinaryPixels) {
  ASSERT_TRUE(map_files::saveMap(map, path("floor.yaml")).ok()) << "an extension is ignored";
  std::ifstream file(path("floor.pgm"), std::ios::binary);
  const std::string pgm((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  ASSERT_EQ(pgm.substr(0, 2), "P5");
  const std::string pixels = pgm.substr(pgm.size() - map.grid().size());
  const int height = map.geometry().height;
  const auto pixel = [&](Cell cell) {
    return static_cast<unsigned char>(pixels[map.geometry().index({cell.x, height - 1 - cell.y})]);
  };
  EXPECT_EQ(pixel({0, 0}), 205);
  EXPECT_EQ(pixel({10, 20}), 254);
  EXPECT_EQ(pixel({17, 100}), 0);
}

TEST_F(MapIo, OverwritesAnOlderMap) {
  ASSERT_TRUE(map_files::saveMap(map, path("floor")).ok());
  map.beginScan();
  map.hit({1, 1});
  ASSERT_TRUE(map_files::saveMap(map, path("floor")).ok());
  EXPECT_TRUE(sim::loadWorld(path("floor.yaml")).map.cells() == map.grid().cells());
  EXPECT_EQ(files(), 3U) << "nothing is left lying around";
}

TEST_F(MapIo, SaysWhyItCannotSave) {
  EXPECT_EQ(map_files::saveMap(map, "").status, map_files::MapIoStatus::kBadPath);
  EXPECT_EQ(map_files::saveMap(map, directory.string() + "/").status, map_files::MapIoStatus::kBadPath);
  const map_files::MapIoResult nowhere = map_files::saveMap(map, path("no/such/floor"));
  EXPECT_EQ(nowhere.status, map_files::MapIoStatus::kBadPath);
  EXPECT_NE(nowhere.text.find("no such directory"), std::string::npos);
  const map_files::MapIoResult home = map_files::saveMap(map, "~/map");
  EXPECT_EQ(home.status, map_files::MapIoStatus::kBadPath);
  EXPECT_NE(home.text.find("only a shell replaces '~'"), std::string::npos) << home.text;
  occupancy::OccupancyMap empty;
  EXPECT_EQ(map_files::saveMap(empty, path("floor")).status, map_files::MapIoStatus::kEmptyMap);
  fs::create_directory(path("floor.pgm"));
  EXPECT_EQ(map_files::saveMap(map, path("floor")).status, map_files::MapIoStatus::kCannotWrite);
}

// [MAP-5] It could not be loaded, and would take the place of one that can.
TEST_F(MapIo, DoesNotSaveAMapThatWasEmptied_MAP_5) {
  ASSERT_TRUE(map_files::saveMap(map, path("floor")).ok());
  map.clear();
  const map_files::MapIoResult emptied = map_files::saveMap(map, path("floor"));
  EXPECT_EQ(emptied.status, map_files::MapIoStatus::kEmptyMap) << emptied.text;
  EXPECT_EQ(emptied.text, "the map is empty");
  EXPECT_TRUE(map_files::loadMap(path("floor"), map).ok());
  EXPECT_EQ(files(), 3U);
}

TEST_F(MapIo, KeepsAnOlderMapWhenSavingFails) {
  ASSERT_TRUE(map_files::saveMap(map, path("floor")).ok());
  const auto before = map.grid().cells();
  map.clear();
  map.hit({1, 1});
  fs::remove(path("floor.bt"));
  fs::create_directory(path("floor.bt"));
  ASSERT_EQ(map_files::saveMap(map, path("floor")).status, map_files::MapIoStatus::kCannotWrite);
  EXPECT_TRUE(sim::loadWorld(path("floor.yaml")).map.cells() == before);
}

TEST_F(MapIo, KeepsTheMapWhenAnOctreeCannotBeLoaded) {
  const auto before = map.grid().cells();
  EXPECT_EQ(map_files::loadOctree(path("floor.bt"), map).status, map_files::MapIoStatus::kMissing);
  write("floor.bt", "no octree");
  EXPECT_EQ(map_files::loadOctree(path("floor.bt"), map).status, map_files::MapIoStatus::kBroken);
  EXPECT_TRUE(map.grid().cells() == before);
}

// [MAP-5]
TEST_F(MapIo, LoadsWhatItSavedByTheSamePath_MAP_5) {
  ASSERT_TRUE(map_files::saveMap(map, path("floor")).ok());
  for (const char* name : {"floor", "floor.bt", "floor.yaml"}) {
    occupancy::OccupancyMap loaded;
    const map_files::MapIoResult result = map_files::loadMap(path(name), loaded);
    ASSERT_TRUE(result.ok()) << result.text;
    EXPECT_EQ(loaded.grid()[loaded.geometry().cellAt(map.geometry().centre({17, 120}))], kOccupied);
  }
}

// [MAP-5]
TEST_F(MapIo, LoadsTheYamlAndPictureOfAMapThatHasNoOctree_MAP_5) {
  ASSERT_TRUE(map_files::saveMap(map, path("floor")).ok());
  occupancy::OccupancyMap loaded;
  fs::remove(path("floor.bt"));
  EXPECT_EQ(map_files::loadMap(path("floor"), loaded).status, map_files::MapIoStatus::kMissing)
      << "a map of our own whose octree is gone is not whole";
  // Half a cell beside our own raster.
  const Vec2 shift(0.025, -0.025);
  const Vec2 origin = map.geometry().origin + shift;
  std::ostringstream yaml;
  yaml << "image: floor.pgm\nresolution: 0.05\norigin: [" << origin.x() << ", " << origin.y() << ", 0.0]\n";
  write("floor.yaml", yaml.str());
  const map_files::MapIoResult result = map_files::loadMap(path("floor"), loaded);
  ASSERT_TRUE(result.ok()) << result.text;
  EXPECT_NE(result.text.find("no octree"), std::string::npos) << result.text;
  const Vec2 offset = (origin - loaded.geometry().origin) / 0.05;
  for (std::size_t i = 0; i < map.grid().size(); ++i) {
    const Cell cell = map.geometry().cell(i);
    const Cell there{cell.x + static_cast<int>(std::lround(offset.x())),
                     cell.y + static_cast<int>(std::lround(offset.y()))};
    const std::int8_t was = map.grid()[i];
    const std::int8_t is = loaded.grid().get(there, kUnknown);
    ASSERT_EQ(isUnknown(is), isUnknown(was)) << cell.x << ", " << cell.y;
    ASSERT_EQ(isOccupied(is), isOccupied(was)) << cell.x << ", " << cell.y;
  }
  ASSERT_TRUE(map_files::saveMap(loaded, path("again")).ok()) << "its octree holds the cells as well";
  EXPECT_TRUE(map_files::loadMap(path("again.bt"), loaded).ok());
}

// [MAP-5] Other mappers save coarser and finer maps.
TEST_F(MapIo, LoadsAPictureWithCellsOfAnySize_MAP_5) {
  write("picture.pgm", "P2 3 2 255 0 254 205 254 254 205\n");  // occupied, free, unknown above free, free, unknown
  for (const char* resolution : {"0.1", "0.025", "0.07"}) {
    write("picture.yaml", std::string("image: picture.pgm\norigin: [1, 2, 0]\nresolution: ") + resolution + "\n");
    occupancy::OccupancyMap loaded;
    const map_files::MapIoResult result = map_files::loadMap(path("picture"), loaded);
    ASSERT_TRUE(result.ok()) << result.text;
    EXPECT_NE(result.text.find("have become 0.05 m"), std::string::npos) << result.text;
    const double cell = std::stod(resolution);
    const auto at = [&](double x, double y) {
      return loaded.grid().get(loaded.geometry().cellAt({1.0 + x * cell, 2.0 + y * cell}), kUnknown);
    };
    EXPECT_TRUE(isOccupied(at(0.5, 1.5))) << resolution;
    EXPECT_TRUE(isUnknown(at(2.9, 1.9))) << resolution;
  }
}

// [FLT-1] [MAP-5]
TEST_F(MapIo, RefusesAPictureWhoseCellsWouldBecomeTooMany_FLT_1_MAP_5) {
  write("picture.yaml", "image: picture.pgm\nresolution: 1\norigin: [0, 0, 0]\n");
  std::string wide = "P5\n5000 1000\n255\n";
  wide.append(5000 * 1000, '\xfe');
  write("picture.pgm", wide);
  const map_files::MapIoResult result = map_files::loadMap(path("picture"), map);
  EXPECT_EQ(result.status, map_files::MapIoStatus::kBroken);
  EXPECT_NE(result.text.find("too large"), std::string::npos) << result.text;
}

// [MAP-5]
TEST_F(MapIo, LoadsAllModesOfMapServer_MAP_5) {
  write("scale.pgm", "P2 3 1 255 0 254 150\n");
  write("raw.pgm", "P2 3 1 255 100 0 255\n");
  for (const char* mode : {"scale", "raw"}) {
    write(std::string(mode) + ".yaml",
          std::string("image: ") + mode + ".pgm\nresolution: 0.05\norigin: [0, 0, 0]\nmode: " + mode + "\n");
    occupancy::OccupancyMap loaded;
    const map_files::MapIoResult result = map_files::loadMap(path(mode), loaded);
    ASSERT_TRUE(result.ok()) << result.text;
    const auto at = [&](double x) { return loaded.grid().get(loaded.geometry().cellAt({x, 0.025}), kUnknown); };
    EXPECT_TRUE(isOccupied(at(0.025))) << mode;
    EXPECT_TRUE(isFree(at(0.075))) << mode;
    EXPECT_TRUE(isUnknown(at(0.125))) << mode;
  }
}

// [MAP-5]
TEST_F(MapIo, KeepsTheMapWhenAPictureCannotBeLoaded_MAP_5) {
  const auto before = map.grid().cells();
  write("picture.yaml", "image: none.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n");
  EXPECT_EQ(map_files::loadMap(path("picture"), map).status, map_files::MapIoStatus::kBroken);
  write("picture.pgm", "P2 2 2 255 0 0 254 254\n");
  for (const char* mode : {"abc", "[1, 2]"}) {
    write("picture.yaml", std::string("image: picture.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nmode: ") + mode + "\n");
    const map_files::MapIoResult other = map_files::loadMap(path("picture"), map);
    EXPECT_EQ(other.status, map_files::MapIoStatus::kBroken) << other.text;
    EXPECT_NE(other.text.find("mode"), std::string::npos) << other.text;
  }
  EXPECT_TRUE(map.grid().cells() == before);
}

// [MAP-5]
TEST_F(MapIo, KeepsTheMapWhenAPictureHoldsNoKnownCell_MAP_5) {
  const auto before = map.grid().cells();
  write("grey.yaml", "image: grey.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n");
  write("grey.pgm", "P2 2 2 255 205 205 205 205\n");
  const map_files::MapIoResult result = map_files::loadMap(path("grey"), map);
  EXPECT_EQ(result.status, map_files::MapIoStatus::kBroken) << result.text;
  EXPECT_NE(result.text.find("no known cell"), std::string::npos) << result.text;
  EXPECT_TRUE(map.grid().cells() == before);
}

// [MAP-5]
TEST_F(MapIo, KeepsTheMapWhenAnotherCannotBeLoaded_MAP_5) {
  const auto before = map.grid().cells();
  EXPECT_EQ(map_files::loadMap("", map).status, map_files::MapIoStatus::kBadPath);
  EXPECT_EQ(map_files::loadMap(path("none"), map).status, map_files::MapIoStatus::kMissing);
  occupancy::OccupancyMapParameters coarse;
  coarse.resolution = 0.1;
  occupancy::OccupancyMap other(coarse);
  ASSERT_EQ(other.reserve({0.0, 0.0}, {1.0, 1.0}), occupancy::MapRoom::kEnough);
  other.beginScan();
  other.hit({3, 3});
  ASSERT_TRUE(map_files::saveMap(other, path("coarse")).ok());
  EXPECT_EQ(map_files::loadMap(path("coarse"), map).status, map_files::MapIoStatus::kBroken);
  EXPECT_TRUE(map.grid().cells() == before);
  const std::string text = map_files::loadMap(path("coarse"), map).text;
  EXPECT_NE(text.find("cells are 0.1 m wide, those of the mapper's map 0.05 m"), std::string::npos) << text;
  EXPECT_NE(text.find("remove the entry 'octree' from " + path("coarse.yaml")), std::string::npos) << text;
}

// [MAP-5]
TEST_F(MapIo, KeepsTheMapWhenTheOtherIsOfAnotherHeight_MAP_5) {
  const auto before = map.grid().cells();
  occupancy::OccupancyMapParameters high;
  high.scanner_height += 0.5;
  occupancy::OccupancyMap other(high);
  ASSERT_EQ(other.reserve({0.0, 0.0}, {1.0, 1.0}), occupancy::MapRoom::kEnough);
  other.beginScan();
  other.hit({3, 3});
  ASSERT_TRUE(map_files::saveMap(other, path("high")).ok());
  EXPECT_EQ(map_files::loadMap(path("high"), map).status, map_files::MapIoStatus::kBroken);
  EXPECT_TRUE(map.grid().cells() == before);
}

TEST(MapIoStatus, HasAWordForEach) {
  for (int i = 0; i <= static_cast<int>(map_files::MapIoStatus::kBroken); ++i) {
    EXPECT_STRNE(toString(static_cast<map_files::MapIoStatus>(i)), "unknown");
  }
}

}  // namespace
}  // namespace frontier_pilot
