#include "oc_core/feeds_video/video_writer.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}

#include <fmt/format.h>

#include <cmath>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/base/output_file.h"
#include "oc_core/base/unfinished_output.h"
#include "oc_core/feeds_video/video_error.h"

namespace ocelli {
namespace {

constexpr int kStampsASecond = 90000;

struct CloseOutput {
  void operator()(AVFormatContext* context) const {
    avio_closep(&context->pb);
    avformat_free_context(context);
  }
};

/// The file that is written until the video is complete: `path` itself where that is a pipe or a device.
std::filesystem::path partialOf(const std::filesystem::path& path) {
  if (isStream(path)) {
    return path;
  }
  std::error_code ignored;
  std::filesystem::path partial = std::filesystem::exists(path, ignored) ? std::filesystem::canonical(path) : path;
  return partial += ".partial";
}

struct FreeEncoder {
  void operator()(AVCodecContext* context) const { avcodec_free_context(&context); }
};
struct FreeWrittenFrame {
  void operator()(AVFrame* frame) const { av_frame_free(&frame); }
};
struct FreeWrittenPacket {
  void operator()(AVPacket* packet) const { av_packet_free(&packet); }
};
struct FreeWriterScaler {
  void operator()(SwsContext* context) const { sws_freeContext(context); }
};

}  // namespace

struct VideoWriter::Impl {
  std::filesystem::path path;
  std::filesystem::path partial;
  UnfinishedOutput unfinished;
  std::unique_ptr<AVFormatContext, CloseOutput> output;
  std::unique_ptr<AVCodecContext, FreeEncoder> encoder;
  std::unique_ptr<AVFrame, FreeWrittenFrame> frame{av_frame_alloc()};
  std::unique_ptr<AVPacket, FreeWrittenPacket> packet{av_packet_alloc()};
  std::unique_ptr<SwsContext, FreeWriterScaler> scaler;
  AVStream* stream = nullptr;
  int64_t lastStamp = -1;
  bool isFinished = false;

  void check(int code, const char* what) const {
    if (code < 0) {
      throw WorkError(fmt::format("{}: {}", what, ffmpegErrorText(code)), path.string(),
                      "check the folder and the space on its disk");
    }
  }

  void open(int width, int height, const VideoWriterOptions& options) {
    if (!options.isLossless && (width % 2 != 0 || height % 2 != 0)) {
      throw InputError(fmt::format("video takes pictures of an even size, not {}x{}", width, height), path.string(),
                       "make width and height of the output even, or write images");
    }
    const char* encoderName = options.isLossless ? "ffv1" : "libx264";
    const AVCodec* codec = avcodec_find_encoder_by_name(encoderName);
    if (codec == nullptr) {
      throw WorkError(fmt::format("this FFmpeg has no encoder {}", encoderName), path.string(),
                      "install one that has, as Debian's libavcodec59 does");
    }
    const AVOutputFormat* const format = av_guess_format(nullptr, path.c_str(), nullptr);
    if (format == nullptr) {
      throw InputError("videos do not end in \"" + path.extension().string() + "\"", path.string(),
                       "write a file that ends in .mp4 or .mkv");
    }
    checkWritable(path);
    partial = partialOf(path);
    const std::string name = "file:" + partial.string();  // a colon in it begins no address
    AVFormatContext* context = nullptr;
    check(avformat_alloc_output_context2(&context, format, nullptr, name.c_str()), "no memory for the container");
    output.reset(context);
    output->flags |= AVFMT_FLAG_BITEXACT;  // the same frames give the same bytes
    encoder.reset(avcodec_alloc_context3(codec));
    encoder->width = width;
    encoder->height = height;
    encoder->pix_fmt = options.isLossless ? AV_PIX_FMT_BGR0 : AV_PIX_FMT_YUV420P;
    encoder->time_base = {1, kStampsASecond};
    encoder->framerate = av_d2q(options.framesPerSecond, 100000);
    encoder->gop_size = 60;
    encoder->max_b_frames = 0;
    encoder->thread_count = 1;
    if ((output->oformat->flags & AVFMT_GLOBALHEADER) != 0) {
      encoder->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    }
    if (!options.isLossless) {
      encoder->colorspace = AVCOL_SPC_SMPTE170M;  // what the scaler makes; players take large videos for BT.709
      encoder->color_range = AVCOL_RANGE_MPEG;
      av_opt_set(encoder->priv_data, "preset", "veryfast", 0);
      av_opt_set_double(encoder->priv_data, "crf", options.rateFactor, 0);
    }
    check(avcodec_open2(encoder.get(), codec, nullptr), "the encoder does not start");
    stream = avformat_new_stream(output.get(), nullptr);
    stream->time_base = encoder->time_base;
    stream->avg_frame_rate = encoder->framerate;
    check(avcodec_parameters_from_context(stream->codecpar, encoder.get()), "the container does not take the video");
    int opened = 0;
    const auto openFile = [&] { opened = avio_open(&output->pb, name.c_str(), AVIO_FLAG_WRITE); };
    if (partial == path) {
      openFile();
    } else {
      unfinished = UnfinishedOutput(partial, openFile);
    }
    check(opened, "cannot be written");
    check(avformat_write_header(output.get(), nullptr), "the header cannot be written");
    scaler.reset(sws_getContext(width, height, AV_PIX_FMT_RGB24, width, height, encoder->pix_fmt,
                                SWS_BICUBIC | SWS_ACCURATE_RND, nullptr, nullptr, nullptr));
    frame->width = width;
    frame->height = height;
    frame->format = encoder->pix_fmt;
    check(av_frame_get_buffer(frame.get(), 0), "no memory for a frame");
  }

  void publish() {
    std::error_code error;
    if (partial != path) {
      std::filesystem::path target = partial;
      unfinished.finish([&] { std::filesystem::rename(partial, target.replace_extension(), error); });
    }
    if (error) {
      throw WorkError("cannot be written: " + error.message(), path.string(), "check who may write into its folder");
    }
    isFinished = true;
  }

  void leaveNothing() {
    output.reset();
    if (!isFinished && !partial.empty() && partial != path) {
      std::error_code ignored;
      unfinished.finish([&] { std::filesystem::remove(partial, ignored); });
    }
  }

  void writePackets() {
    for (;;) {
      const int got = avcodec_receive_packet(encoder.get(), packet.get());
      if (got == AVERROR(EAGAIN) || got == AVERROR_EOF) {
        return;
      }
      check(got, "a frame cannot be encoded");
      av_packet_rescale_ts(packet.get(), encoder->time_base, stream->time_base);
      packet->stream_index = stream->index;
      check(av_interleaved_write_frame(output.get(), packet.get()), "cannot be written");
    }
  }
};

VideoWriter::VideoWriter(const std::filesystem::path& path, int width, int height, const VideoWriterOptions& options)
    : impl_(std::make_unique<Impl>()) {
  av_log_set_level(AV_LOG_FATAL);
  impl_->path = path;
  try {
    impl_->open(width, height, options);
  } catch (...) {
    impl_->leaveNothing();
    throw;
  }
}

VideoWriter::~VideoWriter() {
  impl_->leaveNothing();
}

void VideoWriter::add(const Image<Rgb8>& image, double seconds) {
  OC_CHECK(image.width() == impl_->encoder->width && image.height() == impl_->encoder->height,
           "frames of a video have one size");
  impl_->check(av_frame_make_writable(impl_->frame.get()), "no memory for a frame");
  const uint8_t* const planes[] = {reinterpret_cast<const uint8_t*>(image.data())};
  const int strides[] = {image.width() * 3};
  sws_scale(impl_->scaler.get(), planes, strides, 0, image.height(), impl_->frame->data, impl_->frame->linesize);
  const auto stamp = static_cast<int64_t>(std::llround(seconds * kStampsASecond));
  OC_CHECK(stamp > impl_->lastStamp, "timestamps of a video grow");
  impl_->lastStamp = stamp;
  impl_->frame->pts = stamp;
  impl_->check(avcodec_send_frame(impl_->encoder.get(), impl_->frame.get()), "a frame cannot be encoded");
  impl_->writePackets();
}

void VideoWriter::finish() {
  impl_->check(avcodec_send_frame(impl_->encoder.get(), nullptr), "the encoder does not end");
  impl_->writePackets();
  impl_->check(av_write_trailer(impl_->output.get()), "cannot be written");
  impl_->check(avio_closep(&impl_->output->pb), "cannot be written");  // a full disk may show itself only here
  impl_->publish();
}

}  // namespace ocelli
