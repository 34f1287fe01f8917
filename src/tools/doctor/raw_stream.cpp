#include "tools/doctor/raw_stream.hpp"

#include <algorithm>
#include <chrono>

#include "multipath_localization/core/angle.hpp"
#include "receiver/byte_source.hpp"

namespace multipath_localization {

namespace {

constexpr double kPatience = 0.05;        // for bytes [s]
constexpr double kBadShare = 0.01;        // of messages
constexpr double kLeastRate = 0.9;        // of epochs [Hz]
constexpr double kLongestGap = 5.0;       // between epochs [s]
constexpr double kAllEphemerides = 60.0;  // by then each satellite in sight has told its own [s]
constexpr double kElevationMask = 5.0 * kPi / 180.0;

double duration_of(const RawStream& seen) {
  return seen.epochs.size() < 2 ? 0.0 : seen.epochs.back() - seen.epochs.front();
}

double longest_gap(const RawStream& seen) {
  double longest = 0.0;
  for (std::size_t i = 1; i < seen.epochs.size(); ++i) {
    longest = std::max(longest, seen.epochs[i] - seen.epochs[i - 1]);
  }
  return longest;
}

Finding check_messages(const RawStream& seen) {
  if (seen.messages == 0) {
    return fix(text("stream: %zu bytes, and no UBX message among them", seen.bytes),
               "set baud to the rate of the receiver's port, and let that send UBX (CFG-UART1OUTPROT-UBX 1)");
  }
  if (static_cast<double>(seen.checksum_errors) > kBadShare * static_cast<double>(seen.messages)) {
    return fix(text("stream: %zu of %zu messages with a wrong checksum", seen.checksum_errors,
                    seen.messages + seen.checksum_errors),
               "take USB, a faster rate (baud: 460800) or a shorter cable: the line loses bytes");
  }
  return pass(text("stream: %zu UBX messages", seen.messages));
}

Finding check_subframes(const RawStream& seen) {
  if (seen.counts.subframes > 0) return pass(text("stream: %zu RXM-SFRBX", seen.counts.subframes));
  return fix("stream: no RXM-SFRBX, by which satellites tell their orbits",
             "enable it: CFG-MSGOUT-UBX_RXM_SFRBX_USB 1 (M8: CFG-MSG 02 13), and save the configuration");
}

Finding check_epochs(const RawStream& seen) {
  if (seen.epochs.empty()) {
    return fix("stream: no RXM-RAWX, which holds the measurements",
               "enable it: CFG-MSGOUT-UBX_RXM_RAWX_USB 1 (M8: CFG-MSG 02 15), and save the configuration; "
               "receivers for raw data are M8T, F9P, F9T, X20P and the like");
  }
  const double duration = duration_of(seen);
  const double gap = longest_gap(seen);
  if (duration == 0.0) return untold("stream: one RXM-RAWX alone: watch for longer");
  const double rate = static_cast<double>(seen.epochs.size() - 1) / duration;
  if (rate < kLeastRate || gap > kLongestGap) {
    return fix(text("stream: RXM-RAWX at %.2f Hz, longest gap %.1f s", rate, gap),
               "ask for 1 to 10 Hz (CFG-RATE-MEAS 200), on a line that is fast enough for it: baud 115200 "
               "holds 4 Hz of 80 signals");
  }
  return pass(text("stream: RXM-RAWX at %.2f Hz, longest gap %.1f s, the clock was moved %zu times", rate,
                   gap, seen.counts.clock_resets));
}

Finding check_positions(const RawStream& seen) {
  const LivePositioning::Standing& last = seen.last;
  if (seen.with_position > 0 && last.shortage.empty()) {
    return pass(text("stream: %zu of %zu epochs corrected, the last by %zu of %zu satellites",
                     seen.with_position, seen.epochs.size(), last.used, last.heard));
  }
  const std::string what = "stream: " + last.shortage;
  if (last.heard == 0) return fix(what, "put the antenna where it sees the sky, and check its plug");
  if (duration_of(seen) < kAllEphemerides) return untold(what + ": watch for a minute (--seconds 60)");
  return fix(what,
             "give the antenna more sky, or the node a RINEX navigation file of today (navigation_file)");
}

}  // namespace

RawStream observe_stream(const std::string& source, int baud, double seconds) {
  using Clock = std::chrono::steady_clock;
  RawStream seen;
  seen.name = source;
  ByteSource bytes(source, baud);
  LivePositioning positioning({kElevationMask,
                               {Constellation::kGps, Constellation::kGlonass, Constellation::kGalileo,
                                Constellation::kBeidou, Constellation::kQzss}});
  UbxReceiver receiver(positioning.navigation(), [&](const ReceiverEpoch& epoch) {
    seen.epochs.push_back(epoch.raw.time);
    seen.with_position += positioning.correct(epoch.raw) ? 1 : 0;
  });
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  while (bytes.is_file() ? !bytes.ended() : Clock::now() < end) {
    const std::string some = bytes.read(kPatience);
    seen.bytes += some.size();
    receiver.take(some);
  }
  seen.trouble = bytes.is_file() ? "" : bytes.trouble();
  seen.messages = receiver.framing().messages();
  seen.checksum_errors = receiver.framing().checksum_errors();
  seen.counts = receiver.counts();
  seen.last = positioning.standing();
  return seen;
}

Findings check_stream(const RawStream& seen) {
  if (seen.bytes == 0) {
    return {fix("stream: nothing from " + seen.name + (seen.trouble.empty() ? "" : " (" + seen.trouble + ")"),
                "name the receiver's port, end other programs that read it, and be in the group dialout")};
  }
  Findings findings = {check_messages(seen)};
  if (seen.messages == 0) return findings;
  findings.push_back(check_epochs(seen));
  findings.push_back(check_subframes(seen));
  if (!seen.epochs.empty()) findings.push_back(check_positions(seen));
  return findings;
}

}  // namespace multipath_localization
