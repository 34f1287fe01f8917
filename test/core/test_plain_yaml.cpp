#include <gtest/gtest.h>

#include "core/plain_yaml.hpp"
#include "german_locale.hpp"
#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {
namespace {

template <class Call>
std::string reason_of(const Call& call) {
  try {
    call();
  } catch (const ParameterError& error) {
    return error.what();
  }
  return "";
}

std::string refusal(const std::string& text) {
  return reason_of([&] { plain(YAML::Load(text)); });
}

std::string refusal_to_parse(const std::string& text) {
  return reason_of([&] { parse_yaml(text); });
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

TEST(ParseYaml, TellsOfDepthBeforeTheStackEnds) {
  EXPECT_EQ(refusal_to_parse(std::string(64, '[') + std::string(64, ']')), "");
  for (const char* level : {"[", "{a: ", "- ", "? "}) {
    std::string deep;
    for (int i = 0; i < 20000; ++i) deep += level;
    EXPECT_NE(refusal_to_parse(deep).find("nested over 64 deep"), std::string::npos) << level;
  }
  EXPECT_THROW(parse_yaml("[1, "), YAML::Exception);
  EXPECT_EQ(parse_yaml("a: 1\n---\nb: 2").size(), 1U) << "the first document";
  EXPECT_THROW(parse_yaml_file("/no/such/file"), ParameterError);
}

TEST(ParseYaml, ComesToAnEndWhereBracesDoNot) {
  for (const char* text : {"{a:", "fix: {default_sigma:", "{a: 1, b:", "[a:", "[{a:"}) {
    EXPECT_THROW(parse_yaml(text), YAML::Exception) << text;
  }
  EXPECT_EQ(parse_yaml("a: b")["a"].as<std::string>(), "b");
  EXPECT_EQ(refusal_to_parse("- {x: 1}\n- {x: 10, y:]"),
            "line 2: a colon right before a bracket, ':]': write ': ]'");
  EXPECT_NE(refusal_to_parse("[a:]"), "");
  EXPECT_EQ(refusal_to_parse("[a: ]"), "");
}

TEST(YamlNumber, IsReadAlikeInAnyLocale) {
  const GermanLocale german;
  EXPECT_EQ(yaml_number<double>(YAML::Load("-1234.5e-1")), -123.45);
  EXPECT_EQ(yaml_number<double>(YAML::Load("-.inf")), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(yaml_number<int>(YAML::Load("1234")), 1234);
  EXPECT_EQ(yaml_number<int>(YAML::Load("0x10")), 16);
  EXPECT_EQ(yaml_numbers(YAML::Load("[0.5, 1]")), (std::vector<double>{0.5, 1.0}));
  for (const char* none : {"'0,5'", "' 1.5'", "0.5m", "1e999", "~", "''", "[1]", "inf"}) {
    EXPECT_THROW(yaml_number<double>(YAML::Load(none)), YAML::Exception) << none;
  }
  EXPECT_THROW(yaml_number<int>(YAML::Load("1.000")), YAML::Exception) << "no thousand";
  EXPECT_THROW(yaml_numbers(YAML::Load("{1: 2}")), YAML::Exception);
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
