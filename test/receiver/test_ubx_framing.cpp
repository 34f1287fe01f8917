#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "receiver/ubx_framing.hpp"
#include "ubx_encoder.hpp"

namespace multipath_localization {
namespace {

struct Seen {
  std::vector<std::string> payloads;
  UbxFraming framing;

  void take(const std::string& bytes) {
    framing.take(bytes, [this](const UbxMessage& message) {
      EXPECT_EQ(message.kind, 2);
      EXPECT_EQ(message.id, 0x13);
      payloads.emplace_back(message.payload);
    });
  }
};

std::string message(const std::string& payload) { return ubx::frame(2, 0x13, payload); }

TEST(UbxFraming, FindsMessagesInWhateverPiecesTheyCome) {
  const std::string stream = message("one") + message("") + message(std::string(8192, 'x'));
  for (const std::size_t piece : {std::size_t{1}, std::size_t{7}, stream.size()}) {
    Seen seen;
    for (std::size_t i = 0; i < stream.size(); i += piece) seen.take(stream.substr(i, piece));
    EXPECT_EQ(seen.payloads, (std::vector<std::string>{"one", "", std::string(8192, 'x')})) << piece;
    EXPECT_EQ(seen.framing.messages(), 3U);
    EXPECT_EQ(seen.framing.checksum_errors(), 0U);
  }
}

TEST(UbxFraming, PassesOverWhatIsBetweenThem) {
  Seen seen;
  seen.take("$GNGGA,,,*00\r\n\xb5" + message("one") + "\xb5\xb5" + message("two") +
            std::string(1000, '\xd3'));
  EXPECT_EQ(seen.payloads, (std::vector<std::string>{"one", "two"}));
}

TEST(UbxFraming, LosesOneMessageByOneWrongByte) {
  const std::string good = message("payload");
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ 0x10);
    Seen seen;
    seen.take(good + bad + good + std::string(9000, ' '));
    EXPECT_EQ(seen.payloads.size(), 2U) << "byte " << i;
  }
}

TEST(UbxFraming, GoesOnWithinAMessageThatBrokeOff) {
  Seen seen;
  seen.take(message("cut off by a restart").substr(0, 12) + message("next") + message("and next"));
  EXPECT_EQ(seen.payloads, (std::vector<std::string>{"next", "and next"}));
  EXPECT_EQ(seen.framing.checksum_errors(), 1U);
}

TEST(UbxFraming, PassesOverMessagesLongerThanAnyThatIsRead) {
  Seen seen;
  seen.take(message(std::string(8193, 'x')) + message("next"));
  EXPECT_EQ(seen.payloads, std::vector<std::string>{"next"});
}

}  // namespace
}  // namespace multipath_localization
