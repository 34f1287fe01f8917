#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "../evaluation/temporary_folder.hpp"
#include "../receiver/ubx_encoder.hpp"
#include "found.hpp"
#include "tools/doctor/raw_stream.hpp"

namespace multipath_localization {
namespace {

/// 30 s of a receiver that stands under open sky.
std::string standing() {
  std::stringstream bytes;
  bytes << std::ifstream(CONFIG_DIR "/../test/rostest/standing.ubx", std::ios::binary).rdbuf();
  return bytes.str();
}

Findings found_in(const std::string& bytes) {
  const TemporaryFolder folder;
  return check_stream(observe_stream(folder.write("rover.ubx", bytes), 0, 1.0));
}

/// Without the messages of that identifier.
std::string without(std::uint8_t identifier) {
  std::string kept;
  UbxFraming framing;
  framing.take(standing(), [&](const UbxMessage& message) {
    if (message.id != identifier) kept += ubx::frame(message.kind, message.id, std::string(message.payload));
  });
  return kept;
}

TEST(CheckStream, FindsNothingToFixInAGoodOne) {
  const Findings findings = found_in(standing());
  EXPECT_TRUE(Passes(findings));
  EXPECT_EQ(findings.size(), 4U);
  EXPECT_NE(findings[1].what.find("RXM-RAWX at 4.87 Hz, longest gap 1.0 s"), std::string::npos)
      << findings[1].what;
}

TEST(CheckStream, NamesWhatIsNotEnabled) {
  EXPECT_TRUE(ToFix(found_in(without(0x15)), "no RXM-RAWX", "CFG-MSGOUT-UBX_RXM_RAWX_USB 1"));
  EXPECT_TRUE(ToFix(found_in(without(0x13)), "no RXM-SFRBX", "CFG-MSGOUT-UBX_RXM_SFRBX_USB 1"));
}

TEST(CheckStream, KnowsALineThatIsTooSlowOrSetToAnotherRate) {
  EXPECT_TRUE(ToFix(found_in(std::string(5000, '\x7f')), "no UBX message", "set baud"));
  std::string lossy = standing();
  for (std::size_t i = 0; i < lossy.size(); i += 3000) lossy[i] = '\0';
  EXPECT_TRUE(ToFix(found_in(lossy), "wrong checksum", "loses bytes"));
  const std::string rawx = ubx::frame(2, 0x15, ubx::rawx_payload({2320, 100.0}, ""));
  const std::string later = ubx::frame(2, 0x15, ubx::rawx_payload({2320, 110.0}, ""));
  EXPECT_TRUE(ToFix(found_in(rawx + later), "RXM-RAWX at 0.10 Hz, longest gap 10.0 s", "CFG-RATE-MEAS"));
}

TEST(CheckStream, SaysThatNothingComes) {
  EXPECT_TRUE(ToFix(check_stream(observe_stream("/dev/no_such_line", 0, 0.1)), "No such file", "dialout"));
  EXPECT_TRUE(ToFix(found_in(""), "nothing from", "dialout"));
}

TEST(CheckStream, TellsAnAntennaWithoutSkyFromAWaitThatIsTooShort) {
  std::string bytes;
  for (int i = 0; i < 5; ++i) bytes += ubx::frame(2, 0x15, ubx::rawx_payload({2320, 100.0 + i}, ""));
  EXPECT_TRUE(ToFix(found_in(bytes), "no satellite heard", "sky"));
  const Findings early = found_in(without(0x13));
  EXPECT_EQ(early.back().verdict, Finding::Verdict::kUntold);
  EXPECT_NE(early.back().what.find("--seconds 60"), std::string::npos);
}

}  // namespace
}  // namespace multipath_localization
