#include "ros/gnss_receiver_node/gnss_receiver_parameters.hpp"

namespace multipath_localization {

void GnssReceiverParameters::fields(ParameterVisitor& field) {
  field("source", source, {},
        "of the receiver's stream: a serial line (/dev/ttyACM0), a file (/path/drive.ubx), tcp://host:port; "
        "empty: the topics of a driver");
  field("baud", baud, {0, 921600}, "bit/s", "of a serial line; 0 leaves it as it is, as USB wants it");
  field("stamps", stamps, {"receiver", "arrival"},
        "of epochs: the receiver's time, for a host whose clock is synchronised, or when they arrived");
  field("frame", frame, {}, "frame of the antenna");
  field("elevation_mask_deg", elevation_mask_deg, {0.0, 60.0}, "deg", "lower satellites are left out");
  field("ephemeris_file", ephemeris_file, {},
        "absolute path where ephemerides are saved once a minute and at the end, as RINEX, and read at the "
        "next start; empty: nowhere");
  field("navigation_file", navigation_file, {},
        "absolute path of a RINEX navigation file that helps until satellites have told; empty: none");
  field("record_file", record_file, {}, "absolute path that the stream is appended to; empty: none");
  field("rate", rate, {0.0, 1000.0}, "1",
        "recorded seconds per second of a file; 0: as fast as it can be read");
  for (const std::string* file : {&ephemeris_file, &navigation_file, &record_file}) {
    if (!file->empty() && file->front() != '/') throw ParameterError(*file + " is not an absolute path");
  }
}

}  // namespace multipath_localization
