#include "tools/tuning/tuning.hpp"

#include <algorithm>
#include <cmath>

#include "multipath_localization/models/preintegrated_odometry.hpp"
#include "multipath_localization/models/receiver_class.hpp"
#include "tools/doctor/finding.hpp"
#include "tools/tuning/open_sky.hpp"

namespace multipath_localization {

namespace {

constexpr double kBetterThanStreet = 0.5;  // of its quiet_sigma
constexpr double kEnoughOpenSky = 0.2;     // of the fixes

std::string range(const Told& number) {
  if (number.low_told && number.high_told) return text("%.3g..%.3g", number.low, number.high);
  if (number.high_told) return text("below %.3g", number.high);
  if (number.low_told) return text("above %.3g", number.low);
  return "anything";
}

/// The likeliest value where it is told, else the default as far as the drive allows.
double chosen(const Told& number, double usual) {
  if (number.told()) return number.value;
  if (number.high_told && usual > number.high) return number.high;
  if (number.low_told && usual < number.low) return number.low;
  return usual;
}

std::string line(const char* indent, const char* key, const Told& number, double usual, const char* unit,
                 const char* how) {
  const std::string sure = number.told() ? "told: " + range(number)
                                         : "not told by this bag: " + range(number) +
                                               "; the default as far as that allows. " + how;
  return text("%s%s: %.3g  # [%s] %s\n", indent, key, chosen(number, usual), unit, sure.c_str());
}

/// A constant of the odometer: `usual` has to be wide enough for it.
std::string line(const char* key, const FittedConstant& constant, double usual, const char* unit) {
  const double needed = std::abs(constant.value) + constant.sigma;
  return text("    %s: %.3g  # [%s] told: it is %.3g, give or take %.2g%s\n", key, std::max(usual, needed),
              unit, constant.value, 2.0 * constant.sigma,
              needed > usual ? "; better take it off in the base driver" : "");
}

std::string fix_line(const Tuning& tuning) {
  const NoiseFit& fit = tuning.fit;
  const double sigma = std::hypot(fit.white.value, fit.wander.value);
  return text(
      "fix:\n  default_sigma: %.3g  # [m] of a fix that declares none: white and slow error together%s\n",
      sigma, tuning.open_sky ? "" : ", reflections among them");
}

/// The default filter has classes for receivers between its best and its worst, and weighs them itself: one
/// moved on to another takes away from that. Only beyond them does it have to be told.
std::string class_lines(const Tuning& tuning) {
  if (!tuning.open_sky) return "  # classes: not told by this bag, it has hardly a fix under open sky\n";
  const NoiseFit& fit = tuning.fit;
  const ReceiverClasses classes;
  const ReceiverClass& usual = classes.street;
  const bool spanned =
      fit.white.value > kBetterThanStreet * usual.quiet_sigma && fit.white.value < classes.noisy.quiet_sigma;
  const char* indent = spanned ? "  #   " : "      ";
  return std::string(spanned ? "  # classes: street: as it is, the filter's classes span what was seen:\n"
                             : "  classes:\n    street:  # under open sky\n") +
         line(indent, "quiet_sigma", fit.white, usual.quiet_sigma, "m", "Stand or drive longer.") +
         line(indent, "open_bias_sigma", fit.wander, usual.open_bias_sigma, "m",
              "Drive for ten of its correlation times.") +
         line(indent, "open_bias_time", fit.wander_time, usual.open_bias_time, "s",
              "Drive for ten of these, or there is no slow error.");
}

std::string delay_line(const Told& delay) {
  if (!delay.low_told) return "# delay: not told by this bag; drive faster and with stops\n";
  const bool may_be_none = delay.low <= 0.0 && delay.high >= 0.0;
  return (may_be_none ? "# " : "") +
         text(
             "delay: %.3f  # [s] (%.3f..%.3f) fixes are of so long before their stamps on odometry's "
             "clock%s\n",
             delay.value, delay.low, delay.high,
             may_be_none ? ", which may be none" : "; an antenna further back than told looks the same");
}

}  // namespace

Tuning tune(const Drive& drive) {
  Tuning tuning;
  std::vector<GnssFix> fixes = fixes_under_open_sky(drive);
  const std::vector<GnssFix> all = drive.fixes();
  tuning.fixes = all.size();
  tuning.open_sky = static_cast<double>(fixes.size()) >= kEnoughOpenSky * static_cast<double>(all.size());
  tuning.fit = fit_noise(drive.odometry, tuning.open_sky ? fixes : all);
  return tuning;
}

std::string to_yaml(const Tuning& tuning) {
  const NoiseFit& fit = tuning.fit;
  const std::string by =
      text("# By %zu of %zu fixes%s, %.0f m of way in %.0f s of driving; ranges hold 95 %%.\n", fit.fixes,
           tuning.fixes, tuning.open_sky ? " under open sky" : ", reflected ones among them", fit.way,
           fit.moving_time);
  if (fit.white.value == 0.0) return by + "# Nothing told: too few fixes or too little driving.\n{}\n";
  const OdometryNoise usual;
  return by + fix_line(tuning) + "multipath_particle_filter:\n  odometry:\n" +
         line("scale_sigma", fit.scale, usual.scale_sigma, "1") +
         line("gyro_bias_sigma", fit.gyro_bias, usual.gyro_bias_sigma, "rad/s") +
         line("    ", "distance", fit.distance, usual.distance, "m/sqrt(m)",
              "The fixes are too coarse; a tape tells.") +
         line("    ", "yaw", fit.yaw, usual.yaw, "rad/sqrt(s)", "Drive further.") + class_lines(tuning) +
         delay_line(fit.delay);
}

}  // namespace multipath_localization
