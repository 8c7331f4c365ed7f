// Lines for people, written on a thread of its own: whoever notes something never waits for the reader of a pipe.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace ocelli {

class NoteQueue {
 public:
  static constexpr size_t kMaxLines = 1000;  ///< that wait; others are left out

  /// `write` is called with one line after the other, on one thread; what it throws is dropped.
  explicit NoteQueue(std::function<void(const std::string& line)> write);
  /// Waits until all lines are written.
  ~NoteQueue();
  NoteQueue(const NoteQueue&) = delete;
  NoteQueue& operator=(const NoteQueue&) = delete;

  /// Returns at once. Any thread may call it.
  void add(std::string line);

 private:
  void work();

  const std::function<void(const std::string& line)> write_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::string> lines_;
  size_t leftOut_ = 0;  ///< and not yet told
  bool isEnding_ = false;
  std::thread thread_;
};

}  // namespace ocelli
