#include "ros/localization_node/localization_markers.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace multipath_localization {

namespace {

using visualization_msgs::Marker;

constexpr int kCircleCorners = 72;

std_msgs::ColorRGBA colour(float r, float g, float b, float a = 1.0F) {
  std_msgs::ColorRGBA c;
  c.r = r;
  c.g = g;
  c.b = b;
  c.a = a;
  return c;
}

std_msgs::ColorRGBA colour_of(Mode mode) {
  switch (mode) {
    case Mode::kOpen: return colour(0.2F, 0.8F, 0.3F, 0.8F);
    case Mode::kShadow: return colour(1.0F, 0.55F, 0.1F, 0.8F);
  }
  return colour(1.0F, 1.0F, 1.0F);
}

geometry_msgs::Point point(const Eigen::Vector2d& position, double height = 0.0) {
  geometry_msgs::Point p;
  p.x = position.x();
  p.y = position.y();
  p.z = height;
  return p;
}

Marker marker(const LocalizationPicture& picture, const std::string& name, int type, double width) {
  Marker m;
  m.header = picture.header;
  m.ns = name;
  m.type = type;
  m.pose.orientation.w = 1.0;
  m.scale.x = m.scale.y = m.scale.z = width;
  return m;
}

/// The closed curve centre + shape * (cos, sin).
Marker curve(Marker m, const Eigen::Vector2d& centre, const Eigen::Matrix2d& shape) {
  for (int i = 0; i <= kCircleCorners; ++i) {
    const double angle = 2.0 * kPi * i / kCircleCorners;
    m.points.push_back(point(centre + shape * Eigen::Vector2d(std::cos(angle), std::sin(angle)), 0.05));
  }
  return m;
}

Marker particles(const LocalizationPicture& picture, std::size_t max_particles) {
  Marker m = marker(picture, "particles", Marker::POINTS, 0.15);
  const std::vector<Hypothesis>& all = picture.hypotheses;
  const std::size_t count = std::min(max_particles, all.size());
  for (std::size_t i = 0; i < count; ++i) {
    const Hypothesis& hypothesis = all[i * all.size() / count];
    m.points.push_back(point(hypothesis.pose.position(), 0.02));
    m.colors.push_back(colour_of(hypothesis.mode));
  }
  return m;
}

Marker covariance(const LocalizationPicture& picture) {
  Marker m = marker(picture, "covariance", Marker::LINE_STRIP, 0.08);
  m.color = colour(0.1F, 0.5F, 1.0F);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(picture.estimate.position_covariance_overall);
  const Eigen::Vector2d sigmas = axes.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  return curve(std::move(m), picture.estimate.pose.position(),
               axes.eigenvectors() * (2.0 * sigmas).asDiagonal());
}

Marker bias(const LocalizationPicture& picture) {
  Marker m = marker(picture, "bias", Marker::ARROW, 0.15);
  m.scale.y = m.scale.z = 0.4;
  m.color = colour(0.9F, 0.1F, 0.2F);
  m.points = {point(picture.fix->position - picture.estimate.bias, 0.1), point(picture.fix->position, 0.1)};
  return m;
}

Marker ring(const LocalizationPicture& picture) {
  Marker m = marker(picture, "ring", Marker::LINE_STRIP, 0.05);
  m.color = colour(0.9F, 0.1F, 0.2F, 0.6F);
  return curve(std::move(m), picture.fix->position,
               picture.estimate.bias.norm() * Eigen::Matrix2d::Identity());
}

Marker state(const LocalizationPicture& picture) {
  Marker m = marker(picture, "state", Marker::TEXT_VIEW_FACING, 1.2);
  m.color = colour(1.0F, 1.0F, 1.0F);
  m.pose.position = point(picture.estimate.pose.position() + Eigen::Vector2d(0.0, 2.0), 1.0);
  m.text = picture.state;
  return m;
}

}  // namespace

visualization_msgs::MarkerArray to_markers(const LocalizationPicture& picture, std::size_t max_particles) {
  visualization_msgs::MarkerArray array;
  array.markers = {particles(picture, max_particles), covariance(picture), state(picture)};
  if (!picture.fix) return array;
  array.markers.push_back(ring(picture));
  array.markers.push_back(bias(picture));
  return array;
}

}  // namespace multipath_localization
