#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

/// A building: a flat roof over an outline.
struct BuildingParameters {
  std::string name = "building";
  std::vector<double> corners;  ///< [x0, y0, x1, y1, ...] in map [m]
  double height = 20.0;

  void fields(ParameterVisitor& field);
};

/// A vertical face of a building, from the ground to the roof. Everything in map, east and north.
struct Wall {
  Eigen::Vector2d start = Eigen::Vector2d::Zero();
  Eigen::Vector2d along = Eigen::Vector2d::UnitX();    ///< of length 1, from its start to its end
  Eigen::Vector2d outward = Eigen::Vector2d::UnitY();  ///< of length 1, away from the building
  double length = 0.0;                                 ///< [m]
  double height = 0.0;                                 ///< above the ground [m]
};

/// The faces of a building. Throws ParameterError when it has fewer than three corners.
std::vector<Wall> walls(const BuildingParameters& building);

}  // namespace multipath_localization
