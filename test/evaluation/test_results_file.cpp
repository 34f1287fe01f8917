#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "evaluation/results_file.hpp"
#include "evaluation/standings.hpp"
#include "temporary_folder.hpp"

namespace multipath_localization {
namespace {

const Evaluation kEvaluation = {"random", {"gyro"}, {"gated_ekf=gated_ekf"}, {}, 60.0};

std::vector<RunRecord> runs_of(std::uint64_t seed, double rmse) {
  RunRecord run;
  run.source = "random";
  run.estimator = "gated_ekf";
  run.seed = seed;
  run.kind = "rtk";
  run.score.rmse = rmse;
  run.fixes.rmse = 2.0;
  run.calibration.time = 10.0;
  run.calibration.stanford[{3, 4}] = 10.0;
  run.calibration.shadow.told = {1.5};
  return {run};
}

std::string text_of(const std::string& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

class AResultsFile : public ::testing::Test {
 protected:
  void write(const std::string& text) { std::ofstream(file_) << text; }
  std::string refusal(const Evaluation& evaluation = kEvaluation) {
    try {
      ResultsFile(file_, evaluation);
    } catch (const ResultsError& error) {
      return error.what();
    }
    return "";
  }

  TemporaryFolder folder_;
  std::string file_ = folder_.path() + "/results.jsonl";
};

TEST_F(AResultsFile, GoesOnWhereTheLastProgramEnded) {
  {
    ResultsFile results(file_, kEvaluation);
    EXPECT_TRUE(results.runs().empty());
    results.add(runs_of(7, 0.5));
    results.add(runs_of(3, 1.5));
  }
  ResultsFile again(file_, kEvaluation);
  EXPECT_TRUE(again.holds(7) && again.holds(3));
  EXPECT_FALSE(again.holds(5));
  again.add(runs_of(5, 1.0));
  const std::vector<RunRecord> all = read_results({file_});
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].seed, 3u);
  EXPECT_EQ(all[2].seed, 7u);
  EXPECT_DOUBLE_EQ(*all[0].score.rmse, 1.5);
  EXPECT_FALSE(all[0].score.nees_mean);
  EXPECT_DOUBLE_EQ(all[0].calibration.stanford.at({3, 4}), 10.0);
  EXPECT_DOUBLE_EQ(all[0].calibration.shadow.told.front(), 1.5);
  EXPECT_DOUBLE_EQ(*standings(all, "rtk").back().rmse, std::cbrt(0.75));
}

TEST_F(AResultsFile, MakesARunAgainWhoseLineWasCutOff) {
  {
    ResultsFile results(file_, kEvaluation);
    results.add(runs_of(1, 1.0));
    results.add(runs_of(2, 1.0));
  }
  std::filesystem::resize_file(file_, std::filesystem::file_size(file_) - 20);
  {
    ResultsFile again(file_, kEvaluation);
    EXPECT_TRUE(again.holds(1));
    EXPECT_FALSE(again.holds(2));
    again.add(runs_of(2, 3.0));
  }
  const std::vector<RunRecord> all = read_results({file_});
  ASSERT_EQ(all.size(), 2u);
  EXPECT_DOUBLE_EQ(*all[1].score.rmse, 3.0);
}

TEST_F(AResultsFile, CutOffInItsFirstLineIsBegunAgain) {
  write("{\"evalua");
  ResultsFile(file_, kEvaluation).add(runs_of(1, 1.0));
  EXPECT_EQ(read_results({file_}).size(), 1u);
}

TEST_F(AResultsFile, OfAnotherEvaluationIsRefusedAndKept) {
  { ResultsFile results(file_, kEvaluation); }
  const std::string before = text_of(file_);
  Evaluation other = kEvaluation;
  other.parameters = {"gate=20"};
  EXPECT_NE(refusal(other).find("gate=20"), std::string::npos);
  EXPECT_EQ(text_of(file_), before);
}

TEST_F(AResultsFile, ThatIsNoneIsRefusedByLineAndKept) {
  write("t,lat_deg\n1,2\n");
  EXPECT_NE(refusal().find("line 1"), std::string::npos);
  EXPECT_EQ(text_of(file_), "t,lat_deg\n1,2\n");
}

TEST_F(AResultsFile, OfSeveralWorkersCountsEachSeedOnce) {
  const std::string other = folder_.path() + "/other.jsonl";
  ResultsFile(file_, kEvaluation).add(runs_of(1, 1.0));
  ResultsFile second(other, kEvaluation);
  second.add(runs_of(1, 1.0));
  second.add(runs_of(2, 1.0));
  EXPECT_EQ(read_results({file_, other}).size(), 2u);
  EXPECT_THROW(read_results({file_, folder_.path() + "/missing.jsonl"}), ResultsError);
}

}  // namespace
}  // namespace multipath_localization
