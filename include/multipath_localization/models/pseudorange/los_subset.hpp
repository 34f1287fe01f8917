#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/models/pseudorange/inter_system_bias.hpp"

namespace multipath_localization {

/// What Eq. (5) of [SUZ] takes for the clock, as `clock` says.
enum class SubsetClock { kQuantile, kReference };

/// Decisions about Eqs. (5)-(7) of [SUZ].
struct LosSubsetParameters {
  SubsetClock clock = SubsetClock::kQuantile;
  double clock_quantile = 0.25;
  double lower_threshold = -40.0;
  double upper_threshold = 20.0;
  int least_satellites = 5;

  void fields(ParameterVisitor& field);
};

/// The position that the satellites in line of sight speak for, as seen from a supposed one.
struct SubsetSolution {
  Eigen::Vector3d step = Eigen::Vector3d::Zero();  ///< mu - supposed position, Eq. (10) of [SUZ] [m]
  Eigen::Matrix3d information = Eigen::Matrix3d::Identity();  ///< Sigma^-1 of Eq. (11) of [SUZ] [1/m^2]
  double mahalanobis_squared = 0.0;                           ///< D^2 of Eq. (11) of [SUZ]
  double log_determinant = 0.0;                               ///< of the information
  int satellites = 0;                                         ///< in the subset
};

/// The satellites of one epoch that are in line of sight if the antenna is where it is supposed to be:
/// section 3 of [SUZ]. Made once an epoch, asked once a particle; asking allocates nothing.
///
/// Departs, unless `clock` is "reference": one reference satellite that is itself reflected shifts every
/// residual of Eq. (5); a low quantile of all of them stands as long as some are in line of sight.
class LosSubset {
 public:
  /// One weight > 0 per observation [1/m^2]; the bias says how the clocks of the constellations hang
  /// together. The observations have to outlive this.
  LosSubset(const std::vector<SatelliteObservation>& observations, const std::vector<double>& weights,
            const InterSystemBias& bias, const LosSubsetParameters& parameters);

  /// Selects by the thresholds of Eq. (6) of [SUZ] and solves for the position with one linearised step from
  /// the supposed one, which is enough: a range bends by |step|^2 / 2 range, 0.2 mm at 100 m. Nothing where
  /// the subset is too small or leaves a coordinate undetermined.
  std::optional<SubsetSolution> solve(const Eigen::Vector3d& antenna);

  /// Velocity by the Doppler of the satellites selected last, see `weighted_velocity`.
  [[nodiscard]] std::optional<Eigen::Vector3d> velocity(double tolerance) const;

  /// How far the clock against a constellation was off the common one, selected satellites only.
  struct ClockResidual {
    double mean = 0.0;      ///< [m]
    double variance = 0.0;  ///< [m^2]
  };
  [[nodiscard]] std::optional<ClockResidual> clock_residual(Constellation constellation) const;

  /// Share of the satellites not selected last: out of sight, as supposed.
  [[nodiscard]] double excluded_share() const;

 private:
  /// Weighted sums over the selected satellites of one constellation.
  struct Sums {
    double weight = 0.0;
    double residual = 0.0;
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  };
  struct NormalEquations {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right_hand_side = Eigen::Vector3d::Zero();
  };

  void look_from(const Eigen::Vector3d& antenna);
  void remove_clocks();
  double quantile_of(std::size_t first, std::size_t end);
  NormalEquations select();
  void eliminate_clocks(NormalEquations& equations) const;
  [[nodiscard]] int unknowns() const;

  const std::vector<SatelliteObservation>& observations_;
  LosSubsetParameters parameters_;
  std::vector<double> weights_;
  std::vector<std::size_t> order_;   ///< of the observations: those that share a clock together
  std::vector<std::size_t> bounds_;  ///< of the groups in `order_`
  std::size_t reference_ = 0;        ///< satellite k of Eq. (5)
  std::array<double, kConstellations> offset_{};
  std::array<double, kConstellations> offset_variance_{};

  std::vector<Eigen::Vector3d> directions_;
  std::vector<double> residuals_;
  std::vector<double> sorted_;
  std::vector<double> selected_weights_;  ///< 0 for what is not selected
  std::array<Sums, kConstellations> sums_{};
  int selected_ = 0;
};

}  // namespace multipath_localization
