#include <gtest/gtest.h>

#include "german_locale.hpp"
#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {
namespace {

struct Zone {
  double width = 1.0;
  std::string side = "left";

  void fields(ParameterVisitor& field) {
    field("width", width, {0.0, 10.0}, "m", "across");
    field("side", side, {"left", "right"}, "which way it lies");
  }
};

struct Sample {
  double sigma = 0.1;
  double limit = std::numeric_limits<double>::infinity();
  int particles = 300;
  bool enabled = true;
  std::string note;
  std::vector<double> corners = {1.0, -2.5};
  Zone zone;
  std::vector<Zone> zones = {Zone{}, Zone{3.0, "right"}};

  void fields(ParameterVisitor& field) {
    field("sigma", sigma, {0.0, 5.0}, "m", "standard deviation");
    field("limit", limit, {0.0}, "m", "none when infinite");
    field("particles", particles, {1, 1000}, "1", "how many");
    field("enabled", enabled, "whether at all");
    field("note", note, {}, "anything");
    field("corners", corners, {-10.0, 10.0}, "m", "x and y");
    field.group("zone", zone, "the main one");
    field.list("zones", zones, "the others");
  }
};

/// What `load` says against a text, or nothing when it takes it.
std::string refusal(const std::string& yaml) {
  Sample sample;
  try {
    load(YAML::Load(yaml), sample);
  } catch (const ParameterError& error) {
    return error.what();
  }
  return "";
}

Sample loaded(const std::string& yaml) {
  Sample sample;
  load(YAML::Load(yaml), sample);
  return sample;
}

testing::AssertionResult Names(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    if (text.find(part) == std::string::npos) {
      return testing::AssertionFailure() << "'" << text << "' does not name " << part;
    }
  }
  return testing::AssertionSuccess();
}

TEST(Parameters, EntriesReplaceDefaultsAndTheRestStays) {
  const Sample sample =
      loaded("{sigma: 2, enabled: false, corners: [4], zone: {width: 7}, zones: [{side: right}]}");
  EXPECT_EQ(sample.sigma, 2.0);
  EXPECT_FALSE(sample.enabled);
  EXPECT_EQ(sample.particles, 300);
  EXPECT_EQ(sample.corners, std::vector<double>{4.0});
  EXPECT_EQ(sample.zone.width, 7.0);
  EXPECT_EQ(sample.zone.side, "left");
  ASSERT_EQ(sample.zones.size(), 1U);
  EXPECT_EQ(sample.zones[0].width, 1.0);
  EXPECT_EQ(sample.zones[0].side, "right");
}

TEST(Parameters, NothingGivenIsNoError) {
  EXPECT_EQ(refusal(""), "");
  EXPECT_EQ(refusal("{}"), "");
  Sample sample;
  EXPECT_NO_THROW(load(YAML::Node(), sample));
}

TEST(Parameters, UnknownKeyIsRefusedWithTheNearestName) {
  EXPECT_TRUE(Names(refusal("particels: 5"), {"particels", "did you mean particles?"}));
  EXPECT_TRUE(Names(refusal("zone: {wdth: 5}"), {"zone/wdth", "did you mean width?"}));
  EXPECT_TRUE(Names(refusal("zones: [{}, {sied: left}]"), {"zones[1]/sied", "did you mean side?"}));
}

TEST(Parameters, WrongTypeIsRefusedByName) {
  EXPECT_TRUE(Names(refusal("sigma: wide"), {"sigma", "number"}));
  EXPECT_TRUE(Names(refusal("sigma: [1]"), {"sigma", "number"}));
  EXPECT_TRUE(Names(refusal("particles: 2.5"), {"particles", "whole number"}));
  EXPECT_TRUE(Names(refusal("particles: 99999999999"), {"particles", "whole number"}));
  EXPECT_TRUE(Names(refusal("enabled: 7"), {"enabled", "true or false"}));
  EXPECT_TRUE(Names(refusal("corners: 3"), {"corners", "list"}));
  EXPECT_TRUE(Names(refusal("corners: [a]"), {"corners", "number"}));
  EXPECT_TRUE(Names(refusal("zone: 3"), {"zone", "map"}));
  EXPECT_TRUE(Names(refusal("zones: {width: 1}"), {"zones", "list"}));
  EXPECT_TRUE(Names(refusal("[1, 2]"), {"map"}));
  EXPECT_TRUE(Names(refusal("sigma: "), {"sigma", "number"}));
}

TEST(Parameters, OutOfRangeIsRefusedWithTheRange) {
  EXPECT_TRUE(Names(refusal("sigma: 5.1"), {"sigma", "5.1", "0..5"}));
  EXPECT_TRUE(Names(refusal("sigma: -1"), {"sigma", "-1", "0..5"}));
  EXPECT_TRUE(Names(refusal("particles: 0"), {"particles", "0", "1..1000"}));
  EXPECT_TRUE(Names(refusal("corners: [0, 11]"), {"corners", "11"}));
  EXPECT_TRUE(Names(refusal("zone: {side: up}"), {"zone/side", "up", "left | right"}));
  EXPECT_EQ(refusal("{sigma: 5, particles: 1}"), "");
}

TEST(Parameters, NotFiniteIsRefusedWhereTheRangeIsBounded) {
  EXPECT_TRUE(Names(refusal("sigma: .nan"), {"sigma"}));
  EXPECT_TRUE(Names(refusal("sigma: .inf"), {"sigma"}));
  EXPECT_TRUE(Names(refusal("limit: .nan"), {"limit"}));
  EXPECT_TRUE(Names(refusal("corners: [.nan]"), {"corners"}));
  EXPECT_EQ(refusal("limit: .inf"), "");
}

TEST(Parameters, AKeyGivenTwiceIsRefused) {
  EXPECT_TRUE(Names(refusal("{sigma: 1, sigma: 2}"), {"sigma", "twice"}));
}

TEST(Parameters, AKeyThatIsNoTextIsRefused) { EXPECT_NE(refusal("{[1, 2]: 3}"), ""); }

TEST(Parameters, DescriptionLoadsBackToTheSameValues) {
  Sample sample;
  sample.sigma = 1.0 / 3.0;
  sample.note = "a: colon, a #hash and 'quotes'";
  sample.zones.push_back({0.1 + 0.2, "left"});
  const std::string text = describe(sample);
  const Sample back = loaded(text);
  EXPECT_EQ(back.sigma, sample.sigma);
  EXPECT_EQ(back.limit, sample.limit);
  EXPECT_EQ(back.particles, sample.particles);
  EXPECT_EQ(back.enabled, sample.enabled);
  EXPECT_EQ(back.note, sample.note);
  EXPECT_EQ(back.corners, sample.corners);
  EXPECT_EQ(back.zone.width, sample.zone.width);
  ASSERT_EQ(back.zones.size(), 3U);
  EXPECT_EQ(back.zones[1].side, "right");
  EXPECT_EQ(back.zones[2].width, 0.1 + 0.2);
  EXPECT_EQ(describe(back), text);
}

TEST(Parameters, EmptyListsAndTextsDescribeAndLoad) {
  Sample sample;
  sample.corners.clear();
  sample.zones.clear();
  const Sample back = loaded(describe(sample));
  EXPECT_TRUE(back.corners.empty());
  EXPECT_TRUE(back.zones.empty());
  EXPECT_EQ(back.note, "");
}

TEST(Parameters, AnEmptyListIsDescribedByAnItemInAComment) {
  Sample sample;
  sample.zones.clear();
  EXPECT_TRUE(Names(describe(sample),
                    {"zones: []  # the others\n#  - width: 1", "\n#    side: left  # left | right"}));
}

TEST(Parameters, DescriptionNamesUnitRangeAndMeaning) {
  const Sample sample;
  const std::string text = describe(sample);
  EXPECT_TRUE(Names(
      text, {"sigma: 0.1  # [m] 0..5: standard deviation\n", "particles: 300  # [1] 1..1000: how many\n",
             "  side: left  # left | right: which way it lies\n", "zones:  # the others\n  - width: 1"}));
}

TEST(Parameters, AFileThatCannotBeReadIsNamed) {
  try {
    read_yaml("no/such/file.yaml");
    FAIL() << "read a file that does not exist";
  } catch (const ParameterError& error) {
    EXPECT_TRUE(Names(error.what(), {"no/such/file.yaml"}));
  }
}

TEST(Parameters, AreReadAndDescribedAlikeInAnyLocale) {
  Sample sample;
  sample.sigma = 0.25;
  sample.particles = 1000;
  const std::string plain = describe(sample);
  const GermanLocale german;
  EXPECT_EQ(describe(sample), plain);
  const Sample read = loaded(plain);
  EXPECT_EQ(read.sigma, 0.25);
  EXPECT_EQ(read.particles, 1000);
  EXPECT_EQ(read.corners, (std::vector<double>{1.0, -2.5}));
  EXPECT_EQ(refusal("sigma: 5.5"), "sigma is 5.5, outside 0..5");
}

}  // namespace
}  // namespace multipath_localization
