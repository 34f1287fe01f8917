#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

#include "support/atomic_file.hpp"

namespace multipath_localization {
namespace {

namespace fs = std::filesystem;

class AtomicFile : public testing::Test {
 protected:
  void SetUp() override { fs::remove_all(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  static std::string content(const fs::path& file) {
    std::stringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }

  const fs::path folder_ = fs::path(testing::TempDir()) / "atomic_file_test";
};

TEST_F(AtomicFile, MakesFoldersAndReplacesWhatWasThere) {
  const fs::path file = folder_ / "deep" / "file";
  replace_file(file, "first, and longer");
  replace_file(file, "second");
  EXPECT_EQ(content(file), "second");
  EXPECT_FALSE(fs::exists(file.string() + ".new"));
}

TEST_F(AtomicFile, LeavesTheOldFileWhereItCannotWrite) {
  const fs::path file = folder_ / "file";
  replace_file(file, "old");
  fs::create_directories(file.string() + ".new");
  EXPECT_THROW(replace_file(file, "new"), std::system_error);
  EXPECT_EQ(content(file), "old");
}

TEST_F(AtomicFile, LeavesNothingBesideAFileThatItCannotReplace) {
  const fs::path file = folder_ / "file";
  fs::create_directories(file / "that_is_a_folder");
  EXPECT_THROW(replace_file(file, "new"), std::system_error);
  EXPECT_FALSE(fs::exists(file.string() + ".new"));
}

TEST_F(AtomicFile, WritesIntoTheFolderThatTheProgramIsIn) {
  fs::create_directories(folder_);
  const fs::path before = fs::current_path();
  fs::current_path(folder_);
  replace_file("file", "here");
  fs::current_path(before);
  EXPECT_EQ(content(folder_ / "file"), "here");
}

}  // namespace
}  // namespace multipath_localization
