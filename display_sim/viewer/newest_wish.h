// A thread that makes what is wanted, the newest wish first: what every kind of work in the background has in common
// whose older wishes are of no use any more.
//
//   struct Status { bool busy = false; ... };           // what has come of the wishes
//   NewestWish<Wanted, Status> wishes([&](const Wanted& wanted) { ... wishes.change(...); });
//   wishes.want(a); wishes.want(b);                     // a is made at most in part
//
// Whoever owns it declares it last, so that its thread has ended before what it works with goes.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>

namespace ocelli {

/// `Wanted` can be copied and compared; one that is as a default Wanted asks for nothing at first. `Status` can be
/// copied, and its member `busy` is set by status().
template <class Wanted, class Status>
class NewestWish {
 public:
  /// Runs on the thread, for one wish after the other; those that newer ones have overtaken before it began are left
  /// out. It must not throw.
  using Make = std::function<void(const Wanted& wanted)>;

  explicit NewestWish(Make make) : make_(std::move(make)), thread_([this] { run(); }) {}
  /// Waits for what is being made.
  ~NewestWish() {
    {
      const std::scoped_lock lock(mutex_);
      stop_ = true;
    }
    changed_.notify_all();
    thread_.join();
  }
  NewestWish(const NewestWish&) = delete;
  NewestWish& operator=(const NewestWish&) = delete;

  /// Nothing happens where it is the newest wish already.
  void want(const Wanted& wanted) {
    {
      const std::scoped_lock lock(mutex_);
      if (wanted_ == wanted) {
        return;
      }
      wanted_ = wanted;
      fresh_ = busy_ = true;
    }
    changed_.notify_all();
  }

  Status status() const {
    const std::scoped_lock lock(mutex_);
    Status status = status_;
    status.busy = busy_;
    return status;
  }

  /// Until the newest wish has been made. Meanwhile someoneWaits(). Where `again(wanted, status)`, it is made once more
  /// though it has been made already: something was left out.
  template <class Again>
  void waitUntilIdle(const Again& again) {
    std::unique_lock lock(mutex_);
    hurry_ = true;
    if (again(std::as_const(wanted_), std::as_const(status_))) {
      fresh_ = busy_ = true;
    }
    changed_.notify_all();  // who waits for stillness goes on
    changed_.wait(lock, [this] { return !busy_; });
    hurry_ = false;
  }
  void waitUntilIdle() {
    waitUntilIdle([](const Wanted&, const Status&) { return false; });
  }

  // What follows is for `make`.

  /// Calls change(status), unless the thread is to end, or the newest wish is none for which isOfUse(newest); then it
  /// returns false.
  template <class IsOfUse, class Change>
  bool changeWhere(const IsOfUse& isOfUse, const Change& change) {
    const std::scoped_lock lock(mutex_);
    if (stop_ || !isOfUse(std::as_const(wanted_))) {
      return false;
    }
    change(status_);
    return true;
  }
  template <class Change>
  void change(const Change& change) {
    const std::scoped_lock lock(mutex_);
    change(status_);
  }
  bool isNewest(const Wanted& wanted) const {
    const std::scoped_lock lock(mutex_);
    return !stop_ && wanted_ == wanted;
  }
  bool someoneWaits() const {
    const std::scoped_lock lock(mutex_);
    return hurry_;
  }
  /// Whether it is still the newest wish after so many seconds, or at once where someone waits.
  bool standsStill(const Wanted& wanted, double seconds) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, std::chrono::duration<double>(seconds),
                      [&] { return stop_ || hurry_ || !(wanted_ == wanted); });
    return !stop_ && wanted_ == wanted;
  }

 private:
  void run() {
    while (true) {
      Wanted wanted;
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
      make_(wanted);
    }
  }

  Make make_;
  mutable std::mutex mutex_;  ///< guards what follows
  std::condition_variable changed_;
  Wanted wanted_{};
  bool fresh_ = false;  ///< wanted_ has not been looked at
  bool busy_ = false;
  bool hurry_ = false;  ///< someone waits
  bool stop_ = false;
  Status status_{};
  std::thread thread_;
};

}  // namespace ocelli
