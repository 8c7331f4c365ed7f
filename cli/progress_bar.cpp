#include "cli/progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace ocelli {
namespace {

constexpr int kBarCells = 30;
constexpr std::chrono::milliseconds kRedrawInterval(100);

}  // namespace

bool ProgressBar::possible() {
  const char* terminal = std::getenv("TERM");
  return isatty(STDERR_FILENO) == 1 && terminal != nullptr && std::string_view(terminal) != "dumb";
}

void ProgressBar::show(std::string_view stage, double fraction) {
  const std::scoped_lock lock(mutex_);
  const auto now = std::chrono::steady_clock::now();
  if (drawn_ && stage == stage_ && fraction < 1 && now - drawnAt_ < kRedrawInterval) {
    return;
  }
  stage_ = stage;
  drawnAt_ = now;
  drawn_ = true;
  if (!std::isfinite(fraction)) {
    std::fprintf(stderr, "\r\033[K%s", stage_.c_str());
  } else {
    const double part = std::clamp(fraction, 0.0, 1.0);
    const auto full = static_cast<size_t>(std::lround(part * kBarCells));
    std::fprintf(stderr, "\r\033[K%s [%s%s] %3d%%", stage_.c_str(), std::string(full, '#').c_str(),
                 std::string(kBarCells - full, '.').c_str(), static_cast<int>(part * 100));
  }
  std::fflush(stderr);
}

void ProgressBar::clear() {
  const std::scoped_lock lock(mutex_);
  if (drawn_) {
    std::fputs("\r\033[K", stderr);
    std::fflush(stderr);
    drawn_ = false;
  }
}

}  // namespace ocelli
