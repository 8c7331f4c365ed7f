#include "oc_core/feeds_video/video_reader.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavdevice/avdevice.h>
#include <libavformat/avformat.h>
#include <libavutil/dict.h>
#include <libswscale/swscale.h>
}

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "oc_core/base/error.h"
#include "oc_core/feeds_video/pipe_input.h"
#include "oc_core/feeds_video/video_error.h"

namespace ocelli {
namespace {

using VideoClock = std::chrono::steady_clock;

constexpr double kUnknownFrameSeconds = 1.0 / 25;  ///< where neither timestamps nor a rate are there
constexpr double kMinMissingSeconds = 0.5;
constexpr double kMaxRate = 1000;  ///< above it is what an encoder counts timestamps in

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

/// Colours as the video says that they are coded. Where it says nothing they are those of BT.601, FFmpeg's default.
void setColors(SwsContext* scaler, const AVFrame& from) {
  int* table = nullptr;
  int* targetTable = nullptr;
  int isFullRange = 0;
  int isTargetFull = 0;
  int brightness = 0;
  int contrast = 0;
  int saturation = 0;
  if (sws_getColorspaceDetails(scaler, &table, &isFullRange, &targetTable, &isTargetFull, &brightness, &contrast,
                               &saturation) < 0) {
    return;  // these pixels are no YUV
  }
  if (from.color_range != AVCOL_RANGE_UNSPECIFIED) {
    isFullRange = from.color_range == AVCOL_RANGE_JPEG ? 1 : 0;
  }
  const int* const given = from.colorspace == AVCOL_SPC_UNSPECIFIED ? table : sws_getCoefficients(from.colorspace);
  sws_setColorspaceDetails(scaler, given, isFullRange, targetTable, isTargetFull, brightness, contrast, saturation);
}

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
  int width = 0;  ///< of its pictures, as it was opened
  int height = 0;
  double frameSeconds = 0;  ///< from one picture to the next; what pictures without timestamps go by
  double lastSeconds = 0;
  double longestStep = 0;  ///< seconds from a frame to the next
  bool isAnyShown = false;
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
    beginWait();
    const int opened =
        avformat_open_input(&context, ffmpegNameOf(source).c_str(), format, options.get());  // frees it where it fails
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
    width = decoder->width;
    height = decoder->height;
    const AVRational rate = av_guess_frame_rate(input.get(), input->streams[stream], nullptr);
    const bool isKnown = rate.num > 0 && rate.den > 0 && av_q2d(rate) <= kMaxRate;
    frameSeconds = isKnown ? 1 / av_q2d(rate) : kUnknownFrameSeconds;
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
    if (from.width != width || from.height != height) {
      throw WorkError(fmt::format("the pictures of the feed change from {}x{} to {}x{} pixels", width, height,
                                  from.width, from.height),
                      source,
                      "keep its camera at one size, and convert videos: ffmpeg -i FEED -s WIDTHxHEIGHT OUT.mkv");
    }
    if (frame.image.empty() || frame.image.width() != width || frame.image.height() != height) {  // or was moved away
      frame.image = Image<Rgb8>(width, height);
    }
    scaler.reset(sws_getCachedContext(scaler.release(), width, height, static_cast<AVPixelFormat>(from.format), width,
                                      height, AV_PIX_FMT_RGB24, SWS_BILINEAR, nullptr, nullptr, nullptr));
    if (!scaler) {
      throw InputError("the pixels of the feed have a format that FFmpeg cannot convert", source,
                       "convert it: ffmpeg -i FEED -pix_fmt yuv420p OUT.mkv");
    }
    setColors(scaler.get(), from);
    uint8_t* const planes[] = {reinterpret_cast<uint8_t*>(frame.image.data())};
    const int strides[] = {width * 3};
    sws_scale(scaler.get(), from.data, from.linesize, 0, height, planes, strides);
    frame.seconds = secondsOf(from);
  }

  double secondsOf(const AVFrame& from) {
    const int64_t stamp = from.best_effort_timestamp;
    const double before = lastSeconds;
    if (stamp != AV_NOPTS_VALUE) {
      lastSeconds = static_cast<double>(stamp) * av_q2d(input->streams[stream]->time_base);
    } else if (isAnyShown) {
      lastSeconds += frameSeconds;
    }
    longestStep = isAnyShown ? std::max(longestStep, lastSeconds - before) : frameSeconds;
    isAnyShown = true;
    return lastSeconds;
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
  return impl_->width;
}

int VideoReader::height() const {
  return impl_->height;
}

size_t VideoReader::damagedFrames() const {
  return impl_->damaged;
}

std::optional<double> VideoReader::endSeconds() const {
  const AVFormatContext& input = *impl_->input;
  if (input.duration == AV_NOPTS_VALUE) {
    return std::nullopt;
  }
  const int64_t start = input.start_time == AV_NOPTS_VALUE ? 0 : input.start_time;
  return static_cast<double>(start + input.duration) / AV_TIME_BASE;
}

double VideoReader::missingSeconds() const {
  const std::optional<double> end = endSeconds();
  if (!end || impl_->input->nb_streams != 1) {
    return 0;
  }
  const double missing = *end - impl_->lastSeconds - impl_->longestStep;
  return missing > std::max(kMinMissingSeconds, impl_->longestStep) ? missing : 0;
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
