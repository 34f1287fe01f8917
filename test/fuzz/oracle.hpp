#pragma once

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "../evaluation/temporary_folder.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/core/pose.hpp"

namespace multipath_localization::fuzz {

/// Something does not hold that has to, whatever the input. libFuzzer takes it, uncaught, for a crash.
class Broken : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

inline void require(bool holds, const std::string& what) {
  if (!holds) throw Broken(what);
}

inline void require_finite(double value, const std::string& what) {
  require(std::isfinite(value), what + " is not finite");
}

inline void require_finite(const Pose2& pose, const std::string& what) {
  require_finite(pose.x + pose.y + pose.yaw, what);
}

/// Symmetric positive semi-definite up to rounding: no combination of two of its axes has a negative
/// variance.
template <int N>
void require_covariance(const Eigen::Matrix<double, N, N>& covariance, const std::string& what) {
  require(covariance.allFinite(), what + " is not finite");
  const double rounding = 1e-5 * covariance.diagonal().cwiseAbs().maxCoeff();
  require(covariance.isApprox(covariance.transpose()), what + " is not symmetric");
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j < N; ++j) {
      const double twice = 2.0 * std::abs(covariance(i, j));
      require(covariance(i, i) + covariance(j, j) - (i == j ? 0.0 : twice) >= -rounding,
              what + " is negative");
    }
  }
}

/// What `read` gives; nothing where it refuses by its documented error, with a reason. Any other error
/// passes.
template <class Refusal, class Read>
auto unless_refused(const Read& read) -> std::optional<decltype(read())> {
  try {
    return read();
  } catch (const Refusal& refusal) {
    require(!std::string(refusal.what()).empty(), "a refusal without a reason");
    return std::nullopt;
  }
}

/// A file of that name that holds these bytes; the one before of the same name is gone.
inline std::string written(const std::string& name, const std::string& bytes) {
  static const TemporaryFolder folder;
  return folder.write(name, bytes);
}

/// Described and loaded again, parameters are the same.
template <class Parameters>
void require_described(const Parameters& parameters, const std::string& what) {
  const std::string text = describe(parameters);
  Parameters again;
  load(YAML::Load(text), again);
  require(describe(again) == text, what + " are others once described and loaded again");
}

}  // namespace multipath_localization::fuzz
