#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rinex/line_reader.hpp"

namespace multipath_localization {

/// What the header of an observation file says and later header lines among the epochs change: which
/// observation stands where, and the scale of the epochs' times.
class ObservationHeader {
 public:
  explicit ObservationHeader(const FileKind& kind);

  /// Takes one header line. Throws RinexError.
  void read_line(const LineReader& in);

  /// Throws RinexError when it names no types at all. Where it announces another number of types than it
  /// names the names count; what it says of that.
  [[nodiscard]] std::vector<std::string> check(const LineReader& in) const;

  /// The types of a system's observations by its letter, in the order of their columns.
  [[nodiscard]] const std::vector<std::string>& types(char system) const;

  /// What the numbers of a type have been multiplied by.
  [[nodiscard]] double scale(char system, const std::string& type) const;

  [[nodiscard]] TimeScale time_scale() const { return time_scale_; }
  [[nodiscard]] std::optional<int> leap_seconds() const { return leap_seconds_; }
  [[nodiscard]] double version() const { return version_; }
  [[nodiscard]] bool version_2() const { return version_2_; }

 private:
  void read_types(const LineReader& in);
  void begin_types(const LineReader& in);
  void read_scale(const LineReader& in);
  void read_time_scale(const LineReader& in);

  double version_;
  bool version_2_;
  TimeScale time_scale_;
  std::optional<int> leap_seconds_;
  char system_ = ' ';         ///< whose types the last line held
  char scaled_system_ = ' ';  ///< likewise of scale factors
  double scale_ = 0.0;        ///< the last one, 0: none yet
  std::map<char, std::vector<std::string>> types_;
  std::map<char, std::string> announced_;                 ///< how many, as it is printed
  std::map<char, std::map<std::string, double>> scales_;  ///< under an empty type: of all the others
};

}  // namespace multipath_localization
