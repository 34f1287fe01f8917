#include <gtest/gtest.h>

#include <limits>

#include "ros/parameters/config_messages.hpp"

namespace multipath_localization {
namespace {

struct Inner {
  double gate = 3.0;
  std::string source = "message";

  void fields(ParameterVisitor& field) {
    field("gate", gate, {1.0, 9.0}, "m", "how far");
    field("source", source, {"message", "fixed"}, "which");
  }
};

struct Outer {
  int count = 5;
  bool on = true;
  std::vector<double> list = {1.0};
  Inner inner;

  void fields(ParameterVisitor& field) {
    field("count", count, {1, 10}, "1", "how many");
    field("on", on, "whether");
    field("list", list, {0.0, 1.0}, "1", "not to be set");
    field.group("inner", inner, "more");
  }
};

class ConfigMessages : public testing::Test {
 protected:
  template <class Value>
  std::vector<std::string> set(std::vector<Value> dynamic_reconfigure::Config::*kind, const std::string& name,
                               decltype(Value::value) value) {
    dynamic_reconfigure::Config config;
    Value parameter;
    parameter.name = name;
    parameter.value = value;
    (config.*kind).push_back(parameter);
    return set_parameters(config, visit);
  }

  using Config = dynamic_reconfigure::Config;
  Outer outer;
  VisitParameters visit = [this](ParameterVisitor& field) { outer.fields(field); };
};

TEST_F(ConfigMessages, DescribeWhatFieldsSays) {
  const dynamic_reconfigure::ConfigDescription told = to_description(visit);
  ASSERT_EQ(told.groups.size(), 1U);
  const auto& parameters = told.groups[0].parameters;
  ASSERT_EQ(parameters.size(), 4U);
  EXPECT_EQ(parameters[0].name, "count");
  EXPECT_EQ(parameters[0].type, "int");
  EXPECT_EQ(parameters[2].name, "inner/gate");
  EXPECT_EQ(parameters[2].type, "double");
  EXPECT_EQ(parameters[2].description, "[m] how far");
  EXPECT_NE(parameters[3].edit_method.find("'value': 'fixed'"), std::string::npos);
  EXPECT_EQ(told.min.doubles.at(0).value, 1.0);
  EXPECT_EQ(told.max.doubles.at(0).value, 9.0);
  EXPECT_EQ(told.dflt.doubles.at(0).value, 3.0);
  EXPECT_EQ(told.max.ints.at(0).value, 10);
  EXPECT_EQ(told.dflt.groups.at(0).name, told.groups[0].name);
}

TEST_F(ConfigMessages, SetWhatIsNamed) {
  EXPECT_TRUE(set(&Config::doubles, "inner/gate", 4.0).empty());
  EXPECT_TRUE(set(&Config::ints, "count", 7).empty());
  EXPECT_TRUE(set(&Config::bools, "on", 0).empty());
  EXPECT_TRUE(set(&Config::strs, "inner/source", "fixed").empty());
  EXPECT_EQ(outer.inner.gate, 4.0);
  EXPECT_EQ(outer.count, 7);
  EXPECT_FALSE(outer.on);
  EXPECT_EQ(outer.inner.source, "fixed");
  const dynamic_reconfigure::Config now = to_config(visit);
  EXPECT_EQ(now.doubles.at(0).value, 4.0);
  EXPECT_EQ(now.strs.at(0).value, "fixed");
}

TEST_F(ConfigMessages, HoldNumbersWithinTheirBounds) {
  EXPECT_TRUE(set(&Config::doubles, "inner/gate", 1e300).empty());
  EXPECT_EQ(outer.inner.gate, 9.0);
  EXPECT_TRUE(set(&Config::doubles, "inner/gate", -std::numeric_limits<double>::infinity()).empty());
  EXPECT_EQ(outer.inner.gate, 1.0);
  EXPECT_TRUE(set(&Config::ints, "count", 1000).empty());
  EXPECT_EQ(outer.count, 10);
}

TEST_F(ConfigMessages, ReturnWhatCannotBeSet) {
  const std::vector<std::string> gate = {"inner/gate"};
  EXPECT_EQ(set(&Config::doubles, "inner/gate", std::numeric_limits<double>::quiet_NaN()), gate);
  EXPECT_EQ(set(&Config::ints, "inner/gate", 2), gate) << "of another type";
  EXPECT_EQ(set(&Config::doubles, "gaet", 2.0), std::vector<std::string>{"gaet"});
  EXPECT_EQ(set(&Config::strs, "inner/source", "guess"), std::vector<std::string>{"inner/source"});
  EXPECT_EQ(outer.inner.gate, 3.0);
  EXPECT_EQ(outer.inner.source, "message");
}

}  // namespace
}  // namespace multipath_localization
