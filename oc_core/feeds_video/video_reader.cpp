#include "oc_core/feeds_video/video_reader.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavdevice/avdevice.h>
#include <libavformat/avformat.h>
#include <libavutil/dict.h>
#include <libswscale/swscale.h>
}

#include <fmt/format.h>

#include <chrono>

#include "oc_core/base/error.h"
#include "oc_core/feeds_video/pipe_input.h"
#include "oc_core/feeds_video/video_error.h"

namespace ocelli {
namespace {

using VideoClock = std::chrono::steady_clock;

struct CloseInput {
  void operator()(AVFormatContext* context) const { avformat_close_input(&context); }
};
struct FreeDecoder {
  void operator()(AVCodecContext* context) const { avcodec_free_context(&context); }
};
struct FreeFrame {
  void operator()(AVFrame* frame) const { av_frame_free(&frame); }
};
struct FreePacket {
  void operator()(AVPacket* packet) const { av_packet_free(&packet); }
};
struct FreeScaler {
  void operator()(SwsContext* context) const { sws_freeContext(context); }
};

/// How long the call that runs now may wait.
struct WaitLimit {
  const std::atomic<bool>* stop = nullptr;
  VideoClock::time_point end;

  static int isOver(void* self) {
    const auto& limit = *static_cast<const WaitLimit*>(self);
    return *limit.stop || VideoClock::now() > limit.end ? 1 : 0;
  }
};

/// Options by name, as FFmpeg takes them; what it has used is gone from them afterwards.
class InputOptions {
 public:
  explicit InputOptions(const VideoSource& source) {
    const VideoSourceKind& kind = videoSourceKind(source.name);
    if (kind.mayBeLive) {
      set("fflags", "nobuffer");
    }
    if (kind.takesSize && source.width > 0) {
      set("video_size", fmt::format("{}x{}", source.width, source.height));
    }
    if (kind.takesSize && source.framesPerSecond > 0) {
      set("framerate", fmt::format("{}", source.framesPerSecond));
    }
    for (const std::string& option : source.options) {
      const size_t at = option.find('=');
      if (at == std::string::npos || at == 0) {
        throw InputError("\"" + option + "\" is no option", source.name, "write NAME=VALUE, as rtsp_flags=listen");
      }
      set(option.substr(0, at), option.substr(at + 1));
    }
  }
  ~InputOptions() { av_dict_free(&options_); }
  InputOptions(const InputOptions&) = delete;
  InputOptions& operator=(const InputOptions&) = delete;

  AVDictionary** get() { return &options_; }
  /// The name of one that FFmpeg has not used; empty where there is none.
  std::string unused() const {
    const AVDictionaryEntry* const first = av_dict_get(options_, "", nullptr, AV_DICT_IGNORE_SUFFIX);
    return first == nullptr ? "" : first->key;
  }

 private:
  void set(const std::string& name, const std::string& value) {
    av_dict_set(&options_, name.c_str(), value.c_str(), 0);
  }

  AVDictionary* options_ = nullptr;
};

}  // namespace

struct VideoReader::Impl {
  VideoSource asked;
  std::string source;  ///< its name
  double maxWaitSeconds = 0;
  WaitLimit limit;
  std::unique_ptr<PipeInput> pipe;  ///< of a source that is a named pipe
  std::unique_ptr<AVFormatContext, CloseInput> input;
  std::unique_ptr<AVCodecContext, FreeDecoder> decoder;
  std::unique_ptr<AVFrame, FreeFrame> decoded{av_frame_alloc()};
  std::unique_ptr<AVPacket, FreePacket> packet{av_packet_alloc()};
  std::unique_ptr<SwsContext, FreeScaler> scaler;
  int stream = -1;
  bool isDraining = false;
  size_t damaged = 0;

  void beginWait() {
    limit.end = VideoClock::now() +
                std::chrono::duration_cast<VideoClock::duration>(std::chrono::duration<double>(maxWaitSeconds));
  }

  [[noreturn]] void failRead(int code) const {
    if (*limit.stop) {
      throw WorkError("reading was stopped", source, "run it again");
    }
    if (code == AVERROR_EXIT) {
      throw WorkError(fmt::format("the feed has not answered for {:g} seconds", maxWaitSeconds), source,
                      "check its camera and its line");
    }
    throw WorkError("the feed broke off: " + ffmpegErrorText(code), source, "check its camera and its line");
  }

  void open() {
    InputOptions options(asked);
    AVFormatContext* context = avformat_alloc_context();
    context->interrupt_callback = {WaitLimit::isOver, &limit};
    if (PipeInput::isPipe(source)) {
      pipe = std::make_unique<PipeInput>(source, [this] { return WaitLimit::isOver(&limit) != 0; });
      context->pb = pipe->context();
    }
    const VideoSourceKind& kind = videoSourceKind(source);
    const AVInputFormat* const format = kind.format == nullptr ? nullptr : av_find_input_format(kind.format);
    if (kind.format != nullptr && format == nullptr) {
      avformat_free_context(context);
      throw InputError("this FFmpeg has no such input", source, adviceOnSource(asked, AVERROR_DEMUXER_NOT_FOUND));
    }
    const std::string path = kind.isPrefixOurs ? source.substr(std::string(kind.prefix).size()) : source;
    beginWait();
    const int opened = avformat_open_input(&context, path.c_str(), format, options.get());  // frees it where it fails
    if (opened < 0) {
      if (opened == AVERROR_EXIT) {
        failRead(opened);
      }
      throw InputError("the feed cannot be opened: " + ffmpegErrorText(opened), source, adviceOnSource(asked, opened));
    }
    input.reset(context);
    if (const std::string unused = options.unused(); !unused.empty()) {
      throw InputError("FFmpeg knows no option \"" + unused + "\" for this source", source,
                       "see what `ffmpeg -h demuxer=NAME` and `ffmpeg -h protocol=NAME` list");
    }
    if (const int found = avformat_find_stream_info(input.get(), nullptr); found < 0) {
      failRead(found);
    }
    const AVCodec* codec = nullptr;
    stream = av_find_best_stream(input.get(), AVMEDIA_TYPE_VIDEO, -1, -1, &codec, 0);
    if (stream == AVERROR_DECODER_NOT_FOUND) {
      throw InputError("this FFmpeg has no decoder for the feed", source,
                       "convert it: ffmpeg -i FEED -c:v libx264 OUT.mkv");
    }
    if (stream < 0) {
      throw InputError("the feed holds no video", source, "name a video file or a camera");
    }
    decoder.reset(avcodec_alloc_context3(codec));
    avcodec_parameters_to_context(decoder.get(), input->streams[stream]->codecpar);
    decoder->thread_count = 1;  // feeds have threads of their own
    if (const int ready = avcodec_open2(decoder.get(), codec, nullptr); ready < 0) {
      throw InputError("the feed cannot be decoded: " + ffmpegErrorText(ready), source,
                       "convert it: ffmpeg -i FEED -c:v libx264 OUT.mkv");
    }
    if (decoder->width <= 0 || decoder->height <= 0) {
      throw InputError("the feed has no pictures", source, "check it with `ffprobe`");
    }
  }

  /// Hands the decoder another packet, or tells it that there are no more.
  void feedDecoder() {
    for (;;) {
      beginWait();
      const int got = av_read_frame(input.get(), packet.get());
      if (got == AVERROR_EOF) {
        isDraining = true;
        avcodec_send_packet(decoder.get(), nullptr);
        return;
      }
      if (got < 0) {
        failRead(got);
      }
      const bool isOurs = packet->stream_index == stream;
      const int sent = isOurs ? avcodec_send_packet(decoder.get(), packet.get()) : 0;
      av_packet_unref(packet.get());
      if (sent < 0) {
        ++damaged;
      } else if (isOurs) {
        return;
      }
    }
  }

  void convert(VideoFrame& frame) {
    const AVFrame& from = *decoded;
    if (frame.image.width() != decoder->width || frame.image.height() != decoder->height) {
      frame.image = Image<Rgb8>(decoder->width, decoder->height);
    }
    scaler.reset(sws_getCachedContext(scaler.release(), from.width, from.height,
                                      static_cast<AVPixelFormat>(from.format), decoder->width, decoder->height,
                                      AV_PIX_FMT_RGB24, SWS_BILINEAR, nullptr, nullptr, nullptr));
    if (!scaler) {
      throw InputError("the pixels of the feed have a format that FFmpeg cannot convert", source,
                       "convert it: ffmpeg -i FEED -pix_fmt yuv420p OUT.mkv");
    }
    uint8_t* const planes[] = {reinterpret_cast<uint8_t*>(frame.image.data())};
    const int strides[] = {decoder->width * 3};
    sws_scale(scaler.get(), from.data, from.linesize, 0, from.height, planes, strides);
    const AVStream& of = *input->streams[stream];
    const int64_t stamp = from.best_effort_timestamp;
    frame.seconds = static_cast<double>(stamp == AV_NOPTS_VALUE ? 0 : stamp) * av_q2d(of.time_base);
  }
};

VideoReader::VideoReader(const VideoSource& source, double maxWaitSeconds, const std::atomic<bool>& stop)
    : impl_(std::make_unique<Impl>()) {
  av_log_set_level(AV_LOG_FATAL);
  avdevice_register_all();
  avformat_network_init();
  impl_->asked = source;
  impl_->source = source.name;
  impl_->maxWaitSeconds = maxWaitSeconds;
  impl_->limit.stop = &stop;
  impl_->open();
}

VideoReader::~VideoReader() = default;

int VideoReader::width() const {
  return impl_->decoder->width;
}

int VideoReader::height() const {
  return impl_->decoder->height;
}

size_t VideoReader::damagedFrames() const {
  return impl_->damaged;
}

bool VideoReader::isLive() const {
  const VideoSourceKind& kind = videoSourceKind(impl_->source);
  return kind.isAlwaysLive || (kind.mayBeLive && impl_->input->duration == AV_NOPTS_VALUE);
}

bool VideoReader::next(VideoFrame& frame) {
  for (;;) {
    const int got = avcodec_receive_frame(impl_->decoder.get(), impl_->decoded.get());
    if (got == 0) {
      impl_->convert(frame);
      return true;
    }
    if (got == AVERROR_EOF) {
      return false;
    }
    if (got == AVERROR(EAGAIN) && !impl_->isDraining) {
      impl_->feedDecoder();
    } else if (got != AVERROR(EAGAIN)) {
      ++impl_->damaged;
      if (impl_->isDraining) {
        return false;
      }
      impl_->feedDecoder();
    } else {
      return false;
    }
  }
}

}  // namespace ocelli
