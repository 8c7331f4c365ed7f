// Named pipes as a source: FFmpeg's own reads of them wait for ever, and ask no callback. For the .cpp files of this
// room.
#pragma once

#include <functional>
#include <string>

struct AVIOContext;

namespace ocelli {

class PipeInput {
 public:
  /// Whether a source is a named pipe.
  static bool isPipe(const std::string& source);

  /// `isOver` is asked several times a second while a read waits; where it says so, the read ends with AVERROR_EXIT.
  /// Throws InputError where the pipe cannot be opened.
  PipeInput(const std::string& source, std::function<bool()> isOver);
  ~PipeInput();
  PipeInput(const PipeInput&) = delete;
  PipeInput& operator=(const PipeInput&) = delete;

  AVIOContext* context() const { return context_; }

 private:
  static int read(void* self, unsigned char* bytes, int size);

  std::function<bool()> isOver_;
  int descriptor_ = -1;
  bool hasWriter_ = false;  ///< had one: its end is then the end of the video
  AVIOContext* context_ = nullptr;
};

}  // namespace ocelli
