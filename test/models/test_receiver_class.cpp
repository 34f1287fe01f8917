#include <gtest/gtest.h>

#include "multipath_localization/models/receiver_class.hpp"

namespace multipath_localization {
namespace {

TEST(ReceiverClasses, PriorsAreProbabilities) {
  const ReceiverClasses classes;
  double sum = 0.0;
  for (std::size_t k = 0; k < kReceiverClassCount; ++k) sum += classes[k].prior;
  EXPECT_NEAR(sum, 1.0, 1e-12);
}

TEST(ReceiverClasses, IndexNamesEachOnce) {
  const ReceiverClasses classes;
  EXPECT_EQ(&classes[0], &classes.street);
  EXPECT_EQ(&classes[kCanyon], &classes.canyon);
  EXPECT_EQ(&classes[2], &classes.noisy);
  EXPECT_EQ(&classes[3], &classes.drifting);
}

TEST(ReceiverClasses, OnlyTheCanyonIsAlwaysInShadow) {
  const ReceiverClasses classes;
  for (std::size_t k = 0; k < kReceiverClassCount; ++k) EXPECT_EQ(classes[k].always_shadow, k == kCanyon);
}

TEST(ReceiverClasses, DefaultsLieInTheirRanges) {
  const ReceiverClasses classes;
  ReceiverClasses loaded;
  EXPECT_NO_THROW(load(YAML::Load(describe(classes)), loaded));
  EXPECT_EQ(describe(loaded), describe(classes));
}

TEST(ReceiverClasses, OneClassCanBeChangedAlone) {
  ReceiverClasses classes;
  load(YAML::Load("{canyon: {shadow_bias_sigma: 30}}"), classes);
  EXPECT_EQ(classes.canyon.shadow_bias_sigma, 30.0);
  EXPECT_TRUE(classes.canyon.always_shadow);
  EXPECT_EQ(classes.street.shadow_bias_sigma, ReceiverClass{}.shadow_bias_sigma);
  EXPECT_THROW(load(YAML::Load("{canyon: {sigma: 30}}"), classes), ParameterError);
}

}  // namespace
}  // namespace multipath_localization
