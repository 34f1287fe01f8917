#include "guidance/ring.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/plane.hpp"

namespace multipath_localization {

namespace {

/// The share of the way from `a` to `b` at which it is nearest to `place`.
double share_at(const Eigen::Vector2d& place, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d way = b - a;
  return way.isZero() ? 0.0 : std::clamp((place - a).dot(way) / way.squaredNorm(), 0.0, 1.0);
}

}  // namespace

Ring::Ring(std::vector<Eigen::Vector2d> corners) : corners_(std::move(corners)), stations_({0.0}) {
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    area_ += 0.5 * cross(corners_[i] - corners_.front(), next(i) - corners_.front());
  }
  if (area_ < 0.0) std::reverse(corners_.begin(), corners_.end());
  area_ = std::abs(area_);
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    stations_.push_back(stations_.back() + (next(i) - corners_[i]).norm());
  }
}

double Ring::longest_edge() const {
  Eigen::Vector2d longest = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    if ((next(i) - corners_[i]).norm() > longest.norm()) longest = next(i) - corners_[i];
  }
  return std::atan2(longest.y(), longest.x());
}

double Ring::within_round(double station) const {
  const double rest = std::fmod(station, length());
  return rest < 0.0 ? rest + length() : rest;
}

Eigen::Vector2d Ring::at(double station) const {
  const double s = within_round(station);
  const auto after = std::upper_bound(stations_.begin(), stations_.end() - 1, s);
  const auto i = static_cast<std::size_t>(after - stations_.begin()) - 1;
  const double edge = stations_[i + 1] - stations_[i];
  return corners_[i] + (edge > 0.0 ? (s - stations_[i]) / edge : 0.0) * (next(i) - corners_[i]);
}

double Ring::nearest(const Eigen::Vector2d& place) const {
  double best = 0.0;
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const double share = share_at(place, corners_[i], next(i));
    const double away = (corners_[i] + share * (next(i) - corners_[i]) - place).norm();
    if (away >= distance) continue;
    distance = away;
    best = stations_[i] + share * (stations_[i + 1] - stations_[i]);
  }
  return best;
}

std::size_t Ring::nearest_corner(const Eigen::Vector2d& place) const {
  const auto nearer = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return (a - place).squaredNorm() < (b - place).squaredNorm();
  };
  return static_cast<std::size_t>(std::min_element(corners_.begin(), corners_.end(), nearer) -
                                  corners_.begin());
}

std::vector<Eigen::Vector2d> Ring::way(double from, double to) const {
  std::vector<Eigen::Vector2d> places = counter_clockwise(std::min(from, to), std::max(from, to));
  if (to < from) std::reverse(places.begin(), places.end());
  return places;
}

std::vector<Eigen::Vector2d> Ring::counter_clockwise(double from, double to) const {
  std::vector<Eigen::Vector2d> places = {at(from)};
  const double first_round = std::floor(from / length()) * length();
  for (double round = first_round; round < to; round += length()) {
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const double s = round + stations_[i];
      if (s > from && s < to) places.push_back(corners_[i]);
    }
  }
  places.push_back(at(to));
  return places;
}

bool Ring::contains(const Eigen::Vector2d& place, double slack) const {
  if ((at(nearest(place)) - place).norm() <= slack) return true;
  const auto sections_there = sections(place.y());
  return std::any_of(sections_there.begin(), sections_there.end(), [&](const auto& section) {
    return section.first <= place.x() && place.x() <= section.second;
  });
}

std::vector<std::pair<double, double>> Ring::sections(double y) const {
  std::vector<double> crossings;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Eigen::Vector2d& a = corners_[i];
    const Eigen::Vector2d& b = next(i);
    if ((a.y() > y) == (b.y() > y)) continue;
    crossings.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
  }
  std::sort(crossings.begin(), crossings.end());
  std::vector<std::pair<double, double>> sections;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
    sections.emplace_back(crossings[i], crossings[i + 1]);
  return sections;
}

}  // namespace multipath_localization
