#include "multipath_localization/localization/receiver_record.hpp"

namespace multipath_localization {

void ReceiverRecord::tell_frozen(const GnssFix& fix, double driven, double frozen_distance, Reason& reason) {
  frozen.reset();
  if (reason != Reason::kFrozen) {
    if (!told_ || told_->position != fix.position) told_ = {fix.position, fix.stamp, driven};
    return;
  }
  const double since = told_ ? driven - told_->driven : 0.0;
  if (since <= frozen_distance) {
    reason = Reason::kRepeated;
  } else {
    frozen = {fix.stamp - told_->stamp, since};
  }
}

}  // namespace multipath_localization
