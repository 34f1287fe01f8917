#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "../core/german_locale.hpp"
#include "broadcast.hpp"
#include "rinex/line_reader.hpp"

namespace multipath_localization {
namespace {

class ReadLines : public ::testing::Test {
 protected:
  [[nodiscard]] LineReader reader(const std::string& content) const {
    return LineReader(folder_.write("lines", content));
  }

  /// What is wrong with the first line as that of a RINEX file, without the file's name.
  [[nodiscard]] std::string refusal(const std::string& first_line) const {
    LineReader in = reader(first_line);
    try {
      (void)read_kind(in);
    } catch (const RinexError& error) {
      return std::string(error.what()).substr(folder_.path().size() + 6);
    }
    return "";
  }

  TemporaryFolder folder_;
};

TEST_F(ReadLines, NumbersStandInColumns) {
  LineReader in = reader("  1.5D+01-2.5E-01        7\r\n\n");
  ASSERT_TRUE(in.next());
  EXPECT_EQ(in.line().back(), '7');
  const GermanLocale german;
  EXPECT_EQ(in.number(0, 9), std::optional<double>(15.0));
  EXPECT_EQ(in.number(9, 8), std::optional<double>(-0.25));
  EXPECT_EQ(in.number(17, 3), std::nullopt);
  EXPECT_EQ(in.number(500, 3), std::nullopt);
  EXPECT_EQ(in.integer(20, 9), 7);
  EXPECT_TRUE(in.next());
  EXPECT_FALSE(in.next());
}

TEST_F(ReadLines, RefusesWhatIsNoNumber) {
  LineReader in = reader("nan inf 0x101 1e999 1.5 1-2 1.0.\n");
  ASSERT_TRUE(in.next());
  for (const std::size_t first : {0, 4, 8, 14, 24, 28}) {
    EXPECT_THROW((void)in.number(first, first == 8 || first == 14 ? 5 : 4), RinexError) << first;
  }
  EXPECT_THROW((void)in.integer(20, 3), RinexError);
  EXPECT_THROW((void)in.integer(100, 3), RinexError);
}

TEST_F(ReadLines, ALinePutBackComesAgain) {
  LineReader in = reader("a\nb\n");
  ASSERT_TRUE(in.next());
  ASSERT_TRUE(in.next());
  in.put_back();
  EXPECT_EQ(std::string(in.error("why").what()), folder_.path() + "/lines:1: why");
  ASSERT_TRUE(in.next());
  EXPECT_EQ(in.line(), "b");
  EXPECT_EQ(std::string(in.error("why").what()), folder_.path() + "/lines:2: why");
  EXPECT_THROW(in.require_next("a test"), RinexError);
}

TEST_F(ReadLines, OfALineOfAMegabyteTheBeginIsThere) {
  LineReader in = reader("short\n" + std::string(1 << 20, 'x') + "\nnext\n");
  ASSERT_TRUE(in.next());
  ASSERT_TRUE(in.next());
  EXPECT_EQ(in.line(), std::string(20000, 'x'));
  ASSERT_TRUE(in.next());
  EXPECT_EQ(in.line(), "next");
}

TEST_F(ReadLines, MarksOfEditorsAndOfDosAreNoText) {
  LineReader in = reader(
      "\xef\xbb\xbf"
      "first\r\r\n\xef\xbb\xbfjoined\n\x1a\nlast\r\n\x1a");
  for (const char* line : {"first", "joined", "", "last"}) {
    ASSERT_TRUE(in.next());
    EXPECT_EQ(in.line(), line);
  }
  EXPECT_FALSE(in.next()) << "a lone ^Z is no line that was cut off";
}

TEST_F(ReadLines, LabelsMayBeCutOff) {
  LineReader in = reader(header_line("", "SYS / # / OB") + header_line("", "SYS /") +
                         header_line("", "SYS / # / OBS TYPES"));
  ASSERT_TRUE(in.next());
  EXPECT_TRUE(in.labelled("SYS / # / OBS TYPES"));
  EXPECT_FALSE(in.labelled("SYS / SCALE FACTOR"));
  ASSERT_TRUE(in.next());
  EXPECT_FALSE(in.labelled("SYS / # / OBS TYPES")) << "that could be several";
  ASSERT_TRUE(in.next());
  EXPECT_TRUE(in.labelled("SYS / # / OBS TYPES"));
  EXPECT_FALSE(in.labelled("SYS / # / OB"));
}

TEST_F(ReadLines, ColumnsMoveEitherWay) {
  LineReader in = reader("ab  cd\n");
  ASSERT_TRUE(in.next());
  in.move(4, 5);
  EXPECT_EQ(in.line(), "ab   cd");
  in.move(5, 3);
  EXPECT_EQ(in.line(), "ab cd");
}

TEST_F(ReadLines, ALineWithoutAnEndIsNotWhole) {
  LineReader in = reader("whole\n12345");
  ASSERT_TRUE(in.next());
  try {
    in.next();
    FAIL();
  } catch (const UnexpectedEnd& end) {
    EXPECT_EQ(std::string(end.what()), folder_.path() + "/lines:2: the file ends within this line");
  }
}

/// The command line of a process can be read no further once the process is gone.
TEST_F(ReadLines, AnErrorWhileReadingIsNoEndOfTheFile) {
  const pid_t child = fork();
  if (child == 0) {
    pause();
    _exit(0);
  }
  LineReader in("/proc/" + std::to_string(child) + "/cmdline");
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  try {
    in.next();
    FAIL();
  } catch (const RinexError& error) {
    EXPECT_NE(std::string(error.what()).find("cannot be read beyond this line"), std::string::npos)
        << error.what();
  }
}

TEST_F(ReadLines, RefusesAFileThatIsEmptyOrNotThere) {
  EXPECT_THROW(reader(""), RinexError);
  EXPECT_THROW(LineReader(folder_.path() + "/none"), RinexError);
}

TEST_F(ReadLines, KindIsThatOfTheFirstLine) {
  LineReader in = reader(header_line("     2.11           G: GLONASS NAV DATA", "RINEX VERSION / TYPE"));
  const FileKind kind = read_kind(in);
  EXPECT_DOUBLE_EQ(kind.version, 2.11);
  EXPECT_TRUE(kind.version_2());
  EXPECT_EQ(kind.type, 'G');
  EXPECT_EQ(kind.system, ' ');
}

TEST_F(ReadLines, RefusesOtherVersionsAndOtherFiles) {
  const auto first = [](const std::string& version) {
    return header_line("     " + version + "           OBSERVATION DATA    M", "RINEX VERSION / TYPE");
  };
  for (const char* version : {"2.00", "2.11", "2.12", "3.00", "3.04", "3.05"}) {
    EXPECT_EQ(refusal(first(version)), "") << version;
  }
  for (const char* version : {"1.00", "2.20", "3.06", "4.00", "    "}) {
    EXPECT_NE(refusal(first(version)).find("2.00 to 2.12 and 3.00 to 3.05 are read"), std::string::npos)
        << version;
  }
  EXPECT_EQ(refusal("hello\n"), ":1: not a RINEX file");
  EXPECT_NE(refusal(header_line("3.0", "CRINEX VERS   / TYPE")).find("Hatanaka"), std::string::npos);
}

TEST_F(ReadLines, DateAndTimeStandInColumns) {
  LineReader in = reader("> 2024 06 24 08 20 36.2500000\n 24  6 24  8 20 36.2500000\n");
  for (const bool four_digits : {true, false}) {
    ASSERT_TRUE(in.next());
    const CalendarTime time = four_digits ? calendar_time(in, 2, 4, 11) : calendar_time(in, 1, 2, 11);
    EXPECT_EQ(time.year, 2024);
    EXPECT_EQ(time.month, 6);
    EXPECT_EQ(time.day, 24);
    EXPECT_EQ(time.hour, 8);
    EXPECT_EQ(time.minute, 20);
    EXPECT_DOUBLE_EQ(time.second, 36.25);
  }
}

}  // namespace
}  // namespace multipath_localization
