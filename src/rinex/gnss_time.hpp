#pragma once

#include <optional>
#include <string>

namespace multipath_localization {

constexpr double kSecondsOfDay = 86400.0;
constexpr double kSecondsOfWeek = 7.0 * kSecondsOfDay;

/// An instant on the time scale of GPS, to well below a nanosecond.
struct GnssTime {
  int week = 0;         ///< since 6 January 1980, not rolled over
  double second = 0.0;  ///< of the week, within [0, 604800)
};

bool operator<(const GnssTime& a, const GnssTime& b);

/// `seconds`: up to millions of years.
GnssTime operator+(const GnssTime& time, double seconds);

/// Seconds from `b` to `a`.
double operator-(const GnssTime& a, const GnssTime& b);

/// What the calendar of a file counts. Galileo's and QZSS's scales are that of GPS to some nanoseconds, and
/// receivers name GLONASS's by UTC.
enum class TimeScale { kGps, kUtc, kBeidou };

struct CalendarTime {
  int year = 0;  ///< 1980 to 2099
  int month = 0;
  int day = 0;
  int hour = 0;
  int minute = 0;
  double second = 0.0;  ///< below 61: UTC has leap seconds
};

/// The year of two digits: 80 to 99 are 1980 to 1999.
int year_of_two_digits(int year);

/// Nothing where the calendar has no such time. `leap_seconds` is GPS time - UTC; without it the table knows.
std::optional<GnssTime> gps_time(const CalendarTime& time, TimeScale scale,
                                 std::optional<int> leap_seconds = std::nullopt);

/// "2024-06-24 08:20:00" by GPS's calendar, seconds rounded down.
std::string to_text(const GnssTime& time);

/// GPS time - UTC [s] when UTC reads as `utc` does, by the announcements of IERS to the end of 2016; there
/// were no leap seconds after.
int leap_seconds_at(const GnssTime& utc);

}  // namespace multipath_localization
