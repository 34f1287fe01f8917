#include "tools/tuning/tuning.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "estimators/multipath/multipath_particle_filter.hpp"
#include "multipath_localization/localization/localizer.hpp"
#include "tools/doctor/finding.hpp"
#include "tools/doctor/shape_fit.hpp"
#include "tools/tuning/open_sky.hpp"

namespace multipath_localization {

namespace {

constexpr double kEnoughOpenSky = 0.2;   // of the fixes
constexpr double kWidestConstant = 0.5;  // of scale_sigma and gyro_bias_sigma
constexpr double kAlike = 0.3;           // of the extent of a piece of way, left between fixes and odometry
constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kNothing = 0.05;  // less is not worth a word [m]

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
  if (needed > kWidestConstant) {
    return text("    # %s: it is %.3g, more than the node takes: mend the base driver (doctor says what)\n",
                key, constant.value);
  }
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

/// What the fixes are off by under open sky. The default filter learns it, so these are not parameters.
std::string fix_errors(const Tuning& tuning) {
  if (!tuning.open_sky)
    return "# errors of fixes: not told by this bag, it has hardly a fix under open sky\n";
  const NoiseFit& fit = tuning.fit;
  return text("# errors of fixes under open sky: white %.3g m (%s), slow %.3g m (%s) over %.3g s (%s)\n",
              fit.white.value, range(fit.white).c_str(), fit.wander.value, range(fit.wander).c_str(),
              fit.wander_time.value, range(fit.wander_time).c_str());
}

bool may_be_none(const Told& number) { return number.low <= 0.0 && number.high >= 0.0; }

/// What delay and antenna look like together, where they are not told apart: at this speed.
std::string together_lines(const NoiseFit& fit) {
  const Told& behind = fit.behind;
  if (fit.odometry_leaps)
    return "# delay, antenna: not told by this bag: its odometry leaps by what no robot drives, look at it "
           "with doctor\n";
  if (!behind.low_told)
    return "# delay, antenna: not told by this bag: drive a figure of eight at several speeds\n";
  const double speed = fit.way / fit.moving_time;
  if (may_be_none(behind) || std::abs(behind.value) < kNothing) {
    return text("# delay, antenna: fixes are where they are to be, give or take %.2f m\n",
                0.5 * (behind.high - behind.low));
  }
  const bool late = behind.value > 0.0;
  return text(
      "# delay, antenna: not told apart by this bag, its speed hardly varies: fixes are %.2f m %s of where "
      "they are to be,\n"
      "#   be it by a delay of %.3f s or by an antenna %.2f m further %s than told. Measure the antenna, or "
      "drive\n"
      "#   at several speeds.\n",
      std::abs(behind.value), late ? "behind" : "ahead", behind.value / speed, std::abs(behind.value),
      late ? "back" : "ahead");
}

std::string delay_line(const NoiseFit& fit) {
  const Told& delay = fit.delay;
  const bool too_early = -delay.value >= LocalizerParameters{}.future_tolerance;
  const bool active = !may_be_none(delay) && !too_early;
  const char* remark = "";
  if (may_be_none(delay)) remark = ", which may be none";
  if (too_early) {
    remark =
        ": two clocks, and the node would refuse such fixes as of the future; set the clocks (chronyc "
        "makestep)";
  }
  return (active ? "" : "# ") + text(
                                    "delay: %.3f  # [s] (%.3f..%.3f) fixes are of so long before their "
                                    "stamps on odometry's clock%s\n",
                                    delay.value, delay.low, delay.high, remark);
}

std::string antenna_line(const Told& ahead) {
  if (may_be_none(ahead) || std::abs(ahead.value) < kNothing) return "";
  return text(
      "# antenna: %.2f m (%.2f..%.2f) further %s than told; measure it and say so by tf or by antenna: [X, "
      "Y]\n",
      std::abs(ahead.value), std::min(std::abs(ahead.low), std::abs(ahead.high)),
      std::max(std::abs(ahead.low), std::abs(ahead.high)), ahead.value > 0.0 ? "ahead" : "back");
}

std::string stamp_lines(const NoiseFit& fit) {
  if (!fit.delay.low_told || !fit.antenna_ahead.low_told) return together_lines(fit);
  return delay_line(fit) + antenna_line(fit.antenna_ahead);
}

/// The drive between two silences of odometry, or the ends: where it was silent nobody knows what the robot
/// did.
Drive longest_part(const Drive& drive) {
  if (drive.restarts.empty()) return drive;
  std::vector<double> ends = {drive.odometry.front().stamp};
  ends.insert(ends.end(), drive.restarts.begin(), drive.restarts.end());
  ends.push_back(std::nextafter(drive.odometry.back().stamp, kNever));
  std::size_t longest = 1;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    if (ends[i] - ends[i - 1] > ends[longest] - ends[longest - 1]) longest = i;
  }
  const auto outside = [&](double stamp) { return stamp < ends[longest - 1] || stamp >= ends[longest]; };
  Drive part = drive;
  part.restarts.clear();
  auto& odometry = part.odometry;
  odometry.erase(
      std::remove_if(odometry.begin(), odometry.end(), [&](const auto& u) { return outside(u.stamp); }),
      odometry.end());
  auto& measurements = part.measurements;
  measurements.erase(std::remove_if(measurements.begin(), measurements.end(),
                                    [&](const auto& recorded) { return outside(recorded.arrival); }),
                     measurements.end());
  return part;
}

/// The fixes without those that say the same to the bit as the one before: of a receiver that has frozen, or
/// of a driver that sends each twice.
std::vector<GnssFix> without_repetitions(std::vector<GnssFix> fixes) {
  const auto same = [](const GnssFix& a, const GnssFix& b) { return a.position == b.position; };
  fixes.erase(std::unique(fixes.begin(), fixes.end(), same), fixes.end());
  return fixes;
}

}  // namespace

Tuning tune(const Drive& whole) {
  Tuning tuning;
  tuning.parts = whole.restarts.size() + 1;
  const Drive drive = longest_part(whole);
  const std::vector<GnssFix> all = without_repetitions(drive.fixes());
  const std::vector<GnssFix> open = without_repetitions(fixes_under_open_sky(drive));
  tuning.fixes = all.size();
  tuning.open_sky = static_cast<double>(open.size()) >= kEnoughOpenSky * static_cast<double>(all.size());
  const std::vector<GnssFix>& fixes = tuning.open_sky ? open : all;
  tuning.fit = fit_noise(drive.odometry, fixes);
  const ShapeFit ways = fit_shape(fixes, OdometryTrack(drive.odometry));
  tuning.alike = ways.pieces == 0 || ways.error < kAlike;
  return tuning;
}

std::string to_yaml(const Tuning& tuning) {
  const NoiseFit& fit = tuning.fit;
  const std::string part =
      tuning.parts > 1
          ? text("# Of %zu parts between silences of odometry the longest counts.\n", tuning.parts)
          : "";
  const std::string by =
      part + text("# By %zu of %zu fixes%s, %.0f m of way in %.0f s of driving; ranges hold 95 %%.\n",
                  fit.fixes, tuning.fixes,
                  tuning.open_sky ? " under open sky" : ", reflected ones among them", fit.way,
                  fit.moving_time);
  if (fit.white.value == 0.0) return by + "# Nothing told: too few fixes or too little driving.\n{}\n";
  const OdometryNoise usual = MultipathParticleFilterParameters{}.odometry;
  if (!tuning.alike) {
    return by +
           "# Nothing told: fixes and odometry do not go the same way; doctor --bag FILE says why.\n{}\n";
  }
  return by + fix_line(tuning) + "multipath_particle_filter:\n  odometry:\n" +
         line("scale_sigma", fit.scale, usual.scale_sigma, "1") +
         line("gyro_bias_sigma", fit.gyro_bias, usual.gyro_bias_sigma, "rad/s") +
         line("    ", "distance", fit.distance, usual.distance, "m/sqrt(m)",
              "The fixes are too coarse; a tape tells.") +
         line("    ", "yaw", fit.yaw, usual.yaw, "rad/sqrt(s)", "Drive further.") + fix_errors(tuning) +
         stamp_lines(fit);
}

}  // namespace multipath_localization
