#include "rinex/fix_chain.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace multipath_localization {

namespace {

constexpr double kScatter = 100.0;      // between two fixes among reflections [m]
constexpr double kFaster = 10.0;        // than at either end, in between [m/s]
constexpr double kUnknownSpeed = 50.0;  // [m/s]
constexpr double kLongestWay = 60.0;    // [s]
constexpr int kMostRedundancy = 4;      // that counts
constexpr std::size_t kFarthestBack = 600;

bool reachable(const ChainLink& from, const ChainLink& to) {
  const double duration = to.stamp - from.stamp;
  if (duration > kLongestWay) return true;
  const double slower = std::fmin(from.speed, to.speed);  // of one that is known, that one
  const double speed = std::isfinite(slower) ? slower + kFaster : kUnknownSpeed;
  return (to.position - from.position).norm() <= kScatter + speed * duration;
}

/// Of the links before number i from which that one can be reached the heaviest; i itself where there is
/// none.
std::size_t heaviest_before(const std::vector<ChainLink>& links, const std::vector<int>& weight,
                            std::size_t i) {
  std::size_t best = i;
  int most = 0;
  for (std::size_t j = i; j-- > 0 && i - j <= kFarthestBack;) {
    if (weight[j] <= most || !reachable(links[j], links[i])) continue;
    most = weight[j];
    best = j;
  }
  return best;
}

}  // namespace

std::vector<bool> on_its_way(const std::vector<ChainLink>& links) {
  std::vector<bool> on_it(links.size(), false);
  std::vector<int> weight(links.size());          // of the best chain that ends there
  std::vector<std::size_t> before(links.size());  // on it; itself: none
  std::size_t last = 0;
  for (std::size_t i = 0; i < links.size(); ++i) {
    before[i] = heaviest_before(links, weight, i);
    weight[i] = weight[before[i]] + 1 + std::clamp(links[i].redundancy, 0, kMostRedundancy);
    if (weight[i] > weight[last]) last = i;
  }
  for (std::size_t i = last; i < links.size(); i = before[i]) {
    on_it[i] = true;
    if (before[i] == i) break;
  }
  return on_it;
}

}  // namespace multipath_localization
