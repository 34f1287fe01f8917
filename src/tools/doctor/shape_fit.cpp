#include "tools/doctor/shape_fit.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>

#include "evaluation/metrics.hpp"

namespace multipath_localization {

namespace {

constexpr double kPiece = 20.0;          // of way by odometry, or from end to end by fixes [m]
constexpr std::size_t kFewestFixes = 8;  // of a piece
constexpr std::size_t kFewestPieces = 4;
constexpr double kAlike = 0.2;           // error of a piece that has the same shape
constexpr double kClearly = 2.0;         // times, by which a piece fits better one way round
constexpr double kSteadyScale = 0.06;    // spread of scales that are one
constexpr double kScaleTolerance = 0.1;  // of one that is none

using Complex = std::complex<double>;

/// A fix and where odometry has its antenna.
struct Pair {
  Complex in_map;
  Complex in_odom;
};

struct PieceFit {
  double error;
  double mirrored_error;
  double rigid_error;
  double scale;
};

/// With both middles at zero, z = a w fits best with a = sum z w' / sum |w|^2, w' the conjugate of w, or w
/// itself where it is turned over.
std::optional<PieceFit> fit(const std::vector<Pair>& pairs) {
  const auto count = static_cast<double>(pairs.size());
  Complex z_middle, w_middle;
  for (const Pair& pair : pairs) {
    z_middle += pair.in_map / count;
    w_middle += pair.in_odom / count;
  }
  double z_squares = 0.0, w_squares = 0.0;
  Complex proper, mirrored;
  for (const Pair& pair : pairs) {
    const Complex z = pair.in_map - z_middle;
    const Complex w = pair.in_odom - w_middle;
    z_squares += std::norm(z);
    w_squares += std::norm(w);
    proper += z * std::conj(w);
    mirrored += z * w;
  }
  if (!(z_squares > 0.0) || !(w_squares > 0.0)) return std::nullopt;
  const auto left = [&](double squares) { return std::sqrt(std::max(0.0, squares / z_squares)); };
  return PieceFit{left(z_squares - std::norm(proper) / w_squares),
                  left(z_squares - std::norm(mirrored) / w_squares),
                  left(z_squares + w_squares - 2.0 * std::abs(proper)), std::abs(proper) / w_squares};
}

std::vector<PieceFit> fits_of_pieces(const std::vector<GnssFix>& fixes, const OdometryTrack& track) {
  std::vector<PieceFit> all;
  std::vector<Pair> piece;
  double start = 0.0;
  for (const GnssFix& fix : fixes) {
    const std::optional<Pose2> base = track.pose(fix.stamp);
    const std::optional<double> driven = track.distance(fix.stamp);
    if (!base || !driven) continue;
    if (piece.empty()) start = *driven;
    const Eigen::Vector2d antenna = *base * fix.antenna_in_base;
    piece.push_back({{fix.position.x(), fix.position.y()}, {antenna.x(), antenna.y()}});
    const bool far = std::abs(piece.back().in_map - piece.front().in_map) >= kPiece;
    if (*driven - start < kPiece && !(far && piece.size() >= kFewestFixes)) continue;
    const std::optional<PieceFit> found = fit(piece);
    if (piece.size() >= kFewestFixes && found) all.push_back(*found);
    piece.clear();
  }
  return all;
}

double quantile_of(const std::vector<PieceFit>& pieces, double PieceFit::*figure, double share) {
  std::vector<double> values;
  for (const PieceFit& piece : pieces) values.push_back(piece.*figure);
  return quantile(values, share);
}

}  // namespace

bool ShapeFit::has_enough() const { return pieces >= kFewestPieces; }

bool ShapeFit::same_shape() const { return has_enough() && error < kAlike; }

bool ShapeFit::mirrored_shape() const { return has_enough() && mirrored_error < kAlike; }

bool ShapeFit::tells_scale() const { return same_shape() && scale_spread <= kSteadyScale * scale; }

bool ShapeFit::fits() const { return same_shape() && std::abs(scale - 1.0) <= kScaleTolerance; }

ShapeFit fit_shape(const std::vector<GnssFix>& fixes, const OdometryTrack& track) {
  const std::vector<PieceFit> pieces = fits_of_pieces(fixes, track);
  ShapeFit result;
  result.pieces = pieces.size();
  if (pieces.empty()) return result;
  result.error = quantile_of(pieces, &PieceFit::error, 0.5);
  result.mirrored_error = quantile_of(pieces, &PieceFit::mirrored_error, 0.5);
  result.rigid_error = quantile_of(pieces, &PieceFit::rigid_error, 0.5);
  result.scale = quantile_of(pieces, &PieceFit::scale, 0.5);
  result.scale_spread =
      0.5 * (quantile_of(pieces, &PieceFit::scale, 0.75) - quantile_of(pieces, &PieceFit::scale, 0.25));
  for (const PieceFit& piece : pieces) {
    if (piece.error * kClearly < piece.mirrored_error) ++result.alike;
    if (piece.mirrored_error * kClearly < piece.error) ++result.opposite;
  }
  return result;
}

}  // namespace multipath_localization
