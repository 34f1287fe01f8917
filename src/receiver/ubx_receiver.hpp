#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>

#include "receiver/broadcast_decoder.hpp"
#include "receiver/ubx_framing.hpp"
#include "receiver/ubx_messages.hpp"

namespace multipath_localization {

/// What came of a receiver's stream so far.
struct StreamCounts {
  std::size_t epochs = 0;        ///< RXM-RAWX
  std::size_t subframes = 0;     ///< RXM-SFRBX
  std::size_t malformed = 0;     ///< of either, that are none or of no use, or came before the time
  std::size_t clock_resets = 0;  ///< epochs at which the receiver moved its clock
};

/// Makes of what a u-blox receiver says (8, M8, 9 and later, with RXM-RAWX and RXM-SFRBX enabled) epochs of
/// observations, and the navigation data that they are to be corrected by. Decoded here, because libgps is a
/// client of gpsd's daemon, whose reports lack the words of subframes but GPS's, and rtklib is programs only.
class UbxReceiver {
 public:
  using TakeEpoch = std::function<void(const ReceiverEpoch&)>;

  /// `navigation` is added to as satellites broadcast, and has to outlive it.
  UbxReceiver(Navigation& navigation, TakeEpoch take_epoch);

  /// Takes the bytes that came next of a stream that may hold anything beside.
  void take(std::string_view bytes);

  /// Takes the payload of one message, as drivers hand them on.
  void take_rawx(std::string_view payload);
  void take_sfrbx(std::string_view payload);

  [[nodiscard]] const StreamCounts& counts() const { return counts_; }
  [[nodiscard]] const UbxFraming& framing() const { return framing_; }
  [[nodiscard]] const BroadcastDecoder& broadcast() const { return broadcast_; }
  /// Of the last epoch; nothing before the first.
  [[nodiscard]] const std::optional<ReceptionTime>& time() const { return time_; }

 private:
  Navigation& navigation_;
  TakeEpoch take_epoch_;
  UbxFraming framing_;
  BroadcastDecoder broadcast_;
  std::optional<ReceptionTime> time_;
  StreamCounts counts_;
};

}  // namespace multipath_localization
