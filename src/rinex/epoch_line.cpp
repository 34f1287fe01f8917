#include "rinex/epoch_line.hpp"

#include <cctype>

namespace multipath_localization {

namespace {

constexpr std::size_t kSatellitesOfLine = 12;
constexpr int kMostRecords = 999;
constexpr std::size_t kPoint = 18;  // of the seconds in version 2

/// Where in a line what stands where.
struct Layout {
  std::size_t time;     ///< first column of the year
  std::size_t seconds;  ///< the column after the seconds
  std::size_t flag;
};
constexpr Layout kVersion2 = {1, 26, 28};
constexpr Layout kVersion3 = {2, 29, 31};

bool digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

bool blank(const LineReader& in, std::size_t first, std::size_t width) {
  return in.columns(first, width).find_first_not_of(' ') == std::string_view::npos;
}

/// What of `in` stands next to column `right` is moved there.
void align(LineReader& in, std::size_t from, std::size_t right) {
  constexpr std::size_t kFarthest = 2;
  const std::size_t first = in.line().find_first_not_of(' ', from);
  if (first != std::string::npos && first + kFarthest >= right && first <= right + kFarthest)
    in.move(first, right);
}

/// An event may come without a time.
bool timeless_event(const LineReader& in) {
  const std::string_view flag = in.columns(kVersion2.flag, 1);
  return blank(in, 0, kVersion2.flag) && !flag.empty() && flag.front() >= '2' && flag.front() <= '5' &&
         blank(in, kVersion2.flag + 4, 80);
}

}  // namespace

GnssTime EpochLine::time(const LineReader& in, TimeScale scale, std::optional<int> leap_seconds) const {
  const CalendarTime read =
      version_2 ? calendar_time(in, kVersion2.time, 2, 11) : calendar_time(in, kVersion3.time, 4, 11);
  const std::optional<GnssTime> time = gps_time(read, scale, leap_seconds);
  if (!time) throw in.error("no such date and time");
  return *time;
}

std::vector<std::string> EpochLine::satellites(LineReader& in) const {
  std::vector<std::string> names;
  const std::size_t listed = version_2 ? static_cast<std::size_t>(count) : 0;
  std::size_t first = kVersion2.flag + 4;
  for (std::size_t i = 0; i < listed; ++i) {
    if (i > 0 && i % kSatellitesOfLine == 0) {
      in.require_next("the satellites of an epoch");
      if (!blank(in, 0, kVersion2.flag)) {
        in.put_back();
        throw in.error("an epoch of " + std::to_string(count) + " satellites that lists " +
                       std::to_string(i));
      }
      first = kVersion2.flag + (blank(in, kVersion2.flag, 4) ? 4 : 3);
    }
    names.emplace_back(in.columns(first + 3 * (i % kSatellitesOfLine), 3));
  }
  return names;
}

bool epoch_begins(const LineReader& in, bool version_2) {
  const std::string& line = in.line();
  if (!version_2) return !line.empty() && line.front() == '>';
  if (timeless_event(in)) return true;
  const bool date = line.size() > kVersion2.flag && line[0] == ' ' && digit(line[2]) && line[3] == ' ' &&
                    digit(line[5]) && line[6] == ' ' && digit(line[8]) && line[9] == ' ' && line[12] == ' ';
  return date && line[kPoint] == '.';
}

EpochLine read_epoch_line(LineReader& in, bool version_2) {
  if (!epoch_begins(in, version_2)) throw in.error("no epoch begins here");
  const Layout& layout = version_2 ? kVersion2 : kVersion3;
  if (!version_2) align(in, 1, layout.time);
  align(in, layout.seconds, layout.flag);
  if (blank(in, layout.flag, 1))
    throw in.error("no flag of the epoch in column " + std::to_string(layout.flag + 1));
  EpochLine line;
  line.version_2 = version_2;
  line.flag = in.integer(layout.flag, 1);
  const bool uncounted = line.event() && blank(in, layout.flag + 1, 3);
  line.count = uncounted ? 0 : in.integer(layout.flag + 1, 3);
  if (line.flag < 0 || line.flag > 6) throw in.error("no such flag of an epoch");
  if (line.count < 0 || line.count > kMostRecords) throw in.error("no such number of satellites");
  return line;
}

}  // namespace multipath_localization
