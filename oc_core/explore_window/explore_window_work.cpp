#include "oc_core/explore_window/explore_window_work.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <utility>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

using ExploreClock = std::chrono::steady_clock;

/// Of a step: who walks does not leap where a frame took long.
constexpr double kMaxExploreSeconds = 0.1;
/// A step after a rest.
constexpr double kExploreFrameSeconds = 1.0 / 60;

/// Thrown through work whose window has closed.
struct ExploreWindowClosed {};

bool isHeld(const WindowMotion& motion) {
  return !(motion == WindowMotion{.fast = motion.fast});
}

}  // namespace

ExploreWindowWork::ExploreWindowWork(Make make, Way way, std::function<void()> woken)
    : make_(std::move(make)), woken_(std::move(woken)) {
  if (way == Way::kThread) {
    thread_ = std::thread([this] { run(); });
  }
}

ExploreWindowWork::~ExploreWindowWork() {
  {
    const std::scoped_lock lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) {
    thread_.join();
  }
}

void ExploreWindowWork::tell(Task task) {
  {
    const std::scoped_lock lock(mutex_);
    wish_.tasks.push_back(std::move(task));
  }
  changed_.notify_all();
}

void ExploreWindowWork::want(const WindowMotion& motion, const WindowShape& shape) {
  {
    const std::scoped_lock lock(mutex_);
    const glm::vec2 turned = wish_.motion.turnedDegrees + motion.turnedDegrees;
    wish_.motion = motion;
    wish_.motion.turnedDegrees = turned;
    wish_.shape = shape;
  }
  changed_.notify_all();
}

void ExploreWindowWork::say(const std::string& text, bool isError) {
  const std::scoped_lock lock(mutex_);
  if (!text.empty()) {
    status_.messages.push_back({text, isError});
  }
}

Progress ExploreWindowWork::progress() {
  return [this](std::string_view stage, double fraction) {
    {
      const std::scoped_lock lock(mutex_);
      if (stop_) {
        throw ExploreWindowClosed{};
      }
      status_.stage = stage;
      status_.fraction = std::clamp(fraction, 0.0, 1.0);
    }
    wake();
  };
}

void ExploreWindowWork::wake() const {
  if (woken_) {
    woken_();
  }
}

bool ExploreWindowWork::isWanted() const {
  return !hasDrawn_ || isMoving_ || isHeld(wish_.motion) || !wish_.tasks.empty() || !(wish_.shape == drawnShape_);
}

ExploreWindowWork::Wish ExploreWindowWork::takeWish() {
  Wish wish = wish_;
  wish_.motion.turnedDegrees = {0, 0};
  wish_.tasks.clear();
  return wish;
}

void ExploreWindowWork::make() {
  model_ = make_(progress());
  const std::scoped_lock lock(mutex_);
  status_.stage.clear();
}

void ExploreWindowWork::drawNext(double seconds, Wish wish) {
  for (const Task& task : wish.tasks) {
    try {
      say(task(*model_), false);
    } catch (const Error& error) {
      say(error.what(), true);
    } catch (const std::bad_alloc&) {
      say("out of memory\n  try: a smaller scene or a smaller window", true);
    }
  }
  model_->advance(seconds, wish.motion);
  auto picture = std::make_shared<const WindowPicture>(model_->draw(wish.shape));
  const std::scoped_lock lock(mutex_);
  isMoving_ = picture->isMoving;
  drawnShape_ = wish.shape;
  hasDrawn_ = true;
  status_.picture = std::move(picture);
  ++status_.pictureCount;
  status_.stage.clear();
}

void ExploreWindowWork::step(double seconds) {
  if (!model_) {
    make();
  }
  Wish wish;
  {
    const std::scoped_lock lock(mutex_);
    wish = takeWish();
  }
  drawNext(seconds, std::move(wish));
}

void ExploreWindowWork::run() {
  try {
    make();
    for (ExploreClock::time_point last = ExploreClock::now();;) {
      Wish wish;
      double seconds = 0;
      {
        std::unique_lock lock(mutex_);
        const bool rests = !stop_ && !isWanted();
        isDrawing_ = false;
        changed_.wait(lock, [this] { return stop_ || isWanted(); });
        if (stop_) {
          return;
        }
        isDrawing_ = true;
        wish = takeWish();
        const auto now = ExploreClock::now();
        seconds = rests ? kExploreFrameSeconds
                        : std::min(std::chrono::duration<double>(now - last).count(), kMaxExploreSeconds);
        last = now;
      }
      drawNext(seconds, std::move(wish));
      wake();
      // No more frames than screens show.
      std::this_thread::sleep_until(last + std::chrono::duration_cast<ExploreClock::duration>(
                                               std::chrono::duration<double>(kExploreFrameSeconds)));
    }
  } catch (const ExploreWindowClosed&) {  // nobody waits for it
  } catch (...) {
    const std::scoped_lock lock(mutex_);
    failure_ = std::current_exception();
    isDrawing_ = false;
  }
  wake();
}

ExploreWindowStatus ExploreWindowWork::status() {
  const std::scoped_lock lock(mutex_);
  if (failure_) {
    std::rethrow_exception(failure_);
  }
  ExploreWindowStatus status = status_;
  status_.messages.clear();
  return status;
}

bool ExploreWindowWork::isBusy() const {
  const std::scoped_lock lock(mutex_);
  return !failure_ && (isDrawing_ || isWanted());
}

}  // namespace ocelli
