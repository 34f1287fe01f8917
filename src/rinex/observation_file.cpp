#include "multipath_localization/rinex/observation_file.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <string_view>

#include "multipath_localization/rinex/line_reader.hpp"
#include "multipath_localization/rinex/observation_header.hpp"

namespace multipath_localization {

namespace {

constexpr std::size_t kCell = 16;        // columns: a number of 14, loss of lock, strength
constexpr std::size_t kCellsOfLine = 5;  // in version 2
constexpr std::size_t kSatellitesOfLine = 12;
constexpr int kMostRecords = 999;

/// Codes of a system in the order in which they are taken.
std::vector<std::string> codes(Constellation constellation, bool version_2) {
  const bool beidou = constellation == Constellation::kBeidou;
  if (version_2) return beidou ? std::vector<std::string>{"C2"} : std::vector<std::string>{"C1", "P1"};
  switch (constellation) {
    case Constellation::kGps: return {"C1C", "C1X", "C1L", "C1S", "C1P", "C1W"};
    case Constellation::kGlonass: return {"C1C", "C1P"};
    case Constellation::kGalileo: return {"C1C", "C1X", "C1B"};
    case Constellation::kBeidou: return {"C2I", "C2X", "C1I"};
    case Constellation::kQzss: return {"C1C", "C1X", "C1L", "C1S"};
  }
  return {};
}

/// The signal of a code under another first letter: "C1C" to "D1C", "P1" to "D1".
std::string same_signal(char letter, const std::string& code) { return letter + code.substr(1); }

/// The middle of what a digit of signal strength stands for [dB-Hz].
double cn0_of_digit(char digit) { return 6.0 * (digit - '0') + 2.5; }

/// The observations of one satellite as they stand in the file.
class Cells {
 public:
  Cells(const LineReader& in, const ObservationHeader& header, char system, std::string_view text)
      : in_(in), header_(header), system_(system), text_(text) {}

  /// Nothing where it is blank or 0, which are the two ways to say that there is none.
  [[nodiscard]] std::optional<double> number(const std::string& type) const {
    const std::optional<double> printed = in_.number(cell(type).substr(0, 14));
    if (!printed || *printed == 0.0) return std::nullopt;
    return *printed / header_.scale(system_, type);
  }

  [[nodiscard]] std::optional<double> strength(const std::string& type) const {
    const std::string_view its = cell(type);
    if (its.size() < kCell || its.back() < '1' || its.back() > '9') return std::nullopt;
    return cn0_of_digit(its.back());
  }

 private:
  [[nodiscard]] std::string_view cell(const std::string& type) const {
    const std::vector<std::string>& types = header_.types(system_);
    const auto place = static_cast<std::size_t>(std::find(types.begin(), types.end(), type) - types.begin());
    if (place == types.size() || place * kCell >= text_.size()) return {};
    return text_.substr(place * kCell, kCell);
  }

  const LineReader& in_;
  const ObservationHeader& header_;
  char system_;
  std::string_view text_;
};

std::optional<RawObservation> observation(const SatelliteId& satellite, bool version_2, const Cells& cells) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  for (const std::string& code : codes(satellite.constellation, version_2)) {
    const std::optional<double> pseudorange = cells.number(code);
    if (!pseudorange) continue;
    RawObservation taken;
    taken.satellite = satellite;
    taken.pseudorange = *pseudorange;
    taken.doppler = cells.number(same_signal('D', code)).value_or(kNone);
    const auto by_digit =
        cells.strength(code) ? cells.strength(code) : cells.strength(same_signal('L', code));
    taken.cn0 = cells.number(same_signal('S', code)).value_or(by_digit.value_or(kNone));
    return taken;
  }
  return std::nullopt;
}

class ObservationReader {
 public:
  explicit ObservationReader(const std::string& file)
      : in_(file), kind_(read_kind(in_)), version_2_(kind_.version_2()), header_(kind_) {
    if (kind_.type != 'O') throw in_.error(std::string("type '") + kind_.type + "' is no observations");
    for (in_.require_next("its header"); in_.label() != "END OF HEADER"; in_.require_next("its header")) {
      header_.read_line(in_);
    }
    header_.check(in_);
  }

  ObservationLog read() {
    try {
      while (in_.next()) {
        if (!in_.text(0, 80).empty()) read_record();
      }
    } catch (const UnexpectedEnd& end) {
      log_.left_out.emplace_back(end.what());
    }
    return std::move(log_);
  }

 private:
  /// What an epoch's line says besides its time.
  struct EpochLine {
    int flag = 0;   ///< 0, 1: observations, 6: cycle slips in their form, 2 to 5: events
    int count = 0;  ///< of satellites, of an event's lines
  };

  [[nodiscard]] EpochLine epoch_line() const {
    if (!version_2_ && in_.columns(0, 1) != ">") throw in_.error("no epoch begins here");
    const std::size_t column = version_2_ ? 28 : 31;
    const EpochLine line = {in_.integer(column, 1), in_.integer(column + 1, 3)};
    if (line.flag < 0 || line.flag > 6) throw in_.error("no such flag of an epoch");
    if (line.count < 0 || line.count > kMostRecords) throw in_.error("no such number of satellites");
    return line;
  }

  void read_record() {
    const EpochLine line = epoch_line();
    const bool slips = line.flag == 6;
    if (line.flag >= 2 && !slips) {
      read_event(line.count);
      return;
    }
    RawEpoch epoch;
    bool later = true;
    if (!slips) {
      epoch.time = time();
      later = log_.epochs.empty() || epoch.time - log_.epochs.back().time > 0.0;
      if (!later) log_.left_out.emplace_back(in_.error("time does not increase").what());
    }
    const std::vector<std::string> names = listed_satellites(version_2_ ? line.count : 0);
    for (int i = 0; i < line.count; ++i) {
      read_satellite(version_2_ ? names[static_cast<std::size_t>(i)] : "", epoch);
    }
    if (!slips && later) log_.epochs.push_back(std::move(epoch));
  }

  /// Lines of the header's kind, which may change the types.
  void read_event(int count) {
    for (int i = 0; i < count; ++i) {
      in_.require_next("an event");
      header_.read_line(in_);
    }
    header_.check(in_);
  }

  [[nodiscard]] GnssTime time() const {
    const CalendarTime read = version_2_ ? calendar_time(in_, 1, 2, 11) : calendar_time(in_, 2, 4, 11);
    const std::optional<GnssTime> time = gps_time(read, header_.time_scale(), header_.leap_seconds());
    if (!time) throw in_.error("no such date and time");
    return *time;
  }

  std::vector<std::string> listed_satellites(int count) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      if (i > 0 && i % kSatellitesOfLine == 0) in_.require_next("the satellites of an epoch");
      names.emplace_back(in_.columns(32 + 3 * (i % kSatellitesOfLine), 3));
    }
    return names;
  }

  /// The next satellite's lines; `name` is what the epoch's line says of it in version 2.
  void read_satellite(std::string name, RawEpoch& epoch) {
    in_.require_next("an epoch");
    std::string cells = in_.line();
    if (version_2_) {
      read_further_lines(cells);
    } else {
      name = cells.substr(0, 3);
      cells.erase(0, 3);
    }
    if (name.size() != 3) throw in_.error("'" + name + "' is no satellite");
    const char system = name.front() == ' ' ? unnamed_system() : name.front();
    if (header_.types(system).empty()) throw in_.error("'" + name + "' is of a system without types");
    if (system == 'S' || system == 'I') return;
    const std::optional<Constellation> constellation = constellation_of_letter(system);
    if (!constellation) throw in_.error("'" + name + "' is of no known satellite system");
    const SatelliteId satellite{*constellation, number_in(name)};
    const auto taken = observation(satellite, version_2_, Cells(in_, header_, system, cells));
    if (taken) add(*taken, epoch);
  }

  /// Of satellites without a letter, which version 2 allows.
  [[nodiscard]] char unnamed_system() const {
    return kind_.system == ' ' || kind_.system == 'M' ? 'G' : kind_.system;
  }

  void read_further_lines(std::string& cells) {
    const std::size_t lines = (header_.types(' ').size() + kCellsOfLine - 1) / kCellsOfLine;
    cells.resize(kCellsOfLine * kCell, ' ');
    for (std::size_t line = 1; line < lines; ++line) {
      in_.require_next("an epoch");
      cells += in_.line();
      cells.resize((line + 1) * kCellsOfLine * kCell, ' ');
    }
  }

  [[nodiscard]] int number_in(const std::string& name) const {
    const std::optional<double> number = in_.number(std::string_view(name).substr(1));
    if (!number || !(*number >= 1.0)) throw in_.error("'" + name + "' is no satellite");
    return static_cast<int>(*number);
  }

  void add(const RawObservation& taken, RawEpoch& epoch) const {
    for (const RawObservation& other : epoch.observations) {
      if (other.satellite == taken.satellite) throw in_.error("a satellite for the second time in an epoch");
    }
    epoch.observations.push_back(taken);
  }

  LineReader in_;
  FileKind kind_;
  bool version_2_;
  ObservationHeader header_;
  ObservationLog log_;
};

}  // namespace

ObservationLog read_observations(const std::string& file) { return ObservationReader(file).read(); }

}  // namespace multipath_localization
