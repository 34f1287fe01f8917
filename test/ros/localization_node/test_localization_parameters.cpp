#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "multipath_localization/estimators/make_estimator.hpp"
#include "ros/localization_node/localization_parameters.hpp"

namespace multipath_localization {
namespace {

std::string refusal_of(const std::string& yaml) {
  try {
    LocalizationSettings::from(YAML::Load(yaml));
  } catch (const ParameterError& error) {
    return error.what();
  }
  return "";
}

TEST(LocalizationParameters, AreWhatTheFileSays) {
  std::ifstream file(CONFIG_DIR "/localization.yaml");
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_EQ(text.str(), describe(LocalizationParameters{}));
}

TEST(LocalizationParameters, TheFileLoads) {
  EXPECT_NO_THROW(LocalizationSettings::from(read_yaml(CONFIG_DIR "/localization.yaml")));
}

TEST(LocalizationParameters, DefaultToTheFirstEstimator) {
  EXPECT_EQ(LocalizationParameters{}.estimator, estimator_names().front());
}

TEST(LocalizationSettings, HandTheGroupOfTheChosenEstimatorOn) {
  const auto settings =
      LocalizationSettings::from(YAML::Load("{seed: 7, multipath_particle_filter: {particles: 50}}"));
  EXPECT_EQ(settings.parameters.seed, 7);
  EXPECT_EQ(settings.estimator_parameters["particles"].as<int>(), 50);
}

TEST(LocalizationSettings, TakeFramesWithALeadingSlash) {
  const FrameParameters frames =
      LocalizationSettings::from(YAML::Load("{map_frame: /map, odom_frame: /a/odom}")).parameters.frames;
  EXPECT_EQ(frames.map_frame, "map");
  EXPECT_EQ(frames.odom_frame, "a/odom");
}

TEST(LocalizationSettings, RefuseByName) {
  EXPECT_NE(refusal_of("{datun: [1, 2]}").find("datun"), std::string::npos);
  EXPECT_NE(refusal_of("{fix: {default_sigma: -1}}").find("fix/default_sigma"), std::string::npos);
  EXPECT_NE(refusal_of("{estimator: kalman}").find("kalman"), std::string::npos);
  const std::string group = refusal_of("{multipath_particle_filter: {particels: 50}}");
  EXPECT_NE(group.find("multipath_particle_filter"), std::string::npos);
  EXPECT_NE(group.find("particels"), std::string::npos);
}

TEST(LocalizationSettings, RefuseADatumThatIsNone) {
  EXPECT_EQ(refusal_of("{datum: [52.5, 13.4]}"), "");
  EXPECT_EQ(refusal_of("{datum: [52.5, 13.4, 0, 40]}"), "");
  EXPECT_NE(refusal_of("{datum: [52.5, 13.4, 1.57]}").find("turned"), std::string::npos);
  EXPECT_EQ(refusal_of("{datum_file: /tmp/datum.yaml}"), "");
  EXPECT_NE(refusal_of("{pose_file: pose.yaml}").find("pose_file pose.yaml is not an absolute path"),
            std::string::npos);
  EXPECT_NE(refusal_of("{datum_file: ~/datum.yaml}").find("not an absolute path"), std::string::npos);
  EXPECT_NE(refusal_of("{datum_file: /tmp/datum.yaml, datum: [52.5, 13.4]}").find("datum_file"),
            std::string::npos);
}

TEST(LocalizationSettings, RefuseAnAntennaThatIsNowhere) {
  EXPECT_EQ(refusal_of("{antenna: [0.4, -0.2]}"), "");
  EXPECT_NE(refusal_of("{antenna: [0.4]}").find("antenna"), std::string::npos);
}

TEST(LocalizationSettings, AskTheEstimatorForTheKindsItUses) {
  const UsedKinds used = LocalizationSettings::from(YAML::Load("{estimator: gated_ekf}")).used_kinds();
  EXPECT_TRUE(used[kFixKind]);
  EXPECT_FALSE(used[kDualKind]);
  EXPECT_FALSE(used[kEpochKind]);
}

TEST(LocalizationSettings, EveryEstimatorUsesSomething) {
  for (const std::string& name : estimator_names()) {
    const UsedKinds used = LocalizationSettings::from(YAML::Load("{estimator: " + name + "}")).used_kinds();
    EXPECT_TRUE(used[kFixKind] || used[kDualKind] || used[kEpochKind]) << name;
  }
}

}  // namespace
}  // namespace multipath_localization
