#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

#include "../../evaluation/temporary_folder.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "ros/map/datum_file.hpp"

namespace multipath_localization {
namespace {

const Geodetic kPlace{52.504570117, -13.373662771, 76.0109};

std::string content_of(const std::string& file) {
  std::ifstream in(file);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

TEST(DatumFile, GivesBackWhatWasSavedLast) {
  const TemporaryFolder folder;
  const std::string file = folder.path() + "/made/for/it/datum.yaml";
  EXPECT_FALSE(read_datum(file)) << "nothing was saved as yet";
  write_datum(file, {1.0, 2.0, 3.0});
  write_datum(file, kPlace);
  const std::optional<Geodetic> saved = read_datum(file);
  ASSERT_TRUE(saved);
  EXPECT_NEAR(saved->latitude_deg, kPlace.latitude_deg, 1e-9);
  EXPECT_NEAR(saved->longitude_deg, kPlace.longitude_deg, 1e-9);
  EXPECT_NEAR(saved->altitude, kPlace.altitude, 1e-4);
  EXPECT_FALSE(std::filesystem::exists(file + ".new"));
}

TEST(DatumFile, CutAnywhereIsRefused) {
  const TemporaryFolder folder;
  const std::string file = folder.path() + "/datum.yaml";
  write_datum(file, kPlace);
  const std::string whole = content_of(file);
  const std::size_t end = whole.find(']');
  ASSERT_NE(end, std::string::npos);
  for (std::size_t length = 0; length <= end; ++length) {
    folder.write("datum.yaml", whole.substr(0, length));
    EXPECT_THROW(read_datum(file), ParameterError) << length;
  }
}

TEST(DatumFile, AnythingElseIsRefusedByName) {
  const TemporaryFolder folder;
  const std::string file = folder.path() + "/datum.yaml";
  for (const char* content :
       {"datum: [52.5, 13.4]", "datum: [91.0, 13.4, 0.0]", "datum: [52.5, 13.4, .nan]",
        "datum: [52.5, 13.4, 1e308]", "datum: [a, b, c]", "datum: 52.5", "origin: [52.5, 13.4, 0.0]",
        "datum: [52.5, 13.4, 0.0]\nyaw: 1.0", "- 1", "\x01\x02"}) {
    folder.write("datum.yaml", content);
    try {
      read_datum(file);
      ADD_FAILURE() << content;
    } catch (const ParameterError& error) {
      EXPECT_EQ(std::string(error.what()).find(file + " is damaged: "), 0U) << content;
    }
  }
}

TEST(DatumFile, KeepsTheOldOneWhereItCannotBeReplaced) {
  const TemporaryFolder folder;
  const std::string file = folder.path() + "/datum.yaml";
  write_datum(file, kPlace);
  std::filesystem::create_directory(file + ".new");
  EXPECT_THROW(write_datum(file, {1.0, 2.0, 3.0}), std::system_error);
  ASSERT_TRUE(read_datum(file));
  EXPECT_NEAR(read_datum(file)->altitude, kPlace.altitude, 1e-4);
  folder.write("no_folder", "");
  EXPECT_THROW(write_datum(folder.path() + "/no_folder/datum.yaml", kPlace), std::system_error);
}

}  // namespace
}  // namespace multipath_localization
