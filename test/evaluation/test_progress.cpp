#include <gtest/gtest.h>

#include <string>

#include "evaluation/progress.hpp"

namespace multipath_localization {
namespace {

/// What a bar over two runs writes as they go on.
std::string written(bool on_terminal) {
  testing::internal::CaptureStderr();
  {
    ProgressBar bar(2, on_terminal);
    bar.update(0, 0.5);
    bar.update(1, 1.0);
  }
  return testing::internal::GetCapturedStderr();
}

TEST(ProgressBar, CountsFractionsAndRuns) {
  const std::string text = written(true);
  EXPECT_NE(text.find("]  25 %  0 of 2 runs"), std::string::npos) << text;
  EXPECT_NE(text.find("]  75 %  1 of 2 runs"), std::string::npos) << text;
  EXPECT_EQ(text.back(), '\r') << "leaves the line clean";
}

TEST(ProgressBar, WritesNothingWhereThereIsNoTerminal) { EXPECT_EQ(written(false), ""); }

}  // namespace
}  // namespace multipath_localization
