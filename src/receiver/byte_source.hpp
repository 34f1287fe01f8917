#pragma once

#include <string>

#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

/// A stream of bytes by its name: a serial line ("/dev/ttyACM0"), a file ("/home/me/drive.ubx"), or a TCP
/// server ("tcp://host:port"). What closes or cannot be opened is opened again once a second, but for a file,
/// which is read once.
class ByteSource {
 public:
  /// `baud`: of a serial line that has a rate; 0 leaves it as it is, as for USB. Throws ParameterError on a
  /// name of none of these kinds and on a rate that no line has.
  ByteSource(const std::string& name, int baud);
  ~ByteSource();
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;

  /// What has come, up to 4096 bytes; waits up to `patience` [s] for the first. Empty where nothing came.
  std::string read(double patience);

  /// Whether it is a file, and whether that has been read to its end.
  [[nodiscard]] bool is_file() const { return file_; }
  [[nodiscard]] bool ended() const { return ended_; }

  /// Why it is not open: "/dev/ttyACM0: Permission denied"; empty while it is.
  [[nodiscard]] const std::string& trouble() const { return trouble_; }

 private:
  void open();
  void open_path();
  void open_tcp();
  void close(const std::string& why);
  [[nodiscard]] bool waited_for_bytes(double patience) const;

  std::string name_;
  int baud_;
  bool file_ = false;
  bool ended_ = false;
  int descriptor_ = -1;
  double next_attempt_ = 0.0;  ///< to open it, by the steady clock [s]
  std::string trouble_ = "not open yet";
};

}  // namespace multipath_localization
