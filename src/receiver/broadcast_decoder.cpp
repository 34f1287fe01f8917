#include "receiver/broadcast_decoder.hpp"

namespace multipath_localization {

void BroadcastDecoder::add(const Subframe& subframe, const ReceptionTime& now, Navigation& navigation) {
  take_ionosphere(subframe, navigation);
  const auto its =
      messages_.try_emplace(subframe.satellite, message_of(subframe.satellite.constellation)).first;
  std::visit(
      [&](auto& message) {
        const auto orbit = message.add(subframe, now);
        if (!orbit) return;
        ++ephemerides_;
        if (possible(*orbit)) {
          navigation.ephemerides.update(*orbit);
        } else {
          ++impossible_;
        }
      },
      its->second);
}

BroadcastDecoder::Message BroadcastDecoder::message_of(Constellation constellation) {
  switch (constellation) {
    case Constellation::kGalileo: return GalileoMessage();
    case Constellation::kBeidou: return BeidouMessage();
    case Constellation::kGlonass: return GlonassMessage();
    default: return GpsMessage();
  }
}

void BroadcastDecoder::take_ionosphere(const Subframe& subframe, Navigation& navigation) {
  const bool gps = subframe.satellite.constellation == Constellation::kGps;
  const bool qzss = subframe.satellite.constellation == Constellation::kQzss;
  if (!gps && (!qzss || ionosphere_of_gps_)) return;
  const std::optional<KlobucharCoefficients> ionosphere = gps_ionosphere(subframe);
  // Nothing but zeros is a way to say that there is none.
  if (!ionosphere || ionosphere->alpha.isZero() || ionosphere->beta.isZero()) return;
  ionosphere_of_gps_ = gps;
  navigation.ionosphere = ionosphere;
}

}  // namespace multipath_localization
