#include <gtest/gtest.h>

#include <algorithm>

#include "../core/german_locale.hpp"
#include "evaluation/report.hpp"

namespace multipath_localization {
namespace {

RunRecord run_of(const std::string& estimator, std::uint64_t seed, double rmse) {
  RunRecord run;
  run.source = "a \"drive\"";
  run.estimator = estimator;
  run.seed = seed;
  run.score.epochs = 7;
  run.score.rmse = rmse;
  run.fixes.rmse = 5.0;
  run.cpu = 0.25;
  return run;
}

TEST(Losses, NameEveryKindOfMeasurement) {
  RunRecord run = run_of("a", 1, 1.5);
  for (ReasonTally& fate : run.fates) fate.count(Reason::kNotFinite);
  const std::string text = losses({run});
  for (const char* kind : {"fixes", "pairs of fixes", "epochs", "velocities", "headings"}) {
    EXPECT_NE(text.find(std::string("a: ") + kind), std::string::npos) << kind;
  }
}

TEST(ToJson, HasTheContractsKeysAndNullsForWhatDoesNotApply) {
  const std::string text = to_json({run_of("a", 3, 1.5)});
  const YAML::Node list = YAML::Load(text);
  ASSERT_EQ(list.size(), 1u);
  std::vector<std::string> keys;
  for (const auto& entry : list[0]) keys.push_back(entry.first.as<std::string>());
  EXPECT_EQ(keys, (std::vector<std::string>{"source",
                                            "estimator",
                                            "seed",
                                            "epochs",
                                            "mean_m",
                                            "rmse_m",
                                            "median_m",
                                            "p95_m",
                                            "max_m",
                                            "heading_rmse_rad",
                                            "rmse_shadow_m",
                                            "rmse_open_m",
                                            "longest_off_s",
                                            "longest_beyond_3_sigma_s",
                                            "way_to_alignment_m",
                                            "nees_mean",
                                            "cpu_s",
                                            "fix_rmse_m",
                                            "fix_median_m",
                                            "fix_p95_m",
                                            "fix_max_m",
                                            "fix_rmse_shadow_m",
                                            "fix_rmse_open_m"}));
  EXPECT_EQ(list[0]["source"].as<std::string>(), "a \"drive\"");
  EXPECT_EQ(list[0]["seed"].as<int>(), 3);
  EXPECT_EQ(list[0]["epochs"].as<int>(), 7);
  EXPECT_DOUBLE_EQ(list[0]["rmse_m"].as<double>(), 1.5);
  EXPECT_DOUBLE_EQ(list[0]["fix_rmse_m"].as<double>(), 5.0);
  EXPECT_DOUBLE_EQ(list[0]["cpu_s"].as<double>(), 0.25);
  EXPECT_TRUE(list[0]["heading_rmse_rad"].IsNull());
  EXPECT_NE(text.find("\"nees_mean\": null"), std::string::npos);
}

TEST(ToJson, LeavesOutRunsThatDidNotEnd) {
  RunRecord failed = run_of("a", 1, 1.0);
  failed.failure = "why";
  EXPECT_EQ(YAML::Load(to_json({failed, run_of("b", 1, 1.0)})).size(), 1u);
  EXPECT_EQ(to_json({}), "[\n]\n");
}

TEST(ToTable, MeansOverRunsAndNamesTheWorst) {
  const std::string table = to_table({run_of("a", 1, 1.0), run_of("a", 2, 4.0), run_of("b", 1, 3.0)});
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 4);
  EXPECT_NE(table.find("2.50"), std::string::npos) << table;
  EXPECT_NE(table.find("4.00 (2)"), std::string::npos) << table;
  EXPECT_NE(table.find("3.00 (1)"), std::string::npos) << table;
  EXPECT_NE(table.find("(fixes as they are)"), std::string::npos) << table;
  EXPECT_EQ(table.find("NEES"), std::string::npos) << "applies to no line";
}

TEST(ToTable, KeepsStreamsApart) {
  RunRecord other = run_of("a", 1, 3.0);
  other.source = "another";
  other.fixes.rmse = 7.0;
  const std::string table = to_table({run_of("a", 1, 1.0), run_of("b", 1, 2.0), other});
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 6) << "a head, two of fixes, three of estimators";
  EXPECT_EQ(table.find("stream"), 0U);
  EXPECT_NE(table.find("5.00"), std::string::npos) << table;
  EXPECT_NE(table.find("7.00"), std::string::npos) << table;
  EXPECT_EQ(to_table({other}).find("stream"), std::string::npos) << "one needs no name";
}

TEST(ToTable, ShowsMillimetres) {
  const std::string table = to_table({run_of("a", 1, 0.0026), run_of("b", 1, 0.4)});
  EXPECT_NE(table.find(" 0.003 "), std::string::npos) << table;
  EXPECT_NE(table.find(" 0.40 "), std::string::npos) << table;
}

TEST(Report, IsTheSameInAnyLocale) {
  const std::vector<RunRecord> runs = {run_of("a", 1, 1234.5), run_of("a", 1234, 4.5)};
  const std::string json = to_json(runs);
  const std::string table = to_table(runs);
  const GermanLocale german;
  EXPECT_EQ(to_json(runs), json);
  EXPECT_EQ(to_table(runs), table);
}

}  // namespace
}  // namespace multipath_localization
