#include <gtest/gtest.h>

#include "evaluation/layered_maps.hpp"
#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {
namespace {

TEST(LaidOver, ReplacesWhatIsNamedMapByMapAndLeavesTheRest) {
  const YAML::Node base = YAML::Load("{a: 1, b: {c: 2, d: {e: 3, f: 4}}, g: [1, 2]}");
  const YAML::Node all = laid_over(base, YAML::Load("{b: {d: {e: 5}}, g: [6], h: {i: 7}}"));
  EXPECT_EQ(all["a"].as<int>(), 1);
  EXPECT_EQ(all["b"]["c"].as<int>(), 2);
  EXPECT_EQ(all["b"]["d"]["e"].as<int>(), 5);
  EXPECT_EQ(all["b"]["d"]["f"].as<int>(), 4);
  EXPECT_EQ(all["g"].size(), 1U);
  EXPECT_EQ(all["h"]["i"].as<int>(), 7);
}

TEST(LaidOver, ChangesNeitherOfTheTwo) {
  const YAML::Node base = YAML::Load("{a: {b: 1}}");
  const YAML::Node upper = YAML::Load("{a: {b: 2}, c: {d: 3}}");
  YAML::Node all = laid_over(base, upper);
  all["a"]["b"] = 4;
  all["c"]["d"] = 5;
  EXPECT_EQ(base["a"]["b"].as<int>(), 1);
  EXPECT_EQ(upper["a"]["b"].as<int>(), 2);
  EXPECT_EQ(upper["c"]["d"].as<int>(), 3);
}

TEST(LaidOver, CountsWhatIsNoMapAsEmpty) {
  EXPECT_TRUE(laid_over(YAML::Node(), YAML::Node()).IsMap());
  EXPECT_EQ(laid_over(YAML::Node(), YAML::Load("{a: 1}"))["a"].as<int>(), 1);
  EXPECT_EQ(laid_over(YAML::Load("{a: 1}"), YAML::Node())["a"].as<int>(), 1);
}

TEST(LaidOver, ChangesOneOfTwoMapsThatAnAliasMakesOne) {
  const YAML::Node all = laid_over(YAML::Load("{a: &a {b: 1}, c: *a}"), YAML::Load("{a: {b: 2}}"));
  EXPECT_EQ(all["a"]["b"].as<int>(), 2);
  EXPECT_EQ(all["c"]["b"].as<int>(), 1);
}

TEST(LaidOver, RefusesMapsThatHoldThemselves) {
  EXPECT_THROW(laid_over(YAML::Load("&a {x: *a}"), YAML::Load("&a {x: *a}")), ParameterError);
}

TEST(LaidOver, RefusesAKeyThatIsNotAText) {
  EXPECT_THROW(laid_over(YAML::Node(), YAML::Load("{[1, 2]: 3}")), ParameterError);
}

}  // namespace
}  // namespace multipath_localization
