#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "estimators/pseudorange_mixture/pseudorange_mixture_filter.hpp"
#include "started_mixture_filter.hpp"

namespace multipath_localization {
namespace {

/// Drives on until the filter says that it is not aligned; how long that took, at most `patience` [s].
double time_to_doubt(Started& run, double patience) {
  double waited = 0.0;
  for (; waited < patience && run.filter.estimate().aligned; waited += 1.0) run.drive.run(run.filter, 1.0);
  return waited;
}

TEST(PseudorangeMixtureFilter, FindsBackFromAWrongPlaceItWasSureOf) {
  for (const std::uint64_t seed : {40U, 41U, 42U}) {
    Started run(seed, PseudorangeMixtureFilterParameters());
    Pose2 wrong = run.drive.truth;
    wrong.x += 50.0;
    wrong.y -= 33.0;
    run.filter.start(PosePrior{0.0, wrong, Eigen::Vector3d(0.04, 0.04, 4e-4).asDiagonal()});
    ASSERT_TRUE(run.filter.estimate().aligned);
    EXPECT_LT(time_to_doubt(run, 40.0), 30.0);
    run.drive.run(run.filter, 60.0);
    EXPECT_LT(run.drive.error(run.filter), 3.0);
    EXPECT_LT(run.drive.heading_error(run.filter), 0.1);
    EXPECT_TRUE(run.filter.estimate().aligned);
  }
}

TEST(PseudorangeMixtureFilter, FindsBackFromAHeadingItWasWronglySureOf) {
  Started run(43, PseudorangeMixtureFilterParameters());
  Pose2 wrong = run.drive.truth;
  wrong.yaw += kPi;
  run.filter.start(PosePrior{0.0, wrong, Eigen::Vector3d(0.04, 0.04, 4e-4).asDiagonal()});
  EXPECT_LT(time_to_doubt(run, 120.0), 90.0);
  run.drive.run(run.filter, 60.0);
  EXPECT_LT(run.drive.heading_error(run.filter), 0.1);
  EXPECT_LT(run.drive.error(run.filter), 3.0);
}

TEST(PseudorangeMixtureFilter, NoticesThatItWasCarriedAndFindsBack) {
  for (const std::uint64_t seed : {44U, 45U}) {
    Started run(seed, PseudorangeMixtureFilterParameters());
    const double speed = run.drive.speed;
    run.drive.run(run.filter, 60.0);
    ASSERT_TRUE(run.filter.estimate().aligned);
    run.drive.speed = 0.0;
    run.drive.run(run.filter, 5.0);
    run.drive.truth.x += 60.0;
    run.drive.truth.y += 50.0;
    run.drive.truth.yaw = wrap_angle(run.drive.truth.yaw + 2.0);
    EXPECT_LT(time_to_doubt(run, 40.0), 30.0);
    run.drive.speed = speed;
    run.drive.run(run.filter, 60.0);
    EXPECT_LT(run.drive.error(run.filter), 3.0);
    EXPECT_LT(run.drive.heading_error(run.filter), 0.1);
    EXPECT_TRUE(run.filter.estimate().aligned);
  }
}

TEST(PseudorangeMixtureFilter, SatellitesThatComeIntoViewCorrectAWrongPlaceAtRest) {
  for (const std::uint64_t seed : {47U, 48U, 49U}) {
    Started run(seed, PseudorangeMixtureFilterParameters());
    run.drive.run(run.filter, 60.0);
    // A wall hides what stands in the south and delays the rest.
    const std::vector<SatelliteObservation> whole = run.drive.sky;
    run.drive.sky = {whole[0], whole[1], whole[7], whole[8], whole[12]};
    run.drive.delayed = {0, 1, 2, 3, 4};
    run.drive.delay = 25.0;
    run.drive.run(run.filter, 40.0);
    run.drive.speed = 0.0;
    run.drive.sky = whole;
    run.drive.delayed.clear();
    run.drive.run(run.filter, 15.0);
    EXPECT_LT(run.drive.error(run.filter), 4.0);
  }
}

TEST(PseudorangeMixtureFilter, RivalsLeaveARightPlaceAlone) {
  Started run(46, PseudorangeMixtureFilterParameters());
  run.drive.run(run.filter, 60.0);
  run.drive.delayed = {0, 1, 2, 8};
  run.drive.run(run.filter, 120.0, [&] {
    EXPECT_TRUE(run.filter.estimate().aligned);
    EXPECT_LT(run.drive.error(run.filter), 3.0);
    EXPECT_LT(std::sqrt(run.filter.estimate().position_covariance_overall.trace()), 6.0);
  });
}

}  // namespace
}  // namespace multipath_localization
