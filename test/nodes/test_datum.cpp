#include <gtest/gtest.h>

#include "../evaluation/temporary_folder.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "nodes/datum.hpp"

namespace multipath_localization {
namespace {

TEST(Datum, IsTheOneConfigured) {
  Datum datum(Geodetic{52.5, 13.4, 0.0}, 0.0);
  datum.add(1.0, {48.0, 11.0, 500.0});
  ASSERT_NE(datum.map(), nullptr);
  EXPECT_EQ(datum.map()->datum().latitude_deg, 52.5);
  EXPECT_EQ(datum.map()->datum().altitude, 0.0);
}

TEST(Datum, IsTheFirstPlaceAndStays) {
  Datum datum(std::nullopt, 0.0);
  EXPECT_EQ(datum.map(), nullptr);
  datum.add(1.0, {48.0, 11.0, 500.0});
  datum.add(2.0, {49.0, 12.0, 600.0});
  ASSERT_NE(datum.map(), nullptr);
  EXPECT_EQ(datum.map()->datum().longitude_deg, 11.0);
}

TEST(Datum, IsTheMedianOfTheFirstPlaces) {
  Datum datum(std::nullopt, 1.0);
  datum.add(10.0, {48.0, 11.0, 500.0});
  datum.add(10.5, {80.0, 11.2, std::numeric_limits<double>::quiet_NaN()});
  EXPECT_EQ(datum.map(), nullptr);
  datum.add(11.0, {48.1, 11.1, 502.0});
  ASSERT_NE(datum.map(), nullptr);
  EXPECT_EQ(datum.map()->datum().latitude_deg, 48.1);
  EXPECT_EQ(datum.map()->datum().longitude_deg, 11.1);
  EXPECT_EQ(datum.map()->datum().altitude, 502.0);
}

TEST(Datum, MovesWhereItIsSet) {
  Datum datum(Geodetic{52.5, 13.4, 0.0}, 0.0);
  datum.set({48.0, 11.0, 500.0});
  EXPECT_EQ(datum.map()->datum().latitude_deg, 48.0);
  EXPECT_THROW(datum.set({91.0, 11.0, 500.0}), std::invalid_argument);
}

TEST(Datum, IsFoundAgainByTheNextOne) {
  const TemporaryFolder folder;
  const std::string file = folder.path() + "/datum.yaml";
  Datum first({}, 0.0, file);
  EXPECT_EQ(first.map(), nullptr);
  first.add(1.0, {48.0, 11.0, 500.0});
  Datum next({}, 0.0, file);
  next.add(1.0, {49.0, 12.0, 600.0});
  ASSERT_NE(next.map(), nullptr);
  EXPECT_NEAR(next.map()->datum().latitude_deg, 48.0, 1e-9);
  folder.write("datum.yaml", "datum: [48.0, 11");
  EXPECT_THROW(Datum({}, 0.0, file), ParameterError);
}

TEST(Datum, HoldsWhereItCannotBeSaved) {
  const TemporaryFolder folder;
  folder.write("no_folder", "");
  Datum datum(std::nullopt, 0.0, folder.path() + "/no_folder/datum.yaml");
  datum.add(1.0, {48.0, 11.0, 500.0});
  EXPECT_NE(datum.map(), nullptr);
}

}  // namespace
}  // namespace multipath_localization
