#include <gtest/gtest.h>

#include "multipath_localization/core/parameters.hpp"
#include "ros/parameters/parameter_server.hpp"

namespace multipath_localization {
namespace {

struct Inner {
  std::vector<double> datum;
  void fields(ParameterVisitor& field) { field("datum", datum, {}, "deg", "where"); }
};

struct Outer {
  double rate = 1.0;
  int count = 1;
  bool on = false;
  std::string name = "a";
  Inner inner;
  std::vector<Inner> places;
  void fields(ParameterVisitor& field) {
    field("rate", rate, {0.0, 10.0}, "Hz", "how often");
    field("count", count, {0, 10}, "1", "how many");
    field("on", on, "whether");
    field("name", name, {}, "which");
    field.group("inner", inner, "more");
    field.list("places", places, "others");
  }
};

XmlRpc::XmlRpcValue list(double a, double b) {
  XmlRpc::XmlRpcValue value;
  value[0] = a;
  value[1] = b;
  return value;
}

TEST(ParameterServer, EveryKindOfValueReachesItsField) {
  XmlRpc::XmlRpcValue source;
  source["rate"] = 0.1;
  source["count"] = 7;
  source["on"] = true;
  source["name"] = "two words";
  source["inner"]["datum"] = list(52.504761161, 13);
  source["places"][0]["datum"] = list(1, 2);
  source["places"][1]["datum"] = list(3, 4);
  Outer outer;
  load(to_yaml(source), outer);
  EXPECT_EQ(outer.rate, 0.1);
  EXPECT_EQ(outer.count, 7);
  EXPECT_TRUE(outer.on);
  EXPECT_EQ(outer.name, "two words");
  EXPECT_EQ(outer.inner.datum, (std::vector<double>{52.504761161, 13.0}));
  ASSERT_EQ(outer.places.size(), 2u);
  EXPECT_EQ(outer.places[1].datum, (std::vector<double>{3.0, 4.0}));
}

TEST(ParameterServer, WholeNumbersServeAsRealOnes) {
  XmlRpc::XmlRpcValue source;
  source["rate"] = 5;
  Outer outer;
  load(to_yaml(source), outer);
  EXPECT_EQ(outer.rate, 5.0);
}

TEST(ParameterServer, DoublesLoseNothing) {
  for (const double value : {1.0 / 3.0, 1e-300, 1e308, -33.89412345678901}) {
    EXPECT_EQ(to_yaml(XmlRpc::XmlRpcValue(value)).as<double>(), value);
  }
}

TEST(ParameterServer, NothingLeavesDefaults) {
  Outer outer;
  load(to_yaml(XmlRpc::XmlRpcValue()), outer);
  EXPECT_EQ(outer.rate, 1.0);
}

TEST(ParameterServer, UnknownKeysAreRefusedByName) {
  XmlRpc::XmlRpcValue source;
  source["inner"]["datun"] = 1.0;
  Outer outer;
  try {
    load(to_yaml(source), outer);
    FAIL() << "accepted";
  } catch (const ParameterError& error) {
    EXPECT_NE(std::string(error.what()).find("inner/datun"), std::string::npos) << error.what();
  }
}

TEST(ParameterServer, DatesAreRefusedByName) {
  std::tm date{};
  XmlRpc::XmlRpcValue source;
  source["rate"] = XmlRpc::XmlRpcValue(&date);
  try {
    to_yaml(source);
    FAIL() << "accepted";
  } catch (const ParameterError& error) {
    EXPECT_NE(std::string(error.what()).find("rate"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace multipath_localization
