#pragma once

#include <Eigen/Core>
#include <deque>
#include <optional>

#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

/// Where the covariance of a fix comes from, as `source` says.
enum class CovarianceSource { kMessage, kFixed, kAdaptive };

struct ReceiverCovarianceParameters {
  CovarianceSource source = CovarianceSource::kMessage;
  double scale = 1.0;
  double fixed_sigma = 3.0;
  double window = 10.0;

  void fields(ParameterVisitor& field);
};

/// What a receiver claims of its fixes, beside what they do: the covariance that estimators are told.
///
/// Observed is how far fixes lie from where the pose has the antenna, by the median over the last metres, so
/// that lone outliers do not count. `adaptive` declares that much where the receiver claims less, in the
/// shape the receiver claims: a fix is never believed for more than it says of itself. A robot that stands
/// shows nothing, because its fixes are all off by the same.
class ReceiverCovariance {
 public:
  explicit ReceiverCovariance(const ReceiverCovarianceParameters& parameters) : parameters_(parameters) {}

  void set(const ReceiverCovarianceParameters& parameters) { parameters_ = parameters; }
  void clear() { deviations_.clear(); }

  /// A fix lay `deviation` [m] from the antenna of a pose that is settled, after the robot has driven a way
  /// of `driven` [m] in all.
  void observe(double driven, const Eigen::Vector2d& deviation);

  /// Standard deviation of an axis by the deviations [m], nothing before there are a handful.
  [[nodiscard]] std::optional<double> observed_sigma() const;

  /// The covariance to go by where a receiver declares that one (2x2) [m^2].
  [[nodiscard]] Eigen::Matrix2d of(const Eigen::Matrix2d& declared) const;

 private:
  struct Deviation {
    double driven;   ///< [m]
    double squared;  ///< [m^2]
  };

  ReceiverCovarianceParameters parameters_;
  std::deque<Deviation> deviations_;
};

}  // namespace multipath_localization
