#include <gtest/gtest.h>

#include "evaluation/calibration_report.hpp"

namespace multipath_localization {
namespace {

TEST(CalibrationReport, HasAColumnForEachEstimatorOverAllItsRuns) {
  RunRecord run;
  run.estimator = "mine";
  run.calibration.time = 100.0;
  run.calibration.inside = {40.0, 80.0, 90.0, 100.0};
  run.calibration.in_state[static_cast<std::size_t>(Trust::kGood)] = 50.0;
  run.calibration.beyond[static_cast<std::size_t>(Trust::kGood)] = 1.0;
  run.calibration.shadow.told = {2.0};
  run.calibration.shadow.missed = 1;
  RunRecord other = run;
  other.estimator = "other";
  const std::string text = describe_calibration({run, run, other});
  EXPECT_NE(text.find("mine"), std::string::npos);
  EXPECT_NE(text.find("other"), std::string::npos);
  EXPECT_NE(text.find("inside the 99.7 % ellipse, %"), std::string::npos);
  EXPECT_NE(text.find("100.0 (2.0)"), std::string::npos);
  EXPECT_NE(text.find("2.0, -; 2 of 4"), std::string::npos);
  EXPECT_NE(text.find("2.0, -; 1 of 2"), std::string::npos);
}

}  // namespace
}  // namespace multipath_localization
