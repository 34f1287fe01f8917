#include <gtest/gtest.h>

#include "ros/messages/message_bytes.hpp"
#include "shaped.hpp"

namespace multipath_localization {
namespace {

TEST(MessageBytes, AreThoseThatWereSent) {
  const std::string bytes("\x01\x00\xFFz", 4);
  EXPECT_EQ(bytes_of(shaped("unknown_msgs/Any", bytes)), bytes);
}

}  // namespace
}  // namespace multipath_localization
