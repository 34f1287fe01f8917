#include "ros/localization_node/odometry_log.hpp"

namespace multipath_localization {

void OdometryLog::give_up_older_than(double age) {
  const double oldest = stamp().toSec() - age;
  while (!unanswered_.empty() && unanswered_.front().message.header.stamp.toSec() < oldest) {
    unanswered_.pop_front();
  }
}

}  // namespace multipath_localization
