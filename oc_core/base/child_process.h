// A program in a process of its own, so that a crash, a hang or a lack of memory there does no harm here.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace ocelli {

/// The descriptor that the child writes its result to: a file in memory.
inline constexpr int kChildResultDescriptor = 3;

struct ChildCommand {
  std::filesystem::path program;
  std::vector<std::string> arguments;  ///< those after the program's name
  double seconds = 60;                 ///< wall-clock time after which it is killed
};

/// The file in memory that a child has written, mapped for reading.
class ChildBytes {
 public:
  ChildBytes() = default;
  /// Maps all of the file; the descriptor may be closed afterwards. Throws WorkError.
  explicit ChildBytes(int descriptor);

  std::span<const std::byte> bytes() const { return bytes_; }

 private:
  std::shared_ptr<const void> mapping_;
  std::span<const std::byte> bytes_;
};

struct ChildEnd {
  enum class How { kExited, kKilledBySignal, kOutOfTime };
  How how = How::kExited;
  int code = 0;          ///< the exit code, or the signal
  std::string messages;  ///< the end of what it printed, to standard output and standard error
  ChildBytes result;
};

/// Runs a program until it ends, and calls `tick` at least ten times a second meanwhile. The child is killed when its
/// time is over and when `tick` throws; the exception passes on. It has no terminal signals (Ctrl-C reaches this
/// process alone, and its tick() decides), no input, no open files of this process, and default signal handlers. Throws
/// WorkError where the program cannot be started.
///
/// A child that must not outlive this process calls endWithParent() first.
ChildEnd runChild(const ChildCommand& command, const std::function<void()>& tick);

/// In the child: the system kills this process when the parent ends. Ends it at once where `parent`, the process id
/// that the parent had, is no more.
void endWithParent(int parent);

}  // namespace ocelli
