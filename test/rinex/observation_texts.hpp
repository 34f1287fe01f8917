#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "broadcast.hpp"
#include "rinex/line_reader.hpp"
#include "rinex/observation_file.hpp"

namespace multipath_localization {

/// Parts of observation files.
inline const std::string kHeader3 =
    header_line("     3.04           OBSERVATION DATA    M", "RINEX VERSION / TYPE") +
    header_line("G    8 C1C L1C D1C S1C C1W D1W S1W C2W", "SYS / # / OBS TYPES") +
    header_line("R    4 C1C L1C D1C S1C", "SYS / # / OBS TYPES") +
    header_line("C    5 C6I C2I L2I D2I S2I", "SYS / # / OBS TYPES") +
    header_line("S    1 C1C", "SYS / # / OBS TYPES") +
    header_line("  2024     6    24     8    20    0.0000000     GPS", "TIME OF FIRST OBS") +
    header_line("", "END OF HEADER");
inline const std::string kEpoch3 =
    "> 2024 06 24 08 20  0.0000000  0  4\n"
    "G05  20590792.555 7 108205345.40907      -105.331 7        46.938    20590793.111         -105.300      "
    "    45.000\n"
    "G07                                                                  26127502.600\n"
    "C03  37529157.793 7  37529162.330 7 195424197.82907       172.632 7        44.219\n"
    "S29  38000000.000\n";

inline const std::string kHeader2 =
    header_line("     2.11           OBSERVATION DATA    M: MIXED", "RINEX VERSION / TYPE") +
    header_line("     6    C1    L1    D1    P1    P2    S1", "# / TYPES OF OBSERV") +
    header_line("  2024    06    24    08    20   00.0000000     GPS", "TIME OF FIRST OBS") +
    header_line("", "END OF HEADER");

/// Reads a text as such a file.
class ReadObservations : public ::testing::Test {
 protected:
  [[nodiscard]] std::vector<RawEpoch> read(const std::string& content) const {
    return read_observations(folder_.write("obs", content)).epochs;
  }

  [[nodiscard]] std::vector<std::string> left_out(const std::string& content) const {
    std::vector<std::string> reasons = read_observations(folder_.write("obs", content)).left_out;
    for (std::string& reason : reasons) reason.erase(0, folder_.path().size() + 5);
    return reasons;
  }

  [[nodiscard]] std::string refusal(const std::string& content) const {
    try {
      (void)read(content);
    } catch (const RinexError& error) {
      return std::string(error.what()).substr(folder_.path().size() + 5);
    }
    return "";
  }

  TemporaryFolder folder_;
};

}  // namespace multipath_localization
