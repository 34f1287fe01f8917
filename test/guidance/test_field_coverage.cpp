#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "fields.hpp"
#include "guidance/field_coverage.hpp"
#include "guidance/polygon_inset.hpp"
#include "multipath_localization/guidance/path.hpp"
#include "path_of_way.hpp"

namespace multipath_localization {
namespace {

constexpr double kTightest = 0.88;  // arcs of the default base [m]

std::vector<Eigen::Vector2d> places_along(const Path& path, double step) {
  std::vector<Eigen::Vector2d> places;
  for (double s = 0.0; s < path.length(); s += step) places.push_back(path.at(s).position);
  return places;
}

/// Of the places within, how many lie at most half a width from the way, on a grid.
double share_covered(const Ring& within, const std::vector<Eigen::Vector2d>& way, double width) {
  constexpr double kGrid = 0.2;  // [m]
  constexpr int kCells = 60;     // a side, of one width each
  std::vector<std::vector<Eigen::Vector2d>> cells(kCells * kCells);
  const auto cell_of = [&](double v) { return static_cast<int>(v / width) + 2; };
  for (const Eigen::Vector2d& p : way) {
    cells.at(static_cast<std::size_t>(cell_of(p.x()) * kCells + cell_of(p.y()))).push_back(p);
  }
  const auto covered = [&](const Eigen::Vector2d& p) {
    for (int i = 0; i < 9; ++i) {
      const int cell = (cell_of(p.x()) + i / 3 - 1) * kCells + cell_of(p.y()) + i % 3 - 1;
      for (const Eigen::Vector2d& q : cells.at(static_cast<std::size_t>(cell))) {
        if ((p - q).norm() <= 0.5 * width + 0.01) return true;
      }
    }
    return false;
  };
  int all = 0;
  int done = 0;
  for (double x = 0.05; x < 45.0; x += kGrid) {
    for (double y = 0.05; y < 35.0; y += kGrid) {
      if (!within.contains({x, y}, 0.0)) continue;
      ++all;
      if (covered({x, y})) ++done;
    }
  }
  return static_cast<double>(done) / all;
}

TEST(FieldCoverage, CoversTheFieldAndComesNowhereTooNearToItsBorder) {
  for (const NamedField& field : fields()) {
    for (const double width : {1.0, 2.0}) {
      SCOPED_TRACE(field.name + ", width " + std::to_string(width));
      const Path path = path_of(coverage_of({field.border, width}, kTightest, {0.0, 0.0}));
      const std::vector<Eigen::Vector2d> way = places_along(path, 0.1);
      const Ring within = inset(Ring(field.border), 0.5 * width).front();
      for (const Eigen::Vector2d& place : way)
        EXPECT_TRUE(within.contains(place, 0.021)) << place.transpose();
      EXPECT_GE(share_covered(within, way, width), width > 1.0 ? 0.98 : 0.99);
    }
  }
}

TEST(FieldCoverage, IsDrivenWithoutATurnTighterThanTheBases) {
  for (const NamedField& field : fields()) {
    SCOPED_TRACE(field.name);
    const Path path = path_of(coverage_of({field.border, 1.0}, kTightest, {0.0, 0.0}));
    const std::vector<PathPiece>& pieces = path.pieces();
    for (std::size_t i = 1; i < pieces.size(); ++i) {
      EXPECT_LE(std::abs(pieces[i].curvature), 1.0 / kTightest + 1e-9);
      EXPECT_NEAR(pieces[i].heading, pieces[i - 1].at(pieces[i - 1].length).heading, 1e-6) << i;
    }
  }
}

TEST(FieldCoverage, BeginsAtTheCornerNearestToTheStart) {
  const std::vector<WayPoint> way = coverage_of({fields()[0].border, 1.0}, kTightest, {50.0, 30.0});
  EXPECT_LT((way.front().position - Eigen::Vector2d(39.5, 24.5)).norm(), 1e-6);
}

TEST(FieldCoverage, HasItsTracksAlongTheHeadingTold) {
  const Field across{fields()[0].border, 1.0, 0.5 * kPi};
  const Path path = path_of(coverage_of(across, kTightest, {0.0, 0.0}));
  double north = 0.0;
  for (const PathPiece& piece : path.pieces()) {
    if (piece.curvature == 0.0 && std::abs(std::cos(piece.heading)) < 1e-6) north += piece.length;
  }
  EXPECT_GT(north, 500.0);  // of about 1100 m
}

std::string refusal(const std::vector<Eigen::Vector2d>& border, double width, double radius) {
  try {
    coverage_of({border, width}, radius, {0.0, 0.0});
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(FieldCoverage, SaysWhyAFieldCannotBeDriven) {
  EXPECT_EQ(refusal({{0.0, 0.0}, {9.0, 9.0}, {9.0, 0.0}, {0.0, 9.0}}, 1.0, 0.5),
            "the border of the field has edges that cross or touch");
  EXPECT_EQ(refusal({{0.0, 0.0}, {9.0, 0.0}, {9.0, 0.8}, {0.0, 0.8}}, 1.0, 0.5),
            "the field is narrower than the width");
  EXPECT_EQ(refusal({{0.0, 0.0}, {40.0, 0.0}, {40.0, 4.0}, {0.0, 4.0}}, 1.0, 3.0),
            "the base cannot turn at the corner of the field near 39.5, 3.5");
  EXPECT_EQ(refusal({{0.0, 0.0}, {4000.0, 0.0}, {4000.0, 4000.0}, {0.0, 4000.0}}, 1.0, 1.0),
            "the field takes more than 1000 tracks");
}

}  // namespace
}  // namespace multipath_localization
