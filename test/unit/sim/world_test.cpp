#include "frontier_pilot/sim/simulator.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <vector>

namespace frontier_pilot::sim {
namespace {

class WorldFiles : public ::testing::Test {
 protected:
  WorldFiles()
      : folder_(std::filesystem::temp_directory_path() / ("frontier_pilot_worlds_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
    write("world.pgm", "P2\n# a comment\n3 2\n255\n254 205 0\n0 254 254\n");
  }
  ~WorldFiles() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return (folder_ / name).string();
  }
  std::string writeYaml(const std::string& text) const { return write("world.yaml", text); }
  std::string refusal(const std::string& path) const {
    try {
      loadWorld(path);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  std::filesystem::path folder_;
  const std::string rest_ =
      "resolution: 0.1\norigin: [1.0, -2.0, 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
};

// [SIM-1] a map_server file, read as map_server reads it
TEST_F(WorldFiles, ReadsWhatMapServerReads_SIM_1) {
  const World world = loadWorld(writeYaml("image: world.pgm\n" + rest_));
  EXPECT_EQ(world.map.geometry(), (GridGeometry{0.1, {1.0, -2.0}, 3, 2}));
  EXPECT_EQ(world.map.cells(), (std::vector<std::int8_t>{kOccupied, kFree, kFree, kFree, kUnknown, kOccupied}));
  EXPECT_FALSE(world.start);
}

TEST_F(WorldFiles, ToleratesUnknownKeysAndReadsTheStart_SIM_1) {
  const World world = loadWorld(writeYaml("image: world.pgm\nfriend: 3\nmode: trinary\nstart: [1, 2, 3.0]\n" + rest_));
  ASSERT_TRUE(world.start);
  EXPECT_EQ(*world.start, Pose2(1.0, 2.0, 3.0));
}

TEST_F(WorldFiles, NegatesWhenTold_SIM_1) {
  std::string text = "image: world.pgm\n" + rest_;
  text.replace(text.find("negate: 0"), 9, "negate: 1");
  EXPECT_EQ(loadWorld(writeYaml(text)).map.cells().back(), kFree);
}

// [SIM-1]
TEST_F(WorldFiles, SayThatAPictureNeedsAYamlToDescribeIt_SIM_1) {
  for (const std::string& picture :
       {write("floor.png", "\x89PNG\r\n\x1a\n...."), write("floor.pgm", "P5\n3 2\n255\n......"),
        write("floor.jpg", "\xff\xd8\xff\xe0....")}) {
    EXPECT_NE(refusal(picture).find("is a picture, and not the YAML that describes one"), std::string::npos)
        << refusal(picture);
  }
  EXPECT_NE(refusal((folder_ / "floor.png").string()).find("'image: floor.png'"), std::string::npos);
}

// [SIM-1] every defect is named, with the file
TEST_F(WorldFiles, NamesEveryDefect_SIM_1) {
  EXPECT_NE(refusal((folder_ / "none.yaml").string()).find("none.yaml: cannot be read"), std::string::npos);
  EXPECT_NE(refusal(writeYaml("image: [")).find("world.yaml"), std::string::npos);
  const std::string bare = refusal(writeYaml("negate: 0\n"));
  for (const char* key : {"image: missing", "resolution: missing", "origin: must be"}) {
    EXPECT_NE(bare.find(key), std::string::npos) << bare;
  }
  EXPECT_NE(refusal(writeYaml("image: other.pgm\n" + rest_)).find("other.pgm does not exist"), std::string::npos);
  write("broken.pgm", "P5\n3 2\n255\n");
  EXPECT_NE(refusal(writeYaml("image: broken.pgm\n" + rest_)).find("broken.pgm"), std::string::npos);
  write("text.pgm", "not a picture");
  EXPECT_NE(refusal(writeYaml("image: text.pgm\n" + rest_)).find("cannot be read as PGM or PNG"), std::string::npos);
  const std::string rotated = "image: world.pgm\nresolution: 0.1\norigin: [0, 0, 0.5]\n";
  EXPECT_NE(refusal(writeYaml(rotated)).find("rotated"), std::string::npos);
  EXPECT_NE(refusal(writeYaml("image: world.pgm\nmode: shades\n" + rest_)).find("must be trinary"), std::string::npos);
  EXPECT_EQ(refusal(writeYaml("image: world.pgm\nresolution: 5\norigin: [0, 0, 0]\n")).find("missing"),
            std::string::npos)
      << "a wrong resolution is not missing";
  EXPECT_NE(refusal(writeYaml("image: world.pgm\nresolution: .nan\norigin: [0, 0, 0]\n")).find("resolution"),
            std::string::npos);
}

// [FLT-1] [SIM-1]
TEST_F(WorldFiles, MayNameAnImageOnlyAsAFileMayBeNamed_FLT_1_SIM_1) {
  EXPECT_NE(refusal(writeYaml("image: \"world.pgm\\0x\"\n" + rest_)).find("no file name holds a NUL"),
            std::string::npos);
  const std::string line = refusal(writeYaml("image: |\n  other.pgm\n" + rest_));
  EXPECT_NE(line.find("other.pgm\\n does not exist"), std::string::npos) << line;
}

// [FLT-1] [SIM-1] A pipe would keep the simulator waiting, a device would never end.
TEST_F(WorldFiles, AreFilesAndNothingElse_FLT_1_SIM_1) {
  const std::string pipe = (folder_ / "pipe").string();
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& odd : {pipe, folder_.string(), std::string("/dev/zero")}) {
    EXPECT_NE(refusal(odd).find("is not a regular file"), std::string::npos) << odd << ": " << refusal(odd);
    EXPECT_NE(refusal(writeYaml("image: " + odd + "\n" + rest_)).find("is not a regular file"), std::string::npos)
        << odd;
  }
}

// [FLT-1] [SIM-1] What a world announces sizes grids before it is known to be there.
TEST_F(WorldFiles, AreOfASizeThatCanBeHeld_FLT_1_SIM_1) {
  for (const char* header : {"P5\n30000 30000\n255\n", "P5 2147483647 2147483647 255\n", "P2\n#\n99999999 1\n255\n",
                             "P5\n18446744073709551615 3\n255\n", "P5 -3 2 255\n"}) {
    write("huge.pgm", std::string(header) + "xxx");
    EXPECT_NE(refusal(writeYaml("image: huge.pgm\n" + rest_)), "") << header;
  }
  write("huge.pgm", "P5\n30000 30000\n255\nxxx");
  EXPECT_NE(refusal(writeYaml("image: huge.pgm\n" + rest_)).find("more than 64000000 pixels"), std::string::npos);
  for (const char* resolution : {".nan", ".inf", "-.inf", "0", "-0.1", "1e-10", "1e10", "1e-320"}) {
    const std::string text = std::string("image: world.pgm\norigin: [0, 0, 0]\nresolution: ") + resolution + "\n";
    EXPECT_NE(refusal(writeYaml(text)).find("resolution"), std::string::npos) << resolution;
  }
  for (const char* origin : {"[.nan, 0, 0]", "[0, .inf, 0]", "[1e300, 0, 0]", "[0]", "{}", "[0, 0, 0, 0]"}) {
    const std::string text = std::string("image: world.pgm\nresolution: 0.1\norigin: ") + origin + "\n";
    EXPECT_NE(refusal(writeYaml(text)).find("origin"), std::string::npos) << origin;
  }
  EXPECT_NE(refusal(writeYaml(std::string(200000, '['))), "");
  EXPECT_NE(refusal(writeYaml(std::string(2000000, ' ') + "image: world.pgm\n" + rest_)).find("larger"),
            std::string::npos);
}

// [FLT-1] [SIM-1] A comment ends with CR, too: OpenCV knows that, and would have read another size than the one
// checked.
TEST_F(WorldFiles, HaveTheSizeThatWasChecked_FLT_1_SIM_1) {
  write("comment.pgm", "P5\n#\r60000 1\n2 2\n255\n" + std::string(60000, 'x'));
  EXPECT_NE(refusal(writeYaml("image: comment.pgm\n" + rest_)).find("longer than 5000 m"), std::string::npos)
      << refusal(writeYaml("image: comment.pgm\n" + rest_));
}

// [SIM-1] as map_server does
TEST_F(WorldFiles, AreAsDarkAsTheGreatestValueOfTheImageSays_SIM_1) {
  const std::vector<std::int8_t> cells = {kOccupied, kUnknown, kFree};
  for (const std::string& image :
       {std::string("P2 3 1 15 0 9 # nine\n 15"), std::string("P5 3 1 15\n\0\x09\x0f", 13),
        std::string("P5 3 1 1500\n\0\0\x03\x84\x05\xdc", 18), std::string("P2\r#\r3\r1\r1000\r0 600 2000\r")}) {
    write("shades.pgm", image);
    EXPECT_EQ(loadWorld(writeYaml("image: shades.pgm\n" + rest_)).map.cells(), cells) << image;
  }
}

// [FLT-1] [SIM-1]
TEST_F(WorldFiles, HaveAllPixelsThatTheImageAnnounces_FLT_1_SIM_1) {
  for (const std::string& image :
       {std::string("P2 3 1 255 0 1"), std::string("P2 3 1 255 0 1 x"), std::string("P2 3 1 255 0 1 -1"),
        std::string("P5 3 1 255\nab"), std::string("P5 3 1 256\nabcde"), std::string("P5 3 1 0\nabc"),
        std::string("P5 0 1 255\n"), std::string("P5 3 1 65536\nabcdef"), std::string("P5 3 1 255"),
        std::string("P5x3 1 255\nabc")}) {
    write("short.pgm", image);
    EXPECT_NE(refusal(writeYaml("image: short.pgm\n" + rest_)).find("cannot be read as PGM or PNG"), std::string::npos)
        << image;
  }
}

// [SIM-1] map_server takes no notice of what a camera writes into a picture.
TEST_F(WorldFiles, AreNotTurnedByTheImagesOrientation_SIM_1) {
  write("turned.png",
        std::string(
            "\211\120\116\107\015\012\032\012\000\000\000\015\111\110\104\122\000\000\000\003\000\000\000\001\010\000"
            "\000\000\000\076\213\113\150\000\000\000\032\145\130\111\146\115\115\000\052\000\000\000\010\000\001\001"
            "\022\000\003\000\000\000\001\000\003\000\000\000\000\000\000\204\137\144\316\000\000\000\014\111\104\101"
            "\124\170\332\143\370\167\226\001\000\004\230\001\314\204\216\266\044\000\000\000\000\111\105\116\104\256"
            "\102\140\202",
            107));
  EXPECT_EQ(loadWorld(writeYaml("image: turned.png\n" + rest_)).map.cells(),
            (std::vector<std::int8_t>{kFree, kUnknown, kOccupied}));
}

// [FLT-1] [SIM-1]
TEST_F(WorldFiles, AreReadOrRefusedWhateverTheyHold_FLT_1_SIM_1) {
  const std::string yaml = "image: world.pgm\n" + rest_;
  const std::string pgm = "P5\n3 2\n255\n\xfe\xcd\x01\x02\xfe\xfe";
  std::mt19937 random(20);
  const auto below = [&](std::size_t limit) {
    return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random);
  };
  const auto spoilt = [&](std::string bytes) {
    for (std::size_t flips = below(5); flips > 0; --flips) bytes[below(bytes.size())] = static_cast<char>(below(256));
    if (below(4) == 0) bytes.resize(below(bytes.size()));
    return bytes;
  };
  std::size_t refused = 0;
  for (int i = 0; i < 600; ++i) {
    write("world.pgm", spoilt(pgm));
    refused += refusal(writeYaml(i % 2 == 0 ? yaml : spoilt(yaml))).empty() ? 0 : 1;
  }
  EXPECT_GT(refused, 150U);
}

}  // namespace
}  // namespace frontier_pilot::sim
