#include "receiver/ubx_receiver.hpp"

#include <utility>

namespace multipath_localization {

namespace {

constexpr std::uint8_t kRxm = 0x02, kRawx = 0x15, kSfrbx = 0x13;

}  // namespace

UbxReceiver::UbxReceiver(Navigation& navigation, TakeEpoch take_epoch)
    : navigation_(navigation), take_epoch_(std::move(take_epoch)) {}

void UbxReceiver::take(std::string_view bytes) {
  framing_.take(bytes, [this](const UbxMessage& message) {
    if (message.kind != kRxm) return;
    if (message.id == kRawx) take_rawx(message.payload);
    if (message.id == kSfrbx) take_sfrbx(message.payload);
  });
}

void UbxReceiver::take_rawx(std::string_view payload) {
  const std::optional<ReceiverEpoch> epoch = read_rawx(payload);
  if (!epoch) {
    ++counts_.malformed;
    return;
  }
  ++counts_.epochs;
  if (epoch->clock_reset) ++counts_.clock_resets;
  const GnssTime& gps = epoch->raw.time;
  time_ = {gps, epoch->leap_seconds.value_or(leap_seconds_at(gps))};
  take_epoch_(*epoch);
}

void UbxReceiver::take_sfrbx(std::string_view payload) {
  const std::optional<Subframe> subframe = read_sfrbx(payload);
  if (!subframe || !time_) {
    ++counts_.malformed;
    return;
  }
  ++counts_.subframes;
  broadcast_.add(*subframe, *time_, navigation_);
}

}  // namespace multipath_localization
