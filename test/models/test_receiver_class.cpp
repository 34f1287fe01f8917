#include <gtest/gtest.h>

#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/models/receiver_class.hpp"

namespace multipath_localization {
namespace {

TEST(ReceiverClasses, PriorsSumToOne) {
  const ReceiverClasses classes;
  double sum = 0.0;
  for (std::size_t k = 0; k < kReceiverClassCount; ++k) sum += classes[k].prior;
  EXPECT_NEAR(sum, 1.0, 1e-12);
}

TEST(ReceiverClasses, EachIndexIsAClassOfItsOwn) {
  const ReceiverClasses classes;
  for (const ReceiverClass* named : {&classes.street, &classes.canyon, &classes.noisy, &classes.drifting}) {
    int found = 0;
    for (std::size_t k = 0; k < kReceiverClassCount; ++k) found += named == &classes[k] ? 1 : 0;
    EXPECT_EQ(found, 1);
  }
  EXPECT_EQ(&classes[kCanyon], &classes.canyon);
}

TEST(ReceiverClasses, OnlyTheCanyonNeverSeesTheOpenSky) {
  const ReceiverClasses classes;
  for (std::size_t k = 0; k < kReceiverClassCount; ++k) {
    EXPECT_EQ(classes[k].always_shadow, k == kCanyon);
    EXPECT_EQ(classes[k].shadow_at_start == 1.0, k == kCanyon);
  }
}

TEST(ReceiverClasses, ShadowsAreLargerThanTheOpenSkysBias) {
  const ReceiverClasses classes;
  for (std::size_t k = 0; k < kReceiverClassCount; ++k) {
    EXPECT_GT(classes[k].shadow_bias_sigma, 5.0 * classes[k].open_bias_sigma);
    EXPECT_GT(classes[k].noisy_sigma, classes[k].quiet_sigma);
  }
}

TEST(ReceiverClasses, DescriptionLoadsBackAndKeysReachTheirClass) {
  ReceiverClasses classes;
  const std::string description = describe(classes);
  load(YAML::Load(description), classes);
  EXPECT_EQ(describe(classes), description);
  load(YAML::Load("canyon: {shadow_bias_sigma: 12.5}\ndrifting: {prior: 0.25}"), classes);
  EXPECT_EQ(classes[kCanyon].shadow_bias_sigma, 12.5);
  EXPECT_EQ(classes.drifting.prior, 0.25);
  EXPECT_EQ(classes.street.prior, ReceiverClasses{}.street.prior);
  EXPECT_THROW(load(YAML::Load("street: {quiet_sigma: 0.0}"), classes), ParameterError);
}

}  // namespace
}  // namespace multipath_localization
