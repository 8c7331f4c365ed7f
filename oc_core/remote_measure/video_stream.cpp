#include "oc_core/remote_measure/video_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <numeric>

#include "oc_core/base/check.h"
#include "oc_core/base/child_process.h"
#include "oc_core/base/error.h"
#include "oc_core/base/machine.h"

namespace ocelli {
namespace {

constexpr double kMaxEncodingSeconds = 24 * 3600;
constexpr double kBufferSeconds = 0.1;
constexpr const char* kScaling = "bicubic+accurate_rnd+full_chroma_int+full_chroma_inp";

/// Whole frames only at the beginning: what costs a stream least.
std::vector<std::string> x264Arguments() {
  return {"-preset", "medium", "-tune", "zerolatency", "-x264-params", "keyint=infinite"};
}
std::vector<std::string> x265Arguments() {
  return {"-preset", "medium", "-tune", "zerolatency", "-x265-params", "keyint=-1:log-level=error"};
}

/// Of films that are there as a whole: frames may wait for later ones.
std::vector<std::string> x265FilmArguments() {
  return {"-preset", "medium", "-x265-params", "keyint=250:log-level=error"};
}
std::vector<std::string> av1FilmArguments() {
  return {"-preset", "6", "-g", "240"};
}

constexpr std::array<StreamKind, 4> kKinds{{
    {"x264", "libx264", "H.264 by x264, a frame at a time, colour at half the resolution", "yuv420p", x264Arguments},
    {"x265", "libx265", "HEVC by x265, a frame at a time, colour at half the resolution", "yuv420p", x265Arguments},
    {"x264-444", "libx264", "H.264 by x264, a frame at a time, colour at the full resolution", "yuv444p",
     x264Arguments},
    {"x265-444", "libx265", "HEVC by x265, a frame at a time, colour at the full resolution", "yuv444p", x265Arguments},
}};
constexpr std::array<StreamKind, 2> kFilmKinds{{
    {"x265-film", "libx265", "HEVC by x265, all frames at hand, colour at half the resolution", "yuv420p",
     x265FilmArguments},
    {"av1-film", "libsvtav1", "AV1 by SVT-AV1, all frames at hand, colour at half the resolution", "yuv420p",
     av1FilmArguments},
}};

/// An expression of ffmpeg's that is 1 for these frames, in rising order: halves of halves, as a sum of all of them
/// would be as deep as it is long.
std::string selectionOf(std::span<const size_t> frames) {
  if (frames.size() == 1) {
    return fmt::format("eq(n,{})", frames[0]);
  }
  const size_t half = frames.size() / 2;
  return fmt::format("if(lt(n,{}),{},{})", frames[half], selectionOf(frames.first(half)),
                     selectionOf(frames.subspan(half)));
}

std::vector<std::string> joined(std::vector<std::string> first, const std::vector<std::string>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// "0, 7, 7, 1, 1234, 0x8ad3": the sizes of the packets of a file that ffmpeg's framecrc has written.
std::vector<size_t> packetSizes(std::string_view text) {
  constexpr int kSizeField = 4;
  std::vector<size_t> sizes;
  while (!text.empty()) {
    const size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.empty() || line.front() == '#') {
      continue;
    }
    for (int field = 0; field < kSizeField; ++field) {
      line.remove_prefix(std::min(line.find(',') + 1, line.size()));
    }
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    size_t size = 0;
    std::from_chars(line.data(), line.data() + line.size(), size);
    sizes.push_back(size);
  }
  return sizes;
}

}  // namespace

std::span<const StreamKind> streamKinds() {
  return kKinds;
}

std::span<const StreamKind> filmKinds() {
  return kFilmKinds;
}

const StreamKind* findStreamKind(std::string_view name) {
  for (const StreamKind& kind : kKinds) {
    if (name == kind.name) {
      return &kind;
    }
  }
  return nullptr;
}

size_t StreamEncoder::Stream::bytes() const {
  return std::accumulate(frameBytes.begin(), frameBytes.end(), size_t{0});
}

StreamEncoder::StreamEncoder(const StreamKind& kind) : kind_(kind), program_(findProgram("ffmpeg")) {
  if (!program_) {
    missing_ = "ffmpeg is not installed: apt-get install ffmpeg";
    return;
  }
  try {
    run(joined({"-f", "lavfi", "-i", "color=size=64x64:rate=25", "-frames:v", "1", "-c:v", kind_.encoder, "-f", "null",
                "-"},
               {}),
        {});
  } catch (const WorkError&) {
    missing_ = fmt::format("this ffmpeg has no encoder {}: install one that has, as Debian's does", kind_.encoder);
  }
}

void StreamEncoder::run(const std::vector<std::string>& arguments, const Progress& progress) const {
  OC_CHECK(program_.has_value(), "ffmpeg is there");
  const ChildEnd end =
      runChild({*program_, joined({"-hide_banner", "-loglevel", "error", "-y"}, arguments), kMaxEncodingSeconds},
               [&] { report(progress, fmt::format("encoding by {}", kind_.name), 0.5); });
  if (end.how != ChildEnd::How::kExited || end.code != 0) {
    std::string said = end.messages;
    while (said.ends_with('\n')) {
      said.pop_back();
    }
    throw WorkError("ffmpeg failed" + (said.empty() ? said : ": " + said), kind_.encoder,
                    "check the space in the folder for temporary files, or leave this peer out with --modes");
  }
}

StreamEncoder::Stream StreamEncoder::encode(const PathFilm& film, const StreamQuality& quality,
                                            const Progress& progress) const {
  if (film.screen().x % 2 != 0 || film.screen().y % 2 != 0) {
    throw InputError("video takes pictures of an even width and height", "--screen", "give an even width and height");
  }
  Stream stream;
  stream.file = std::make_unique<UnnamedFile>();
  std::vector<std::string> arguments{"-f",
                                     "rawvideo",
                                     "-pixel_format",
                                     "rgb24",
                                     "-video_size",
                                     fmt::format("{}x{}", film.screen().x, film.screen().y),
                                     "-framerate",
                                     fmt::format("{:.6f}", film.framesPerSecond()),
                                     "-i",
                                     film.rawPath(),
                                     "-an",
                                     "-sws_flags",
                                     kScaling,
                                     "-pix_fmt",
                                     kind_.pixelFormat,
                                     "-c:v",
                                     kind_.encoder};
  arguments = joined(std::move(arguments), kind_.arguments());
  arguments = joined(std::move(arguments), {"-crf", fmt::format("{:g}", quality.rateFactor)});
  if (quality.maxBytesPerSecond) {
    const double bits = 8 * *quality.maxBytesPerSecond;
    arguments = joined(std::move(arguments), {"-maxrate", fmt::format("{:.0f}", bits), "-bufsize",
                                              fmt::format("{:.0f}", bits * kBufferSeconds)});
  }
  arguments = joined(std::move(arguments), {"-f", "matroska", stream.file->path()});
  run(arguments, progress);
  UnnamedFile sizes;
  run({"-i", stream.file->path(), "-c", "copy", "-f", "framecrc", sizes.path()}, {});
  const std::span<const std::byte> text = sizes.map();
  stream.frameBytes = packetSizes({reinterpret_cast<const char*>(text.data()), text.size()});
  if (stream.frameBytes.size() != film.frames()) {
    throw WorkError(fmt::format("ffmpeg made {} frames of {}", stream.frameBytes.size(), film.frames()), kind_.encoder,
                    "try another version of ffmpeg, or leave this peer out with --modes");
  }
  return stream;
}

void StreamEncoder::decode(const Stream& stream, const glm::ivec2& size, const std::vector<size_t>& frames,
                           const std::function<void(size_t, const Image<Rgb8>&)>& sink) const {
  if (frames.empty()) {
    return;
  }
  // As a file: an argument of a program ends at 128 KiB.
  const std::string filter = "select='" + selectionOf(frames) + "'";
  UnnamedFile script;
  script.append(std::as_bytes(std::span(filter)));
  UnnamedFile raw;
  run({"-i", stream.file->path(), "-filter_script:v", script.path(), "-fps_mode", "passthrough", "-sws_flags", kScaling,
       "-f", "rawvideo", "-pix_fmt", "rgb24", raw.path()},
      {});
  const std::span<const std::byte> bytes = raw.map();
  Image<Rgb8> picture(size.x, size.y);
  const size_t each = picture.size() * sizeof(Rgb8);
  if (bytes.size() != each * frames.size()) {
    throw WorkError("ffmpeg did not give back all frames of a stream", kind_.encoder,
                    "check the space in the folder for temporary files, or leave this peer out with --modes");
  }
  for (size_t i = 0; i < frames.size(); ++i) {
    std::memcpy(reinterpret_cast<std::byte*>(picture.data()), bytes.subspan(i * each, each).data(), each);
    sink(frames[i], picture);
  }
}

}  // namespace ocelli
