#include "multipath_localization/rinex/navigation_file.hpp"

#include "multipath_localization/rinex/line_reader.hpp"
#include "multipath_localization/rinex/navigation_message.hpp"

namespace multipath_localization {

namespace {

/// Files of version 2 are of one system each.
std::optional<Constellation> constellation_of_type(char type) {
  if (type == 'N') return Constellation::kGps;
  if (type == 'G') return Constellation::kGlonass;
  return std::nullopt;
}

/// One system's coefficients as the header gives them, in two lines.
struct IonosphereLines {
  KlobucharCoefficients coefficients;
  int lines = 0;

  /// Nothing but zeros is a receiver's way to say that it has none.
  [[nodiscard]] bool complete() const {
    return lines == 2 && !coefficients.alpha.isZero() && !coefficients.beta.isZero();
  }
};

class NavigationReader {
 public:
  NavigationReader(const std::string& file, Navigation& navigation)
      : in_(file), kind_(read_kind(in_)), navigation_(navigation) {
    const bool known = kind_.version_2() ? constellation_of_type(kind_.type).has_value() : kind_.type == 'N';
    if (!known) throw in_.error(std::string("type '") + kind_.type + "' is no navigation that is read");
  }

  void read() {
    for (in_.require_next("its header"); in_.label() != "END OF HEADER"; in_.require_next("its header")) {
      read_header_line();
    }
    for (const IonosphereLines* ionosphere : {&gps_, &qzss_}) {
      if (!navigation_.ionosphere && ionosphere->complete()) {
        navigation_.ionosphere = ionosphere->coefficients;
      }
    }
    while (in_.next()) {
      if (!in_.text(0, 80).empty()) read_message();
    }
  }

 private:
  void read_header_line() {
    const std::string label = in_.label();
    if (label == "LEAP SECONDS" && in_.text(24, 3) != "BDS") leap_seconds_ = in_.integer(0, 6);
    const std::string name = label == "IONOSPHERIC CORR" ? in_.text(0, 4) : label;
    if (name == "ION ALPHA") read_coefficients(2, gps_.coefficients.alpha, gps_);
    if (name == "ION BETA") read_coefficients(2, gps_.coefficients.beta, gps_);
    if (name == "GPSA") read_coefficients(5, gps_.coefficients.alpha, gps_);
    if (name == "GPSB") read_coefficients(5, gps_.coefficients.beta, gps_);
    if (name == "QZSA") read_coefficients(5, qzss_.coefficients.alpha, qzss_);
    if (name == "QZSB") read_coefficients(5, qzss_.coefficients.beta, qzss_);
  }

  void read_coefficients(std::size_t first, Eigen::Vector4d& coefficients, IonosphereLines& of) const {
    for (std::size_t i = 0; i < 4; ++i) {
      coefficients(static_cast<Eigen::Index>(i)) = in_.number(first + 12 * i, 12).value_or(0.0);
    }
    ++of.lines;
  }

  /// SBAS and NavIC.
  [[nodiscard]] bool passed_over() const {
    const char letter = in_.columns(0, 1).front();
    return !kind_.version_2() && (letter == 'S' || letter == 'I');
  }

  void read_message() {
    if (passed_over()) {
      while (next_is_continuation()) {
      }
      return;
    }
    const auto constellation = kind_.version_2() ? constellation_of_type(kind_.type) : std::nullopt;
    NavigationMessage message(in_, constellation);
    while (message.lines() < NavigationMessage::kMostLines && next_is_continuation()) message.add_line(in_);
    navigation_.ephemerides.add(message.ephemeris(in_, leap_seconds_));
  }

  bool next_is_continuation() {
    if (!in_.next()) return false;
    if (in_.text(0, 3).empty() && !in_.text(0, 80).empty()) return true;
    in_.put_back();
    return false;
  }

  LineReader in_;
  FileKind kind_;
  Navigation& navigation_;
  std::optional<int> leap_seconds_;
  IonosphereLines gps_;
  IonosphereLines qzss_;
};

}  // namespace

Navigation read_navigation(const std::vector<std::string>& files) {
  Navigation navigation;
  for (const std::string& file : files) NavigationReader(file, navigation).read();
  return navigation;
}

}  // namespace multipath_localization
