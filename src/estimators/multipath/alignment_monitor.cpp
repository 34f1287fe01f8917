#include "estimators/multipath/alignment_monitor.hpp"

#include <algorithm>

#include "support/numbers.hpp"

namespace multipath_localization::multipath {

namespace {

constexpr double kKnownYaw = 0.2;  // sigma of a heading that can be steered by [rad]
constexpr double kLostYaw = 0.5;  // sigma of one that cannot: twice, so that the state does not flicker [rad]
constexpr double kConfirmingWay =
    10.0;  // a metre of error of a fix is a known heading's sigma over half of it [m]

constexpr double kWayIfTold =
    1.0;  // a heading that velocities or headings tell wants no more than that they go on doing so [m]

}  // namespace

AlignmentMonitor::AlignmentMonitor(bool confirmed)
    : way_(confirmed ? kConfirmingWay : 0.0), wanted_(kConfirmingWay), aligned_(confirmed) {}

void AlignmentMonitor::update(double way, double yaw_variance, bool told) {
  way_ += way;
  wanted_ = told ? kWayIfTold : kConfirmingWay;
  aligned_ = (aligned_ || way_ >= wanted_) && yaw_variance < square(aligned_ ? kLostYaw : kKnownYaw);
}

double AlignmentMonitor::way_left() const { return std::max(0.0, wanted_ - way_); }

}  // namespace multipath_localization::multipath
