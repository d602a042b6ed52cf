#include "tools/map_log.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "frontier_pilot/sim/simulator.h"
#include "support/temporary_folder.h"

namespace frontier_pilot {
namespace {

namespace fs = std::filesystem;

std::string problemOf(const std::vector<std::string>& words) {
  try {
    tools::parseMapLogOptions(words);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

TEST(MapLogOptions, AreReadInAnyOrder) {
  const tools::MapLogOptions options = tools::parseMapLogOptions(
      {"--out=/tmp/x", "--resolution", "0.1", "drive.csv", "--mount", "0.1", "0", "-0.5", "--fov", "90", "--range",
       "12", "--relations", "r", "--scan", "/base_scan", "--odom", "wheel_odom"});
  EXPECT_EQ(options.log, "drive.csv");
  EXPECT_EQ(options.out, "/tmp/x");
  EXPECT_EQ(options.mapper.map.resolution, 0.1);
  EXPECT_EQ(options.scanner.T_base_sensor, Pose2(0.1, 0.0, -0.5));
  EXPECT_DOUBLE_EQ(options.scanner.field_of_view.value(), kPi / 2.0);
  EXPECT_EQ(options.scanner.range_max, 12.0);
  EXPECT_EQ(options.relations, "r");
  EXPECT_EQ(options.topics.scan, "/base_scan");
  EXPECT_EQ(options.topics.odom, "wheel_odom");
}

TEST(MapLogOptions, SayWhatIsWrong) {
  EXPECT_EQ(problemOf({}), "no log given");
  EXPECT_EQ(problemOf({"a"}), "--out is missing: where should the map go?");
  EXPECT_EQ(problemOf({"a", "b", "--out", "x"}), "more than one log: a and b");
  EXPECT_EQ(problemOf({"a", "--fast"}), "unknown option --fast");
  EXPECT_EQ(problemOf({"a", "--out", "x", "--range", "0"}), "--range must be positive");
  EXPECT_EQ(problemOf({"a", "--out", "x", "--fov", "361"}), "--fov must be at most 360 degrees");
}

// [FLT-1] What sizes memory has the bounds that it has in messages and parameters.
TEST(MapLogOptions, AreBoundedWhereTheySizeMemory_FLT_1) {
  for (const char* resolution : {"0.001", "0.0099", "10.1", "1e-10", "-1"}) {
    EXPECT_EQ(problemOf({"a", "--out", "x", "--resolution", resolution}), "--resolution must be between 0.01 and 10 m");
  }
  EXPECT_EQ(problemOf({"a", "--out", "x", "--mount", "-1e9", "1e9", "1"}), "--mount must be within 10 m of the base");
  EXPECT_EQ(problemOf({"a", "--out", "x", "--mount", "8", "8", "0"}), "--mount must be within 10 m of the base");
  EXPECT_EQ(problemOf({"a", "--out", "x", "--mount", "0", "0", "1e30"}), "--mount must have a yaw within 2 pi");
  EXPECT_EQ(problemOf({"a", "--out", "x", "--mount", "9", "0", "0", "--resolution", "0.01"}), "none");
}

// [FLT-1]
TEST(MapLogOptions, WantNamesOfTopicsThatThereCanBe_FLT_1) {
  for (const char* name : {"/", "//scan", "scan/", "a b", "1scan", "/scan//b", "sc\nan", "~scan", "-"}) {
    EXPECT_EQ(problemOf({"a", "--out", "x", "--scan", name}),
              std::string("--scan needs the name of a topic, not '") + name + "'");
    EXPECT_NE(problemOf({"a", "--out", "x", "--odom", name}), "none") << name;
    EXPECT_NE(problemOf({"a", "--out", "x", "--base", name}), "none") << name;
  }
  EXPECT_EQ(problemOf({"a", "--out", "x", "--scan", ""}), "--scan needs a value");
  for (const char* name : {"scan", "/scan", "robot1/scan_2", "/a/1"}) {
    EXPECT_EQ(problemOf({"a", "--out", "x", "--scan", name}), "none") << name;
  }
}

/// A drive of 2 m along the middle of a corridor 2 m wide, 40 scans of 181 beams.
void writeDrive(const std::string& path) {
  std::ofstream file(path);
  for (int i = 0; i < 40; ++i) {
    file << 0.1 * i << "," << 0.05 * i << ",0,0";
    for (int beam = 0; beam <= 180; ++beam) {
      const double across = std::abs(std::sin((beam - 90) * kPi / 180.0));
      file << "," << (across > 0.2 ? 1.0 / across : 0.0);
    }
    file << "\n";
  }
}

/// While it lives, this process makes no file larger than so many bytes.
class LargestFile {
 public:
  explicit LargestFile(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~LargestFile() { setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_{};
};

class MapLog : public ::testing::Test {
 protected:
  void SetUp() override { writeDrive(path("drive.csv")); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  /// Runs the program: its exit code and what it printed.
  int run(const std::vector<std::string>& words, const tools::BagReader& read_bag = {}) {
    ::testing::internal::CaptureStdout();
    ::testing::internal::CaptureStderr();
    const int code = tools::runMapLog(words, read_bag);
    out_ = ::testing::internal::GetCapturedStdout();
    errors_ = ::testing::internal::GetCapturedStderr();
    return code;
  }

  const test::TemporaryFolder temporary;
  const fs::path folder_ = temporary.path();
  std::string out_;
  std::string errors_;
};

TEST_F(MapLog, WritesMapTrajectoriesAndPicture) {
  ASSERT_EQ(run({path("drive.csv"), "--out", path("map"), "--mount", "0", "0", "0"}), 0) << errors_;
  const OccupancyGrid map = sim::loadWorld(path("map.yaml")).map;
  EXPECT_EQ(map.get(map.geometry().cellAt({1.5, 0.02}), kUnknown), kFree);
  EXPECT_EQ(map.get(map.geometry().cellAt({1.5, 1.02}), kUnknown), kOccupied);
  EXPECT_TRUE(fs::exists(path("map.bt")));
  for (const char* name : {"map.tum", "map_odom.tum"}) {
    std::ifstream file(path(name));
    EXPECT_EQ(std::count(std::istreambuf_iterator<char>(file), {}, '\n'), 40) << name;
  }
  EXPECT_FALSE(cv::imread(path("map.png")).empty());
  EXPECT_NE(out_.find("40 scans of 181 beams"), std::string::npos) << out_;
}

TEST_F(MapLog, PrintsTheErrorAgainstRelations) {
  std::ofstream(path("relations")) << "0 20 1.25 0 0\n";
  ASSERT_EQ(run({path("drive.csv"), "--out", path("map"), "--relations", path("relations")}), 0) << errors_;
  EXPECT_NE(out_.find("odometry : translation 0.250 +- 0.000 m, rotation 0.00"), std::string::npos) << out_;
  EXPECT_NE(out_.find("corrected: translation 0.2"), std::string::npos) << out_;
}

// [MAP-1] A real robot with bad odometry: 4.8 m and 17 degrees off, where there is the log.
TEST_F(MapLog, MapsARealLogAccurately_MAP_1) {
  const char* folder = std::getenv("FRONTIER_PILOT_LOGS");
  const std::string log = std::string(folder != nullptr ? folder : PROJECT_ROOT "/../shared/logs") + "/telecom_loop";
  if (!fs::exists(log + ".csv")) GTEST_SKIP() << "no " << log << ".csv";
  ASSERT_EQ(run({log + ".csv", "--out", path("map"), "--relations", log + ".relations"}), 0) << errors_;
  const std::string mark = "corrected: translation ";
  ASSERT_NE(out_.find(mark), std::string::npos) << out_;
  double translation = 0.0;
  double rotation = 0.0;
  ASSERT_EQ(
      std::sscanf(out_.c_str() + out_.find(mark) + mark.size(), "%lf +- %*f m, rotation %lf", &translation, &rotation),
      2)
      << out_;
  EXPECT_LT(translation, 0.15) << "[m]";
  EXPECT_LT(rotation, 1.0) << "[degrees]";
}

TEST_F(MapLog, SaysWhatItCannotReadOrWrite) {
  EXPECT_EQ(run({path("none.csv"), "--out", path("map")}), 1);
  EXPECT_NE(errors_.find("none.csv: cannot be read"), std::string::npos) << errors_;
  std::ofstream(path("broken.csv")) << "1,0,0,0,5,9\n2,0,0,zero\n";
  EXPECT_EQ(run({path("broken.csv"), "--out", path("map")}), 1);
  EXPECT_NE(errors_.find("broken.csv:2: odometry's yaw is not a number: 'zero'"), std::string::npos) << errors_;
  EXPECT_EQ(run({path("drive.csv"), "--out", path("no/such/map")}), 1);
  EXPECT_NE(errors_.find("no/such: No such file or directory"), std::string::npos) << errors_;
  EXPECT_EQ(out_, "") << "said before the drive is mapped, which may take an hour";
  EXPECT_EQ(run({path("drive.csv"), "--out", path("map"), "--relations", path("none")}), 1);
  EXPECT_NE(errors_.find("none: cannot be read"), std::string::npos) << errors_;
  EXPECT_EQ(out_, "") << "likewise";
  EXPECT_EQ(run({path("drive.csv")}), 2);
  EXPECT_NE(errors_.find("usage: map_log"), std::string::npos);
}

TEST_F(MapLog, ReplacesNoFileThatItReads) {
  fs::rename(path("drive.csv"), path("drive.png"));
  fs::create_symlink(path("drive.png"), path("drive.csv"));
  EXPECT_EQ(run({path("drive.csv"), "--out", path("drive")}), 1);
  EXPECT_EQ(errors_, "map_log: " + path("drive.csv") + ": would be replaced by a result, choose another --out\n");
}

TEST_F(MapLog, SaysThatItCannotWriteUnderANameBeforeItMaps) {
  fs::create_directory(path("taken.png"));
  const std::string too_long = path(std::string(247, 'x'));
  for (const auto& [out, words] :
       std::vector<std::pair<std::string, std::string>>{{folder_.string() + "/", "names no file"},
                                                        {too_long, "is longer than"},
                                                        {path("a\tb"), "control character"},
                                                        {path("\xff"), "UTF-8"},
                                                        {path("taken"), "it is a folder"}}) {
    EXPECT_EQ(run({path("drive.csv"), "--out", out}), 1);
    EXPECT_NE(errors_.find(words), std::string::npos) << errors_;
    EXPECT_EQ(out_, "") << "said before the drive is mapped, which may take an hour";
  }
}

// A map that the disk does not take leaves the trajectories of the map of before, which is still there.
TEST_F(MapLog, ReplacesNothingIfTheMapCannotBeWritten_MAP_5) {
  std::ofstream(path("map.tum")) << "of before";
  const LargestFile limit(4000);
  EXPECT_EQ(run({path("drive.csv"), "--out", path("map")}), 1);
  EXPECT_NE(errors_.find("File too large"), std::string::npos) << errors_;
  std::ifstream trajectory(path("map.tum"));
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(trajectory), {}), "of before");
}

// [FLT-1] Nothing that lies about under a result's name is followed, and a pipe is not waited for.
TEST_F(MapLog, ReplacesLinksAndReadsFilesOnly_FLT_1) {
  std::ofstream(path("victim")) << "precious";
  for (const char* name : {"map.tum", "map_odom.tum", "map.png", "map.bt"})
    fs::create_symlink(path("victim"), path(name));
  ASSERT_EQ(run({path("drive.csv"), "--out", path("map")}), 0) << errors_;
  std::ifstream victim(path("victim"));
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(victim), {}), "precious");
  EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(path("map.tum"))));
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  EXPECT_EQ(run({path("pipe"), "--out", path("map")}), 1);
  EXPECT_NE(errors_.find("pipe: is not a regular file"), std::string::npos) << errors_;
  EXPECT_EQ(run({folder_.string(), "--out", path("map")}), 1);
}

TEST_F(MapLog, RefusesToDescribeTheScannerOfARosbagWhichDoesSoItself) {
  std::ofstream(path("drive.bag")) << "#ROSBAG V2.0\n";
  const tools::BagReader reader = [](const std::string&, const tools::BagTopics&) -> logs::ScanLog {
    throw logs::LogError("the bag was read");
  };
  for (const std::vector<std::string>& scanner :
       {std::vector<std::string>{"--fov", "180"}, {"--mount", "0", "0", "0"}}) {
    std::vector<std::string> words{path("drive.bag"), "--out", path("map")};
    words.insert(words.end(), scanner.begin(), scanner.end());
    EXPECT_EQ(run(words, reader), 2) << scanner.front();
    EXPECT_NE(errors_.find("are not for a rosbag"), std::string::npos) << errors_;
  }
}

TEST_F(MapLog, TakesLongerRangesThanTheGivenOneForNoReturnsAlsoInARosbag) {
  std::ofstream(path("drive.bag")) << "#ROSBAG V2.0\n";
  std::optional<double> range_max;
  const tools::BagReader reader = [&](const std::string&, const tools::BagTopics&) {
    std::ifstream drive(path("drive.csv"));
    return logs::readScanLog(drive, "drive.csv", {Pose2(), range_max, {}});
  };
  const auto wall = [&](const std::vector<std::string>& range) {
    std::vector<std::string> words{path("drive.bag"), "--out", path("map")};
    words.insert(words.end(), range.begin(), range.end());
    EXPECT_EQ(run(words, reader), 0) << errors_;
    const OccupancyGrid map = sim::loadWorld(path("map.yaml")).map;
    return map.get(map.geometry().cellAt({1.5, 1.02}), kUnknown);
  };
  EXPECT_EQ(wall({}), kOccupied);
  EXPECT_NE(wall({"--range", "0.8"}), kOccupied);
  range_max = 0.8;
  EXPECT_NE(wall({"--range", "200"}), kOccupied) << "the scanner does not see farther for that";
}

TEST_F(MapLog, HandsARosbagToItsReader) {
  std::ofstream(path("drive.bag")) << "#ROSBAG V2.0\n";
  EXPECT_EQ(run({path("drive.bag"), "--out", path("map")}), 1);
  EXPECT_NE(errors_.find("without ROS"), std::string::npos) << errors_;
  std::string asked;
  const tools::BagReader reader = [&](const std::string& bag, const tools::BagTopics& topics) {
    asked = bag + " " + topics.scan;
    std::ifstream file(path("drive.csv"));
    return logs::readScanLog(file, "drive.csv");
  };
  EXPECT_EQ(run({path("drive.bag"), "--out", path("map"), "--scan", "laser"}, reader), 0) << errors_;
  EXPECT_EQ(asked, path("drive.bag") + " laser");
}

TEST_F(MapLog, HelpsWhenAsked) {
  EXPECT_EQ(run({"--help"}), 0);
  EXPECT_NE(out_.find("--relations FILE"), std::string::npos);
}

}  // namespace
}  // namespace frontier_pilot
