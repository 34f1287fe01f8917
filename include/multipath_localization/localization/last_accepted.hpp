#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>

#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization {

/// When a measurement of each kind was last accepted, by its stamp.
class LastAccepted {
 public:
  /// A measurement was; one that tells no position counts for nothing.
  void note(const Measurement& measurement);

  /// The latest of all, -infinity before the first [s].
  [[nodiscard]] double stamp() const;
  /// Which kind that was: "fixes", "pairs of fixes", "pseudoranges".
  [[nodiscard]] std::string kind() const;
  /// ", no pseudoranges for 12 s": what says more than that, was accepted before and has been missed for over
  /// `longest` [s] at `now` [s]; empty for nothing.
  [[nodiscard]] std::string missed(double now, double longest) const;

 private:
  [[nodiscard]] std::size_t latest() const;

  std::array<std::optional<double>, std::variant_size_v<Measurement>> stamps_;
};

}  // namespace multipath_localization
