// Turns a receiver's raw log in RINEX into a drive directory for `evaluate --drive`.

#include <algorithm>
#include <boost/program_options.hpp>
#include <iostream>
#include <map>
#include <set>
#include <sstream>
#include <string_view>

#include "multipath_localization/core/angle.hpp"
#include "rinex/drive_writer.hpp"

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
  fix.csv           plain least squares of each epoch, and robust_fix.csv the same with less trust in outliers;
                    status -1 where the antenna cannot have come from or gone to the other fixes
  drive.yaml        GPS time of t = 0, and where the drive comes from
Of each satellite the first of these codes is taken, with its own Doppler shift and C/N0: GPS C1C C1X C1L C1S C1P C1W
C1Y C1M, GLONASS C1C C1P, Galileo C1C C1X C1B C1Z C1A, BeiDou C2I C2X C2Q C1I (B1I), C1P C1X C1D C1Q C1S C1L C1Z (B1C,
whose group delay navigation in RINEX 3 does not tell: B1I's stands in), QZSS C1C C1X C1L C1S C1E C1Z C1B; RINEX 2: C1 CA
P1 CB, of BeiDou C2. Others are counted.
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

std::string name_of(const SatelliteId& satellite) {
  return letter_of(satellite.constellation) + std::to_string(satellite.number);
}

void report(const Tally& tally, const Options& options, const Navigation& navigation) {
  std::cout << options.directory << ": " << tally.written << " of " << tally.epochs << " epochs, "
            << tally.observations << " pseudoranges of " << tally.used.size() << " satellites, "
            << tally.plain_fixes << " fixes, " << tally.robust_fixes << " robust ones\n";
  std::string unused;
  for (const SatelliteId& satellite : tally.heard) {
    const bool asked = options.positioning.constellations.count(satellite.constellation) > 0;
    if (asked && tally.used.count(satellite) == 0) unused += " " + name_of(satellite);
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

/// The kind of a reason: without file and line, quoted text and numbers.
std::string kind_of(const std::string& reason, const std::string& file) {
  std::string kind;
  bool quoted = false;
  for (const char c : reason.substr(reason.rfind(file, 0) == 0 ? file.size() : 0)) {
    if (c == '\'') quoted = !quoted;
    if (!quoted && (c < '0' || c > '9')) kind += c;
  }
  return kind;
}

/// Counts what of the files could not be used, and names the first of each kind.
void warn_of(const std::vector<std::string>& reasons, const std::string& file, const std::string& what) {
  constexpr std::size_t kNamed = 10;  // kinds
  if (reasons.empty()) return;
  std::vector<std::string> first;
  std::map<std::string, std::size_t> times;
  for (const std::string& reason : reasons) {
    if (++times[kind_of(reason, file)] == 1) first.push_back(reason);
  }
  std::cerr << what << ": " << reasons.size() << "\n";
  for (std::size_t i = 0; i < std::min(first.size(), kNamed); ++i) {
    const std::size_t more = times[kind_of(first[i], file)] - 1;
    std::cerr << "  " << first[i] << (more > 0 ? ", and " + std::to_string(more) + " more such" : "") << "\n";
  }
  if (first.size() > kNamed) std::cerr << "  ... and " << first.size() - kNamed << " other kinds\n";
}

std::string unread_codes(const ObservationLog& log) {
  std::string text;
  for (const auto& [code, times] : log.unread) {
    text += (text.empty() ? "" : ", ") + code + " (" + std::to_string(times) + " times)";
  }
  return text;
}

/// What the times have to do with each other; empty where they meet.
std::string missed_times(const std::vector<RawEpoch>& epochs, const Navigation& navigation) {
  constexpr double kLongestUse = 6.0 * 3600.0;  // of an ephemeris before and after its time [s]
  const auto span = navigation.ephemerides.span();
  if (!span) return "no usable navigation message";
  const GnssTime first = epochs.front().time, last = epochs.back().time;
  if (first - span->second <= kLongestUse && span->first - last <= kLongestUse) return "";
  return "the observations are of " + to_text(first) + " to " + to_text(last) + ", the navigation of " +
         to_text(span->first) + " to " + to_text(span->second) + " (GPS time)";
}

/// Why there is no position at all.
std::string why_none(const Tally& tally, const ObservationLog& log, const Navigation& navigation) {
  const std::string unread = unread_codes(log);
  if (tally.heard.empty()) {
    return "no pseudorange of a code that is read" + (unread.empty() ? "" : "; there are: " + unread);
  }
  const std::string missed = missed_times(log.epochs, navigation);
  if (!missed.empty()) return missed;
  std::string heard;
  for (const SatelliteId& satellite : tally.heard) heard += " " + name_of(satellite);
  return "no epoch has enough satellites with an ephemeris for a position; heard were" + heard +
         (unread.empty() ? "" : "; not read is: " + unread);
}

void warn_of_fixes(const std::vector<double>& off_the_way) {
  if (off_the_way.empty()) return;
  std::cerr << off_the_way.size()
            << " robust fixes with status -1, where the antenna cannot have been: t = " << off_the_way.front()
            << " to " << off_the_way.back() << " s\n";
}

ObservationLog observations_of(const std::string& file) {
  ObservationLog log = read_observations(file);
  warn_of(log.notices, file, "what the header says and is not believed");
  warn_of(log.left_out, file, "epochs and records that cannot be used");
  if (log.epochs.empty()) throw RinexError(file + ": no epoch");
  return log;
}

int convert(const Options& options) {
  const ObservationLog log = observations_of(options.observations);
  const Navigation navigation = read_navigation(options.navigation);
  warn_of(navigation.left_out, options.navigation.front(), "navigation messages that cannot be used");
  const DriveSource source{options.observations, options.navigation, log.epochs.front().time,
                           options.elevation_mask_deg, navigation.ionosphere.has_value()};
  PointPositioning positioning(navigation, options.positioning);
  std::optional<DriveWriter> writer;
  Tally tally;
  for (const RawEpoch& epoch : log.epochs) {
    tally.add(epoch);
    const std::optional<CorrectedEpoch> corrected = positioning.correct(epoch);
    if (!corrected) continue;
    if (!writer) writer.emplace(options.directory, source, options.overwrite);
    writer->add(*corrected);
    tally.add(*corrected);
  }
  if (!writer) throw RinexError(options.observations + ": " + why_none(tally, log, navigation));
  writer->close();
  report(tally, options, navigation);
  if (!log.unread.empty()) std::cerr << "pseudoranges that are not read: " << unread_codes(log) << "\n";
  const std::string missed = missed_times(log.epochs, navigation);
  if (!missed.empty()) std::cerr << missed << "\n";
  warn_of_fixes(writer->off_the_way());
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
