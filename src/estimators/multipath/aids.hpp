#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "estimators/multipath/hypothesis.hpp"

namespace multipath_localization::multipath {

/// Inputs beside the fixes that a hypothesis believes or doubts: which of them there have been, and what all
/// know of them.
struct Aids {
  bool velocity = false;
  bool heading = false;
  double heading_offset = 0.0;  ///< about which the mounting is guessed [rad]

  [[nodiscard]] bool any() const { return velocity || heading; }
  /// Whether a hypothesis takes one of them to say nothing.
  [[nodiscard]] bool doubted(const Hypothesis& h) const {
    return (velocity && !h.velocity.believed) || (heading && !h.heading.believed);
  }
};

constexpr std::uint64_t kAidSeed = 0xD1B54A32D192ED03U;  ///< draws that fixes alone do not take
constexpr double kAgreedVariance = 0.1;                  ///< of headings that agree [rad^2]

/// Draws whether a hypothesis believes an input, and gives it the weight that goes with that, where a share
/// `doubted` of such inputs is of another frame or sign. More hypotheses than that hold that it is, so that
/// they know all headings.
bool draw_belief(Hypothesis& hypothesis, double doubted, RandomStream& random);

/// Weighs those that believe an input among themselves by their logarithms of the density, equation (21);
/// `is_outlier` says of one that it takes the last one for an outlier.
void weigh_believing(std::vector<Hypothesis>& hypotheses,
                     const std::vector<std::optional<double>>& log_density, bool heading_known,
                     bool (*is_outlier)(const Hypothesis&));

/// `count` hypotheses drawn by weight, enough of them such as doubt the aids, and all that are wanted while
/// these do not agree on the heading. `settled`: those that believe do.
std::vector<Hypothesis> drawn_by_kind(const std::vector<Hypothesis>& hypotheses, const Aids& aids,
                                      bool settled, std::size_t count, RandomStream& random);

}  // namespace multipath_localization::multipath
