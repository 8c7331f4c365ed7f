// What seas are measured beside: a row each.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "oc_core/image_codecs/image_codec.h"
#include "oc_core/remote_measure/path_film.h"
#include "oc_core/remote_measure/rate_curve.h"
#include "oc_core/remote_measure/video_stream.h"
#include "oc_core/sea_measure/sea_measure.h"

namespace ocelli {
namespace {

/// Each image by itself, at the lowest quality whose mean FLIP is no more than that.
SeaPeerResult measureCodec(const char* name, const SeaPeerInput& input) {
  SeaPeerResult result;
  const ColorCodec* codec = findColorCodec(name);
  if (codec == nullptr) {
    result.missing = fmt::format("this program was built without {}", name);
    return result;
  }
  const SeaProjection& projection = input.source.projection();
  std::vector<Image<Rgb8>> images(input.sample.size());
  parallelFor(images.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      images[i] = input.source.image(input.sample[i]);
    }
  });
  const auto attempt = [&](double quality, bool withSsim) {
    std::vector<size_t> sizes(images.size());
    const SeaErrors errors = compareImages(
        input.source, input.sample,
        [&](size_t i) {
          const std::vector<std::byte> bytes = codec->encode(images[i], quality);
          sizes[i] = bytes.size();
          return codec->decode(bytes, {projection.width, projection.height});
        },
        withSsim, input.progress);
    double bytes = 0;
    for (const size_t size : sizes) {
      bytes += static_cast<double>(size) / static_cast<double>(sizes.size());
    }
    return SeaPeerResult{"", "", quality, bytes, errors.flip, errors.ssim, 0};
  };
  double worse = 1;
  double better = 100;
  constexpr double kPrecision = 0.5;
  while (better - worse > kPrecision) {
    const double middle = (worse + better) / 2;
    (attempt(middle, false).flip > input.flip ? worse : better) = middle;
  }
  result = attempt(better, true);
  const std::vector<std::byte> one = codec->encode(images[0], better);
  const auto start = std::chrono::steady_clock::now();
  constexpr int kTimes = 5;
  for (int i = 0; i < kTimes; ++i) {
    runAlone([&] { codec->decode(one, {projection.width, projection.height}); });
  }
  result.secondsPerImage = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / kTimes;
  return result;
}

/// The first images in a row as a film; its bytes at that FLIP between those of some rates.
SeaPeerResult measureVideo(const StreamKind& kind, const SeaPeerInput& input) {
  SeaPeerResult result;
  const StreamEncoder encoder(kind);
  if (!encoder.isThere()) {
    result.missing = encoder.missing();
    return result;
  }
  std::vector<Image<Rgb8>> frames(input.run);
  parallelFor(frames.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      frames[i] = input.source.image(static_cast<uint32_t>(i));
    }
  });
  constexpr double kFramesPerSecond = 25;
  const PathFilm film(frames, kFramesPerSecond);
  frames.clear();
  std::vector<size_t> judged;
  std::vector<uint32_t> sample;
  const size_t step = std::max<size_t>(1, input.run / input.sample.size());
  for (size_t frame = step / 2; frame < input.run; frame += step) {
    judged.push_back(frame);
    sample.push_back(static_cast<uint32_t>(frame));
  }
  const SeaProjection& projection = input.source.projection();
  std::vector<RatePoint> curve;
  // Less is better: until the error is enclosed.
  double rate = 28;
  constexpr double kStep = 6;
  for (int i = 0; i < 7 && rate >= 4 && rate <= 51; ++i) {
    const StreamEncoder::Stream stream = encoder.encode(film, {rate, {}}, input.progress);
    std::vector<Image<Rgb8>> pictures;
    encoder.decode(stream, {projection.width, projection.height}, judged,
                   [&](size_t /*frame*/, const Image<Rgb8>& picture) { pictures.push_back(picture); });
    const SeaErrors errors = compareImages(
        input.source, sample, [&](size_t at) { return pictures[at]; }, false, input.progress);
    curve.push_back({rate, static_cast<double>(stream.bytes()), errors.flip});
    const bool isWorse = errors.flip > input.flip;
    const bool isEnclosed = std::any_of(curve.begin(), curve.end(),
                                        [&](const RatePoint& point) { return (point.flip > input.flip) != isWorse; });
    if (isEnclosed) {
      // The time of a frame at random: all before it are decoded, up to the frame that is whole.
      const auto start = std::chrono::steady_clock::now();
      encoder.decode(stream, {projection.width, projection.height}, {input.run / 2},
                     [](size_t /*frame*/, const Image<Rgb8>& /*picture*/) {});
      result.secondsPerImage = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      break;
    }
    rate += isWorse ? -kStep : kStep;
  }
  const std::optional<double> bytes = bytesAtFlip(curve, input.flip);
  if (!bytes) {
    result.missing = fmt::format("it does not reach a FLIP of {:.4f} at the rates that were tried", input.flip);
    return result;
  }
  result.quality = curve.back().rateFactor;
  result.bytesPerImage = *bytes / static_cast<double>(input.run);
  result.flip = input.flip;
  return result;
}

}  // namespace

const std::vector<SeaPeer>& seaPeers() {
  static const std::vector<SeaPeer> kPeers{
      {"jpeg", "each image as JPEG", [](const SeaPeerInput& input) { return measureCodec("jpeg", input); }},
      {"jxl", "each image as JPEG XL", [](const SeaPeerInput& input) { return measureCodec("jxl", input); }},
      {"webp", "each image as WebP", [](const SeaPeerInput& input) { return measureCodec("webp", input); }},
      {"x265", "a film by x265", [](const SeaPeerInput& input) { return measureVideo(filmKinds()[0], input); }},
      {"av1", "a film by SVT-AV1", [](const SeaPeerInput& input) { return measureVideo(filmKinds()[1], input); }}};
  return kPeers;
}

const SeaPeer& requireSeaPeer(const std::string& name) {
  std::string known;
  for (const SeaPeer& peer : seaPeers()) {
    if (peer.name == name) {
      return peer;
    }
    known += (known.empty() ? "" : ", ") + std::string(peer.name);
  }
  throw InputError("no peer is called \"" + name + "\"", "--peers", "choose some of " + known);
}

}  // namespace ocelli
