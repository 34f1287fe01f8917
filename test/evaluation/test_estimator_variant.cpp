#include <gtest/gtest.h>

#include "evaluation/estimator_variant.hpp"
#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {
namespace {

TEST(ParseVariants, TakesNamesLabelsAndParametersOfTheirOwn) {
  const auto variants = parse_variants("a,b{c: 1, d: [2, 3]},own name=b{e: {f: x=y}}");
  ASSERT_EQ(variants.size(), 3u);
  EXPECT_EQ(variants[0].label, "a");
  EXPECT_EQ(variants[0].name, "a");
  EXPECT_EQ(variants[0].parameters, "");
  EXPECT_EQ(variants[1].label, "b{c: 1, d: [2, 3]}");
  EXPECT_EQ(variants[1].name, "b");
  EXPECT_EQ(variants[1].parameters, "{c: 1, d: [2, 3]}");
  EXPECT_EQ(variants[2].label, "own name");
  EXPECT_EQ(variants[2].name, "b");
  EXPECT_EQ(variants[2].parameters, "{e: {f: x=y}}");
}

TEST(ParseVariants, RefusesWhatIsNoVariant) {
  for (const char* list :
       {"", "a,", "=a", "a=", "{c: 1}", "a{c: 1", "a}b{", "a{c: 1}d", "a{c: 1}{d: 2}", "a{c: [}"}) {
    EXPECT_THROW(parse_variants(list), ParameterError) << list;
  }
}

TEST(ParseVariants, RefusesTwoOfOneLabel) {
  EXPECT_THROW(parse_variants("a,a"), ParameterError);
  EXPECT_THROW(parse_variants("x=a,x=b"), ParameterError);
  EXPECT_NO_THROW(parse_variants("x=a,y=a,a"));
}

TEST(Over, LaysAVariantOverACopyMapByMap) {
  const YAML::Node base = YAML::Load("{a: 1, b: {c: 2, d: 3}}");
  const YAML::Node all = over(base, parse_variants("x{b: {c: 5}, e: {f: 6}, g: [7]}").front());
  EXPECT_EQ(all["a"].as<int>(), 1);
  EXPECT_EQ(all["b"]["c"].as<int>(), 5);
  EXPECT_EQ(all["b"]["d"].as<int>(), 3);
  EXPECT_EQ(all["e"]["f"].as<int>(), 6);
  EXPECT_EQ(all["g"][0].as<int>(), 7);
  EXPECT_EQ(base["b"]["c"].as<int>(), 2);
  EXPECT_TRUE(over(YAML::Node(), parse_variants("x").front()).IsMap());
}

}  // namespace
}  // namespace multipath_localization
