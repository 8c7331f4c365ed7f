// Outputs under temporary names, which a signal that ends the program takes along.
//
// A program calls removeUnfinishedOutputs() in its handler of SIGINT, SIGTERM and SIGHUP, and then ends. Without such a
// handler, and with SIGKILL, what lies under a temporary name stays there; the next run replaces it.
#pragma once

#include <filesystem>
#include <functional>

namespace ocelli {

/// A file or a folder that is known to removeUnfinishedOutputs() while this object lives, or until finish().
class UnfinishedOutput {
 public:
  UnfinishedOutput() = default;
  /// `create` makes it. No signal ends the program between the making and the knowing.
  UnfinishedOutput(const std::filesystem::path& path, const std::function<void()>& create);
  ~UnfinishedOutput();
  UnfinishedOutput(UnfinishedOutput&& other) noexcept;
  UnfinishedOutput& operator=(UnfinishedOutput&& other) noexcept;

  /// `end` renames or removes it; it is then forgotten, also where that throws. Either happens as a whole: a signal
  /// waits for it, or nothing of it happens any more. Does nothing but call `end` for an object that holds nothing.
  void finish(const std::function<void()>& end);

  struct Entry;

 private:
  Entry* entry_ = nullptr;
};

/// Removes all of them, folders with what they hold. From now on other threads that begin or finish an output stand
/// still, so that nothing new appears: the program must end. Does nothing in a process that was forked off. May be
/// called in a signal handler.
void removeUnfinishedOutputs() noexcept;

}  // namespace ocelli
