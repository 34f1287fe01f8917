#include "tools/tune_from_bag/tuning.hpp"

#include <algorithm>
#include <cmath>

#include "multipath_localization/estimators/localizer.hpp"
#include "tools/doctor/finding.hpp"

namespace multipath_localization {

namespace {

/// What is believed at least of noise that a drive of minutes tells.
constexpr double kLeastScaleSigma = 0.005;
constexpr double kLeastGyroBiasSigma = 5e-4;
constexpr double kLeastWhite = 0.01;

std::string untold(const char* what, const char* why) {
  return text("# %s: not told by this bag: %s\n", what, why);
}

std::string odometry_lines(const SensorNoise& noise) {
  constexpr char kIndent[] = "    ";
  std::string out = "  odometry:\n";
  const double scale_sigma =
      std::clamp(std::hypot(noise.scale->value - 1.0, noise.scale->sigma), kLeastScaleSigma, 0.5);
  const double gyro_sigma =
      std::clamp(std::hypot(noise.gyro_bias->value, noise.gyro_bias->sigma), kLeastGyroBiasSigma, 0.5);
  out +=
      kIndent + text("scale_sigma: %.3g  # the robot goes %.4f +- %.4f times as far as its odometry says\n",
                     scale_sigma, noise.scale->value, noise.scale->sigma);
  out += kIndent + text("gyro_bias_sigma: %.3g  # the yaw rate is off by %.5f +- %.5f rad/s\n", gyro_sigma,
                        noise.gyro_bias->value, noise.gyro_bias->sigma);
  const char* hidden = "the scatter of the fixes explains what varies, or there are fewer than 4 stretches";
  out += kIndent + (noise.distance_noise
                        ? text("distance: %.3g  # by how much the scale varies from stretch to stretch\n",
                               std::clamp(*noise.distance_noise, 1e-6, 1.0))
                        : untold("distance", hidden));
  out +=
      kIndent + (noise.yaw_noise
                     ? text("yaw: %.3g  # by how much the yaw rate's error varies from stretch to stretch\n",
                            std::clamp(*noise.yaw_noise, 1e-6, 1.0))
                     : untold("yaw", hidden));
  return out;
}

std::string class_lines(const FixNoise& fix) {
  constexpr char kIndent[] = "      ";
  std::string out = "  classes:\n    street:\n";
  out += kIndent + text("quiet_sigma: %.3g  # by differences of neighbouring fixes against odometry\n",
                        std::clamp(fix.white_sigma, kLeastWhite, 100.0));
  if (fix.coloured_sigma == 0.0)
    return out + kIndent + untold("open_bias_sigma, open_bias_time", "no slow wander is seen");
  out += kIndent + text("open_bias_sigma: %.3g  # slow wander of a fix about its place\n",
                        std::min(fix.coloured_sigma, 100.0));
  return out + kIndent +
         (fix.time_constant ? text("open_bias_time: %.3g  # its correlation time\n", *fix.time_constant)
                            : untold("open_bias_time", "longer than a quarter of a stretch"));
}

std::string delay_lines(const SensorNoise& noise) {
  std::string out;
  if (!noise.delay) {
    out = "# delay: not told by this bag: it takes turns and changes of speed\n";
  } else if (std::abs(noise.delay->value) < 3.0 * noise.delay->sigma) {
    out = text("# delay: none to be seen, %.2f +- %.2f s\n", noise.delay->value, noise.delay->sigma);
  } else {
    out = text(
        "# delay: a fix shows where the antenna was %.2f +- %.2f s before its stamp; no parameter takes "
        "that\n"
        "# up, have the driver stamp fixes %.2f s earlier\n",
        noise.delay->value, noise.delay->sigma, noise.delay->value);
  }
  const double kept = LocalizerParameters{}.history_length;
  if (noise.latency < 0.5 * kept) return out;
  return out + text("localizer:\n  history_length: %.3g  # fixes come in %.1f s after their stamps\n",
                    std::clamp(2.0 * noise.latency, kept, 60.0), noise.latency);
}

}  // namespace

std::string tuning(const SensorNoise& noise, const std::string& source) {
  std::string out =
      text("# %s: from %.0f s and %.0f m of driving in %zu of %zu stretches, the others loud or unusable.\n",
           source.c_str(), noise.time, noise.way, noise.quiet, noise.stretches);
  if (!noise.fix || !noise.scale) {
    return out +
           "# Too little to tell anything: drive some minutes under open sky, with turns and changes of "
           "speed.\n";
  }
  const FixNoise& fix = *noise.fix;
  out += "multipath_particle_filter:\n" + odometry_lines(noise) + class_lines(fix);
  out +=
      text("fix:\n  default_sigma: %.3g  # white and wandering noise together, for fixes that declare none\n",
           std::clamp(std::hypot(fix.white_sigma, fix.coloured_sigma), 1e-3, 1e3));
  return out + delay_lines(noise);
}

}  // namespace multipath_localization
