#pragma once

#include <random>
#include <vector>

#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization {

/// What a good engineer writes first: an array of structs, the generator, distribution and functions of the
/// standard library, one loop for each step of the method of [NIS]. What the product's filter is measured
/// against.
class NaiveFilter {
 public:
  explicit NaiveFilter(std::size_t size);

  /// Motion, ring, likelihood of both parts with the heading's term, moments, effective sample size,
  /// resampling.
  void step(const OdometryIncrement& u, const GnssFix& fix);

  /// Mean of the estimate, so that nothing is optimised away.
  [[nodiscard]] double x() const { return mean_x_; }

 private:
  struct Particle {
    double x;
    double y;
    double yaw;
    double weight;
  };

  void move(const OdometryIncrement& u);
  void sample_ring();
  void weigh(const GnssFix& fix);
  void average();
  void resample();
  double normal() { return normal_(generator_); }

  std::mt19937 generator_{42};
  std::normal_distribution<double> normal_;
  std::uniform_real_distribution<double> uniform_;
  std::vector<Particle> particles_;
  double mean_x_ = 0.0;
  double mean_y_ = 0.0;
  double mean_yaw_ = 0.0;
  double variance_x_ = 0.0;
  double covariance_xy_ = 0.0;
  double variance_y_ = 0.0;
  double effective_sample_size_ = 0.0;
};

}  // namespace multipath_localization
