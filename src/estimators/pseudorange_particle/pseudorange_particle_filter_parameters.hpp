#pragma once

#include "estimators/pseudorange_particle/pseudorange_motion.hpp"
#include "multipath_localization/core/estimate.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/models/pseudorange/los_subset.hpp"
#include "multipath_localization/models/pseudorange/one_sided_position.hpp"

namespace multipath_localization {

/// What a particle is weighed by, as `likelihood` says.
enum class SubsetLikelihood { kDensity, kDistance };

/// What an epoch is worth, as `tempering` says.
enum class Tempering { kTime, kNone };

/// Decisions about Eqs. (11), (12) of [SUZ].
struct SubsetLikelihoodParameters {
  SubsetLikelihood likelihood = SubsetLikelihood::kDensity;
  double likelihood_sigma = 1.0;
  double outlier_sigma = 100.0;
  Tempering tempering = Tempering::kTime;
  double evidence_rate = 0.2;
  double standing_evidence = 0.1;

  void fields(ParameterVisitor& field);
};

/// By which solution the filter starts, as `start` says.
enum class StartPosition { kRobust, kPlain };

/// Whether a filter that is lost starts again, as `reset` says.
enum class Reset { kRobust, kNever };

/// What satellites are weighed by, as `weighting` says.
enum class SatelliteWeighting { kSignal, kDeclared };

/// How the clocks of constellations hang together, as `constellations` says.
enum class ConstellationClocks { kTied, kSeparate };

struct PseudorangeParticleFilterParameters {
  int particles = 500;
  double ess_fraction = 0.5;
  StartPosition start = StartPosition::kRobust;
  double start_sigma = 8.0;
  Reset reset = Reset::kRobust;
  double restart_rate = 0.05;
  double reset_after = 3.0;
  PointEstimate point_estimate = PointEstimate::kCluster;
  double position_sigma_floor = 0.1;
  SatelliteWeighting weighting = SatelliteWeighting::kSignal;
  ConstellationClocks constellations = ConstellationClocks::kTied;
  double inter_system_sigma = 15.0;
  LosSubsetParameters subset;
  SubsetLikelihoodParameters likelihood;
  PseudorangeMotionParameters motion;
  OneSidedPositionParameters robust;

  void fields(ParameterVisitor& field);
};

}  // namespace multipath_localization
