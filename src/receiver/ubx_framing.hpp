#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace multipath_localization {

/// A message of u-blox's protocol UBX.
struct UbxMessage {
  std::uint8_t kind = 0;     ///< its class
  std::uint8_t id = 0;       ///< within the class
  std::string_view payload;  ///< as long as the callback runs that is given it
};

/// Finds the UBX messages in a stream of bytes that may hold anything else (NMEA, RTCM, noise) and begin
/// anywhere. A message whose checksum is wrong is left out, and the search goes on within it. Keeps at most
/// one message in memory, of a payload of up to 8192 bytes; longer ones are passed over.
class UbxFraming {
 public:
  using Found = std::function<void(const UbxMessage&)>;

  /// Takes the bytes that came next and calls `found` for each message that is whole with them.
  void take(std::string_view bytes, const Found& found);

  [[nodiscard]] std::size_t messages() const { return messages_; }
  [[nodiscard]] std::size_t checksum_errors() const { return checksum_errors_; }

 private:
  /// Handles what begins at `first` of the buffer and gives how many bytes are done with; 0: more are needed.
  std::size_t step(std::size_t first, const Found& found);

  std::string buffer_;
  std::size_t messages_ = 0;
  std::size_t checksum_errors_ = 0;
};

}  // namespace multipath_localization
