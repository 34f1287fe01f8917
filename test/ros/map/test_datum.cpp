#include <gtest/gtest.h>

#include <filesystem>
#include <limits>

#include "../../evaluation/temporary_folder.hpp"
#include "good_fix.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "ros/map/datum.hpp"

namespace multipath_localization {
namespace {

Datum datum_with(const std::optional<Geodetic>& configured, const std::string& file = "") {
  return {configured, DatumSearch({}, 50.0, 0.0), file};
}

/// Has it told that place by a number of fixes, a second apart.
void tell(Datum& datum, double from, const Geodetic& place, int fixes = 3) {
  for (int i = 0; i < fixes; ++i) {
    sensor_msgs::NavSatFix fix = good_fix();
    fix.header.stamp = ros::Time(from + i);
    fix.latitude = place.latitude_deg;
    fix.longitude = place.longitude_deg;
    fix.altitude = place.altitude;
    datum.admit(fix);
  }
}

TEST(Datum, IsTheOneConfigured) {
  Datum datum = datum_with(Geodetic{52.5, 13.4, 0.0});
  tell(datum, 1.0, {48.0, 11.0, 500.0});
  ASSERT_NE(datum.map(), nullptr);
  EXPECT_EQ(datum.map()->datum().latitude_deg, 52.5);
  EXPECT_EQ(datum.map()->datum().altitude, 0.0);
  EXPECT_TRUE(datum.settled());
}

TEST(Datum, IsWhereTheFirstFixesAgree) {
  Datum datum = datum_with(std::nullopt);
  tell(datum, 1.0, {48.0, 11.0, 500.0}, 2);
  EXPECT_EQ(datum.map(), nullptr);
  tell(datum, 3.0, {48.0, 11.0, 500.0}, 1);
  tell(datum, 4.0, {49.0, 12.0, 600.0}, 2);
  ASSERT_NE(datum.map(), nullptr);
  EXPECT_EQ(datum.map()->datum().longitude_deg, 11.0);
  EXPECT_FALSE(datum.settled()) << "nobody has driven yet";
}

TEST(Datum, SaysWhenItMoves) {
  Datum datum = datum_with(std::nullopt);
  tell(datum, 1.0, {48.0, 11.0, 500.0});
  tell(datum, 4.0, {49.0, 12.0, 600.0}, 2);
  sensor_msgs::NavSatFix fix = good_fix();
  fix.header.stamp = ros::Time(6.0);
  fix.latitude = 49.0;
  fix.longitude = 12.0;
  EXPECT_TRUE(datum.admit(fix).moved);
  EXPECT_EQ(datum.map()->datum().latitude_deg, 49.0);
}

TEST(Datum, MovesWhereItIsSet) {
  Datum datum = datum_with(Geodetic{52.5, 13.4, 0.0});
  datum.set({48.0, 11.0, 500.0});
  EXPECT_EQ(datum.map()->datum().latitude_deg, 48.0);
  EXPECT_THROW(datum.set({91.0, 11.0, 500.0}), std::invalid_argument);
}

TEST(Datum, IsSavedOnceProvenAndFoundAgainByTheNextOne) {
  const TemporaryFolder folder;
  const std::string file = folder.path() + "/datum.yaml";
  Datum first = datum_with({}, file);
  tell(first, 1.0, {48.0, 11.0, 500.0});
  EXPECT_NE(first.map(), nullptr);
  EXPECT_FALSE(std::filesystem::exists(file)) << "it may be nonsense yet";
  tell(first, 4.0, {48.0003, 11.0, 500.0});
  EXPECT_TRUE(first.settled());
  Datum next = datum_with({}, file);
  tell(next, 1.0, {49.0, 12.0, 600.0});
  ASSERT_NE(next.map(), nullptr);
  EXPECT_NEAR(next.map()->datum().latitude_deg, 48.0, 1e-9);
  folder.write("datum.yaml", "datum: [48.0, 11");
  EXPECT_THROW(datum_with({}, file), ParameterError);
}

TEST(Datum, HoldsWhereItCannotBeSaved) {
  const TemporaryFolder folder;
  folder.write("no_folder", "");
  Datum datum = datum_with(std::nullopt, folder.path() + "/no_folder/datum.yaml");
  tell(datum, 1.0, {48.0, 11.0, 500.0});
  tell(datum, 4.0, {48.0003, 11.0, 500.0});
  EXPECT_NE(datum.map(), nullptr);
}

TEST(Datum, NamesItsDistanceAndWhatMendsIt) {
  const TemporaryFolder folder;
  folder.write("datum.yaml", "datum: [0.0, 0.0, 0.0]\n");
  const std::string file = folder.path() + "/datum.yaml";
  const std::string saved = datum_with({}, file).distance_to({52.27, 10.53, 110.0});
  EXPECT_NE(saved.find("from " + file), std::string::npos) << saved;
  EXPECT_NE(saved.find("5669 km from [52.27000000, 10.53000000]"), std::string::npos) << saved;
  EXPECT_NE(saved.find("remove " + file), std::string::npos) << saved;
  const std::string given = datum_with(Geodetic{0.0, 0.0, 0.0}).distance_to({52.27, 10.53, 110.0});
  EXPECT_NE(given.find("datum: [52.27000000, 10.53000000]"), std::string::npos) << given;
}

}  // namespace
}  // namespace multipath_localization
