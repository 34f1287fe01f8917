#include "oracle.hpp"
#include "rinex/line_reader.hpp"
#include "rinex/observation_file.hpp"
#include "targets.hpp"

namespace multipath_localization::fuzz {

namespace {

void check(const RawEpoch& epoch) {
  require(epoch.time.second >= 0.0 && epoch.time.second < kSecondsOfWeek, "no second of a week");
  require(epoch.time.week >= -2 && epoch.time.week < 6300, "a week outside 1980 to 2099");
  for (const RawObservation& taken : epoch.observations) {
    require(taken.satellite.number >= 1 && taken.satellite.number <= 999, "no number of a satellite");
    require_finite(taken.pseudorange, "a pseudorange");
    require(!std::isinf(taken.doppler) && !std::isinf(taken.cn0), "Doppler or C/N0 is infinite");
  }
}

}  // namespace

void observations(const std::string& bytes) {
  const auto log =
      unless_refused<RinexError>([&] { return read_observations(written("observations.rnx", bytes)); });
  if (!log) return;
  for (std::size_t i = 0; i < log->epochs.size(); ++i) {
    check(log->epochs[i]);
    require(i == 0 || log->epochs[i].time - log->epochs[i - 1].time > 0.0, "epochs out of order");
  }
  for (const std::string& reason : log->left_out) require(!reason.empty(), "left out without a reason");
}

}  // namespace multipath_localization::fuzz
