#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include <chrono>

#include "../evaluation/temporary_folder.hpp"
#include "receiver/byte_source.hpp"

namespace multipath_localization {
namespace {

/// What comes until that many bytes are there, or two seconds are over.
std::string read_all(ByteSource& source, std::size_t count) {
  std::string bytes;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(2);
  while (bytes.size() < count && std::chrono::steady_clock::now() < end) bytes += source.read(0.02);
  return bytes;
}

TEST(ByteSource, ReadsAFileOnceToItsEnd) {
  const TemporaryFolder folder;
  const std::string content(10000, '\x0d');
  ByteSource source(folder.write("log.ubx", content), 0);
  EXPECT_EQ(read_all(source, content.size()), content);
  EXPECT_TRUE(source.is_file());
  EXPECT_FALSE(source.ended());
  EXPECT_EQ(source.read(0.01), "");
  EXPECT_TRUE(source.ended());
  EXPECT_EQ(source.read(0.01), "");
}

TEST(ByteSource, ReadsASerialLineAsItIs) {
  const int line = posix_openpt(O_RDWR | O_NOCTTY);
  ASSERT_GE(line, 0);
  ASSERT_EQ(grantpt(line), 0);
  ASSERT_EQ(unlockpt(line), 0);
  ByteSource source(ptsname(line), 115200);
  EXPECT_EQ(source.read(0.01), "") << "opens it";
  EXPECT_TRUE(source.trouble().empty()) << source.trouble();
  const std::string content("\xb5\x62\r\n\x03\x04\x11\x13\x00\xff", 10);
  ASSERT_EQ(write(line, content.data(), content.size()), static_cast<ssize_t>(content.size()));
  EXPECT_EQ(read_all(source, content.size()), content);
  termios state{};
  ASSERT_EQ(tcgetattr(line, &state), 0);
  EXPECT_EQ(cfgetispeed(&state), static_cast<speed_t>(B115200));
  close(line);
  for (int i = 0; i < 5 && source.trouble().empty(); ++i) source.read(0.01);
  EXPECT_FALSE(source.trouble().empty()) << "unplugged";
  EXPECT_FALSE(source.ended());
}

/// A TCP server on this machine.
class Server {
 public:
  explicit Server(std::uint16_t port = 0) : socket_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(port);
    const int again = 1;
    setsockopt(socket_, SOL_SOCKET, SO_REUSEADDR, &again, sizeof(again));
    socklen_t size = sizeof(address);
    EXPECT_EQ(bind(socket_, reinterpret_cast<sockaddr*>(&address), size), 0);
    EXPECT_EQ(listen(socket_, 1), 0);
    getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size);
    port_ = ntohs(address.sin_port);
  }
  ~Server() { close(socket_); }
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  [[nodiscard]] std::string name() const { return "tcp://127.0.0.1:" + std::to_string(port_); }
  /// Sends that to who has connected, and hangs up.
  void serve(const std::string& bytes) const {
    const int client = accept(socket_, nullptr, nullptr);
    EXPECT_EQ(send(client, bytes.data(), bytes.size(), 0), static_cast<ssize_t>(bytes.size()));
    close(client);
  }

 private:
  int socket_;
  std::uint16_t port_ = 0;
};

TEST(ByteSource, ConnectsToAServerAgainWhenThatHangsUp) {
  const Server server;
  ByteSource source(server.name(), 0);
  source.read(0.0);
  EXPECT_TRUE(source.trouble().empty()) << source.trouble();
  server.serve("one");
  EXPECT_EQ(read_all(source, 3), "one");
  EXPECT_EQ(source.read(0.1), "");
  EXPECT_EQ(source.trouble(), server.name() + ": closed");
  while (!source.trouble().empty()) source.read(0.02);
  server.serve("two");
  EXPECT_EQ(read_all(source, 3), "two");
}

TEST(ByteSource, SaysWhyItCannotBeOpened) {
  ByteSource missing("/dev/no_such_line", 9600);
  EXPECT_EQ(missing.read(0.0), "");
  EXPECT_EQ(missing.trouble(), "/dev/no_such_line: No such file or directory");
  EXPECT_FALSE(missing.ended());
  ByteSource refused("tcp://127.0.0.1:1", 0);
  EXPECT_EQ(refused.read(0.0), "");
  EXPECT_EQ(refused.trouble(), "tcp://127.0.0.1:1: Connection refused");
}

TEST(ByteSource, RefusesNamesAndRatesOfNoKind) {
  for (const char* name :
       {"", "ttyACM0", "tcp://", "tcp://host", "tcp://host:", "tcp://:2101", "http://host:1"}) {
    EXPECT_THROW(ByteSource(name, 0), ParameterError) << name;
  }
  EXPECT_THROW(ByteSource("/dev/ttyACM0", 12345), ParameterError);
}

}  // namespace
}  // namespace multipath_localization
