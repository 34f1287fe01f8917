#include <gtest/gtest.h>

#include "evaluation/suite.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "temporary_folder.hpp"

namespace multipath_localization {
namespace {

TEST(LoadSuite, LaysEachRowOverTheBase) {
  const TemporaryFolder folder;
  const std::string file =
      folder.write("suite.yaml",
                   "base: {duration: 20, simulator: {receiver: {rate: 5, latency: 0.1}}}\n"
                   "rows:\n"
                   "  as it is:\n"
                   "  slow: {simulator: {receiver: {rate: 1}}}\n");
  const std::vector<Scenario> rows = load_suite(file);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].name, "as it is");
  EXPECT_EQ(rows[0].simulator.receiver.rate, 5.0);
  EXPECT_EQ(rows[1].name, "slow");
  EXPECT_EQ(rows[1].simulator.receiver.rate, 1.0);
  EXPECT_EQ(rows[1].simulator.receiver.latency, 0.1);
  EXPECT_EQ(rows[1].duration, 20.0);
}

TEST(LoadSuite, RefusesWhatIsNoneAndNamesTheRow) {
  const TemporaryFolder folder;
  for (const char* text : {"[]", "base: {}", "rows: {}", "rows: []", "rows: {a: {}}\nmore: 1", "rows: {a: 3}",
                           "rows: {a: {durat: 3}}", "rows:\n  a: {}\n  a: {}", "{[1, 2]: 3}",
                           "rows: {{a: b}: {}}", "base: {[1]: 2}\nrows: {a: {}}", "rows: {a: {[1]: 2}}"}) {
    EXPECT_THROW(load_suite(folder.write("suite.yaml", text)), ParameterError) << text;
  }
  try {
    load_suite(
        folder.write("suite.yaml", "rows: {fine: {}, the bad one: {simulator: {receiver: {rat: 1}}}}"));
    FAIL();
  } catch (const ParameterError& error) {
    EXPECT_NE(std::string(error.what()).find("the bad one"), std::string::npos) << error.what();
  }
}

TEST(LoadSuite, ShippedOneHasEveryFaultOnTheSameWay) {
  const std::vector<Scenario> rows = load_suite(std::string(CONFIG_DIR) + "/suites/faults.yaml");
  EXPECT_GE(rows.size(), 16U);
  for (const Scenario& row : rows) {
    EXPECT_TRUE(row.steered_on_truth) << row.name;
    EXPECT_TRUE(row.localization.IsNull()) << row.name << ": estimators are told nothing";
  }
}

TEST(LoadSuite, ConditionsAreSteeredOnTruthWithEstimatorsToldNothing) {
  const std::vector<Scenario> rows = load_suite(std::string(CONFIG_DIR) + "/suites/conditions.yaml");
  EXPECT_EQ(rows.size(), 23U);
  for (const Scenario& row : rows) {
    EXPECT_TRUE(row.steered_on_truth) << row.name;
    EXPECT_TRUE(row.localization.IsNull()) << row.name;
  }
}

}  // namespace
}  // namespace multipath_localization
