#include "simulation/random_heading.hpp"

#include <algorithm>
#include <cmath>

#include "simulation/gauss_markov.hpp"
#include "simulation/random_ranges.hpp"
#include "simulation/streams.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

namespace ranges = random_ranges;

constexpr double kOutlierRun = 1.5;  ///< mean time of one [s]

}  // namespace

RandomHeading draw_heading(std::uint64_t seed) {
  RandomStream random(seed, 0, kRandomHeadingStream);
  RandomHeading heading;
  heading.period_ms = one_of(random, {50, 100, 200, 1000});
  const double sigma = draw(random, ranges::kHeadingSigma);
  const double slow_share = draw(random, Span{0.0, 1.0});
  heading.white_sigma = sigma * std::sqrt(1.0 - slow_share);
  heading.slow_sigma = sigma * std::sqrt(slow_share);
  heading.slow_time = draw(random, ranges::kHeadingTime);
  heading.offset = draw(random, ranges::kHeadingOffset);
  heading.declared = sigma * draw(random, ranges::kHeadingDeclared);
  heading.outlier_share = draw(random, ranges::kHeadingOutliers);
  return heading;
}

std::vector<Heading> read_headings(const RandomHeading& heading, const std::vector<MotionStep>& steps,
                                   std::uint64_t seed) {
  RandomStream random(seed, 1, kRandomHeadingStream);
  GaussMarkov2 slow(heading.slow_sigma, heading.slow_time, RandomStream(seed, 2, kRandomHeadingStream));
  const auto stride = static_cast<std::size_t>(heading.period_ms / kWayStepMs);
  const double period = 1e-3 * heading.period_ms;
  double wrong_until = 0.0;
  std::vector<Heading> read;
  for (std::size_t n = stride; n <= steps.size(); n += stride) {
    const double time = static_cast<double>(n) * kWayStepMs / 1000.0;
    slow.step(period, random);
    if (chance(random, heading.outlier_share * std::min(1.0, period / kOutlierRun))) {
      wrong_until = time + kOutlierRun * draw(random, Span{0.5, 1.5});
    }
    const double any = draw(random, Span{-kPi, kPi});
    const double told = steps[n - 1].base_in_map.yaw + heading.offset + slow.value().x() +
                        heading.white_sigma * random.normal();
    read.push_back({time, wrap_angle(time < wrong_until ? any : told), square(heading.declared)});
  }
  return read;
}

}  // namespace multipath_localization
