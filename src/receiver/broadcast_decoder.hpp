#pragma once

#include <cstddef>
#include <map>
#include <variant>

#include "receiver/beidou_message.hpp"
#include "receiver/galileo_message.hpp"
#include "receiver/glonass_message.hpp"
#include "receiver/gps_message.hpp"
#include "rinex/navigation_file.hpp"

namespace multipath_localization {

/// Puts together what all satellites broadcast: ephemerides, and of GPS, else QZSS, the model of the
/// ionosphere, as `read_navigation` takes them from a file. (BeiDou's model is one of its own and passed
/// over.)
class BroadcastDecoder {
 public:
  /// Takes a subframe and adds to `navigation` what is whole with it. Of a satellite as many pieces are kept
  /// as one ephemeris has; an impossible orbit is left out.
  void add(const Subframe& subframe, const ReceptionTime& now, Navigation& navigation);

  /// How many ephemerides were whole, and how many of them impossible.
  [[nodiscard]] std::size_t ephemerides() const { return ephemerides_; }
  [[nodiscard]] std::size_t impossible() const { return impossible_; }

 private:
  using Message = std::variant<GpsMessage, GalileoMessage, BeidouMessage, GlonassMessage>;

  static Message message_of(Constellation constellation);
  void take_ionosphere(const Subframe& subframe, Navigation& navigation);

  std::map<SatelliteId, Message> messages_;
  bool ionosphere_of_gps_ = false;
  std::size_t ephemerides_ = 0;
  std::size_t impossible_ = 0;
};

}  // namespace multipath_localization
