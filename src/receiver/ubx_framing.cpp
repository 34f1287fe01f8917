#include "receiver/ubx_framing.hpp"

#include <algorithm>

namespace multipath_localization {

namespace {

constexpr char kSync1 = '\xb5', kSync2 = '\x62';
constexpr std::size_t kHeader = 6;             // sync, class, id, length
constexpr std::size_t kChecksum = 2;           // bytes
constexpr std::size_t kLongestPayload = 8192;  // of RXM-RAWX with 255 measurements: 8176 bytes

std::size_t byte_at(std::string_view bytes, std::size_t place) {
  return static_cast<unsigned char>(bytes[place]);
}

/// Fletcher's, over all but the sync characters and the checksum itself.
bool checksum_holds(std::string_view frame) {
  unsigned a = 0;
  unsigned b = 0;
  for (std::size_t i = 2; i < frame.size() - kChecksum; ++i) {
    a = (a + static_cast<unsigned>(byte_at(frame, i))) & 0xFFU;
    b = (b + a) & 0xFFU;
  }
  return a == byte_at(frame, frame.size() - 2) && b == byte_at(frame, frame.size() - 1);
}

}  // namespace

void UbxFraming::take(std::string_view bytes, const Found& found) {
  buffer_.append(bytes);
  std::size_t done = 0;
  while (done < buffer_.size()) {
    const std::size_t handled = step(done, found);
    if (handled == 0) break;
    done += handled;
  }
  buffer_.erase(0, done);
}

std::size_t UbxFraming::step(std::size_t first, const Found& found) {
  const std::string_view rest = std::string_view(buffer_).substr(first);
  if (rest[0] != kSync1) return std::min(rest.find(kSync1), rest.size());
  if (rest.size() > 1 && rest[1] != kSync2) return 1;
  if (rest.size() < kHeader) return 0;
  const std::size_t length = byte_at(rest, 4) + 256 * byte_at(rest, 5);
  if (length > kLongestPayload) return 1;
  const std::size_t whole = kHeader + length + kChecksum;
  if (rest.size() < whole) return 0;
  if (!checksum_holds(rest.substr(0, whole))) {
    ++checksum_errors_;
    return 1;
  }
  ++messages_;
  found({static_cast<std::uint8_t>(byte_at(rest, 2)), static_cast<std::uint8_t>(byte_at(rest, 3)),
         rest.substr(kHeader, length)});
  return whole;
}

}  // namespace multipath_localization
