#include "tools/doctor/checks.hpp"

namespace multipath_localization {

Findings diagnose(const Observations& seen) {
  Findings all;
  for (const auto check : {check_topics,
                           check_rates,
                           check_stamps,
                           check_clocks,
                           check_simulated_time,
                           check_frames,
                           check_parents,
                           check_map_to_odom,
                           check_antenna,
                           check_status,
                           check_places,
                           check_leaps,
                           check_declared_covariance,
                           check_scatter,
                           check_frozen,
                           check_datum,
                           check_twist,
                           check_way,
                           check_gyro,
                           check_velocity,
                           check_heading}) {
    const Findings found = check(seen);
    all.insert(all.end(), found.begin(), found.end());
  }
  return all;
}

}  // namespace multipath_localization
