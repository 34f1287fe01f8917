// Writes where a robot drove, as a bag tells it, for maps: GPX or GeoJSON.

#include <cstdio>
#include <filesystem>
#include <iostream>

#include "support/atomic_file.hpp"
#include "tools/track/track.hpp"

int main(int argc, char** argv) {
  using namespace multipath_localization;
  const std::string first = argc > 1 ? argv[1] : "";
  const std::string out = argc > 2 ? argv[2] : "";
  const std::string ending = std::filesystem::path(out).extension().string();
  const bool gpx = ending == ".gpx";
  const bool known = gpx || ending == ".geojson" || ending == ".json";
  if (first == "--help" || argc < 3 || argc > 4 || !known) {
    std::ostream& to = first == "--help" ? std::cout : std::cerr;
    to << "usage: bag_to_track IN.bag OUT.gpx|OUT.geojson\n"
          "       bag_to_track IN.bag OUT.gpx|OUT.geojson TOPIC\n\n"
          "Writes where a robot drove as a track with times, a point every 0.2 m. TOPIC is of\n"
          "sensor_msgs/NavSatFix: /gps/filtered, where localization_node says the base is, unless told "
          "otherwise.\n";
    return first == "--help" ? 0 : 2;
  }
  try {
    const std::vector<TrackPoint> track = read_track(first, argc == 4 ? argv[3] : "/gps/filtered");
    replace_file(out, gpx ? gpx_of(track) : geojson_of(track));
    std::printf("%s: %zu points\n", out.c_str(), track.size());
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "bag_to_track: " << error.what() << "\n";
    return 2;
  }
}
