#include "guidance/route_continuation.hpp"

#include <algorithm>

namespace multipath_localization {

namespace {

using Route = std::vector<Eigen::Vector2d>;

bool same_waypoint(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return (a - b).norm() <= kSameWaypoint;
}

/// Whether the first `count` waypoints of `after` are those of `before` up to its index `end`, exclusive.
bool repeats(const Route& before, std::size_t end, const Route& after, std::size_t count) {
  if (count > after.size() || count > end) return false;
  const auto begin = before.begin() + static_cast<std::ptrdiff_t>(end - count);
  return std::equal(begin, begin + static_cast<std::ptrdiff_t>(count), after.begin(), same_waypoint);
}

}  // namespace

bool same_route(const Route& a, const Route& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_waypoint);
}

std::optional<std::size_t> target_in_continuation(const Route& before, std::size_t passed,
                                                  const Route& after) {
  if (before.empty()) return std::nullopt;
  if (passed >= before.size()) {
    const bool longer = after.size() > before.size() && repeats(before, before.size(), after, before.size());
    return longer ? std::optional(before.size()) : std::nullopt;
  }
  // Where waypoints recur there are several such places: it is the one with as many left to drive, if any is.
  const std::size_t left = before.size() - passed;
  if (after.size() >= left && repeats(before, passed + 1, after, after.size() - left + 1)) {
    return after.size() - left;
  }
  for (std::size_t kept = passed + 1; kept > 0; --kept) {
    if (repeats(before, passed + 1, after, kept)) return kept - 1;
  }
  return std::nullopt;
}

}  // namespace multipath_localization
