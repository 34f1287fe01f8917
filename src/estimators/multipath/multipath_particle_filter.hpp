#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "estimators/multipath/odometry_jump.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/estimators/estimator.hpp"
#include "multipath_localization/models/motion/preintegrated_odometry.hpp"

namespace multipath_localization {

struct MultipathParticleFilterParameters {
  int particles = 800;
  double largest_bias = 40.0;
  double time_between_shadows = 60.0;
  double turn_scale_sigma = 0.04;
  OdometryNoise odometry = {0.005, 0.002, 0.03, 0.004, 1.5e-4, 2e-5};
  OdometryJumpParameters odometry_jump = {2.5, 8.0, 0.5};
  double stamp_sigma = 0.05;
  double sigma_factor = 1.5;
  double uncorrected_sigma = 1.5;
  double position_sigma_floor = 0.01;

  void fields(ParameterVisitor& field);
  /// Those of them that may change at any time.
  void tunable(ParameterVisitor& field);
};

/// The default: a Rao-Blackwellised particle filter after [NIS] in which every hypothesis carries its own law
/// of errors.
///
/// Each has a Kalman filter over the pose, four constant errors of the odometry, a slow error of the fixes
/// and the bias of a shadow. What it samples is how large these errors are, relative to what the receiver
/// declares for each fix, whether the robot is in a shadow, and whether its wheels fail; how well it
/// foretells the fixes weighs it. Hypotheses start with headings all round the circle. What is published is
/// the mean of all of them and their covariance, between them and within.
/// doc/concepts/multipath_particle_filter.md has the mathematics; equation numbers in
/// src/estimators/multipath/ are those of that page.
class MultipathParticleFilter : public Estimator {
 public:
  MultipathParticleFilter(const MultipathParticleFilterParameters& parameters, std::uint64_t seed);
  ~MultipathParticleFilter() override;

  void start(const std::optional<PosePrior>& prior) override;
  void predict(const OdometryIncrement& u) override;
  [[nodiscard]] bool uses(std::size_t kind) const override {
    return kind == kFixKind || kind == kVelocityKind || kind == kHeadingKind;
  }
  Innovation update(const Measurement& z) override;
  void tune(ParameterVisitor& field) override;
  [[nodiscard]] PoseEstimate estimate() const override;
  [[nodiscard]] std::vector<Hypothesis> hypotheses() const override;

 private:
  struct State;

  MultipathParticleFilterParameters parameters_;
  std::uint64_t seed_;
  std::unique_ptr<State> state_;
};

}  // namespace multipath_localization
