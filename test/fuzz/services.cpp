#include <multipath_localization/SetPose.h>
#include <ros/console.h>

#include "byte_stream.hpp"
#include "multipath_localization/estimators/make_estimator.hpp"
#include "multipath_localization/localization/localizer.hpp"
#include "oracle.hpp"
#include "ros/localization_node/map_requests.hpp"
#include "ros/map/datum.hpp"
#include "ros/messages/conversions.hpp"
#include "targets.hpp"

namespace multipath_localization::fuzz {

namespace {

constexpr double kNear = 100e3;  ///< of map's origin: there and back again, nothing moves [m]

/// Requests as a localisation gets them, one after the other, each behind a byte that tells its type.
class Services {
 public:
  explicit Services(const std::string& bytes)
      : in_(bytes), localizer_(make_estimator("gated_ekf", YAML::Node(), 1), LocalizerParameters{}) {
    localizer_.start(std::nullopt);
  }

  void run() {
    while (!in_.empty()) {
      switch (in_.take<std::uint8_t>() % 4) {
        case 0: set_datum(); break;
        case 1: to_place(); break;
        case 2: from_place(); break;
        default: set_pose(); break;
      }
    }
  }

 private:
  void set_datum() {
    Geodetic place;
    if (!answer(in_.take<SetDatum::Request>(), place).empty()) return;
    datum_.set(place);
    require(datum_.map()->origin().allFinite(), "map's origin is not finite");
    require_finite(datum_.map()->datum().altitude, "the datum's altitude");
  }

  void to_place() {
    const auto request = in_.take<ToLL::Request>();
    ToLL::Response response;
    if (!answer(request, datum_.map(), response).empty()) return;
    const GeoPoint& place = response.ll_point;
    require_finite(place.altitude, "an altitude");
    require(valid({place.latitude, place.longitude, 0.0}), "a point of map is no place");
    const Eigen::Vector3d point(request.map_point.x, request.map_point.y, request.map_point.z);
    if (point.norm() > kNear || std::abs(datum_.map()->datum().altitude) > kNear) return;
    FromLL::Request back;
    FromLL::Response there;
    back.ll_point = place;
    if (!answer(back, datum_.map(), there).empty()) return;
    const Eigen::Vector3d again(there.map_point.x, there.map_point.y, there.map_point.z);
    require((again - point).norm() < 1e-3, "a point has moved on its way to the Earth and back");
  }

  void from_place() {
    FromLL::Response response;
    if (!answer(in_.take<FromLL::Request>(), datum_.map(), response).empty()) return;
    require_finite(response.map_point.x, "x of a place");
    require_finite(response.map_point.y, "y of a place");
    require_finite(response.map_point.z, "z of a place");
  }

  void set_pose() {
    const auto prior = to_prior(in_.take<SetPose::Request>().pose);
    if (!prior) return;
    localizer_.start(prior);
    localizer_.add(OdometryIncrement{prior->stamp + 0.1, 0.1, 1.0, 0.1});
    const PoseEstimate estimate = localizer_.estimate();
    if (!estimate.valid) return;
    require_finite(estimate.pose, "the pose");
    require(estimate.covariance.allFinite(), "the covariance is not finite");
    require_covariance<3>(estimate.covariance, "the covariance");
  }

  ByteStream in_;
  Datum datum_{std::nullopt, DatumSearch({}, 50.0, 0.0)};
  Localizer localizer_;
};

}  // namespace

void services(const std::string& bytes) {
  static const bool silent =
      ros::console::set_logger_level(ROSCONSOLE_DEFAULT_NAME, ros::console::levels::Fatal);
  static_cast<void>(silent);
  unless_cut(Services(bytes));
}

}  // namespace multipath_localization::fuzz
