#pragma once

#include <functional>

namespace multipath_localization {

/// ros::spin for a node that must not end in silence. Asked to by SIGINT, SIGTERM or `rosnode kill`, it lets
/// `say_last` publish, some times over, while topics are open still. Wants ros::init with NoSigintHandler.
void spin_until_shutdown(const std::function<void()>& say_last);

}  // namespace multipath_localization
