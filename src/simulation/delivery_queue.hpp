#pragma once

#include <algorithm>
#include <deque>
#include <utility>
#include <vector>

namespace multipath_localization {

/// What is under way from a receiver to whom it may concern: a line that delivers in the order of sending.
template <class Item>
class DeliveryQueue {
 public:
  /// Sends something that arrives at `time` [s], but not before what was sent earlier.
  void send(Item item, double time) {
    const double after_last = under_way_.empty() ? time : under_way_.back().time;
    under_way_.push_back({std::max(time, after_last), std::move(item)});
  }

  /// What has arrived by `time` [s] and was not taken before.
  std::vector<Item> take(double time) {
    std::vector<Item> arrived;
    while (!under_way_.empty() && under_way_.front().time <= time + kRounding) {
      arrived.push_back(std::move(under_way_.front().item));
      under_way_.pop_front();
    }
    return arrived;
  }

 private:
  struct Delivery {
    double time;
    Item item;
  };
  static constexpr double kRounding = 1e-9;  ///< of a sum of time steps [s]

  std::deque<Delivery> under_way_;
};

}  // namespace multipath_localization
