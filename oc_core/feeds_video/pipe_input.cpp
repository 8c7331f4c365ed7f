#include "oc_core/feeds_video/pipe_input.h"

extern "C" {
#include <libavformat/avio.h>
#include <libavutil/error.h>
#include <libavutil/mem.h>
}

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr int kPollMilliseconds = 50;
constexpr int kPipeBytes = 1 << 16;

}  // namespace

bool PipeInput::isPipe(const std::string& source) {
  std::error_code ignored;
  return std::filesystem::is_fifo(source, ignored);
}

PipeInput::PipeInput(const std::string& source, std::function<bool()> isOver)
    : isOver_(std::move(isOver)), descriptor_(open(source.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {
  if (descriptor_ < 0) {
    throw InputError("the pipe cannot be opened", source, "check who may read it");
  }
  context_ = avio_alloc_context(static_cast<unsigned char*>(av_malloc(kPipeBytes)), kPipeBytes, 0, this, read, nullptr,
                                nullptr);
}

PipeInput::~PipeInput() {
  av_freep(&context_->buffer);
  avio_context_free(&context_);
  close(descriptor_);
}

int PipeInput::read(void* self, unsigned char* bytes, int size) {
  auto& pipe = *static_cast<PipeInput*>(self);
  while (!pipe.isOver_()) {
    const ssize_t got = ::read(pipe.descriptor_, bytes, static_cast<size_t>(size));
    if (got > 0) {
      pipe.hasWriter_ = true;
      return static_cast<int>(got);
    }
    if (got == 0 && pipe.hasWriter_) {
      return AVERROR_EOF;
    }
    if (got < 0 && errno != EAGAIN && errno != EINTR) {
      return AVERROR(errno);
    }
    if (got == 0) {
      usleep(kPollMilliseconds * 1000);  // nobody has opened it to write yet
      continue;
    }
    pollfd wait{pipe.descriptor_, POLLIN, 0};
    poll(&wait, 1, kPollMilliseconds);
  }
  return AVERROR_EXIT;
}

}  // namespace ocelli
