#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rinex/line_reader.hpp"
#include "rinex/observation_header.hpp"
#include "rinex/satellite_id.hpp"

namespace multipath_localization {

/// What a receiver measured of one satellite on the one signal that is used of each.
struct RawObservation {
  SatelliteId satellite;
  double pseudorange = 0.0;                                   ///< [m]
  double doppler = std::numeric_limits<double>::quiet_NaN();  ///< positive when approaching [Hz]; NaN: none
  double cn0 = std::numeric_limits<double>::quiet_NaN();      ///< [dB-Hz]; NaN: not told
  bool b1c = false;  ///< of BeiDou: on the carrier of B1C and not of B1I
};

/// The observations of one satellite as they stand in the file.
class SatelliteRecord {
 public:
  /// Columns a cell has: a number of 14, loss of lock, strength.
  static constexpr std::size_t kCell = 16;

  /// `text`: its cells side by side; `in` is asked for errors alone. All have to outlive the record.
  SatelliteRecord(const LineReader& in, const ObservationHeader& header, char system, std::string_view text)
      : in_(in), header_(header), system_(system), text_(text) {}

  /// What is taken of it: the pseudorange of the first of `pseudorange_codes` that it has, with the Doppler
  /// shift and C/N0 of the same code; where there is no C/N0 the digit of the signal's strength gives it to
  /// 3 dB. Nothing without any. Throws RinexError for a number that is none or is cut off.
  [[nodiscard]] std::optional<RawObservation> observation(const SatelliteId& satellite) const;

  /// The pseudoranges it has, whether they are read or not, by their codes.
  [[nodiscard]] std::vector<std::string> pseudoranges() const;

 private:
  [[nodiscard]] std::string_view cell(const std::string& type) const;
  [[nodiscard]] std::optional<double> number(const std::string& type) const;
  [[nodiscard]] std::optional<double> strength(const std::string& type) const;

  const LineReader& in_;
  const ObservationHeader& header_;
  char system_;
  std::string_view text_;
};

}  // namespace multipath_localization
