#include <gtest/gtest.h>

#include "evaluation/run_json.hpp"

namespace multipath_localization {
namespace {

TEST(RunJson, ReadsWhatItWrites) {
  RunRecord run;
  run.source = "random";
  run.estimator = "gated_ekf";
  run.seed = 12;
  run.about = "a \"mower\"";
  run.traits = {{"speed_mps", "0.5"}};
  run.score.rmse = 0.25;
  run.calibration.pit[3] = 1.5;
  run.calibration.nis.add(2.5, 4.0);
  run.calibration.wheel_fault.missed = 2;
  const nlohmann::json json = run_to_json(run);
  EXPECT_EQ(run_to_json(run_from_json(json)), json);
  EXPECT_EQ(json.at("about"), "a \"mower\"");
  EXPECT_TRUE(json.at("nees_mean").is_null());
}

TEST(RunJson, RefusesWhatIsNoRun) {
  EXPECT_THROW(run_from_json(nlohmann::json::parse("{\"seed\": 1}")), nlohmann::json::exception);
  EXPECT_THROW(run_from_json(nlohmann::json::parse("[]")), nlohmann::json::exception);
}

}  // namespace
}  // namespace multipath_localization
