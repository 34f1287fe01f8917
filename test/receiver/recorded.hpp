#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "rinex/navigation_file.hpp"
#include "rinex/observation_file.hpp"
#include "ubx_encoder.hpp"

namespace multipath_localization {

/// A receiver's log, by RINEX.
struct Recording {
  Navigation navigation;
  std::vector<RawEpoch> epochs;
};

/// Where the folder that MULTIPATH_LOCALIZATION_DATA names has them, drives of u-blox receivers.
inline std::vector<std::filesystem::path> recorded_drives() {
  const char* data = std::getenv("MULTIPATH_LOCALIZATION_DATA");
  std::vector<std::filesystem::path> found;
  if (data == nullptr) return found;
  for (const char* name : {"hk_tst2021_m8t", "hk_tst2021_f9p"}) {
    const std::filesystem::path drive = std::filesystem::path(data) / "drives" / name;
    if (std::filesystem::exists(drive / "rover.obs")) found.push_back(drive);
  }
  return found;
}

/// The drive's, with the ephemerides alone that may be used in it, as messages hold them: some files have
/// numbers with fewer digits.
inline Recording read_recording(const std::filesystem::path& drive) {
  Recording recording;
  recording.epochs = read_observations((drive / "rover.obs").string()).epochs;
  const Navigation all = read_navigation({(drive / "brdc.nav").string()});
  recording.navigation.ionosphere = all.ionosphere;
  for (const Ephemeris& ephemeris : all.ephemerides.all()) {
    const GnssTime reference = std::visit([](const auto& orbit) { return orbit.reference; }, ephemeris);
    const double before = recording.epochs.front().time - reference,
                 after = reference - recording.epochs.back().time;
    if (before < 7200.0 && after < 7200.0) recording.navigation.ephemerides.add(ephemeris);
  }
  return recording;
}

/// What a receiver sends that heard all that: an epoch to know the time by, what is broadcast, the epochs.
inline std::string stream_of(const Recording& recording) {
  const GnssTime start = recording.epochs.front().time;
  std::string bytes = ubx::rawx({start + -1.0, {}});
  double later = 0.0;
  for (const Ephemeris& ephemeris : recording.navigation.ephemerides.all()) {
    bytes += ubx::sfrbx(ephemeris, start + (later += 30.0));
  }
  if (recording.navigation.ionosphere) {
    bytes += ubx::sfrbx({Constellation::kGps, 1},
                        {ubx::gps_ionosphere_page(*recording.navigation.ionosphere, start)});
  }
  for (const RawEpoch& epoch : recording.epochs) bytes += ubx::rawx(epoch);
  return bytes;
}

}  // namespace multipath_localization
