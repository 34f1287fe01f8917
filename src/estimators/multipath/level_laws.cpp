#include "estimators/multipath/level_laws.hpp"

namespace multipath_localization::multipath {

namespace {

constexpr double kFollows = 0.5;  // of receivers, whose declared sigma follows the level

}  // namespace

FixLaw LevelLaws::change(FixLevel from, FixLevel to, const FixLaw& held, RandomStream& random) {
  laws_.at(static_cast<std::size_t>(from)) = held;
  std::optional<FixLaw>& law = laws_.at(static_cast<std::size_t>(to));
  if (!law) law = random.uniform() < kFollows ? held : draw_fix_law(random);
  return *law;
}

}  // namespace multipath_localization::multipath
