#include "receiver/byte_source.hpp"

#include <fcntl.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <memory>
#include <thread>
#include <utility>

namespace multipath_localization {

namespace {

constexpr std::size_t kMost = 4096;       // bytes at once
constexpr double kBetweenAttempts = 1.0;  // [s]
constexpr int kConnectPatience = 2000;    // [ms]
constexpr const char* kTcp = "tcp://";
/// Bits per second as people and as termios name them.
constexpr std::array<std::pair<int, speed_t>, 9> kRates = {{{9600, B9600},
                                                            {19200, B19200},
                                                            {38400, B38400},
                                                            {57600, B57600},
                                                            {115200, B115200},
                                                            {230400, B230400},
                                                            {460800, B460800},
                                                            {921600, B921600},
                                                            {0, B0}}};  // none set

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

bool is_tcp(const std::string& name) { return name.rfind(kTcp, 0) == 0; }

/// B0 for 0. Throws ParameterError.
speed_t rate_of(int baud) {
  for (const auto& [number, rate] : kRates) {
    if (number == baud) return rate;
  }
  throw ParameterError("baud: no serial line has a rate of " + std::to_string(baud));
}

struct Address {
  std::string host;
  std::string port;
};

Address address_of(const std::string& name) {
  const std::size_t first = std::strlen(kTcp);
  const std::size_t colon = name.rfind(':');
  if (colon <= first || colon + 1 == name.size()) {
    throw ParameterError("source: " + name + " is not tcp://host:port");
  }
  return {name.substr(first, colon - first), name.substr(colon + 1)};
}

/// Bytes as they are, at that rate, and no modem's signals waited for. False where it is no serial line.
bool make_raw(int descriptor, speed_t rate) {
  termios line{};
  if (tcgetattr(descriptor, &line) != 0) return false;
  cfmakeraw(&line);
  line.c_cflag |= CLOCAL | CREAD;
  if (rate != B0) cfsetspeed(&line, rate);
  return tcsetattr(descriptor, TCSANOW, &line) == 0;
}

/// A connected socket, or -1 and errno.
int connected(const addrinfo& address) {
  const int descriptor = socket(address.ai_family, address.ai_socktype | SOCK_NONBLOCK, address.ai_protocol);
  if (descriptor < 0) return -1;
  if (connect(descriptor, address.ai_addr, address.ai_addrlen) == 0) return descriptor;
  pollfd waiting{descriptor, POLLOUT, 0};
  int failure = errno;
  if (failure == EINPROGRESS) {
    failure = ETIMEDOUT;
    socklen_t size = sizeof(failure);
    if (poll(&waiting, 1, kConnectPatience) == 1) {
      getsockopt(descriptor, SOL_SOCKET, SO_ERROR, &failure, &size);
    }
    if (failure == 0) return descriptor;
  }
  ::close(descriptor);
  errno = failure;
  return -1;
}

}  // namespace

ByteSource::ByteSource(const std::string& name, int baud) : name_(name), baud_(baud) {
  static_cast<void>(rate_of(baud));
  if (is_tcp(name)) {
    static_cast<void>(address_of(name));
  } else if (name.empty() || name.front() != '/') {
    throw ParameterError("source: " + name + " is neither an absolute path nor tcp://host:port");
  }
}

ByteSource::~ByteSource() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::string ByteSource::read(double patience) {
  if (descriptor_ < 0 && !ended_ && now() >= next_attempt_) open();
  if (descriptor_ < 0 || (!file_ && !waited_for_bytes(patience))) {
    if (descriptor_ < 0) std::this_thread::sleep_for(std::chrono::duration<double>(patience));
    return {};
  }
  std::string bytes(kMost, '\0');
  const ssize_t count = ::read(descriptor_, bytes.data(), bytes.size());
  if (count > 0) {
    bytes.resize(static_cast<std::size_t>(count));
    return bytes;
  }
  const bool not_yet = count < 0 && (errno == EAGAIN || errno == EINTR);
  if (!not_yet) close(count == 0 ? "closed" : std::strerror(errno));
  return {};
}

void ByteSource::open() {
  next_attempt_ = now() + kBetweenAttempts;
  if (is_tcp(name_)) {
    open_tcp();
  } else {
    open_path();
  }
  if (descriptor_ >= 0) trouble_.clear();
}

void ByteSource::open_path() {
  descriptor_ = ::open(name_.c_str(), O_RDONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  struct stat kind {};
  if (descriptor_ < 0 || fstat(descriptor_, &kind) != 0) return close(std::strerror(errno));
  file_ = S_ISREG(kind.st_mode);
  if (isatty(descriptor_) == 1 && !make_raw(descriptor_, rate_of(baud_))) close(std::strerror(errno));
}

void ByteSource::open_tcp() {
  const Address address = address_of(name_);
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int failure = getaddrinfo(address.host.c_str(), address.port.c_str(), &hints, &found);
  if (failure != 0) return close(gai_strerror(failure));
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> owner(found, freeaddrinfo);
  for (const addrinfo* one = found; one != nullptr && descriptor_ < 0; one = one->ai_next) {
    descriptor_ = connected(*one);
  }
  if (descriptor_ < 0) close(std::strerror(errno));
}

void ByteSource::close(const std::string& why) {
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
  ended_ = file_;
  trouble_ = name_ + ": " + why;
}

bool ByteSource::waited_for_bytes(double patience) const {
  pollfd waiting{descriptor_, POLLIN, 0};
  return poll(&waiting, 1, static_cast<int>(1e3 * patience)) > 0;
}

}  // namespace multipath_localization
