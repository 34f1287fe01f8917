#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>
#include <vector>

namespace multipath_localization {

/// A progress bar over several runs on stderr. Threads may share it.
class ProgressBar {
 public:
  /// Draws nothing unless `on_terminal`.
  ProgressBar(std::size_t runs, bool on_terminal);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// `fraction` in 0..1 of that run is done.
  void update(std::size_t run, double fraction);

 private:
  void draw(int percent);
  [[nodiscard]] std::string to_go(int percent) const;

  bool on_terminal_;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  std::mutex mutex_;
  std::vector<double> fractions_;
  int drawn_percent_ = -1;
};

}  // namespace multipath_localization
