#include <cmath>
#include <limits>

#include "found.hpp"
#include "healthy_robot.hpp"
#include "tools/doctor/checks.hpp"

namespace multipath_localization {
namespace {

/// The healthy robot with every fix changed.
template <class Change>
Observations with_fixes(const Change& change) {
  Observations seen = healthy_robot();
  for (auto& fix : seen.fixes) change(fix.message);
  return seen;
}

TEST(CheckStatus, FindsADriverThatNeverFillsItIn) {
  EXPECT_TRUE(Passes(check_status(healthy_robot())));
  const auto none = with_fixes([](auto& fix) { fix.status.status = -1; });
  EXPECT_TRUE(ToFix(check_status(none), "every one has status -1", "min_fix_status: -1"));
  Observations some = healthy_robot();
  some.fixes[3].message.status.status = -1;
  EXPECT_TRUE(Passes(check_status(some)));
  EXPECT_NE(check_status(some).front().what.find("1 of 600"), std::string::npos);
  for (std::size_t i = 0; i < 200; ++i) some.fixes[i].message.status.status = -1;
  EXPECT_TRUE(ToFix(check_status(some), "200 of 600 have a status below 0", "view of the sky"));
  some = healthy_robot();
  some.fix_parameters.min_fix_status = 2;
  EXPECT_TRUE(ToFix(check_status(some), "600 of 600 have a status below 2", "min_fix_status: 0"));
}

TEST(CheckDeclaredCovariance, FindsNoneNanAndHuge) {
  EXPECT_TRUE(Passes(check_declared_covariance(healthy_robot())));
  const auto zero = with_fixes([](auto& fix) { fix.position_covariance.assign(0.0); });
  EXPECT_TRUE(ToFix(check_declared_covariance(zero), "600 of 600 declare no covariance", "default_sigma"));
  const auto unknown = with_fixes([](auto& fix) { fix.position_covariance_type = 0; });
  EXPECT_TRUE(ToFix(check_declared_covariance(unknown), "declare no covariance", "default_sigma"));
  for (const double bad : {std::nan(""), 1e308, -1.0}) {
    const auto refused = with_fixes([bad](auto& fix) { fix.position_covariance[0] = bad; });
    EXPECT_TRUE(ToFix(check_declared_covariance(refused), "are refused", "COVARIANCE_TYPE_UNKNOWN")) << bad;
  }
}

TEST(CheckDeclaredCovariance, SaysWhenItNeverChanges) {
  Observations seen = healthy_robot();
  EXPECT_NE(check_declared_covariance(seen).front().what.find("always the same"), std::string::npos);
  seen.fixes[5].message.position_covariance[0] = 4.0;
  EXPECT_EQ(check_declared_covariance(seen).front().what.find("always the same"), std::string::npos);
}

TEST(CheckScatter, FindsAReceiverThatClaimsMillimetres) {
  EXPECT_TRUE(Passes(check_scatter(healthy_robot())));
  const auto boasting =
      with_fixes([](auto& fix) { fix.position_covariance[0] = fix.position_covariance[4] = 1e-4; });
  EXPECT_TRUE(ToFix(check_scatter(boasting), "declared 0.01 m", "fixed_sigma: 0."));
  Observations parked = healthy_robot();
  parked.odometry.clear();
  EXPECT_TRUE(Untold(check_scatter(parked)));
}

TEST(CheckFrozen, FindsAPlaceThatStandsWhileTheRobotDrives) {
  EXPECT_TRUE(Passes(check_frozen(healthy_robot())));
  Observations seen = healthy_robot();
  for (std::size_t i = 101; i < 150; ++i) {
    seen.fixes[i].message.latitude = seen.fixes[100].message.latitude;
    seen.fixes[i].message.longitude = seen.fixes[100].message.longitude;
  }
  EXPECT_TRUE(ToFix(check_frozen(seen), "over 9.8 m of way", "respawn"));
}

TEST(CheckDatum, FindsARoundedAndASwappedOne) {
  Observations seen = healthy_robot();
  EXPECT_TRUE(check_datum(seen).empty());
  seen.datum = {52.512345678, 13.412345678};
  EXPECT_TRUE(Passes(check_datum(seen)));
  seen.datum = {52.5123, 13.4123};
  EXPECT_TRUE(ToFix(check_datum(seen), "rounded to four decimals", "datum: [52.5123"));
  seen.datum = {13.412345678, 52.512345678};
  EXPECT_TRUE(ToFix(check_datum(seen), "latitude comes first", "datum: [52.5123"));
  seen.datum = {139.7, 35.6};
  EXPECT_TRUE(ToFix(check_datum(seen), "is not latitude, longitude", "datum: [52.5123"));
}

TEST(CheckDatum, NamesASavedOneAndItsFile) {
  Observations seen = healthy_robot();
  seen.datum = {0.0, 0.0};
  seen.datum_file = "/data/site.yaml";
  EXPECT_TRUE(ToFix(check_datum(seen), "km from the fixes, saved in /data/site.yaml", "rm /data/site.yaml"));
  seen.datum = {52.5123, 13.4123};
  EXPECT_TRUE(Passes(check_datum(seen))) << "nobody typed that";
}

TEST(CheckPlaces, FindsZerosAndStrangers) {
  Observations seen = healthy_robot();
  EXPECT_TRUE(Passes(check_places(seen)));
  for (std::size_t i = 0; i < 15; ++i) seen.fixes[i].message.latitude = seen.fixes[i].message.longitude = 0.0;
  EXPECT_TRUE(ToFix(check_places(seen), "15 of 600 are at 0, 0", "publish nothing without a fix"));
  EXPECT_TRUE(Passes(check_frozen(seen))) << "what is refused is not taken for a receiver that has frozen";
  EXPECT_FALSE(motion_of(seen).fixes.empty());
  EXPECT_LT(motion_of(seen).fixes.front().position.norm(), 100.0) << "the rest is looked at all the same";
  seen = healthy_robot();
  seen.fixes.front().message.latitude += 30.0;
  EXPECT_TRUE(ToFix(check_places(seen), "1 of 600 are over 100 km from [52.5123", "one receiver"));
}

TEST(CheckPlaces, FindsWhatIsNotFiniteOrOutOfRangeWhereATenthIsLost) {
  Observations seen = healthy_robot();
  const auto spoil = [&](std::size_t many, const auto& change) {
    seen = healthy_robot();
    for (std::size_t i = 0; i < many; ++i) change(seen.fixes[i].message);
    return check_places(seen);
  };
  const auto no_latitude = [](auto& fix) { fix.latitude = std::nan(""); };
  EXPECT_TRUE(ToFix(spoil(300, no_latitude), "300 of 600 have no finite latitude", "publish nothing"));
  EXPECT_TRUE(Passes(spoil(15, no_latitude))) << "before its first fix many a driver says so";
  const auto far_up = [](auto& fix) { fix.altitude = 1e6; };
  EXPECT_TRUE(ToFix(spoil(300, far_up), "300 of 600 have a latitude or longitude out of range", "degrees"));
}

TEST(CheckLeaps, FindTwoReceiversOnOneTopic) {
  Observations seen = healthy_robot();
  EXPECT_TRUE(check_leaps(seen).empty());
  for (std::size_t i = 0; i < seen.fixes.size(); i += 2) seen.fixes[i].message.latitude += 300.0 / 111e3;
  EXPECT_TRUE(
      ToFix(check_leaps(seen), "leap by 301 m", "one receiver on this topic only: rostopic info /gps/fix"));
  seen = healthy_robot();
  for (std::size_t i = 300; i < seen.fixes.size(); ++i) seen.fixes[i].message.latitude += 300.0 / 111e3;
  EXPECT_TRUE(check_leaps(seen).empty()) << "one that stays is no other receiver";
}

}  // namespace
}  // namespace multipath_localization
