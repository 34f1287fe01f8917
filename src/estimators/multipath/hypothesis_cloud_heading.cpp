#include <algorithm>
#include <cmath>

#include "estimators/multipath/heading_explanations.hpp"
#include "estimators/multipath/hypothesis_cloud.hpp"

namespace multipath_localization::multipath {

namespace {

constexpr std::uint64_t kHeadingSeed = 0x9FB21C651E98DF25U;  // draws that other inputs do not take
constexpr double kEvidenceTime = 5.0;                        // headings are off alike for about that [s]
/// Of headings that are of another frame or sign: so many that the heading counts as known, AlignmentMonitor,
/// only when some metres of fixes have agreed.
constexpr double kDoubted = 0.03;
constexpr double kFoundSigma = 0.01;  // of an offset that was found beside a yaw that is known [rad]

}  // namespace

void HypothesisCloud::weigh(const HeadingSighting& sighting) {
  aids_.heading = true;
  ++aid_step_;
  const double share = std::min(1.0, sighting.duration / kEvidenceTime);
  std::vector<std::optional<double>> log_density(hypotheses_.size());
  for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
    RandomStream random(seed_ ^ kHeadingSeed, aid_step_, static_cast<std::uint32_t>(i));
    Hypothesis& h = hypotheses_[i];
    if (!h.heading.drawn) {
      h.heading.drawn = true;
      draw_heading_errors(h.heading, aids_.heading_offset, random);
      h.heading.believed = draw_belief(h, kDoubted, random);
    }
    wander(h.heading, sighting.duration, random);
    if (h.heading.believed) log_density[i] = share * explain_heading(h, sighting, random);
  }
  weigh_believing(hypotheses_, log_density, mixture_.covariance(2, 2) < kAgreedVariance,
                  [](const Hypothesis& h) { return h.heading.outlier; });
  refresh();
  resample();
}

/// Each hypothesis takes headings to be off against its own yaw, which the fixes have told it: so the
/// headings of that moment teach it nothing, and later ones what has become of it.
void HypothesisCloud::mount_heading(double offset) {
  aids_.heading_offset = offset;
  ++aid_step_;
  for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
    RandomStream random(seed_ ^ kHeadingSeed, aid_step_, static_cast<std::uint32_t>(i));
    Hypothesis& h = hypotheses_[i];
    draw_heading_errors(h.heading, offset, random);
    h.heading.offset =
        offset + angle_difference(mixture_.mean(kYaw), h.mean(kYaw)) + kFoundSigma * random.normal();
    h.heading.drawn = h.heading.believed = true;
    h.heading.outlier = false;
  }
  refresh();
}

}  // namespace multipath_localization::multipath
