// A thread that walks and draws for the window, so that a frame that takes long holds up neither keys nor panels. It
// draws the newest wish: what was held and turned while a frame was drawn counts once, in the next.
//
//   ExploreWindowWork work(makeModel, ExploreWindowWork::Way::kThread);
//   work.want(motion, shape);                       // each frame of the window
//   work.tell([](ExploreWindowModel& model) { model.choose(2); return std::string(); });
//   const ExploreWindowStatus status = work.status();
//
// With kStepwise there is no thread, and step() does it: the same events then give the same pictures.
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/explore_window/explore_window_model.h"

namespace ocelli {

struct ExploreWindowMessage {
  std::string text;
  bool isError = false;
};

struct ExploreWindowStatus {
  std::shared_ptr<const WindowPicture> picture;  ///< the newest; null until there is one
  uint64_t pictureCount = 0;                     ///< how many there have been
  /// What is being done that takes long, such as reading the scene; empty for nothing.
  std::string stage;
  double fraction = 0;
  std::vector<ExploreWindowMessage> messages;  ///< since the last time
};

class ExploreWindowWork {
 public:
  enum class Way : uint8_t { kThread, kStepwise };
  using Make = std::function<std::unique_ptr<ExploreWindowModel>(const Progress& progress)>;
  /// Returns what the window shall say of it; empty for nothing. InputError and WorkError become messages.
  using Task = std::function<std::string(ExploreWindowModel& model)>;

  /// `woken` is called on the thread where there is something new to show; it may be empty.
  ExploreWindowWork(Make make, Way way, std::function<void()> woken = {});
  /// Waits for the frame that is being drawn. Long work ends where it next tells how far it is.
  ~ExploreWindowWork();
  ExploreWindowWork(const ExploreWindowWork&) = delete;
  ExploreWindowWork& operator=(const ExploreWindowWork&) = delete;

  /// Before the next frame, one after the other.
  void tell(Task task);
  /// `motion` holds until the next call, but what it was turned by, which adds up until a frame has taken it.
  void want(const WindowMotion& motion, const WindowShape& shape);
  /// With kStepwise: lets time pass and draws.
  void step(double seconds);

  /// Throws what the model could not be made for, or what ended the session.
  ExploreWindowStatus status();
  /// Whether another picture will come though nothing is asked for.
  bool isBusy() const;

 private:
  struct Wish {
    WindowMotion motion;
    WindowShape shape;
    std::vector<Task> tasks;
  };

  void run();
  /// Whether there is something to draw. Hold the lock.
  bool isWanted() const;
  Wish takeWish();
  void make();
  void drawNext(double seconds, Wish wish);
  void say(const std::string& text, bool isError);
  void wake() const;
  Progress progress();

  Make make_;
  std::function<void()> woken_;
  std::unique_ptr<ExploreWindowModel> model_;  ///< of the thread
  mutable std::mutex mutex_;                   ///< guards what follows
  std::condition_variable changed_;
  Wish wish_;
  WindowShape drawnShape_;
  bool hasDrawn_ = false;
  bool isMoving_ = false;
  bool isDrawing_ = false;
  bool stop_ = false;
  std::exception_ptr failure_;
  ExploreWindowStatus status_;
  std::thread thread_;
};

}  // namespace ocelli
