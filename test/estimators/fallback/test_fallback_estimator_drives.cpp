#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <vector>

#include "estimators/fallback/fallback_estimator.hpp"
#include "multipath_localization/estimators/make_estimator.hpp"
#include "pseudorange_drive.hpp"
#include "simulated_drive.hpp"

namespace multipath_localization {
namespace {

/// Both streams of one robot, and what the composition of the real filters makes of them.
class RealFallback {
 public:
  explicit RealFallback(std::uint64_t seed)
      : localizer(make_estimator("pseudorange_mixture_filter", YAML::Load("{subsets: 100}"), seed), {}),
        drive(seed) {
    localizer.start(std::nullopt);
    drive.disturb = [this](std::vector<SatelliteObservation>& sky) {
      if (!receiving) sky.clear();
    };
  }

  void run(
      double duration, const std::function<void()>& observe = [] {}) {
    drive.run(localizer, duration, [&] {
      localizer.add(Measurement(fix()));
      observe();
    });
  }

  [[nodiscard]] GnssFix fix() {
    const double east = random_.normal();
    GnssFix fix;
    fix.stamp = drive.time;
    fix.position = drive.truth.position() + Eigen::Vector2d(east, random_.normal());
    return fix;
  }

  Localizer localizer;
  PseudorangeDrive drive;
  bool receiving = true;

 private:
  RandomStream random_{3, 3, 3};
};

TEST(FallbackEstimator, KeepsThePoseThroughAMinuteWithoutEpochs) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    RealFallback robot(seed);
    robot.run(40.0);
    ASSERT_EQ(robot.localizer.state(), Trust::kGood);
    RootMeanSquare error;
    double squares = 0.0;
    int count = 0;
    const auto observe = [&] {
      const PoseEstimate estimate = robot.localizer.estimate();
      error.add(position_error(estimate, robot.drive.truth));
      squares += nees(estimate, robot.drive.truth);
      ++count;
      EXPECT_TRUE(robot.localizer.state() == Trust::kGood || robot.localizer.state() == Trust::kMultipath);
    };
    robot.receiving = false;
    robot.run(60.0, observe);
    EXPECT_NE(robot.localizer.state_reason().find("fixes agree"), std::string::npos);
    EXPECT_NE(robot.localizer.state_reason().find("no pseudoranges for 60 s"), std::string::npos);
    robot.receiving = true;
    robot.run(20.0, observe);
    EXPECT_EQ(robot.localizer.state_reason(), "pseudoranges agree with odometry");
    EXPECT_LT(error.value(), 1.5) << seed;
    EXPECT_LT(squares / count, 4.0) << seed;
  }
}

TEST(FallbackEstimator, IsTheSameToTheByteForTheSameSeed) {
  std::vector<std::vector<double>> results;
  for (int i = 0; i < 2; ++i) {
    RealFallback robot(5);
    robot.run(20.0);
    robot.receiving = false;
    robot.run(10.0);
    robot.receiving = true;
    robot.run(5.0);
    results.push_back(numbers_of(robot.localizer.estimate()));
  }
  EXPECT_EQ(results[0], results[1]);
}

TEST(FallbackEstimator, CanBeSwitchedOff) {
  const auto filter =
      make_estimator("pseudorange_mixture_filter", YAML::Load("{fallback: {enabled: false}}"), 1);
  EXPECT_EQ(filter->update(GnssFix{}).reason, Reason::kUnused);
}

}  // namespace
}  // namespace multipath_localization
