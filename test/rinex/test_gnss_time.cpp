#include <gtest/gtest.h>

#include "rinex/gnss_time.hpp"

namespace multipath_localization {
namespace {

void expect_time(const std::optional<GnssTime>& time, int week, double second) {
  ASSERT_TRUE(time);
  EXPECT_EQ(time->week, week);
  EXPECT_NEAR(time->second, second, 1e-9);
}

TEST(GnssTime, CountsWeeksFromTheSixthOfJanuary1980) {
  expect_time(gps_time({1980, 1, 6, 0, 0, 0.0}, TimeScale::kGps), 0, 0.0);
  expect_time(gps_time({1999, 8, 22, 0, 0, 0.0}, TimeScale::kGps), 1024, 0.0);
  expect_time(gps_time({2019, 4, 7, 0, 0, 0.0}, TimeScale::kGps), 2048, 0.0);
  expect_time(gps_time({2024, 6, 24, 8, 20, 0.25}, TimeScale::kGps), 2320, 116400.25);
}

TEST(GnssTime, OfOtherScalesIsLaterByTheirOffset) {
  const CalendarTime time{2024, 6, 24, 8, 20, 0.0};
  expect_time(gps_time(time, TimeScale::kUtc), 2320, 116418.0);
  expect_time(gps_time(time, TimeScale::kUtc, 19), 2320, 116419.0);
  expect_time(gps_time(time, TimeScale::kBeidou), 2320, 116414.0);
  expect_time(gps_time({2016, 12, 31, 23, 59, 60.0}, TimeScale::kUtc), 1930, 17.0);
}

TEST(GnssTime, LeapSecondsAreThoseOfTheTable) {
  const auto at = [](int year, int month, int day) {
    return leap_seconds_at(*gps_time({year, month, day, 0, 0, 0.0}, TimeScale::kGps));
  };
  EXPECT_EQ(at(1980, 2, 1), 0);
  EXPECT_EQ(at(1998, 12, 31), 12);
  EXPECT_EQ(at(1999, 1, 1), 13);
  EXPECT_EQ(at(2016, 12, 31), 17);
  EXPECT_EQ(at(2017, 1, 1), 18);
}

TEST(GnssTime, RunsOverTheEndOfAWeek) {
  const GnssTime last = GnssTime{2320, 604799.5} + 1.0;
  EXPECT_EQ(last.week, 2321);
  EXPECT_DOUBLE_EQ(last.second, 0.5);
  const GnssTime before = last + -2.0 * kSecondsOfWeek;
  EXPECT_EQ(before.week, 2319);
  EXPECT_DOUBLE_EQ(last - before, 2.0 * kSecondsOfWeek);
}

TEST(GnssTime, AHairBeforeAWeekIsItsBeginning) {
  const GnssTime sum = GnssTime{2320, 0.0} + -1e-12;
  EXPECT_EQ(sum.week, 2320);
  EXPECT_EQ(sum.second, 0.0);
}

TEST(GnssTime, RefusesWhatNoCalendarHas) {
  for (const CalendarTime& time : {CalendarTime{2023, 2, 29, 0, 0, 0.0}, CalendarTime{2024, 13, 1, 0, 0, 0.0},
                                   CalendarTime{2024, 0, 1, 0, 0, 0.0}, CalendarTime{2024, 4, 31, 0, 0, 0.0},
                                   CalendarTime{2024, 1, 1, 24, 0, 0.0}, CalendarTime{2024, 1, 1, 0, 60, 0.0},
                                   CalendarTime{2024, 1, 1, 0, 0, 61.0}, CalendarTime{2024, 1, 1, 0, 0, -1.0},
                                   CalendarTime{1979, 1, 1, 0, 0, 0.0}}) {
    EXPECT_FALSE(gps_time(time, TimeScale::kGps)) << time.year << " " << time.month << " " << time.day;
  }
  EXPECT_TRUE(gps_time({2024, 2, 29, 0, 0, 0.0}, TimeScale::kGps));
}

TEST(GnssTime, IsPrintedAsACalendarHasIt) {
  for (const CalendarTime& time :
       {CalendarTime{2024, 6, 24, 8, 20, 30.7}, CalendarTime{2000, 2, 29, 23, 59, 59.0},
        CalendarTime{1980, 1, 6, 0, 0, 0.0}, CalendarTime{2099, 12, 31, 0, 0, 0.0}}) {
    char text[80];
    std::snprintf(text, sizeof(text), "%04d-%02d-%02d %02d:%02d:%02d", time.year, time.month, time.day,
                  time.hour, time.minute, static_cast<int>(time.second));
    EXPECT_EQ(to_text(*gps_time(time, TimeScale::kGps)), text);
  }
}

TEST(GnssTime, TwoDigitsAreAYearFrom1980To2079) {
  EXPECT_EQ(year_of_two_digits(80), 1980);
  EXPECT_EQ(year_of_two_digits(99), 1999);
  EXPECT_EQ(year_of_two_digits(0), 2000);
  EXPECT_EQ(year_of_two_digits(79), 2079);
}

}  // namespace
}  // namespace multipath_localization
