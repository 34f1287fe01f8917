#include "nodes/datum_file.hpp"

#include <fcntl.h>
#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <vector>

#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

namespace {

namespace fs = std::filesystem;

/// Latitude and longitude to a tenth of a millimetre.
std::string text_of(const Geodetic& datum) {
  char text[200];
  std::snprintf(text, sizeof(text),
                "# Origin of map: latitude, longitude [deg], altitude [m]\ndatum: [%.9f, %.9f, %.4f]\n",
                datum.latitude_deg, datum.longitude_deg, datum.altitude);
  return text;
}

std::system_error failure(const std::string& what) { return {errno, std::generic_category(), what}; }

/// Writes a file and waits until it is on the disk.
void write_through(const std::string& file, const std::string& content) {
  const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor < 0) throw failure(file);
  const bool written =
      write(descriptor, content.data(), content.size()) == static_cast<ssize_t>(content.size()) &&
      fsync(descriptor) == 0;
  const std::system_error error = failure(file);
  close(descriptor);
  if (!written) throw error;
}

}  // namespace

std::optional<Geodetic> read_datum(const std::string& file) {
  std::error_code unreadable;
  if (!fs::exists(file, unreadable) && !unreadable) return std::nullopt;
  try {
    const YAML::Node content = YAML::LoadFile(file);
    const bool is_datum = content.IsMap() && content.size() == 1 && content["datum"];
    const auto numbers = is_datum ? content["datum"].as<std::vector<double>>() : std::vector<double>();
    if (numbers.size() == 3) {
      const Geodetic datum{numbers[0], numbers[1], numbers[2]};
      if (valid(datum) && std::isfinite(datum.altitude)) return datum;
    }
  } catch (const YAML::Exception& error) {
    throw ParameterError(file + " is damaged: " + error.what());
  }
  throw ParameterError(file + " is damaged: it does not hold datum: [latitude, longitude, altitude]");
}

void write_datum(const std::string& file, const Geodetic& datum) {
  const fs::path folder = fs::path(file).parent_path();
  if (!folder.empty()) fs::create_directories(folder);
  const std::string fresh = file + ".new";
  write_through(fresh, text_of(datum));
  fs::rename(fresh, file);
}

}  // namespace multipath_localization
