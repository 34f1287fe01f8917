#include <gtest/gtest.h>

#include "../../models/sky.hpp"
#include "estimators/pseudorange_particle/pseudorange_cloud.hpp"
#include "estimators/pseudorange_particle/pseudorange_particle_filter_parameters.hpp"
#include "multipath_localization/models/pseudorange/signal_weights.hpp"

namespace multipath_localization {
namespace {

const Eigen::Vector3d kAntenna(40.0, -25.0, 12.0);
const Eigen::Vector2d kNoLever = Eigen::Vector2d::Zero();

/// A fix of that place, 1 m in each direction.
PseudorangeSolution fix_at(const Eigen::Vector3d& place) {
  PseudorangeSolution fix;
  fix.position = place;
  fix.covariance = Eigen::Matrix3d::Identity();
  return fix;
}

PreparedEpoch epoch() {
  PreparedEpoch result;
  result.observations = observed(open_sky(), kAntenna, 5e4, 5e4);
  result.weights = declared_weights(result.observations);
  result.antenna_in_base = kNoLever;
  return result;
}

class Cloud : public testing::Test {
 protected:
  bool weigh(double exponent) {
    InterSystemBias bias(15.0);
    LosSubset subset(epoch_.observations, epoch_.weights, bias, parameters_.subset);
    const bool weighed = cloud_.weigh(epoch_, subset, exponent, {});
    cloud_.take_stock();
    return weighed;
  }

  PreparedEpoch epoch_ = epoch();
  PseudorangeParticleFilterParameters parameters_;
  PseudorangeCloud cloud_{parameters_, 1};
};

TEST_F(Cloud, StartsRoundAFixWithHeadingsAllRound) {
  EXPECT_TRUE(cloud_.empty());
  cloud_.start_near(fix_at(kAntenna), kNoLever);
  cloud_.take_stock();
  EXPECT_LT((cloud_.mean_antenna(kNoLever) - kAntenna).norm(), 5.0);
  EXPECT_FALSE(cloud_.estimate().aligned);
  cloud_.clear();
  EXPECT_TRUE(cloud_.empty());
}

TEST_F(Cloud, WeighingBringsTheMeanToWhereThePseudorangesWereMeasured) {
  cloud_.start_near(fix_at(kAntenna + Eigen::Vector3d(6.0, 0.0, 0.0)), kNoLever);
  cloud_.take_stock();
  const double before = (cloud_.mean_antenna(kNoLever) - kAntenna).norm();
  EXPECT_TRUE(weigh(1.0));
  EXPECT_LT((cloud_.mean_antenna(kNoLever) - kAntenna).norm(), 0.5 * before);
  EXPECT_LT(cloud_.estimate().effective_sample_size, 0.5 * parameters_.particles);
}

TEST_F(Cloud, AnEpochThatIsWorthNothingChangesNoWeight) {
  cloud_.start_near(fix_at(kAntenna), kNoLever);
  EXPECT_TRUE(weigh(0.0));
  EXPECT_NEAR(cloud_.estimate().effective_sample_size, parameters_.particles, 1e-6);
}

TEST_F(Cloud, NoParticleHasASubsetOfFourSatellites) {
  epoch_.observations.resize(4);
  epoch_.weights.resize(4);
  cloud_.start_near(fix_at(kAntenna), kNoLever);
  EXPECT_FALSE(weigh(1.0));
  EXPECT_NEAR(cloud_.estimate().effective_sample_size, parameters_.particles, 1e-6);
}

TEST_F(Cloud, ResamplesOnlyWhereWeightsAreUneven) {
  cloud_.start_near(fix_at(kAntenna), kNoLever);
  cloud_.take_stock();
  const Eigen::Vector3d even = cloud_.mean_antenna(kNoLever);
  cloud_.resample_if_uneven();
  cloud_.take_stock();
  EXPECT_EQ(cloud_.mean_antenna(kNoLever), even);
  weigh(1.0);
  cloud_.resample_if_uneven();
  cloud_.take_stock();
  EXPECT_NEAR(cloud_.estimate().effective_sample_size, parameters_.particles, 1e-6);
}

TEST_F(Cloud, AllOrSomeGoToAnotherFix) {
  const Eigen::Vector3d elsewhere = kAntenna + Eigen::Vector3d(500.0, 0.0, 0.0);
  cloud_.start_near(fix_at(kAntenna), kNoLever);
  cloud_.restart_some(fix_at(elsewhere), kNoLever, 0.2);
  cloud_.take_stock();
  EXPECT_LT((cloud_.mean_antenna(kNoLever) - kAntenna).norm(), 5.0) << "most stay";
  cloud_.restart_all(fix_at(elsewhere), kNoLever);
  cloud_.take_stock();
  EXPECT_LT((cloud_.mean_antenna(kNoLever) - elsewhere).norm(), 5.0);
}

TEST_F(Cloud, AStartFromAPriorIsAlignedAndLearnsItsHeights) {
  PosePrior prior;
  prior.pose = {40.0, -25.0, 0.5};
  prior.covariance = Eigen::Vector3d(1.0, 1.0, 0.01).asDiagonal();
  cloud_.start_at(prior);
  EXPECT_TRUE(cloud_.estimate().aligned);
  cloud_.draw_heights(fix_at(kAntenna));
  EXPECT_NEAR(cloud_.mean_antenna(kNoLever).z(), 12.0, 2.0);
}

}  // namespace
}  // namespace multipath_localization
