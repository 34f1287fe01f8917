#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "evaluation/json.hpp"

namespace multipath_localization {
namespace {

TEST(Quoted, ReadsBackAsTheSameText) {
  for (const std::string text : {"plain", "a \"b\" {c: [d, \\e]}", "line\nand\ttab", ""}) {
    EXPECT_EQ(YAML::Load(quoted(text)).as<std::string>(), text);
  }
  EXPECT_EQ(quoted("\n"), "\"\\u000a\"");
}

}  // namespace
}  // namespace multipath_localization
