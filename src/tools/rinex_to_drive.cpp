// Turns a receiver's raw log in RINEX into a drive directory for `evaluate --drive`.

#include <algorithm>
#include <boost/program_options.hpp>
#include <iostream>
#include <set>
#include <sstream>
#include <string_view>

#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/rinex/drive_writer.hpp"

namespace multipath_localization {
namespace {

namespace po = boost::program_options;

/// The command line.
struct Options {
  std::string observations;
  std::vector<std::string> navigation;
  std::string directory;
  double elevation_mask_deg = 0.0;
  PositioningSettings positioning;
  bool overwrite = false;
};

/// What is wrong with the command line.
class UsageError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

constexpr std::string_view kAfterwards = R"(
OBS: observations, RINEX 2.00 to 2.12 or 3.00 to 3.05. NAV: broadcast navigation of the same hours, one file or several,
of any mix of systems in RINEX 3, of GPS (N) or GLONASS (G) in RINEX 2. OUT: the directory to write
  pseudoranges.csv  without satellite clock, group delay, ionosphere (Klobuchar) and troposphere (Saastamoinen); range
                    rates without satellite clock drift; satellites at transmission, the Earth's rotation not undone
  fix.csv           plain least squares of each epoch, and robust_fix.csv the same with less trust in outliers
  drive.yaml        GPS time of t = 0, and where the drive comes from
Of each satellite the first of these codes is taken, with its own Doppler shift and C/N0: GPS C1C C1X C1L C1S C1P C1W,
GLONASS C1C C1P, Galileo C1C C1X C1B, BeiDou C2I C2X C1I (B1I), QZSS C1C C1X C1L C1S; RINEX 2: C1 P1, of BeiDou C2.
Put odometry.csv (t,vx,wz) and truth.csv (t,lat_deg,lon_deg) beside them where you have them: without odometry evaluate
moves by Doppler velocity, without truth it scores nothing.
Exit status: 0 when the drive was written, 2 when the command line or the files cannot be used.
)";

po::options_description visible_options() {
  po::options_description options("rinex_to_drive [options] OBS NAV... OUT", 110);
  const auto add = [&](auto... arguments) { options.add_options()(arguments...); };
  add("elevation-mask", po::value<double>()->default_value(5.0)->value_name("DEG"),
      "leave out satellites below this elevation");
  add("systems",
      po::value<std::string>()->default_value("GPS,GLONASS,GALILEO,BEIDOU,QZSS")->value_name("A,B"),
      "use these satellite systems");
  add("overwrite", "replace the files of an earlier run");
  add("help", "print this");
  return options;
}

std::set<Constellation> parse_systems(const std::string& text) {
  std::set<Constellation> systems;
  std::istringstream in(text);
  for (std::string name; std::getline(in, name, ',');) {
    const std::optional<Constellation> constellation = constellation_of(name);
    if (!constellation) throw UsageError("--systems: unknown system '" + name + "'");
    systems.insert(*constellation);
  }
  if (systems.empty()) throw UsageError("--systems names none");
  return systems;
}

Options read_options(const po::variables_map& given) {
  std::vector<std::string> files;
  if (given.count("file") > 0) files = given["file"].as<std::vector<std::string>>();
  if (files.size() < 3) throw UsageError("give OBS NAV... OUT; --help tells more");
  Options options;
  options.observations = files.front();
  options.navigation.assign(files.begin() + 1, files.end() - 1);
  options.directory = files.back();
  options.elevation_mask_deg = given["elevation-mask"].as<double>();
  if (!(options.elevation_mask_deg >= 0.0 && options.elevation_mask_deg < 90.0)) {
    throw UsageError("--elevation-mask is not within 0 and 90");
  }
  options.positioning.elevation_mask = options.elevation_mask_deg * kPi / 180.0;
  options.positioning.constellations = parse_systems(given["systems"].as<std::string>());
  options.overwrite = given.count("overwrite") > 0;
  return options;
}

/// What became of the epochs.
struct Tally {
  std::size_t epochs = 0;
  std::size_t written = 0;
  std::size_t observations = 0;
  std::size_t plain_fixes = 0;
  std::size_t robust_fixes = 0;
  std::set<SatelliteId> heard;
  std::set<SatelliteId> used;

  void add(const RawEpoch& raw) {
    ++epochs;
    for (const RawObservation& observation : raw.observations) heard.insert(observation.satellite);
  }
  void add(const CorrectedEpoch& epoch) {
    ++written;
    observations += epoch.observations.size();
    plain_fixes += epoch.plain ? 1 : 0;
    robust_fixes += epoch.robust ? 1 : 0;
    for (const TrackedSatellite& tracked : epoch.satellites) used.insert(tracked.satellite);
  }
};

void report(const Tally& tally, const Options& options, const Navigation& navigation) {
  std::cout << options.directory << ": " << tally.written << " of " << tally.epochs << " epochs, "
            << tally.observations << " pseudoranges of " << tally.used.size() << " satellites, "
            << tally.plain_fixes << " fixes, " << tally.robust_fixes << " robust ones\n";
  std::string unused;
  for (const SatelliteId& satellite : tally.heard) {
    const bool asked = options.positioning.constellations.count(satellite.constellation) > 0;
    if (!asked || tally.used.count(satellite) > 0) continue;
    unused += std::string(" ") + letter_of(satellite.constellation) + std::to_string(satellite.number);
  }
  if (!unused.empty()) {
    std::cerr << "never used, for want of a healthy ephemeris of the time or below the mask:" << unused
              << "\n";
  }
  if (tally.written < tally.epochs) {
    std::cerr << tally.epochs - tally.written
              << " epochs not written: no satellite, or no position known so far\n";
  }
  if (!navigation.ionosphere) {
    std::cerr << "no GPS or QZSS coefficients of the ionosphere in any NAV: its delay is left in\n";
  }
}

/// Counts what of the files could not be used, and names the first of it.
void warn_of(const std::vector<std::string>& left_out, const char* what) {
  constexpr std::size_t kNamed = 5;
  if (left_out.empty()) return;
  std::cerr << what << " that cannot be used: " << left_out.size() << "\n";
  for (std::size_t i = 0; i < std::min(left_out.size(), kNamed); ++i)
    std::cerr << "  " << left_out[i] << "\n";
  if (left_out.size() > kNamed) std::cerr << "  ...\n";
}

int convert(const Options& options) {
  const ObservationLog log = read_observations(options.observations);
  warn_of(log.left_out, "epochs");
  const std::vector<RawEpoch>& raw = log.epochs;
  if (raw.empty()) throw RinexError(options.observations + ": no epoch");
  const Navigation navigation = read_navigation(options.navigation);
  warn_of(navigation.left_out, "navigation messages");
  const DriveSource source{options.observations, options.navigation, raw.front().time,
                           options.elevation_mask_deg, navigation.ionosphere.has_value()};
  PointPositioning positioning(navigation, options.positioning);
  std::optional<DriveWriter> writer;
  Tally tally;
  for (const RawEpoch& epoch : raw) {
    tally.add(epoch);
    const std::optional<CorrectedEpoch> corrected = positioning.correct(epoch);
    if (!corrected) continue;
    if (!writer) writer.emplace(options.directory, source, options.overwrite);
    writer->add(*corrected);
    tally.add(*corrected);
  }
  if (!writer) {
    throw RinexError(options.observations +
                     ": no epoch has enough satellites with an ephemeris for a position");
  }
  writer->close();
  report(tally, options, navigation);
  return 0;
}

}  // namespace
}  // namespace multipath_localization

int main(int argc, char** argv) {
  using namespace multipath_localization;
  try {
    const po::options_description visible = visible_options();
    po::options_description all;
    all.add(visible).add_options()("file", po::value<std::vector<std::string>>());
    po::variables_map given;
    const int style = po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
    const po::positional_options_description positional =
        po::positional_options_description().add("file", -1);
    po::store(po::command_line_parser(argc, argv).options(all).positional(positional).style(style).run(),
              given);
    if (given.count("help") > 0) {
      std::cout << visible << kAfterwards;
      return 0;
    }
    return convert(read_options(given));
  } catch (const std::exception& error) {
    std::cerr << "rinex_to_drive: " << error.what() << "\n";
    return 2;
  }
}
