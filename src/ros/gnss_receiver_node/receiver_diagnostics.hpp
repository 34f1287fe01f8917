#pragma once

#include <diagnostic_updater/diagnostic_updater.h>

#include <cstddef>
#include <string>

#include "receiver/byte_source.hpp"
#include "receiver/live_positioning.hpp"
#include "receiver/ubx_receiver.hpp"

namespace multipath_localization {

/// The status `receiver` on /diagnostics: how the stream is, in one sentence, and its figures.
class ReceiverDiagnostics {
 public:
  /// Looks at its arguments whenever it reports; they have to outlive it. `source`: nothing where a driver's
  /// topics are read.
  ReceiverDiagnostics(const ByteSource* source, const UbxReceiver& receiver,
                      const LivePositioning& positioning);

  /// Publishes it, once a second at most.
  void report() { updater_.update(); }

  void add_bytes(std::size_t count) { bytes_ += count; }
  /// An epoch that came, by which the host's clock is `ahead` of the receiver's [s]; whether it was
  /// published.
  void add_epoch(double ahead, bool published);
  /// A message of a topic that is not what it should be.
  void add_refused(const std::string& topic) { refused_ = topic; }

 private:
  using Status = diagnostic_updater::DiagnosticStatusWrapper;

  void tell(Status& status);
  [[nodiscard]] std::string what_is_wrong(double seconds) const;

  const ByteSource* source_;
  const UbxReceiver& receiver_;
  const LivePositioning& positioning_;
  std::size_t bytes_ = 0;      ///< since the last report
  std::size_t epochs_ = 0;     ///< likewise
  std::size_t published_ = 0;  ///< likewise
  double host_ahead_ = 0.0;    ///< at the last epoch [s]
  std::string refused_;        ///< topic
  ros::WallTime reported_ = ros::WallTime::now();
  diagnostic_updater::Updater updater_;
};

}  // namespace multipath_localization
