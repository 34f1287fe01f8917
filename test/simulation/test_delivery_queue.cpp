#include <gtest/gtest.h>

#include "simulation/delivery_queue.hpp"

namespace multipath_localization {
namespace {

using Items = std::vector<int>;

TEST(DeliveryQueue, DeliversWhenItIsTimeAndOnce) {
  DeliveryQueue<int> queue;
  queue.send(1, 0.5);
  queue.send(2, 1.5);
  EXPECT_EQ(queue.take(0.4), Items{});
  EXPECT_EQ(queue.take(0.5), Items{1});
  EXPECT_EQ(queue.take(1.0), Items{});
  EXPECT_EQ(queue.take(2.0), Items{2});
}

TEST(DeliveryQueue, NothingOvertakes) {
  DeliveryQueue<int> queue;
  queue.send(1, 2.0);
  queue.send(2, 1.0);
  EXPECT_EQ(queue.take(1.9), Items{});
  EXPECT_EQ(queue.take(2.0), (Items{1, 2}));
}

}  // namespace
}  // namespace multipath_localization
