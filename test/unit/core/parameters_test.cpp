#include "frontier_pilot/core/parameters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace frontier_pilot {
namespace {

Bounds positive() { return {0.0, std::numeric_limits<double>::infinity(), true}; }

struct Wheel {
  double radius = 0.033;
  template <class V>
  void describe(V& v) {
    v.field("radius", radius, "m", "of the wheel", positive());
  }
};

struct Sample {
  bool on = true;
  int count = 3;
  double rate = 10.0;
  std::string name = "burger";
  std::vector<double> polygon = {0.1, 0.2};
  std::vector<std::vector<double>> polygons;
  Wheel wheel;
  std::vector<Wheel> spares;

  template <class V>
  void describe(V& v) {
    v.field("on", on, "", "whether");
    v.field("count", count, "", "how many", between(1, 5));
    v.field("rate", rate, "Hz", "how often", positive());
    v.field("name", name, "", "what it is called");
    v.field("polygon", polygon, "m", "corners", Bounds{});
    v.field("polygons", polygons, "m", "corners of each", between(-10.0, 10.0));
    v.group("wheel", wheel, "the wheel");
    v.list("spares", spares, "more wheels");
  }
  void check(Problems& problems) const {
    if (rate > 100.0 && count > 4) problems.push_back("rate: too high for so many");
  }
};

Problems problemsOf(const std::string& yaml) {
  Sample sample;
  return loadParameters(parseYaml(yaml), sample);
}

bool anyMentions(const Problems& problems, const std::string& key) {
  return std::any_of(problems.begin(), problems.end(),
                     [&](const std::string& line) { return line.rfind(key + ":", 0) == 0; });
}

TEST(Parameters, AListOfListsIsReadWholeOrNotAtAll) {
  Sample sample;
  EXPECT_TRUE(loadParameters(parseYaml("polygons: [[1, 2.5], []]"), sample).empty());
  EXPECT_EQ(sample.polygons, (std::vector<std::vector<double>>{{1.0, 2.5}, {}}));
  EXPECT_EQ(loadParameters(parseYaml("polygons: [[1], [2, 11]]"), sample),
            Problems{"polygons[1]: must be >= -10 and <= 10, is 11"});
  EXPECT_EQ(loadParameters(parseYaml("polygons: [[1], 2]"), sample),
            Problems{"polygons[1]: must be a list of numbers"});
  EXPECT_EQ(loadParameters(parseYaml("polygons: 2"), sample), Problems{"polygons: must be a list of lists of numbers"});
  EXPECT_EQ(sample.polygons.size(), 2U) << "as it was";
}

TEST(Parameters, WhatIsGivenReplacesTheDefaultAndTheRestStays) {
  Sample sample;
  EXPECT_TRUE(loadParameters(parseYaml(R"(
on: false
rate: 20
name: "12"
polygon: [1, 2.5]
wheel: {radius: 0.05}
spares: [{radius: 1}, {}]
)"),
                             sample)
                  .empty());
  EXPECT_FALSE(sample.on);
  EXPECT_EQ(sample.count, 3);
  EXPECT_EQ(sample.rate, 20.0);
  EXPECT_EQ(sample.name, "12");
  EXPECT_EQ(sample.polygon, (std::vector<double>{1.0, 2.5}));
  EXPECT_EQ(sample.wheel.radius, 0.05);
  ASSERT_EQ(sample.spares.size(), 2U);
  EXPECT_EQ(sample.spares[0].radius, 1.0);
  EXPECT_EQ(sample.spares[1].radius, 0.033);
}

TEST(Parameters, EveryProblemIsReportedAtOnceByName) {
  const Problems problems = problemsOf(R"(
on: 3
count: 2.5
rate: .nan
wheel: {radius: -1, raduis: 2}
spares: [{radius: .inf}, 7]
nmae: x
)");
  for (const char* key :
       {"on", "count", "rate", "wheel/radius", "wheel/raduis", "spares[0]/radius", "spares[1]", "nmae"}) {
    EXPECT_TRUE(anyMentions(problems, key)) << key;
  }
  EXPECT_EQ(problems.size(), 8U);
}

TEST(Parameters, BoundsAreKept) {
  EXPECT_TRUE(problemsOf("count: 1").empty());
  EXPECT_TRUE(problemsOf("count: 5").empty());
  EXPECT_TRUE(anyMentions(problemsOf("count: 0"), "count"));
  EXPECT_TRUE(anyMentions(problemsOf("count: 6"), "count"));
  EXPECT_TRUE(anyMentions(problemsOf("rate: 0"), "rate"));
}

TEST(Parameters, ARuleBetweenFieldsIsCheckedToo) {
  EXPECT_TRUE(anyMentions(problemsOf("{rate: 101, count: 5}"), "rate"));
}

TEST(Parameters, ARefusedValueLeavesTheDefault) {
  Sample sample;
  EXPECT_FALSE(loadParameters(parseYaml("rate: -1"), sample).empty());
  EXPECT_EQ(sample.rate, 10.0);
}

TEST(Parameters, AKeyThatIsThereTwiceAndASecondDocumentAreErrors) {
  for (const char* text : {"a: 1\na: 2", "b: {a: 1, a: 2}", "a: 1\n---\na: 2"}) {
    EXPECT_THROW(parseYaml(text), std::invalid_argument) << text;
  }
  EXPECT_EQ(parseYaml("---\na: 1\n...\n").size(), 1U) << "marks of one document";
}

TEST(Parameters, BrokenYamlIsAnErrorWithItsPlace) {
  EXPECT_THROW(parseYaml("a: [1, 2"), std::invalid_argument);
  EXPECT_THROW(parseYaml("- a\n- b"), std::invalid_argument);
  EXPECT_THROW(loadYamlFile("/nowhere/at/all.yaml"), std::invalid_argument);
  EXPECT_TRUE(parseYaml("").empty());
}

// [FLT-1] the parser quotes the byte at which it fails, which need not be text
TEST(Parameters, FLT_1_BrokenYamlIsRefusedInWordsThatCanBePrinted) {
  try {
    parseYaml("a: \"\\\xcf\"");
    FAIL() << "an escape that there is not";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("\\xcf"), std::string::npos) << error.what();
  }
}

// [FLT-1]
TEST(Parameters, FLT_1_YamlWhoseAliasesMakeACycleOrABombIsAnError) {
  for (const char* cycle :
       {"a: &a [*a]", "a: &a {b: *a}", "a: {file: x, bytes: &b [*b]}", "&m {image: q.pgm, <<: *m}"}) {
    EXPECT_THROW(parseYaml(cycle), std::invalid_argument) << cycle;
  }
  std::string bomb = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 12; ++i) {
    const std::string before = "*a" + std::to_string(i - 1);
    bomb += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + before;
    for (int j = 1; j < 10; ++j) bomb += ", " + before;
    bomb += "]\n";
  }
  EXPECT_THROW(parseYaml(bomb), std::invalid_argument) << "10^12 values";
  EXPECT_EQ(parseYaml("a: &a [1, 2]\nb: *a").size(), 2U) << "an alias by itself is fine";
}

// [FLT-1]
TEST(Parameters, FLT_1_AKeyOfYamlIsAWord) {
  for (const char* text : {"[1, 2]: 3", "{a: 1}: 2", "? \n: 1", "a: {[1]: 2}"}) {
    EXPECT_THROW(parseYaml(text), std::invalid_argument) << text;
  }
}

TEST(Parameters, ATextWrittenAsYamlIsReadAsTheSameText) {
  for (const char* text :
       {"floor", "1", "-2.5e3", "0x10", "true", "no", "~",  "null", ".nan", "",           " ",    "a: b", "# a",
        "- a",   "[", "\"",     "'",    "!x",   "&a", "*a", "%",    "@",    "K\u00fcche", "a\nb", "<<"}) {
    const ParameterMap map = parseYaml("key: " + yamlText(text));
    const auto* read = std::get_if<std::string>(&map.at("key").value);
    ASSERT_NE(read, nullptr) << text;
    EXPECT_EQ(*read, text);
  }
  EXPECT_EQ(yamlText("floor.pgm"), "floor.pgm") << "quotes only where they are needed";
}

TEST(Parameters, TheDescriptionHasARowPerFieldWithUnitsAndDefaults) {
  const auto rows = describeParameters(Sample{});
  ASSERT_EQ(rows.size(), 7U);
  EXPECT_EQ(rows[2].name, "rate");
  EXPECT_EQ(rows[2].unit, "Hz");
  EXPECT_EQ(rows[2].value, "10");
  EXPECT_EQ(rows[6].name, "wheel/radius");
  EXPECT_NE(tabulateRows(rows).find("| `wheel/radius` | double | 0.033 | m | > 0 | of the wheel |"), std::string::npos);
  EXPECT_NE(printRows(rows).find("rate: 10 Hz\n"), std::string::npos);
}

struct Tuned : Wheel {
  Wheel spare;
  template <class V>
  void describe(V& v) {
    Wheel::describe(v);
    v.group("spare", spare, "another wheel");
    v.tunable({"spare/radius"});
  }
};

TEST(Parameters, WhatMayChangeWhileTheNodeRunsIsMarkedInTheDescriptionAndInTheTable) {
  const auto rows = describeParameters(Tuned());
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_FALSE(rows[0].tunable);
  EXPECT_TRUE(rows[1].tunable);
  EXPECT_NE(tabulateRows(rows).find("| `spare/radius` ↻ | double"), std::string::npos);
  EXPECT_NE(tabulateRows(rows).find("| `radius` | double"), std::string::npos);
}

}  // namespace
}  // namespace frontier_pilot
