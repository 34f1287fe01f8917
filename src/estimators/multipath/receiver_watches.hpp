#pragma once

#include <cstddef>
#include <map>

#include "estimators/multipath/receiver_watch.hpp"

namespace multipath_localization::multipath {

/// The watch over each receiver, by GnssFix::receiver.
class ReceiverWatches {
 public:
  /// That of a receiver; of a new one the errors go on since `since` [s].
  ReceiverWatch& of(std::size_t receiver, double since) {
    return watches_.try_emplace(receiver, since).first->second;
  }

  /// The base has moved on by that, in its own frame.
  void move(const Pose2& step);
  /// A first fix has been used otherwise.
  void begin(double now);
  /// One whose fixes wait for others that do not come, if any.
  [[nodiscard]] ReceiverWatch* overdue(double now);
  /// Variance of what a receiver may have begun wrong by, an axis [m^2]; none of one that is not watched.
  [[nodiscard]] double doubt(std::size_t receiver, double now) const;

 private:
  std::map<std::size_t, ReceiverWatch> watches_;
};

}  // namespace multipath_localization::multipath
