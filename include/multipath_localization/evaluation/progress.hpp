#pragma once

#include <cstddef>
#include <mutex>
#include <vector>

namespace multipath_localization {

/// A progress bar over several runs on stderr, drawn only when that is a terminal. Threads may share it.
class ProgressBar {
 public:
  explicit ProgressBar(std::size_t runs);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// `fraction` in 0..1 of that run is done.
  void update(std::size_t run, double fraction);

 private:
  void draw(int percent);

  bool on_terminal_;
  std::mutex mutex_;
  std::vector<double> fractions_;
  int drawn_percent_ = -1;
};

}  // namespace multipath_localization
