#include "receiver/galileo_message.hpp"

#include <algorithm>

#include "multipath_localization/core/angle.hpp"

namespace multipath_localization {

namespace {

constexpr std::size_t kWords = 8;
constexpr std::size_t kOddPage = 128;                  // its first bit: each page is padded to four words
constexpr std::size_t kEvenData = 112, kOddData = 16;  // bits of a word in either page
constexpr std::size_t kEvenChecked = 114, kOddChecked = 82;  // bits that the CRC is of
constexpr std::size_t kTypeWidth = 6;                        // of a word's first field
constexpr double kMinute = 60.0;

/// The 128 bits of a word; nothing where the two pages are not those of one or are damaged.
std::optional<BitString> word_of(const Subframe& subframe) {
  if (subframe.words.size() < kWords) return std::nullopt;
  BitString pages;
  for (std::size_t i = 0; i < kWords; ++i) pages.append(subframe.words[i], 32);
  const bool nominal = !pages.at(1) && !pages.at(kOddPage + 1);  // neither is an alert
  if (pages.at(0) || !pages.at(kOddPage) || !nominal) return std::nullopt;
  BitString checked;
  checked.append(pages, 0, kEvenChecked);
  checked.append(pages, kOddPage, kOddChecked);
  const std::uint64_t crc = BitReader(pages, kOddPage + kOddChecked).whole(24);
  if (crc24q(checked, 0, checked.size()) != crc) return std::nullopt;
  BitString word;
  word.append(pages, 2, kEvenData);
  word.append(pages, kOddPage + 2, kOddData);
  return word;
}

/// Reads the issue of data that words 1 to 4 begin with.
std::uint64_t issue_of(const BitString& word) { return BitReader(word, kTypeWidth).whole(10); }

BitReader content_of(const BitString& word) { return BitReader(word, kTypeWidth + 10); }

void read_word_1(const BitString& word, const ReceptionTime& now, BroadcastOrbit& orbit) {
  BitReader in = content_of(word);
  orbit.toe = kMinute * in.scaled(14, 0);
  orbit.reference = nearest(now.gps, orbit.toe, kSecondsOfWeek);
  orbit.mean_anomaly = kPi * in.scaled_signed(32, -31);
  orbit.eccentricity = in.scaled(32, -33);
  orbit.root_axis = in.scaled(32, -19);
}

void read_word_2(const BitString& word, BroadcastOrbit& orbit) {
  BitReader in = content_of(word);
  orbit.node = kPi * in.scaled_signed(32, -31);
  orbit.inclination = kPi * in.scaled_signed(32, -31);
  orbit.perigee = kPi * in.scaled_signed(32, -31);
  orbit.inclination_rate = kPi * in.scaled_signed(14, -43);
}

/// Returns the index of accuracy.
std::uint64_t read_word_3(const BitString& word, BroadcastOrbit& orbit) {
  BitReader in = content_of(word);
  orbit.node_rate = kPi * in.scaled_signed(24, -43);
  orbit.mean_motion_difference = kPi * in.scaled_signed(16, -43);
  orbit.latitude_correction.y() = in.scaled_signed(16, -29);
  orbit.latitude_correction.x() = in.scaled_signed(16, -29);
  orbit.radius_correction.y() = in.scaled_signed(16, -5);
  orbit.radius_correction.x() = in.scaled_signed(16, -5);
  return in.whole(8);
}

void read_word_4(const BitString& word, const ReceptionTime& now, BroadcastOrbit& orbit) {
  BitReader in = content_of(word);
  in.skip(6);  // the satellite's number
  orbit.inclination_correction.y() = in.scaled_signed(16, -29);
  orbit.inclination_correction.x() = in.scaled_signed(16, -29);
  orbit.clock_reference = nearest(now.gps, kMinute * in.scaled(14, 0), kSecondsOfWeek);
  orbit.clock_polynomial.x() = in.scaled_signed(31, -34);
  orbit.clock_polynomial.y() = in.scaled_signed(21, -46);
  orbit.clock_polynomial.z() = in.scaled_signed(6, -59);
}

/// Returns whether E1 B is healthy and its data are valid.
bool read_word_5(const BitString& word, BroadcastOrbit& orbit) {
  BitReader in(word, kTypeWidth);
  in.skip(41 + 10);                               // ionosphere, delay of E5a
  orbit.group_delay = in.scaled_signed(10, -32);  // of E5b: I/NAV's clock is of E1 with E5b
  in.skip(2);                                     // health of E5b
  const bool healthy = in.whole(2) == 0;
  in.skip(1);  // validity of E5b
  return !in.flag() && healthy;
}

}  // namespace

std::optional<BroadcastOrbit> GalileoMessage::add(const Subframe& subframe, const ReceptionTime& now) {
  constexpr std::uint64_t kNoAccuracy = 255;
  const std::optional<BitString> word = word_of(subframe);
  if (!word) return std::nullopt;
  const std::uint64_t type = BitReader(*word).whole(kTypeWidth);
  if (type < 1 || type > words_.size()) return std::nullopt;
  words_.at(type - 1) = word;
  if (!std::all_of(words_.begin(), words_.end(), [](const auto& there) { return there.has_value(); })) {
    return std::nullopt;
  }
  const std::uint64_t issue = issue_of(*words_[0]);
  if (issue_of(*words_[1]) != issue || issue_of(*words_[2]) != issue || issue_of(*words_[3]) != issue) {
    return std::nullopt;
  }
  BroadcastOrbit orbit;
  orbit.satellite = subframe.satellite;
  read_word_1(*words_[0], now, orbit);
  read_word_2(*words_[1], orbit);
  const bool accurate = read_word_3(*words_[2], orbit) != kNoAccuracy;
  read_word_4(*words_[3], now, orbit);
  orbit.healthy = read_word_5(*words_[4], orbit) && accurate;
  orbit.sent = now.gps - orbit.reference;
  words_ = {};
  return orbit;
}

}  // namespace multipath_localization
