#include "oc_core/remote/server/note_queue.h"

#include <fmt/format.h>

#include <utility>

namespace ocelli {

NoteQueue::NoteQueue(std::function<void(const std::string& line)> write)
    : write_(std::move(write)), thread_([this] { work(); }) {}

NoteQueue::~NoteQueue() {
  {
    const std::lock_guard lock(mutex_);
    isEnding_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void NoteQueue::add(std::string line) {
  {
    const std::lock_guard lock(mutex_);
    if (lines_.size() >= kMaxLines) {
      ++leftOut_;
      return;
    }
    lines_.push_back(std::move(line));
  }
  changed_.notify_one();
}

void NoteQueue::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [&] { return isEnding_ || !lines_.empty() || leftOut_ > 0; });
    const bool isLine = !lines_.empty();
    if (!isLine && leftOut_ == 0) {
      return;
    }
    const std::string line =
        isLine ? std::move(lines_.front()) : fmt::format("({} lines are left out)", std::exchange(leftOut_, 0));
    if (isLine) {
      lines_.pop_front();
    }
    lock.unlock();
    try {
      write_(line);
    } catch (...) {  // what cannot be written must not end what is served
    }
    lock.lock();
  }
}

}  // namespace ocelli
