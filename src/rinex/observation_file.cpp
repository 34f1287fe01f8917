#include "rinex/observation_file.hpp"

#include <algorithm>
#include <iterator>

#include "rinex/epoch_line.hpp"
#include "rinex/epoch_order.hpp"

namespace multipath_localization {

namespace {

constexpr std::size_t kCellsOfLine = 5;  // in version 2

std::string name_of(char system) {
  if (system == 'S') return "SBAS";
  if (system == 'I') return "NavIC";
  return std::string(to_string(*constellation_of_letter(system)));
}

class ObservationReader {
 public:
  explicit ObservationReader(const std::string& file) : in_(file), kind_(read_kind(in_)), header_(kind_) {
    read_header();
  }

  ObservationLog read() {
    try {
      while (in_.next()) {
        if (in_.text(0, 80).empty()) continue;
        attempt([&] { read_record(); });
      }
    } catch (const UnexpectedEnd& end) {
      log_.left_out.emplace_back(end.what());
    }
    keep_in_order();
    return std::move(log_);
  }

 private:
  /// From the line after the first.
  void read_header() {
    if (kind_.type != 'O') throw in_.error(std::string("type '") + kind_.type + "' is no observations");
    for (in_.require_next("its header"); !in_.labelled("END OF HEADER"); in_.require_next("its header")) {
      if (epoch_begins(in_, header_.version_2())) {
        note("no END OF HEADER before the first epoch");
        in_.put_back();
        break;
      }
      read_header_line();
    }
    take_notices();
  }

  void read_header_line() {
    try {
      header_.read_line(in_);
    } catch (const RinexError& error) {
      log_.notices.emplace_back(error.what());
    }
  }

  void take_notices() {
    for (const std::string& notice : header_.check(in_)) log_.notices.push_back(notice);
  }

  void note(const std::string& what) { log_.notices.emplace_back(in_.error(what).what()); }

  /// Does a step and, where it fails, leaves out what comes before the next epoch or header.
  template <class Step>
  void attempt(const Step& step) {
    try {
      step();
    } catch (const UnexpectedEnd&) {
      throw;
    } catch (const RinexError& error) {
      log_.left_out.emplace_back(error.what());
      skip_to([&] { return something_begins(); });
    }
  }

  [[nodiscard]] bool something_begins() const {
    return begins_file(in_) || epoch_begins(in_, header_.version_2());
  }

  template <class Found>
  void skip_to(const Found& found) {
    while (in_.next()) {
      if (!found()) continue;
      in_.put_back();
      return;
    }
  }

  void read_record() {
    if (begins_file(in_)) return begin_file();
    const EpochLine line = read_epoch_line(in_, header_.version_2());
    if (line.event()) return read_event(line.count);
    RawEpoch epoch;
    const std::size_t number = in_.line_number();
    if (!line.slips()) epoch.time = line.time(in_, header_.time_scale(), header_.leap_seconds());
    const bool whole = read_satellites(line, epoch);
    if (line.slips() || !whole) return;
    files_.back().push_back({number, std::move(epoch)});
  }

  /// A file that was joined to the one before.
  void begin_file() {
    try {
      kind_ = kind_of(in_);
      header_ = ObservationHeader(kind_);
      files_.emplace_back();
      read_header();
    } catch (const UnexpectedEnd&) {
      throw;
    } catch (const RinexError& error) {
      log_.left_out.push_back(std::string(error.what()) + "; all up to the next header is left out");
      skip_to([&] { return begins_file(in_); });
    }
  }

  /// Lines of the header's kind, which may change the types.
  void read_event(int count) {
    for (int i = 0; i < count; ++i) {
      in_.require_next("an event");
      if (something_begins()) return in_.put_back();
      read_header_line();
    }
    if (count > 0) take_notices();
  }

  /// Whether the epoch can be used.
  bool read_satellites(const EpochLine& line, RawEpoch& epoch) {
    const std::size_t number = in_.line_number();
    const std::vector<std::string> names = line.satellites(in_);
    int there = 0;
    while (there < line.count && read_satellite(line, names, static_cast<std::size_t>(there), epoch)) ++there;
    const bool short_of = there < line.count;
    if (short_of || (header_.version_2() && !something_follows())) {
      const std::string what = short_of ? "an epoch of " + std::to_string(line.count) +
                                              " satellites that ends after " + std::to_string(there)
                                        : "an epoch of more lines than its satellites have";
      if (!line.slips()) log_.left_out.emplace_back(in_.error(number, what).what());
      return !header_.version_2();
    }
    return true;
  }

  /// Whether the next line that is not blank begins something, or there is none.
  bool something_follows() {
    try {
      while (in_.next()) {
        if (in_.text(0, 80).empty()) continue;
        in_.put_back();
        return something_begins();
      }
    } catch (const UnexpectedEnd&) {
      in_.put_back();
    }
    return true;
  }

  /// The lines of the next satellite, by name and cells; false when something else begins before it ends.
  bool read_satellite(const EpochLine& line, const std::vector<std::string>& names, std::size_t place,
                      RawEpoch& epoch) {
    in_.require_next("an epoch");
    if (something_begins()) return in_.put_back(), false;
    std::string cells = in_.line();
    std::string name = header_.version_2() ? names[place] : cells.substr(0, 3);
    if (!header_.version_2()) cells.erase(0, 3);
    if (header_.version_2() && !read_further_lines(cells)) return false;
    try {
      take_satellite(name, cells, epoch);
    } catch (const RinexError& error) {
      if (!line.slips()) log_.left_out.emplace_back(error.what());
    }
    return true;
  }

  bool read_further_lines(std::string& cells) {
    const std::size_t lines = (header_.types(' ').size() + kCellsOfLine - 1) / kCellsOfLine;
    cells.resize(kCellsOfLine * SatelliteRecord::kCell, ' ');
    for (std::size_t line = 1; line < lines; ++line) {
      in_.require_next("an epoch");
      if (something_begins()) return in_.put_back(), false;
      cells += in_.line();
      cells.resize((line + 1) * kCellsOfLine * SatelliteRecord::kCell, ' ');
    }
    return true;
  }

  void take_satellite(const std::string& name, const std::string& cells, RawEpoch& epoch) {
    if (name.size() != 3) throw in_.error("'" + name + "' is no satellite");
    const char system = name.front() == ' ' ? unnamed_system() : name.front();
    const std::optional<Constellation> constellation = constellation_of_letter(system);
    const bool passed_over = system == 'S' || system == 'I';
    if (!constellation && !passed_over) throw in_.error("'" + name + "' is of no known satellite system");
    const int number = number_in(name);
    if (header_.types(system).empty()) throw in_.error("'" + name + "' is of a system without types");
    const SatelliteRecord record(in_, header_, system, cells);
    const auto taken = passed_over ? std::nullopt : record.observation({*constellation, number});
    if (taken) {
      add(*taken, epoch);
    } else {
      count_unread(name_of(system), record.pseudoranges());
    }
  }

  void count_unread(const std::string& system, const std::vector<std::string>& codes) {
    for (const std::string& code : codes) ++log_.unread[system + " " + code];
    if (codes.empty()) ++log_.unread[system + " without a pseudorange"];
  }

  /// Of satellites without a letter, which version 2 allows.
  [[nodiscard]] char unnamed_system() const {
    return kind_.system == ' ' || kind_.system == 'M' ? 'G' : kind_.system;
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

  /// Files that were joined come in the order of their first epochs.
  void keep_in_order() {
    files_.erase(std::remove_if(files_.begin(), files_.end(), [](const auto& file) { return file.empty(); }),
                 files_.end());
    std::stable_sort(files_.begin(), files_.end(), [](const auto& a, const auto& b) {
      return a.front().epoch.time < b.front().epoch.time;
    });
    std::vector<ReadEpoch> all;
    for (auto& file : files_) std::move(file.begin(), file.end(), std::back_inserter(all));
    std::vector<GnssTime> times;
    times.reserve(all.size());
    for (const ReadEpoch& read : all) times.push_back(read.epoch.time);
    const std::vector<std::size_t> in_order = longest_in_order(times);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::size_t next = log_.epochs.size();
      if (next < in_order.size() && in_order[next] == i) {
        log_.epochs.push_back(std::move(all[i].epoch));
      } else {
        log_.left_out.emplace_back(in_.error(all[i].line, "time does not increase").what());
      }
    }
  }

  struct ReadEpoch {
    std::size_t line;
    RawEpoch epoch;
  };

  LineReader in_;
  FileKind kind_;
  ObservationHeader header_;
  ObservationLog log_;
  std::vector<std::vector<ReadEpoch>> files_{1};  ///< one but where several were joined
};

}  // namespace

ObservationLog read_observations(const std::string& file) { return ObservationReader(file).read(); }

}  // namespace multipath_localization
