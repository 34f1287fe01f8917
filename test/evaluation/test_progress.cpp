#include <gtest/gtest.h>

#include "multipath_localization/evaluation/progress.hpp"

namespace multipath_localization {
namespace {

TEST(ProgressBar, WritesNothingWhereThereIsNoTerminal) {
  testing::internal::CaptureStderr();
  {
    ProgressBar bar(2);
    bar.update(0, 0.5);
    bar.update(1, 1.0);
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace multipath_localization
