#include "evaluation/progress.hpp"

#include <cmath>
#include <cstdio>
#include <numeric>
#include <string>

namespace multipath_localization {

namespace {

constexpr int kWidth = 40;

}  // namespace

ProgressBar::ProgressBar(std::size_t runs, bool on_terminal)
    : on_terminal_(on_terminal), fractions_(runs, 0.0) {
  if (on_terminal_) draw(0);
}

ProgressBar::~ProgressBar() {
  if (on_terminal_) std::fprintf(stderr, "\r%*s\r", kWidth + 40, "");
}

void ProgressBar::update(std::size_t run, double fraction) {
  if (!on_terminal_) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  fractions_[run] = fraction;
  const double done = std::accumulate(fractions_.begin(), fractions_.end(), 0.0);
  const int percent = static_cast<int>(100.0 * done / static_cast<double>(fractions_.size()));
  if (percent != drawn_percent_) draw(percent);
}

std::string ProgressBar::to_go(int percent) const {
  if (percent == 0 || percent == 100) return "";
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begun_;
  const double minutes = passed.count() / 60.0 * (100 - percent) / percent;
  return ", " + std::to_string(std::lround(std::ceil(minutes))) + " min to go ";
}

void ProgressBar::draw(int percent) {
  drawn_percent_ = percent;
  std::size_t ended = 0;
  for (const double fraction : fractions_) ended += fraction >= 1.0 ? 1 : 0;
  const auto full = static_cast<std::size_t>(kWidth * percent / 100);
  const std::string bar = std::string(full, '#') + std::string(kWidth - full, '.');
  std::fprintf(stderr, "\r[%s] %3d %%  %zu of %zu runs%s", bar.c_str(), percent, ended, fractions_.size(),
               to_go(percent).c_str());
  std::fflush(stderr);
}

}  // namespace multipath_localization
