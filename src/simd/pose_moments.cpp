#include "simd/pose_moments.hpp"

#include <cmath>

#include "simd/elementary.hpp"

namespace multipath_localization {

namespace {

void mark(PoseBlock poses, PoseNeighbourhood within, float* member) {
#pragma omp simd
  for (std::size_t i = 0; i < poses.size; ++i) {
    member[i] = static_cast<float>(membership(within, poses.x[i], poses.y[i], poses.yaw[i]));
  }
}

float count(const float* member, std::size_t size) {
  float members = 0.0F;
#pragma omp simd reduction(+ : members)
  for (std::size_t i = 0; i < size; ++i) members += member[i];
  return members;
}

/// Zero for others.
void weights_of_members(const double* weight, const float* member, double* of_members, std::size_t size) {
#pragma omp simd
  for (std::size_t i = 0; i < size; ++i) of_members[i] = weight[i] * static_cast<double>(member[i]);
}

struct PositionSums {
  double w, x, y, xx, xy, yy;
};

PositionSums position_sums(PoseBlock poses, const double* weight, Pose2 reference) {
  double sw = 0.0;
  double sx = 0.0;
  double sy = 0.0;
  double sxx = 0.0;
  double sxy = 0.0;
  double syy = 0.0;
#pragma omp simd reduction(+ : sw, sx, sy, sxx, sxy, syy)
  for (std::size_t i = 0; i < poses.size; ++i) {
    const double x = poses.x[i] - reference.x;
    const double y = poses.y[i] - reference.y;
    const double wx = weight[i] * x;
    const double wy = weight[i] * y;
    sw += weight[i];
    sx += wx;
    sy += wy;
    sxx += wx * x;
    sxy += wx * y;
    syy += wy * y;
  }
  return {sw, sx, sy, sxx, sxy, syy};
}

/// With s and c the sine and cosine of d / 2: those of d are 2 s c and 1 - 2 s s.
struct HeadingSums {
  double d, sc, ss, xd, yd, dd;
};

HeadingSums heading_sums(PoseBlock poses, const double* weight, Pose2 reference) {
  double sd = 0.0;
  double ssc = 0.0;
  double sss = 0.0;
  double sxd = 0.0;
  double syd = 0.0;
  double sdd = 0.0;
#pragma omp simd reduction(+ : sd, ssc, sss, sxd, syd, sdd)
  for (std::size_t i = 0; i < poses.size; ++i) {
    const double d = elementary::wrap(poses.yaw[i] - reference.yaw);
    const auto [s, c] = elementary::sincos_quarter(0.5 * d);
    const double wd = weight[i] * d;
    const double ws = weight[i] * s;
    sd += wd;
    ssc += ws * c;
    sss += ws * s;
    sxd += wd * (poses.x[i] - reference.x);
    syd += wd * (poses.y[i] - reference.y);
    sdd += wd * d;
  }
  return {sd, ssc, sss, sxd, syd, sdd};
}

}  // namespace

void mark_members(InstructionSet set, const PoseBlock& poses, const PoseNeighbourhood& within,
                  float* member) {
  run<mark>(set, poses, within, member);
}

void PoseSums::add(double scale, const PoseSums& other) {
  all.w += scale * other.all.w;
  all.x += scale * other.all.x;
  all.y += scale * other.all.y;
  all.xx += scale * other.all.xx;
  all.xy += scale * other.all.xy;
  all.yy += scale * other.all.yy;
  members.w += scale * other.members.w;
  members.x += scale * other.members.x;
  members.y += scale * other.members.y;
  members.xx += scale * other.members.xx;
  members.xy += scale * other.members.xy;
  members.yy += scale * other.members.yy;
  members.d += scale * other.members.d;
  members.c += scale * other.members.c;
  members.s += scale * other.members.s;
  members.xd += scale * other.members.xd;
  members.yd += scale * other.members.yd;
  members.dd += scale * other.members.dd;
}

PoseSums pose_sums(InstructionSet set, const PoseBlock& poses, const double* weight, const float* member,
                   const Pose2& reference) {
  const PositionSums all = run<position_sums>(set, poses, weight, reference);
  PositionSums p = all;
  BlockValues members_alone;
  if (run<count>(set, member, poses.size) < static_cast<float>(poses.size)) {
    run<weights_of_members>(set, weight, member, members_alone.data(), poses.size);
    weight = members_alone.data();
    p = run<position_sums>(set, poses, weight, reference);
  }
  const HeadingSums h = run<heading_sums>(set, poses, weight, reference);
  return {{all.w, all.x, all.y, all.xx, all.xy, all.yy},
          {p.w, p.x, p.y, p.xx, p.xy, p.yy, h.d, p.w - 2.0 * h.ss, 2.0 * h.sc, h.xd, h.yd, h.dd}};
}

PoseMoments member_moments(const PoseSums& sums, const Pose2& reference) {
  const PoseSums::Members& m = sums.members;
  const double x = m.x / m.w;
  const double y = m.y / m.w;
  const double d = m.d / m.w;
  const double turn = std::atan2(m.s, m.c);
  PoseMoments result;
  result.mean = {reference.x + x, reference.y + y, wrap_angle(reference.yaw + turn)};
  Eigen::Matrix3d& P = result.covariance;
  P(0, 0) = m.xx / m.w - x * x;
  P(0, 1) = P(1, 0) = m.xy / m.w - x * y;
  P(1, 1) = m.yy / m.w - y * y;
  P(0, 2) = P(2, 0) = m.xd / m.w - x * d;
  P(1, 2) = P(2, 1) = m.yd / m.w - y * d;
  P(2, 2) = m.dd / m.w - d * d + (d - turn) * (d - turn);
  P.diagonal() = P.diagonal().cwiseMax(0.0);
  return result;
}

Eigen::Matrix2d position_spread(const PoseSums& sums, const Pose2& reference, const Eigen::Vector2d& centre) {
  const PoseSums::All& a = sums.all;
  const Eigen::Vector2d c = centre - reference.position();
  const Eigen::Vector2d mean(a.x / a.w, a.y / a.w);
  Eigen::Matrix2d square;
  square << a.xx / a.w, a.xy / a.w, a.xy / a.w, a.yy / a.w;
  return square - mean * mean.transpose() + (mean - c) * (mean - c).transpose();
}

}  // namespace multipath_localization
