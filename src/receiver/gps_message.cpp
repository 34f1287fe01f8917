#include "receiver/gps_message.hpp"

#include "multipath_localization/core/angle.hpp"

namespace multipath_localization {

namespace {

constexpr std::size_t kWords = 10;
constexpr int kDataBits = 24, kParityBits = 6;  // of a word
constexpr std::uint64_t kPreamble = 0x8B;
constexpr std::size_t kHandover = 43;          // first bit of the subframe's number
constexpr std::size_t kContent = 48;           // first bit after the two words that begin every subframe
constexpr std::uint64_t kIonospherePage = 56;  // identifier of page 18 of subframe 4

/// The data without parity; nothing where it is no subframe.
std::optional<BitString> data_of(const Subframe& subframe) {
  if (subframe.words.size() < kWords) return std::nullopt;
  BitString bits;
  for (std::size_t i = 0; i < kWords; ++i) bits.append(subframe.words[i] >> kParityBits, kDataBits);
  if (BitReader(bits).whole(8) != kPreamble) return std::nullopt;
  return bits;
}

std::uint64_t number_of(const BitString& bits) { return BitReader(bits, kHandover).whole(3); }

/// What tells whether subframes belong together.
struct Issue {
  std::uint64_t of_clock = 0;  ///< IODC's lower half
  std::uint64_t of_orbit_2 = 0;
  std::uint64_t of_orbit_3 = 0;

  [[nodiscard]] bool is_one() const { return of_clock == of_orbit_2 && of_orbit_2 == of_orbit_3; }
};

void read_clock(const BitString& bits, const ReceptionTime& now, BroadcastOrbit& orbit, Issue& issue) {
  BitReader in(bits, kContent);
  in.skip(16);  // week, code on L2, accuracy
  const std::uint64_t health = in.whole(6);
  in.skip(2 + 88);  // upper half of the IODC, reserved
  orbit.group_delay = in.scaled_signed(8, -31);
  issue.of_clock = in.whole(8);
  orbit.clock_reference = nearest(now.gps, in.scaled(16, 4), kSecondsOfWeek);
  const double second_order = in.scaled_signed(8, -55);
  const double first_order = in.scaled_signed(16, -43);
  orbit.clock_polynomial = {in.scaled_signed(22, -31), first_order, second_order};
  // Of QZSS the lowest bit is of L1C/B, which is not used.
  const bool qzss = orbit.satellite.constellation == Constellation::kQzss;
  orbit.healthy = (qzss ? health & 0x3eU : health) == 0;
}

void read_first_half(const BitString& bits, const ReceptionTime& now, BroadcastOrbit& orbit, Issue& issue) {
  BitReader in(bits, kContent);
  issue.of_orbit_2 = in.whole(8);
  orbit.radius_correction.x() = in.scaled_signed(16, -5);
  orbit.mean_motion_difference = kPi * in.scaled_signed(16, -43);
  orbit.mean_anomaly = kPi * in.scaled_signed(32, -31);
  orbit.latitude_correction.y() = in.scaled_signed(16, -29);
  orbit.eccentricity = in.scaled(32, -33);
  orbit.latitude_correction.x() = in.scaled_signed(16, -29);
  orbit.root_axis = in.scaled(32, -19);
  orbit.toe = in.scaled(16, 4);
  orbit.reference = nearest(now.gps, orbit.toe, kSecondsOfWeek);
}

void read_second_half(const BitString& bits, BroadcastOrbit& orbit, Issue& issue) {
  BitReader in(bits, kContent);
  orbit.inclination_correction.y() = in.scaled_signed(16, -29);
  orbit.node = kPi * in.scaled_signed(32, -31);
  orbit.inclination_correction.x() = in.scaled_signed(16, -29);
  orbit.inclination = kPi * in.scaled_signed(32, -31);
  orbit.radius_correction.y() = in.scaled_signed(16, -5);
  orbit.perigee = kPi * in.scaled_signed(32, -31);
  orbit.node_rate = kPi * in.scaled_signed(24, -43);
  issue.of_orbit_3 = in.whole(8);
  orbit.inclination_rate = kPi * in.scaled_signed(14, -43);
}

}  // namespace

std::optional<BroadcastOrbit> GpsMessage::add(const Subframe& subframe, const ReceptionTime& now) {
  const std::optional<BitString> bits = data_of(subframe);
  if (!bits) return std::nullopt;
  const std::uint64_t number = number_of(*bits);
  if (number < 1 || number > subframes_.size()) return std::nullopt;
  subframes_.at(number - 1) = bits;
  if (!subframes_[0] || !subframes_[1] || !subframes_[2]) return std::nullopt;
  BroadcastOrbit orbit;
  orbit.satellite = subframe.satellite;
  Issue issue;
  read_clock(*subframes_[0], now, orbit, issue);
  read_first_half(*subframes_[1], now, orbit, issue);
  read_second_half(*subframes_[2], orbit, issue);
  if (!issue.is_one()) return std::nullopt;
  orbit.sent = now.gps - orbit.reference;
  subframes_ = {};
  return orbit;
}

std::optional<KlobucharCoefficients> gps_ionosphere(const Subframe& subframe) {
  const std::optional<BitString> bits = data_of(subframe);
  if (!bits || number_of(*bits) != 4) return std::nullopt;
  BitReader in(*bits, kContent);
  in.skip(2);  // data identifier
  if (in.whole(6) != kIonospherePage) return std::nullopt;
  KlobucharCoefficients ionosphere;
  constexpr std::array<int, 4> kAmplitude = {-30, -27, -24, -24};
  constexpr std::array<int, 4> kPeriod = {11, 14, 16, 16};
  for (std::size_t i = 0; i < kAmplitude.size(); ++i) {
    ionosphere.alpha(static_cast<Eigen::Index>(i)) = in.scaled_signed(8, kAmplitude.at(i));
  }
  for (std::size_t i = 0; i < kPeriod.size(); ++i) {
    ionosphere.beta(static_cast<Eigen::Index>(i)) = in.scaled_signed(8, kPeriod.at(i));
  }
  return ionosphere;
}

}  // namespace multipath_localization
