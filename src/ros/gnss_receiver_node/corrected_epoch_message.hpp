#pragma once

#include "multipath_localization/GnssEpoch.h"
#include "rinex/point_positioning.hpp"

namespace multipath_localization {

/// An epoch as a message, the same that becomes of it once rinex_to_drive has written it and gnss_epoch_node
/// plays it.
GnssEpoch to_message(const CorrectedEpoch& epoch, const std_msgs::Header& header);

}  // namespace multipath_localization
