#include "receiver/beidou_message.hpp"

#include "multipath_localization/core/angle.hpp"

namespace multipath_localization {

namespace {

constexpr std::size_t kWords = 10;
constexpr int kWordBits = 30;
constexpr int kFirstParity = 4, kParity = 8;  // bits at the end of the first word and of each other
constexpr std::uint64_t kPreamble = 0x712;
constexpr std::size_t kContent = 38;      // first bit after preamble, number and second of the week
constexpr std::size_t kPageContent = 42;  // the same of a page of D2, after its number
constexpr double kBehindGps = 14.0;       // BeiDou's scale of time [s]
constexpr double kTenthOfNanosecond = 1e-10;
constexpr std::uint64_t kWeek = 604800;  // [s]

/// The data without parity; nothing where it is no subframe.
std::optional<BitString> data_of(const Subframe& subframe) {
  if (subframe.words.size() < kWords) return std::nullopt;
  BitString bits;
  for (std::size_t i = 0; i < kWords; ++i) {
    const int parity = i == 0 ? kFirstParity : kParity;
    bits.append(subframe.words[i] >> parity, kWordBits - parity);
  }
  if (BitReader(bits).whole(11) != kPreamble) return std::nullopt;
  return bits;
}

GnssTime reference_of(double second, const ReceptionTime& now) {
  return nearest(now.gps, second + kBehindGps, kSecondsOfWeek);
}

void read_health_and_clock_reference(BitReader& in, const ReceptionTime& now, BroadcastOrbit& orbit) {
  orbit.healthy = !in.flag();
  in.skip(5 + 4 + 13);  // age of the clock's data, accuracy, week
  orbit.clock_reference = reference_of(in.scaled(17, 3), now);
  orbit.group_delay = kTenthOfNanosecond * in.scaled_signed(10, 0);
  in.skip(10);  // of B2I
}

}  // namespace

std::optional<BroadcastOrbit> BeidouMessage::add(const Subframe& subframe, const ReceptionTime& now) {
  const bool d2 = geostationary(subframe.satellite);
  const std::size_t count = d2 ? 10 : 3;
  const std::uint64_t interval = d2 ? 3 : 6;  // from part to part [s]
  const std::optional<BitString> bits = data_of(subframe);
  if (!bits) return std::nullopt;
  BitReader in(*bits, 15);
  const std::uint64_t frame = in.whole(3);
  const std::uint64_t second = in.whole(20);
  const std::uint64_t number = d2 ? in.whole(4) : frame;
  if ((d2 && frame != 1) || number < 1 || number > count) return std::nullopt;
  parts_.at(number - 1) = Part{*bits, (second + kWeek - interval * (number - 1)) % kWeek};
  if (!whole(count)) return std::nullopt;
  BroadcastOrbit orbit = d2 ? orbit_of_d2(now) : orbit_of_d1(now);
  orbit.satellite = subframe.satellite;
  orbit.sent = now.gps - orbit.reference;
  parts_ = {};
  return orbit;
}

bool BeidouMessage::whole(std::size_t count) const {
  for (std::size_t i = 0; i < count; ++i) {
    const std::optional<Part>& part = parts_.at(i);
    if (!part || part->round != parts_[0]->round) return false;
  }
  return true;
}

BroadcastOrbit BeidouMessage::orbit_of_d1(const ReceptionTime& now) const {
  BroadcastOrbit orbit;
  BitReader first(parts_[0]->bits, kContent);
  read_health_and_clock_reference(first, now, orbit);
  first.skip(64);  // ionosphere
  orbit.clock_polynomial.z() = first.scaled_signed(11, -66);
  orbit.clock_polynomial.x() = first.scaled_signed(24, -33);
  orbit.clock_polynomial.y() = first.scaled_signed(22, -50);

  BitReader second(parts_[1]->bits, kContent);
  orbit.mean_motion_difference = kPi * second.scaled_signed(16, -43);
  orbit.latitude_correction.y() = second.scaled_signed(18, -31);
  orbit.mean_anomaly = kPi * second.scaled_signed(32, -31);
  orbit.eccentricity = second.scaled(32, -33);
  orbit.latitude_correction.x() = second.scaled_signed(18, -31);
  orbit.radius_correction.y() = second.scaled_signed(18, -6);
  orbit.radius_correction.x() = second.scaled_signed(18, -6);
  orbit.root_axis = second.scaled(32, -19);

  BitString upper_and_lower;  // halves of t_oe
  upper_and_lower.append(parts_[1]->bits, second.place(), 2);
  upper_and_lower.append(parts_[2]->bits, kContent, 15);
  orbit.toe = BitReader(upper_and_lower).scaled(17, 3);
  orbit.reference = reference_of(orbit.toe, now);

  BitReader third(parts_[2]->bits, kContent + 15);
  orbit.inclination = kPi * third.scaled_signed(32, -31);
  orbit.inclination_correction.y() = third.scaled_signed(18, -31);
  orbit.node_rate = kPi * third.scaled_signed(24, -43);
  orbit.inclination_correction.x() = third.scaled_signed(18, -31);
  orbit.inclination_rate = kPi * third.scaled_signed(14, -43);
  orbit.node = kPi * third.scaled_signed(32, -31);
  orbit.perigee = kPi * third.scaled_signed(32, -31);
  return orbit;
}

BroadcastOrbit BeidouMessage::orbit_of_d2(const ReceptionTime& now) const {
  BroadcastOrbit orbit;
  BitReader first(parts_[0]->bits, kPageContent);
  read_health_and_clock_reference(first, now, orbit);

  // What follows from page 3 on runs on from page to page, each of which is left where these bits end.
  BitString run;
  run.append(parts_[2]->bits, 80, 28);
  for (const std::size_t page : {4U, 5U, 6U, 7U}) run.append(parts_.at(page - 1)->bits, kPageContent, 64);
  run.append(parts_[7]->bits, kPageContent, 66);
  run.append(parts_[8]->bits, kPageContent, 64);
  run.append(parts_[9]->bits, kPageContent, 19);
  BitReader in(run);
  orbit.clock_polynomial.x() = in.scaled_signed(24, -33);
  orbit.clock_polynomial.y() = in.scaled_signed(22, -50);
  orbit.clock_polynomial.z() = in.scaled_signed(11, -66);
  in.skip(5);  // age of the orbit's data
  orbit.mean_motion_difference = kPi * in.scaled_signed(16, -43);
  orbit.latitude_correction.y() = in.scaled_signed(18, -31);
  orbit.mean_anomaly = kPi * in.scaled_signed(32, -31);
  orbit.latitude_correction.x() = in.scaled_signed(18, -31);
  orbit.eccentricity = in.scaled(32, -33);
  orbit.root_axis = in.scaled(32, -19);
  orbit.inclination_correction.y() = in.scaled_signed(18, -31);
  orbit.inclination_correction.x() = in.scaled_signed(18, -31);
  orbit.toe = in.scaled(17, 3);
  orbit.reference = reference_of(orbit.toe, now);
  orbit.inclination = kPi * in.scaled_signed(32, -31);
  orbit.radius_correction.y() = in.scaled_signed(18, -6);
  orbit.radius_correction.x() = in.scaled_signed(18, -6);
  orbit.node_rate = kPi * in.scaled_signed(24, -43);
  orbit.node = kPi * in.scaled_signed(32, -31);
  orbit.perigee = kPi * in.scaled_signed(32, -31);
  orbit.inclination_rate = kPi * in.scaled_signed(14, -43);
  return orbit;
}

}  // namespace multipath_localization
