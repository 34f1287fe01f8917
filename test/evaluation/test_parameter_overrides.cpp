#include <gtest/gtest.h>

#include "evaluation/parameter_overrides.hpp"
#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {
namespace {

TEST(ParameterOverrides, NestByDotsAndSlashes) {
  const ParameterOverrides overrides({"a=1", "b.c=2.5", "b/d=[1, 2]"}, {});
  const YAML::Node all = overrides.over(YAML::Node(), "anyone");
  EXPECT_EQ(all["a"].as<int>(), 1);
  EXPECT_DOUBLE_EQ(all["b"]["c"].as<double>(), 2.5);
  EXPECT_EQ(all["b"]["d"].size(), 2u);
}

TEST(ParameterOverrides, LieOverACopy) {
  const YAML::Node base = YAML::Load("{a: 1, b: {c: 2, d: 3}}");
  const YAML::Node all = ParameterOverrides({"b.c=5"}, {}).over(base, "anyone");
  EXPECT_EQ(all["a"].as<int>(), 1);
  EXPECT_EQ(all["b"]["c"].as<int>(), 5);
  EXPECT_EQ(all["b"]["d"].as<int>(), 3);
  EXPECT_EQ(base["b"]["c"].as<int>(), 2);
}

TEST(ParameterOverrides, OfAnOwnerAreForItAlone) {
  const ParameterOverrides overrides({"mine.a=1", "other.a=2", "mine=3"}, {"mine", "other"});
  EXPECT_EQ(overrides.over(YAML::Node(), "mine")["a"].as<int>(), 1);
  EXPECT_EQ(overrides.over(YAML::Node(), "mine")["mine"].as<int>(), 3);
  EXPECT_EQ(overrides.of("other").size(), 1u);
  EXPECT_EQ(overrides.owners(), (std::vector<std::string>{"mine", "other"}));
}

TEST(ParameterOverrides, RefuseWhatIsNoAssignment) {
  for (const char* text : {"a", "=1", "a..b=1", "a.=1", "a=[1"}) {
    EXPECT_THROW(ParameterOverrides({text}, {}), ParameterError) << text;
  }
}

}  // namespace
}  // namespace multipath_localization
