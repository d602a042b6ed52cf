#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "frontier_pilot/map_files/map_io.h"
#include "support/temporary_folder.h"

namespace frontier_pilot {
namespace {

namespace fs = std::filesystem;

/// A map with a wall of one cell, saved as `floor`.
class EditedMap : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(map.reserve({0.0, 0.0}, {1.0, 1.0}), occupancy::MapRoom::kEnough);
    map.beginScan();
    for (int x = 5; x < 15; ++x) map.miss({x, 10});
    map.hit(kWall);
    ASSERT_TRUE(map_files::saveMap(map, path("floor")).ok());
  }

  std::string path(const std::string& name) const { return (temporary.path() / name).string(); }
  std::string read(const std::string& name) const {
    std::ifstream file(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }
  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
  }
  /// The picture without its only dark pixel, as somebody leaves it who has erased what stood there.
  std::string withoutWall(const std::string& name = "floor.pgm") const {
    std::string picture = read(name);
    for (std::size_t i = picture.size() - map.grid().size(); i < picture.size(); ++i) {
      if (picture[i] == '\0') picture[i] = static_cast<char>(254);
    }
    return picture;
  }
  map_files::MapIoResult load() { return map_files::loadMap(path("floor"), loaded); }
  std::int8_t at(Cell cell) const {
    return loaded.grid().get(loaded.geometry().cellAt(map.geometry().centre(cell)), kUnknown);
  }
  std::int8_t atWall() const { return at(kWall); }

  static constexpr Cell kWall{10, 12};
  const test::TemporaryFolder temporary;
  occupancy::OccupancyMap map;
  occupancy::OccupancyMap loaded;
};

TEST_F(EditedMap, IsLoadedFromTheOctreeAsLongAsNobodyHasEditedIt) {
  const map_files::MapIoResult result = load();
  ASSERT_TRUE(result.ok()) << result.text;
  EXPECT_EQ(result.text, "loaded " + path("floor.bt"));
  EXPECT_EQ(atWall(), kOccupied);
}

TEST_F(EditedMap, IsLoadedAsItsPictureShowsItAndSaysSo_MAP_5) {
  write("floor.pgm", withoutWall());
  const map_files::MapIoResult result = load();
  ASSERT_TRUE(result.ok()) << result.text;
  EXPECT_NE(result.text.find("edited after the map was saved"), std::string::npos) << result.text;
  EXPECT_FALSE(result.doubtful);
  EXPECT_EQ(atWall(), kFree);
}

TEST_F(EditedMap, DoesNotGrowHoweverOftenItIsEditedLoadedAndSaved_MAP_5) {
  for (int i = 0; i < 4; ++i) {
    std::string picture = read("floor.pgm");
    picture[picture.find(static_cast<char>(254))] = '\0';  // one more of its free pixels becomes a wall
    write("floor.pgm", picture);
    ASSERT_TRUE(load().ok());
    ASSERT_TRUE(map_files::saveMap(loaded, path("floor")).ok());
    EXPECT_LE(loaded.geometry().width, map.geometry().width) << i;
    EXPECT_LE(loaded.geometry().height, map.geometry().height) << i;
  }
}

TEST_F(EditedMap, IsLoadedFromAnotherPictureThatItsYamlNames) {
  write("mine.pgm", withoutWall());
  std::string yaml = read("floor.yaml");
  yaml.replace(yaml.find("floor.pgm"), 9, "mine.pgm");
  write("floor.yaml", yaml);
  ASSERT_TRUE(load().ok());
  EXPECT_EQ(atWall(), kFree);
}

TEST_F(EditedMap, IsLoadedFromTheOctreeIfItsPictureCannotBeReadAndSaysSo) {
  write("floor.pgm", "P5 nonsense");
  const map_files::MapIoResult result = load();
  ASSERT_TRUE(result.ok()) << result.text;
  EXPECT_NE(result.text.find("cannot be used: "), std::string::npos) << result.text;
  EXPECT_TRUE(result.doubtful);
  EXPECT_EQ(atWall(), kOccupied);
  fs::remove(path("floor.pgm"));
  EXPECT_EQ(load().text, "loaded " + path("floor.bt"));
  EXPECT_FALSE(load().doubtful);
}

// The YAML of a renamed map names the picture of before, which is that of the map that was saved there since.
TEST_F(EditedMap, IsLoadedFromItsOwnFilesAfterTheyWereRenamed_MAP_5) {
  for (const char* extension : {".pgm", ".yaml", ".bt"})
    fs::rename(path("floor") + extension, path("monday") + extension);
  map.beginScan();
  map.hit({11, 12});
  ASSERT_TRUE(map_files::saveMap(map, path("floor")).ok());
  const map_files::MapIoResult result = map_files::loadMap(path("monday"), loaded);
  EXPECT_EQ(result.text, "loaded " + path("monday.bt"));
  EXPECT_EQ(atWall(), kOccupied);
  EXPECT_NE(at({11, 12}), kOccupied) << "of the map that has its name now";

  write("monday.pgm", withoutWall("monday.pgm"));
  const map_files::MapIoResult edited = map_files::loadMap(path("monday"), loaded);
  EXPECT_NE(edited.text.find("edited after the map was saved"), std::string::npos) << edited.text;
  EXPECT_EQ(atWall(), kFree);
}

// [MAP-5] map_server's map_saver overwrites the picture and the YAML only.
TEST_F(EditedMap, IsLoadedFromTheMapThatAnotherProgramHasSavedUnderItsName_MAP_5) {
  write("floor.pgm", withoutWall());
  const std::string yaml = read("floor.yaml");
  write("floor.yaml", yaml.substr(0, yaml.find("octree:")));
  const map_files::MapIoResult result = load();
  ASSERT_TRUE(result.ok()) << result.text;
  EXPECT_EQ(result.text, "loaded " + path("floor.yaml") + " from its image: its YAML names no octree");
  EXPECT_EQ(atWall(), kFree);
}

TEST_F(EditedMap, SaysHowItsPictureIsLoadedAloneIfItsOctreeIsMissing) {
  fs::remove(path("floor.bt"));
  EXPECT_EQ(load().text, path("floor.bt") + ": no such file; to load the image alone, remove the entry 'octree' from " +
                             path("floor.yaml"));
  const std::string yaml = read("floor.yaml");
  const std::size_t begin = yaml.find("octree:");
  write("floor.yaml", yaml.substr(0, begin) + yaml.substr(yaml.find("picture:")));
  EXPECT_EQ(load().text, "loaded " + path("floor.yaml") + " from its image: it has no octree");
  EXPECT_EQ(atWall(), kOccupied);
}

TEST_F(EditedMap, IsLoadedFromItsOwnPictureAloneAlsoAfterItWasRenamed_MAP_5) {
  for (const char* extension : {".pgm", ".yaml"}) fs::rename(path("floor") + extension, path("monday") + extension);
  write("floor.pgm", withoutWall("monday.pgm"));
  const std::string yaml = read("monday.yaml");
  write("monday.yaml", yaml.substr(0, yaml.find("octree:")) + yaml.substr(yaml.find("picture:")));
  ASSERT_TRUE(map_files::loadMap(path("monday"), loaded).ok());
  EXPECT_EQ(atWall(), kOccupied);
}

// [MAP-5]
TEST_F(EditedMap, IsRefusedForItsPlaceAndNotForItsSizeWhereItsOriginIsFarAway_MAP_5) {
  write("far.pgm", withoutWall());
  write("far.yaml", "image: far.pgm\nresolution: 0.05\norigin: [5000, 0, 0]\n");
  const map_files::MapIoResult result = map_files::loadMap(path("far"), loaded);
  EXPECT_EQ(result.text, path("far.yaml") + ": lies farther than 1638.4 m from the frame's origin");
}

// A way out that does not lead out is worse than none.
TEST_F(EditedMap, IsNotSaidToBeLoadedFromItsPictureWhereThatCannotBeRead_MAP_5) {
  fs::remove(path("floor.bt"));
  fs::remove(path("floor.pgm"));
  EXPECT_EQ(load().text, path("floor.bt") + ": no such file");
}

TEST_F(EditedMap, CountsAsSavedWhenItIsSavedAgain) {
  write("floor.pgm", withoutWall());
  ASSERT_TRUE(load().ok());
  ASSERT_TRUE(map_files::saveMap(loaded, path("floor")).ok());
  const map_files::MapIoResult result = load();
  EXPECT_EQ(result.text, "loaded " + path("floor.bt"));
  EXPECT_EQ(atWall(), kFree);
}

TEST_F(EditedMap, SaysThatThePictureOfTheSaveBeforeDoesNotCount_MAP_5) {
  const std::string before = read("floor.pgm");
  map.beginScan();
  map.hit({3, 4});
  ASSERT_TRUE(map_files::saveMap(map, path("floor")).ok());
  write("floor.pgm", before);
  const map_files::MapIoResult result = load();
  EXPECT_EQ(result.text, "loaded " + path("floor.bt") +
                             "; its image does not count, because it is that of the save before the last one");
  EXPECT_TRUE(result.doubtful);
  EXPECT_EQ(at({3, 4}), kOccupied);
}

}  // namespace
}  // namespace frontier_pilot
