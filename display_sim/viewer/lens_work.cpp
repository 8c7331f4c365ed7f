#include "display_sim/viewer/lens_work.h"

#include <algorithm>
#include <chrono>

#include "display_sim/viewer/error_message.h"

namespace ocelli {

size_t lensPreviewSize(std::span<const double> secondsOfSizes, double seconds) {
  constexpr double kHardlyLonger = 1.3;
  constexpr double kShareOfNext = 0.25;  // of an image half as wide, where that is not known
  std::vector<double> likely;
  for (const double known : secondsOfSizes) {
    likely.push_back(known > 0 ? known : likely.empty() ? 0 : likely.back() * kShareOfNext);
    if (likely.back() <= seconds) {
      return likely.size() - 1;
    }
  }
  const double fastest = *std::min_element(likely.begin(), likely.end());
  const auto found =
      std::find_if(likely.begin(), likely.end(), [&](double each) { return each <= kHardlyLonger * fastest; });
  return static_cast<size_t>(found - likely.begin());
}

LensWork::LensWork() : thread_([this] { run(); }) {}

LensWork::~LensWork() {
  {
    const std::scoped_lock lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void LensWork::want(const LensWanted& wanted) {
  {
    const std::scoped_lock lock(mutex_);
    if (wanted_ == wanted) {
      return;
    }
    wanted_ = wanted;
    fresh_ = true;
    busy_ = true;
  }
  changed_.notify_all();
}

LensStatus LensWork::status() const {
  const std::scoped_lock lock(mutex_);
  LensStatus status = status_;
  status.busy = busy_;
  return status;
}

void LensWork::waitUntilIdle() {
  std::unique_lock lock(mutex_);
  hurry_ = true;
  changed_.notify_all();  // make() may be waiting for the lenses to stand still
  changed_.wait(lock, [this] { return !busy_; });
  hurry_ = false;
}

void LensWork::run() {
  LensPainter painter;
  while (true) {
    LensWanted wanted;
    {
      std::unique_lock lock(mutex_);
      busy_ = fresh_;
      changed_.notify_all();
      changed_.wait(lock, [&] { return stop_ || fresh_; });
      if (stop_) {
        return;
      }
      wanted = wanted_;
      fresh_ = false;
    }
    if (!wanted.shows || wanted.scene == nullptr) {
      painter = {};  // gives its memory back
      seconds_ = {};
      const std::scoped_lock lock(mutex_);
      status_ = {};
      continue;
    }
    try {
      make(wanted, painter);
    } catch (const std::exception&) {
      const std::scoped_lock lock(mutex_);
      status_.picture = nullptr;
      status_.error = errorMessage(std::current_exception());
    }
  }
}

bool LensWork::isStillWanted(const LensWanted& wanted) const {
  const std::scoped_lock lock(mutex_);
  return !stop_ && wanted_ == wanted;
}

void LensWork::make(const LensWanted& wanted, LensPainter& painter) {
  bool hurries = false;
  {
    const std::scoped_lock lock(mutex_);
    hurries = hurry_;
  }
  const size_t first = hurries ? 0 : lensPreviewSize(seconds_, kLensFrameSeconds);
  draw(wanted, first, painter);
  if (first > 0) {
    constexpr double kStillSeconds = 0.15;
    {
      std::unique_lock lock(mutex_);
      changed_.wait_for(lock, std::chrono::duration<double>(kStillSeconds),
                        [&] { return stop_ || hurry_ || !(wanted_ == wanted); });
    }
    if (isStillWanted(wanted)) {
      draw(wanted, 0, painter);
    }
  }
}

void LensWork::draw(const LensWanted& wanted, size_t scale, LensPainter& painter) {
  const glm::ivec2 size = glm::max(glm::ivec2(glm::round(glm::dvec2(wanted.size) * kLensScales[scale])), glm::ivec2(1));
  const auto start = std::chrono::steady_clock::now();
  LensPicture picture{wanted, scale == 0, painter.paint(wanted, size), 0};
  seconds_[scale] = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  picture.milliseconds = 1000 * seconds_[scale];
  const std::scoped_lock lock(mutex_);
  status_.picture = std::make_shared<const LensPicture>(std::move(picture));
  status_.error.clear();
}

}  // namespace ocelli
