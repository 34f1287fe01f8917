#include "rinex/navigation_file.hpp"

#include <cctype>

#include "rinex/line_reader.hpp"
#include "rinex/navigation_message.hpp"

namespace multipath_localization {

namespace {

/// Files of version 2 are of one system each.
std::optional<Constellation> constellation_of_type(char type) {
  if (type == 'N') return Constellation::kGps;
  if (type == 'G') return Constellation::kGlonass;
  return std::nullopt;
}

/// Nothing but zeros is a receiver's way to say that it has none.
bool complete(const KlobucharCoefficients& ionosphere) {
  return !ionosphere.alpha.isZero() && !ionosphere.beta.isZero();
}

class NavigationReader {
 public:
  NavigationReader(const std::string& file, Navigation& navigation)
      : in_(file), kind_(read_kind(in_)), navigation_(navigation) {
    check_kind();
  }

  void read() {
    read_header();
    try {
      while (in_.next()) {
        if (begins_file(in_)) {
          read_joined_file();
        } else if (!in_.text(0, 80).empty()) {
          read_message();
        }
      }
    } catch (const UnexpectedEnd& end) {
      navigation_.left_out.emplace_back(end.what());
    }
  }

 private:
  void check_kind() const {
    const bool known = kind_.version_2() ? constellation_of_type(kind_.type).has_value() : kind_.type == 'N';
    if (!known) throw in_.error(std::string("type '") + kind_.type + "' is no navigation that is read");
  }

  /// From the line after the first.
  void read_header() {
    for (in_.require_next("its header"); !in_.labelled("END OF HEADER"); in_.require_next("its header")) {
      try {
        read_header_line();
      } catch (const RinexError& error) {
        navigation_.left_out.emplace_back(error.what());
      }
    }
    for (const KlobucharCoefficients& ionosphere : {gps_, qzss_}) {
      if (!navigation_.ionosphere && complete(ionosphere)) navigation_.ionosphere = ionosphere;
    }
  }

  /// One that was joined to the one before, and is left out where its header cannot be used.
  void read_joined_file() {
    try {
      kind_ = kind_of(in_);
      check_kind();
      read_header();
    } catch (const UnexpectedEnd&) {
      throw;
    } catch (const RinexError& error) {
      navigation_.left_out.emplace_back(error.what());
      while (in_.next() && !begins_file(in_)) {
      }
      in_.put_back();
    }
  }

  void read_header_line() {
    if (in_.labelled("LEAP SECONDS") && in_.text(24, 3) != "BDS") leap_seconds_ = in_.integer(0, 6);
    if (in_.labelled("ION ALPHA")) gps_.alpha = coefficients(2);
    if (in_.text(60, 20) == "ION BETA") gps_.beta = coefficients(2);
    if (!in_.labelled("IONOSPHERIC CORR")) return;
    const std::string name = in_.text(0, 4);
    if (name == "GPSA") gps_.alpha = coefficients(5);
    if (name == "GPSB") gps_.beta = coefficients(5);
    if (name == "QZSA") qzss_.alpha = coefficients(5);
    if (name == "QZSB") qzss_.beta = coefficients(5);
  }

  [[nodiscard]] Eigen::Vector4d coefficients(std::size_t first) const {
    Eigen::Vector4d all;
    for (std::size_t i = 0; i < 4; ++i) {
      all(static_cast<Eigen::Index>(i)) = in_.number(first + 12 * i, 12).value_or(0.0);
    }
    return all;
  }

  /// What version 2 says once for all messages; nothing for a message that names its system itself, as those
  /// of version 3 do, and some writers' in files that they call version 2.
  [[nodiscard]] std::optional<Constellation> constellation_of_file() const {
    const bool named = std::isalpha(static_cast<unsigned char>(in_.columns(0, 1).front())) != 0;
    return kind_.version_2() && !named ? constellation_of_type(kind_.type) : std::nullopt;
  }

  /// SBAS and NavIC.
  [[nodiscard]] bool passed_over() const {
    const char letter = in_.columns(0, 1).front();
    return letter == 'S' || letter == 'I';
  }

  /// A message that cannot be used is left out to its last line.
  void read_message() {
    const auto constellation = constellation_of_file();
    std::optional<NavigationMessage> message;
    if (!passed_over()) attempt(message, [&] { message.emplace(in_, constellation); });
    while (next_is_continuation()) {
      if (message) attempt(message, [&] { message->add_line(in_); });
    }
    if (message) attempt(message, [&] { add(message->ephemeris(in_, leap_seconds_)); });
  }

  template <class Step>
  void attempt(std::optional<NavigationMessage>& message, const Step& step) {
    try {
      step();
    } catch (const RinexError& error) {
      navigation_.left_out.emplace_back(error.what());
      message.reset();
    }
  }

  void add(const std::optional<Ephemeris>& ephemeris) {
    if (ephemeris) navigation_.ephemerides.add(*ephemeris);
  }

  /// Throws UnexpectedEnd when the file breaks off in a line that continues the message, and not when it does
  /// in the first line of the next.
  bool next_is_continuation() {
    try {
      if (!in_.next()) return false;
      if (continues()) return true;
    } catch (const UnexpectedEnd&) {
      if (continues()) throw;
    }
    in_.put_back();
    return false;
  }

  [[nodiscard]] bool continues() const {
    return in_.text(0, 3).empty() && !in_.text(0, 80).empty() && !begins_file(in_);
  }

  LineReader in_;
  FileKind kind_;
  Navigation& navigation_;
  std::optional<int> leap_seconds_;
  KlobucharCoefficients gps_;
  KlobucharCoefficients qzss_;
};

}  // namespace

Navigation read_navigation(const std::vector<std::string>& files) {
  Navigation navigation;
  for (const std::string& file : files) NavigationReader(file, navigation).read();
  return navigation;
}

}  // namespace multipath_localization
