#include "simulation/sky_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/core/random.hpp"
#include "simulation/streams.hpp"

namespace multipath_localization {

namespace {

constexpr double kTouching = 1e-6;  // what is this near to where a ray starts is not in its way [m]
constexpr double kLeastReflectionLossDb = 3.0;
constexpr int kMostReflections = 2;
constexpr double kEndless = std::numeric_limits<double>::infinity();

/// How far along a ray it crosses the vertical strip below and above a wall [m].
std::optional<double> crossing(const Wall& wall, const Eigen::Vector3d& from,
                               const Eigen::Vector3d& direction) {
  const Eigen::Vector2d heading = direction.head<2>();
  const double closing = heading.dot(wall.outward);
  if (closing == 0.0) return std::nullopt;
  const double distance = (wall.start - from.head<2>()).dot(wall.outward) / closing;
  const double along = (from.head<2>() + distance * heading - wall.start).dot(wall.along);
  if (!(distance > kTouching) || along < 0.0 || along > wall.length) return std::nullopt;
  return distance;
}

/// Loss over a knife edge for the Fresnel-Kirchhoff parameter nu > -0.78, ITU-R P.526-15 [dB].
double knife_edge_loss_db(double nu) { return 6.9 + 20.0 * std::log10(std::hypot(nu - 0.1, 1.0) + nu - 0.1); }

/// Loss by a panel that is smaller than the Fresnel zone of a distance from the antenna [m, dB].
double spreading_loss_db(double distance, double panel_size) {
  return 20.0 * std::log10(std::max(distance * kL1Wavelength / (panel_size * panel_size), 1.0));
}

}  // namespace

void SkyParameters::fields(ParameterVisitor& field) {
  field("reflection_loss_db", reflection_loss_db, {kLeastReflectionLossDb, 60.0}, "dB",
        "of C/N0 off a wall, in the mean");
  field("reflection_loss_spread_db", reflection_loss_spread_db, {0.0, 60.0}, "dB",
        "its spread from wall to wall, by seed; below 3 dB counts as 3 dB");
  field("panel_size", panel_size, {0.1, 1e3}, "m",
        "walls are flat over this only: from further than its square over the wavelength they lose more");
  field("reflections", reflections, {0, kMostReflections}, "1",
        "off how many walls one after the other; twice only what arrives in no other way");
  field("diffraction_limit_deg", diffraction_limit_deg, {0.0, 90.0}, "deg",
        "a signal is bent over the edge of a roof by no more than this");
}

SkyView::SkyView(const SkyParameters& parameters, const std::vector<BuildingParameters>& buildings,
                 std::uint64_t seed)
    : parameters_(parameters) {
  for (const BuildingParameters& building : buildings) {
    roofs_.push_back({Polygon(building.corners, "building " + building.name), building.height});
    for (const Wall& wall : walls(building)) {
      RandomStream random(seed, 0, kWallStream + static_cast<std::uint32_t>(faces_.size()));
      const double loss =
          parameters_.reflection_loss_db + parameters_.reflection_loss_spread_db * random.normal();
      faces_.push_back({wall, std::max(loss, kLeastReflectionLossDb)});
    }
  }
}

bool SkyView::indoors(const Eigen::Vector3d& antenna) const {
  return std::any_of(roofs_.begin(), roofs_.end(), [&](const Roof& roof) {
    return antenna.z() < roof.height && roof.outline.contains(antenna.head<2>());
  });
}

bool SkyView::clear(const Eigen::Vector3d& from, const Eigen::Vector3d& direction, double reach) const {
  return std::none_of(faces_.begin(), faces_.end(), [&](const Face& face) {
    const std::optional<double> distance = crossing(face.wall, from, direction);
    return distance && *distance < reach - kTouching &&
           from.z() + *distance * direction.z() < face.wall.height;
  });
}

std::optional<SignalPath> SkyView::straight_or_bent(const Eigen::Vector3d& antenna,
                                                    const Eigen::Vector3d& direction) const {
  const double horizontal = direction.head<2>().norm();
  const double elevation = std::atan2(direction.z(), horizontal);
  double highest = elevation;
  double to_edge = 0.0;
  for (const Face& face : faces_) {
    const std::optional<double> distance = crossing(face.wall, antenna, direction);
    if (!distance) continue;
    const double rise = face.wall.height - antenna.z();
    const double edge = std::atan2(rise, *distance * horizontal);
    if (edge <= highest) continue;
    highest = edge;
    to_edge = std::hypot(rise, *distance * horizontal);
  }
  const double bend = highest - elevation;
  if (bend == 0.0) return SignalPath{SignalPath::Kind::kDirect, 0.0, 0.0, direction};
  if (bend > parameters_.diffraction_limit_deg * kPi / 180.0) return std::nullopt;
  SignalPath path{SignalPath::Kind::kDiffracted, to_edge * (1.0 - std::cos(bend)),
                  knife_edge_loss_db(bend * std::sqrt(2.0 * to_edge / kL1Wavelength)), direction};
  path.arrival.head<2>() *= std::cos(highest) / horizontal;
  path.arrival.z() = std::sin(highest);
  return path;
}

std::optional<SignalPath> SkyView::reflected(std::initializer_list<const Face*> faces,
                                             const Eigen::Vector3d& antenna,
                                             const Eigen::Vector3d& direction) const {
  std::array<Eigen::Vector3d, kMostReflections> legs;
  Eigen::Vector3d leg = direction;
  for (std::size_t i = faces.size(); i-- > 0;) {
    const Eigen::Vector2d& outward = faces.begin()[i]->wall.outward;
    const double facing = leg.head<2>().dot(outward);
    if (facing <= 0.0) return std::nullopt;
    leg.head<2>() -= 2.0 * facing * outward;
    legs[i] = leg;
  }

  SignalPath path{SignalPath::Kind::kReflected, 0.0, 0.0, leg};
  Eigen::Vector3d from = antenna;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Face& face = *faces.begin()[i];
    const std::optional<double> distance = crossing(face.wall, from, legs[i]);
    if (!distance || from.z() + *distance * legs[i].z() >= face.wall.height) return std::nullopt;
    if (!clear(from, legs[i], *distance)) return std::nullopt;
    from += *distance * legs[i];
    path.delay += *distance;
    path.loss_db += face.reflection_loss_db + spreading_loss_db(path.delay, parameters_.panel_size);
  }
  if (!clear(from, direction, kEndless)) return std::nullopt;
  path.delay -= (from - antenna).dot(direction);
  return path;
}

std::vector<SignalPath> SkyView::reflections(const Eigen::Vector3d& antenna, const Eigen::Vector3d& direction,
                                             int times) const {
  std::vector<SignalPath> all;
  const auto add = [&](std::initializer_list<const Face*> faces) {
    if (const auto path = reflected(faces, antenna, direction)) all.push_back(*path);
  };
  for (const Face& near : faces_) {
    if (times == 1) add({&near});
    if (times != 2) continue;
    for (const Face& far : faces_) add({&near, &far});
  }
  return all;
}

std::vector<SignalPath> SkyView::paths(const Eigen::Vector3d& antenna,
                                       const Eigen::Vector3d& direction) const {
  if (indoors(antenna)) return {};
  std::vector<SignalPath> all;
  if (parameters_.reflections > 0) all = reflections(antenna, direction, 1);
  if (const auto path = straight_or_bent(antenna, direction)) all.insert(all.begin(), *path);
  if (all.empty() && parameters_.reflections > 1) all = reflections(antenna, direction, 2);
  std::stable_sort(all.begin(), all.end(),
                   [](const SignalPath& a, const SignalPath& b) { return a.loss_db < b.loss_db; });
  return all;
}

}  // namespace multipath_localization
