#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <vector>

#include "multipath_localization/core/parameters.hpp"
#include "simulation/building.hpp"
#include "simulation/polygon.hpp"

namespace multipath_localization {

constexpr double kL1Wavelength = 0.19;  ///< [m]

/// How signals spread among buildings.
struct SkyParameters {
  double reflection_loss_db = 6.0;
  double reflection_loss_spread_db = 3.0;
  double panel_size = 3.0;
  int reflections = 2;
  double diffraction_limit_deg = 6.0;

  void fields(ParameterVisitor& field);
};

/// A way from a satellite to the antenna.
struct SignalPath {
  enum class Kind { kDirect, kReflected, kDiffracted };

  Kind kind = Kind::kDirect;
  double delay = 0.0;                                  ///< beyond the straight line [m]
  double loss_db = 0.0;                                ///< against the straight line in the open
  Eigen::Vector3d arrival = Eigen::Vector3d::UnitZ();  ///< from the antenna to where it comes from, length 1
};

/// The sky from among buildings, by ray casting: which satellites are seen, and by which ways the signals of
/// all arrive. Map frame; the ground lies at zero, satellites are infinitely far away.
class SkyView {
 public:
  /// Throws ParameterError on a building of fewer than three corners.
  SkyView(const SkyParameters& parameters, const std::vector<BuildingParameters>& buildings,
          std::uint64_t seed);

  /// The ways by which a signal from `direction` (length 1, above the horizon) reaches an antenna (east,
  /// north, up [m]), the strongest first; none inside a building. By straight line unless a wall is in the
  /// way; then over the highest edge in the way, if it is bent by no more than the limit: a knife edge square
  /// to the ray, ITU-R P.526-15. By specular reflection off each wall that shows the satellite's
  /// image; reflected once.
  [[nodiscard]] std::vector<SignalPath> paths(const Eigen::Vector3d& antenna,
                                              const Eigen::Vector3d& direction) const;

 private:
  struct Roof {
    Polygon outline;
    double height;
  };
  struct Face {
    Wall wall;
    double reflection_loss_db;
  };

  [[nodiscard]] bool indoors(const Eigen::Vector3d& antenna) const;
  [[nodiscard]] bool clear(const Eigen::Vector3d& from, const Eigen::Vector3d& direction, double reach) const;
  [[nodiscard]] std::optional<SignalPath> straight_or_bent(const Eigen::Vector3d& antenna,
                                                           const Eigen::Vector3d& direction) const;
  [[nodiscard]] std::optional<SignalPath> reflected(std::initializer_list<const Face*> faces,
                                                    const Eigen::Vector3d& antenna,
                                                    const Eigen::Vector3d& direction) const;

  [[nodiscard]] std::vector<SignalPath> reflections(const Eigen::Vector3d& antenna,
                                                    const Eigen::Vector3d& direction, int times) const;

  SkyParameters parameters_;
  std::vector<Roof> roofs_;
  std::vector<Face> faces_;
};

}  // namespace multipath_localization
