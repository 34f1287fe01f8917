#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/estimators/make_estimator.hpp"

namespace multipath_localization {
namespace {

class EveryEstimator : public ::testing::TestWithParam<std::string> {};

std::string message_of(const std::string& name, const YAML::Node& parameters) {
  try {
    make_estimator(name, parameters, 1);
  } catch (const ParameterError& error) {
    return error.what();
  }
  return "";
}

TEST_P(EveryEstimator, ConfigurationFileIsItsDescription) {
  std::ifstream file(std::string(CONFIG_DIR) + "/" + GetParam() + ".yaml");
  ASSERT_TRUE(file) << "config/" << GetParam() << ".yaml is missing";
  std::ostringstream content;
  content << file.rdbuf();
  EXPECT_EQ(content.str(), describe_estimator(GetParam()));
}

TEST_P(EveryEstimator, LoadsItsOwnDescription) {
  EXPECT_NE(make_estimator(GetParam(), YAML::Load(describe_estimator(GetParam())), 1), nullptr);
  EXPECT_NE(make_estimator(GetParam(), YAML::Node(), 1), nullptr);
}

TEST_P(EveryEstimator, RefusesUnknownKeysByName) {
  EXPECT_NE(message_of(GetParam(), YAML::Load("particels: 10")).find("particels"), std::string::npos);
}

TEST_P(EveryEstimator, APriorOfOneLongAxisAndAnyHeadingStaysACovariance) {
  const auto filter = make_estimator(GetParam(), YAML::Node(), 1);
  for (const double yaw_variance : {0.01, 0.5, 3.0, 1e6}) {
    PosePrior prior;
    prior.stamp = 1.0;
    const double correlated = 0.99 * std::sqrt(100.0 * yaw_variance);
    prior.covariance << 100.0, 0.0, correlated, 0.0, 0.01, 0.0, correlated, 0.0, yaw_variance;
    filter->start(prior);
    for (int i = 1; i <= 3; ++i) filter->predict({1.0 + 0.1 * i, 0.1, 1.0, 0.1});
    const PoseEstimate estimate = filter->estimate();
    if (!estimate.valid) continue;
    EXPECT_EQ(estimate.covariance.llt().info(), Eigen::Success) << yaw_variance;
    EXPECT_TRUE(estimate.covariance.isApprox(estimate.covariance.transpose(), 1e-12)) << yaw_variance;
  }
}

TEST_P(EveryEstimator, RefusesAsUnusedWhatItDoesNotUseAndNothingElse) {
  const std::vector<Measurement> empty = {GnssFix{}, DualAntennaFix{}, PseudorangeEpoch{}, GnssVelocity{}};
  for (const Measurement& z : empty) {
    const auto estimator = make_estimator(GetParam(), YAML::Node(), 1);
    estimator->start(std::nullopt);
    EXPECT_EQ(estimator->update(z).reason == Reason::kUnused, !estimator->uses(z.index())) << z.index();
  }
}

INSTANTIATE_TEST_SUITE_P(ByName, EveryEstimator, ::testing::ValuesIn(estimator_names()),
                         [](const auto& instance) { return instance.param; });

/// How many estimators the files of a folder of the configuration are of, each of which has to make its own.
int variants_made(const std::string& folder) {
  int count = 0;
  for (const auto& file : std::filesystem::directory_iterator(std::string(CONFIG_DIR) + "/" + folder)) {
    const std::string name = file.path().stem().string();
    EXPECT_EQ(message_of(name, YAML::LoadFile(file.path().string())), "") << name;
    ++count;
  }
  return count;
}

TEST(MakeEstimator, MakesThePrintedAndTheWorkingVariants) {
  EXPECT_EQ(variants_made("printed"), 4);
  EXPECT_EQ(variants_made("working"), 1);
}

TEST(MakeEstimator, RefusesUnknownNamesAndTellsTheKnown) {
  const std::string message = message_of("kalmann", YAML::Node());
  EXPECT_NE(message.find("kalmann"), std::string::npos);
  EXPECT_NE(message.find("gated_ekf"), std::string::npos);
}

TEST(MakeEstimator, RefusesValuesOutOfRangeAndOfTheWrongTypeByKey) {
  EXPECT_NE(message_of("nishida_particle_filter", YAML::Load("ring_fraction: 1.5")).find("ring_fraction"),
            std::string::npos);
  EXPECT_NE(
      message_of("nishida_particle_filter", YAML::Load("likelihood_kernel: star")).find("likelihood_kernel"),
      std::string::npos);
  EXPECT_NE(message_of("gated_ekf", YAML::Load("odometry: {distance: far}")).find("odometry/distance"),
            std::string::npos);
}

TEST(MakeEstimator, KnowsThoseOfTheReadme) {
  const std::vector<std::string> first = {"multipath_particle_filter", "nishida_particle_filter",
                                          "conventional_particle_filter", "gated_ekf"};
  ASSERT_GE(estimator_names().size(), first.size());
  EXPECT_TRUE(std::equal(first.begin(), first.end(), estimator_names().begin()));
}

}  // namespace
}  // namespace multipath_localization
