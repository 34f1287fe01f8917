#include <gtest/gtest.h>

#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/core/plain_yaml.hpp"

namespace multipath_localization {
namespace {

std::string refusal(const std::string& text) {
  try {
    plain(YAML::Load(text));
  } catch (const ParameterError& error) {
    return error.what();
  }
  return "";
}

TEST(PlainYaml, IsACopyInWhichNothingIsShared) {
  const YAML::Node source = YAML::Load("{a: &a {x: 1, y: [~, 'true']}, b: *a}");
  YAML::Node copy = plain(source);
  copy["b"]["x"] = 2;
  EXPECT_EQ(copy["a"]["x"].as<int>(), 1);
  EXPECT_EQ(source["b"]["x"].as<int>(), 1);
  EXPECT_TRUE(copy["b"]["y"][0].IsNull());
  EXPECT_EQ(copy["b"]["y"][1].as<std::string>(), "true");
  EXPECT_TRUE(plain(YAML::Node()).IsNull());
}

TEST(PlainYaml, RefusesWhatHoldsItself) {
  EXPECT_NE(refusal("&a {x: *a}").find("within itself"), std::string::npos);
  EXPECT_NE(refusal("&a [1, *a]").find("within itself"), std::string::npos);
  EXPECT_EQ(refusal(std::string(60, '[') + std::string(60, ']')), "");
  EXPECT_NE(refusal(std::string(70, '[') + std::string(70, ']')), "");
}

TEST(PlainYaml, RefusesAliasesOfAliasesThatStandForMillions) {
  std::string text = "l0: &l0 [1, 2, 3, 4, 5, 6, 7, 8, 9, 10]\n";
  for (int i = 1; i < 10; ++i) {
    const std::string below = "*l" + std::to_string(i - 1);
    text += "l" + std::to_string(i) + ": &l" + std::to_string(i) + " [" + below;
    for (int k = 1; k < 10; ++k) text += ", " + below;
    text += "]\n";
  }
  EXPECT_NE(refusal(text).find("aliases counted"), std::string::npos);
}

}  // namespace
}  // namespace multipath_localization
