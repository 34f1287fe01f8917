#include "rinex/ephemerides.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "multipath_localization/core/geodesy.hpp"

namespace multipath_localization {

namespace {

constexpr double kB1I = 1561.098e6;        // [Hz]
constexpr double kGlonassL1 = 1602.0e6;    // [Hz]
constexpr double kGlonassStep = 562.5e3;   // [Hz]
constexpr std::size_t kMostOfStream = 40;  // of a satellite
constexpr std::array<double, kConstellations> kUsable = {7200.0, 1800.0, 14400.0, 21600.0, 7200.0};  // [s]

const SatelliteId& satellite_of(const Ephemeris& ephemeris) {
  return std::visit([](const auto& e) -> const SatelliteId& { return e.satellite; }, ephemeris);
}

GnssTime reference_of(const Ephemeris& ephemeris) {
  return std::visit([](const auto& e) { return e.reference; }, ephemeris);
}

double distance(const Ephemeris& ephemeris, const GnssTime& time) {
  return std::abs(reference_of(ephemeris) - time);
}

std::optional<double> sent(const Ephemeris& ephemeris) {
  return std::visit([](const auto& e) { return e.sent; }, ephemeris);
}

bool healthy(const Ephemeris& ephemeris) {
  return std::visit([](const auto& e) { return e.healthy; }, ephemeris);
}

}  // namespace

SatelliteState satellite_state(const Ephemeris& ephemeris, const GnssTime& time) {
  return std::visit([&](const auto& e) { return satellite_state(e, time); }, ephemeris);
}

bool possible(const Ephemeris& ephemeris) {
  return std::visit([](const auto& e) { return possible(e); }, ephemeris);
}

double carrier_frequency(const Ephemeris& ephemeris, bool b1c) {
  if (const auto* glonass = std::get_if<GlonassOrbit>(&ephemeris)) {
    return kGlonassL1 + glonass->channel * kGlonassStep;
  }
  return satellite_of(ephemeris).constellation == Constellation::kBeidou && !b1c ? kB1I : kL1Frequency;
}

double group_delay(const Ephemeris& ephemeris) {
  const auto* orbit = std::get_if<BroadcastOrbit>(&ephemeris);
  return orbit != nullptr ? orbit->group_delay : 0.0;
}

void Ephemerides::add(const Ephemeris& ephemeris) {
  by_satellite_[satellite_of(ephemeris)].push_back(ephemeris);
  const GnssTime reference = reference_of(ephemeris);
  if (!span_) span_ = {reference, reference};
  span_ = {std::min(span_->first, reference), std::max(span_->second, reference)};
}

void Ephemerides::update(const Ephemeris& ephemeris) {
  std::vector<Ephemeris>& known = by_satellite_[satellite_of(ephemeris)];
  const GnssTime reference = reference_of(ephemeris);
  known.erase(std::remove_if(known.begin(), known.end(),
                             [&](const Ephemeris& other) { return reference_of(other) - reference == 0.0; }),
              known.end());
  if (known.size() == kMostOfStream) known.erase(known.begin());
  add(ephemeris);
}

std::vector<Ephemeris> Ephemerides::all() const {
  std::vector<Ephemeris> ephemerides;
  for (const auto& [satellite, known] : by_satellite_) {
    ephemerides.insert(ephemerides.end(), known.begin(), known.end());
  }
  return ephemerides;
}

std::vector<SatelliteId> Ephemerides::usable(const GnssTime& time) const {
  std::vector<SatelliteId> all;
  all.reserve(by_satellite_.size());
  for (const auto& [satellite, known] : by_satellite_) {
    if (find(satellite, time) != nullptr) all.push_back(satellite);
  }
  return all;
}

const Ephemeris* Ephemerides::find(const SatelliteId& satellite, const GnssTime& time) const {
  const auto known = by_satellite_.find(satellite);
  if (known == by_satellite_.end()) return nullptr;
  // Of two that are as good as each other min_element takes the first: they are gone through from the last.
  const auto nearest = std::min_element(known->second.rbegin(), known->second.rend(),
                                        [&](const Ephemeris& a, const Ephemeris& b) {
                                          const double left = distance(a, time);
                                          const double right = distance(b, time);
                                          return left < right || (left == right && sent(a) > sent(b));
                                        });
  const double usable = kUsable.at(static_cast<std::size_t>(satellite.constellation));
  return healthy(*nearest) && distance(*nearest, time) <= usable ? &*nearest : nullptr;
}

GnssTime transmission_time(const Ephemeris& ephemeris, const GnssTime& reception, double pseudorange) {
  const GnssTime by_its_clock = reception + -pseudorange / kSpeedOfLight;
  GnssTime time = by_its_clock;
  // The clock is asked for at a time that is wrong by the clock itself, which drifts by 1e-11: twice is
  // exact.
  for (int i = 0; i < 2; ++i) time = by_its_clock + -satellite_state(ephemeris, time).clock;
  return time;
}

}  // namespace multipath_localization
