#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <memory>
#include <vector>

#include "support/background_writer.hpp"

namespace multipath_localization {
namespace {

/// A disk that is written to when it is let.
class SlowDisk {
 public:
  void write(int what) {
    begun_.set_value();
    let_.get_future().wait();
    written_.push_back(what);
  }
  void wait_for_the_first() { begun_.get_future().wait(); }
  void let_go() { let_.set_value(); }
  /// For further writes, which need not wait.
  void add(int what) { written_.push_back(what); }
  [[nodiscard]] const std::vector<int>& written() const { return written_; }

 private:
  std::promise<void> begun_, let_;
  std::vector<int> written_;
};

TEST(BackgroundWriter, KeepsNobodyWaitingAndWritesTheLatest) {
  SlowDisk disk;
  {
    BackgroundWriter writer;
    writer.write([&] { disk.write(1); });
    disk.wait_for_the_first();
    for (int i = 2; i <= 5; ++i) writer.write([&disk, i] { disk.add(i); });
    disk.let_go();
  }
  EXPECT_EQ(disk.written(), (std::vector<int>{1, 5}));
}

TEST(BackgroundWriter, HasWrittenTheLastWhenItIsGone) {
  for (int times = 0; times < 100; ++times) {
    int last = 0;
    {
      BackgroundWriter writer;
      for (int i = 1; i <= 3; ++i) writer.write([&last, i] { last = i; });
    }
    ASSERT_EQ(last, 3);
  }
}

TEST(BackgroundWriter, EndsWithNothingToWrite) { const BackgroundWriter writer; }

TEST(BackgroundWriter, WritesWithoutBeingAskedTwice) {
  BackgroundWriter writer;
  for (int i = 0; i < 3; ++i) {
    auto done = std::make_shared<std::promise<void>>();
    writer.write([done] { done->set_value(); });
    EXPECT_EQ(done->get_future().wait_for(std::chrono::seconds(10)), std::future_status::ready);
  }
}

}  // namespace
}  // namespace multipath_localization
