#include <gtest/gtest.h>

#include <functional>

#include "../core/german_locale.hpp"
#include "../evaluation/temporary_folder.hpp"
#include "support/csv.hpp"

namespace multipath_localization {
namespace {

std::string failure_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const DriveError& error) {
    return error.what();
  }
  return "";
}

TEST(CsvTable, HeaderNamesDecideColumns) {
  const TemporaryFolder folder;
  const CsvTable table(folder.write("a.csv", "b , a,\"c\"\r\n1,2e1,text\r\n\r\n3,-4,\r\n"), {"a", "b"});
  EXPECT_EQ(table.rows(), 2u);
  EXPECT_DOUBLE_EQ(table.number(0, "a"), 20.0);
  EXPECT_DOUBLE_EQ(table.number(1, "b"), 3.0);
  EXPECT_TRUE(table.has("c"));
  EXPECT_FALSE(table.has("d"));
}

TEST(CsvTable, LeavesOutCommentsAndAByteOrderMark) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.csv", "\xEF\xBB\xBF# of today\na,b\n1,2 # first\n# none\n3,x\n");
  const CsvTable table(file, {"a"});
  EXPECT_EQ(table.rows(), 2u);
  EXPECT_EQ(table.number(0, "b"), 2.0);
  EXPECT_EQ(failure_of([&] { static_cast<void>(table.number(1, "b")); }),
            file + ":5: b is 'x', not a finite number");
}

TEST(CsvTable, NamesFileLineAndReason) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.csv", "a,b\n1,2\n\nx,nan\n");
  const CsvTable table(file, {"a"});
  EXPECT_EQ(failure_of([&] { static_cast<void>(table.number(1, "a")); }),
            file + ":4: a is 'x', not a finite number");
  EXPECT_EQ(failure_of([&] { static_cast<void>(table.number(1, "b")); }),
            file + ":4: b is 'nan', not a finite number");
  EXPECT_EQ(failure_of([&] { CsvTable(file, {"a", "c"}); }), file + ":1: no column c");
}

TEST(CsvTable, RefusesNumbersBeyondABoundAndWithMoreBehindThem) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.csv", std::string("a,b\n-1e300,1\0 x\n", 16));
  const CsvTable table(file, {"a"});
  EXPECT_EQ(table.number(0, "a"), -1e300);
  EXPECT_EQ(failure_of([&] { static_cast<void>(table.number(0, "a", 1e11)); }),
            file + ":2: a is '-1e300', beyond 1e+11");
  EXPECT_NE(failure_of([&] { static_cast<void>(table.number(0, "b")); }), "");
}

TEST(CsvTable, RefusesWhatIsNoTable) {
  const TemporaryFolder folder;
  const std::string ragged = folder.write("ragged.csv", "a,b\n1,2\n3\n");
  EXPECT_EQ(failure_of([&] { CsvTable(ragged, {}); }), ragged + ":3: 1 cells under 2 columns");
  const std::string missing = folder.path() + "/missing.csv";
  EXPECT_EQ(failure_of([&] { CsvTable(missing, {}); }), missing + ": cannot be read or is empty");
  EXPECT_NE(failure_of([&] { CsvTable(folder.write("empty.csv", ""), {}); }), "");
}

TEST(CsvTable, IsReadAlikeInAnyLocale) {
  const GermanLocale german;
  const TemporaryFolder folder;
  const std::string file = folder.write("a.csv", "a\n1234.5\n");
  const CsvTable table(file, {"a"});
  EXPECT_EQ(table.number(0, "a"), 1234.5);
  EXPECT_EQ(failure_of([&] { static_cast<void>(table.number(0, "a", 1000.5)); }),
            file + ":2: a is '1234.5', beyond 1000.5");
}

}  // namespace
}  // namespace multipath_localization
