#include "rinex/gnss_time.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <tuple>

namespace multipath_localization {

namespace {

constexpr int kDaysToGpsEpoch = 3657;    // from 1 January 1970
constexpr double kBeidouSeconds = 14.0;  // GPS time - BeiDou time

struct Month {
  int year;
  int month;
};

/// Each began with one more second between GPS and UTC.
constexpr std::array<Month, 18> kLeaps = {{{1981, 7},
                                           {1982, 7},
                                           {1983, 7},
                                           {1985, 7},
                                           {1988, 1},
                                           {1990, 1},
                                           {1991, 1},
                                           {1992, 7},
                                           {1993, 7},
                                           {1994, 7},
                                           {1996, 1},
                                           {1997, 7},
                                           {1999, 1},
                                           {2006, 1},
                                           {2009, 1},
                                           {2012, 7},
                                           {2015, 7},
                                           {2017, 1}}};

/// From 1 January 1970, in the Gregorian calendar. The year is taken to begin in March: then the leap day is
/// its last.
int days_since_1970(int year, int month, int day) {
  const int y = month <= 2 ? year - 1 : year;
  const int day_of_year = (153 * (month + (month > 2 ? -3 : 9)) + 2) / 5 + day - 1;
  return 365 * y + y / 4 - y / 100 + y / 400 + day_of_year - 719468;
}

GnssTime as_it_reads(const CalendarTime& time) {
  const int days = days_since_1970(time.year, time.month, time.day) - kDaysToGpsEpoch;
  const int week = days / 7;
  return GnssTime{week, kSecondsOfDay * (days - 7 * week)} +
         (3600.0 * time.hour + 60.0 * time.minute + time.second);
}

int days_in(int year, int month) {
  const int next = month == 12 ? days_since_1970(year + 1, 1, 1) : days_since_1970(year, month + 1, 1);
  return next - days_since_1970(year, month, 1);
}

bool within(int value, int low, int high) { return value >= low && value <= high; }

bool exists(const CalendarTime& time) {
  return within(time.year, 1980, 2099) && within(time.month, 1, 12) &&
         within(time.day, 1, days_in(time.year, time.month)) && within(time.hour, 0, 23) &&
         within(time.minute, 0, 59) && time.second >= 0.0 && time.second < 61.0;
}

}  // namespace

bool operator<(const GnssTime& a, const GnssTime& b) {
  return std::tie(a.week, a.second) < std::tie(b.week, b.second);
}

GnssTime operator+(const GnssTime& time, double seconds) {
  const double second = time.second + seconds;
  const double weeks = std::floor(second / kSecondsOfWeek);
  const GnssTime sum = {time.week + static_cast<int>(weeks), second - weeks * kSecondsOfWeek};
  // A hair before the week begins is its beginning, rounded.
  return sum.second < kSecondsOfWeek ? sum : GnssTime{sum.week + 1, 0.0};
}

double operator-(const GnssTime& a, const GnssTime& b) {
  return kSecondsOfWeek * (a.week - b.week) + (a.second - b.second);
}

int year_of_two_digits(int year) { return year < 80 ? year + 2000 : year + 1900; }

std::optional<GnssTime> gps_time(const CalendarTime& time, TimeScale scale, std::optional<int> leap_seconds) {
  if (!exists(time)) return std::nullopt;
  const GnssTime reading = as_it_reads(time);
  // A leap second still counts by what held before it: the minute it is in tells.
  if (scale == TimeScale::kUtc)
    return reading + leap_seconds.value_or(leap_seconds_at(reading + -time.second));
  return scale == TimeScale::kBeidou ? reading + kBeidouSeconds : reading;
}

std::string to_text(const GnssTime& time) {
  const auto second_of_day = static_cast<int>(std::fmod(time.second, kSecondsOfDay));
  int days = kDaysToGpsEpoch + 7 * time.week + static_cast<int>(time.second / kSecondsOfDay);
  int year = 1970 + days / 366;
  while (days_since_1970(year + 1, 1, 1) <= days) ++year;
  int month = 12;
  while (days_since_1970(year, month, 1) > days) --month;
  days -= days_since_1970(year, month, 1);
  std::array<char, 80> text{};
  std::snprintf(text.data(), text.size(), "%04d-%02d-%02d %02d:%02d:%02d", year, month, days + 1,
                second_of_day / 3600, second_of_day / 60 % 60, second_of_day % 60);
  return text.data();
}

int leap_seconds_at(const GnssTime& utc) {
  int leaps = 0;
  for (const Month& month : kLeaps) {
    if (utc - as_it_reads({month.year, month.month, 1}) >= 0.0) ++leaps;
  }
  return leaps;
}

}  // namespace multipath_localization
