#include "oc_core/remote_measure/remote_measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "oc_core/base/error.h"
#include "oc_core/evaluation/flip.h"
#include "oc_core/image/image_error.h"
#include "oc_core/remote_measure/frame_play.h"
#include "oc_core/remote_measure/stream_play.h"
#include "oc_core/remote_measure/video_stream.h"

namespace ocelli {
namespace {

constexpr const char* kJpegMode = "jpeg";
constexpr size_t kMoments = 4;

double meanOf(std::span<const double> values) {
  return values.empty() ? 0 : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// One measurement as it runs.
class PathMeasurement {
 public:
  PathMeasurement(const RemoteScene& scene, const RemoteMeasureOptions& options, const Progress& progress)
      : scene_(scene),
        options_(options),
        progress_(progress),
        film_(scene, options.path, options.screen, options.truthSamples) {
    for (size_t i = 0; i < kMoments; ++i) {
      const size_t frame = options.path.views.size() * (2 * i + 1) / (2 * kMoments) / options.every * options.every;
      if (found_.truth.emplace(frame, film_.frame(frame)).second) {
        found_.moments.push_back(frame);
      }
    }
  }

  RemoteMeasurement measure() {
    for (const std::string& mode : options_.modes) {
      if (const ImageMode* const images = findImageMode(mode)) {
        measureImages(*images);
      } else if (const StreamKind* const stream = findStreamKind(mode)) {
        measureStreams(*stream);
      } else {
        measureFrames();
      }
    }
    return std::move(found_);
  }

 private:
  void tell(const std::string& what) {
    stage_ = what;
    report(progress_, stage_, 0);
  }

  bool keeps(size_t frame, const LinkSpeed& link) const {
    return link == options_.links.front() && found_.truth.contains(frame);
  }

  void judge(const Image<Rgb8>& picture, size_t truthFrame, PictureErrors& errors) const {
    const Image<Rgb8> truth = film_.frame(truthFrame);
    errors.add(flip(picture, truth), meanSquaredError(picture, truth));
    report(progress_, stage_, static_cast<double>(truthFrame) / static_cast<double>(film_.frames()));
  }

  ModeFigures figuresOf(const std::string& mode, const std::string& variant, const LinkSpeed& link,
                        const Playback& playback) const {
    ModeFigures row;
    row.mode = mode;
    row.variant = variant;
    row.link = link;
    row.bytes = playback.bytes;
    row.images = playback.images;
    row.firstPictureSeconds = playback.firstPictureSeconds;
    row.viewsPerSecond = viewsPerSecond(options_.path, playback.shown);
    row.clientFrameSeconds = playback.clientFrameSeconds;
    row.clientDecodeSeconds = playback.clientDecodeSeconds;
    row.covered = coveredShare(playback.shown);
    row.stalls = stallsOf(options_.path, playback.shown, false);
    row.coveredStalls = stallsOf(options_.path, playback.shown, true);
    row.lags = lagsOf(options_.path, playback.shown);
    row.meanLagSeconds = meanOf(row.lags);
    for (size_t k = 0; k < playback.shown.size(); k += options_.every) {
      row.blackFrames += !playback.shown[k].frame;
    }
    return row;
  }

  void measureImages(const ImageMode& mode) {
    if (std::string_view(mode.name) == "di" && found_.equalSize == 0) {
      tell("finding the size of plain images");
      found_.equalSize = equalBytesSize(scene_, options_.path.views.front(), options_.screen, options_.settings);
    }
    const RemoteSettings settings = mode.settings(options_.settings, found_.equalSize);
    for (const LinkSpeed& link : options_.links) {
      tell(fmt::format("{} over {}", mode.name, link.name()));
      const ImagePlayOptions play{options_.screen,        options_.rule,          options_.serverSeconds,
                                  options_.clientSeconds, options_.decodeSeconds, options_.every};
      PictureErrors errors;
      std::vector<size_t> judged;
      std::map<size_t, Image<Rgb8>> kept;
      const Playback playback =
          playImages(scene_, options_.path, link, mode, settings, play, [&](size_t frame, const Image<Rgb8>& picture) {
            judge(picture, frame, errors);
            judged.push_back(frame);
            if (keeps(frame, link)) {
              kept.emplace(frame, picture);
            }
          });
      ModeFigures row = figuresOf(mode.name, "", link, playback);
      row.shown = std::move(errors);
      row.judged = std::move(judged);
      row.kept = std::move(kept);
      addRow(std::move(row));
    }
  }

  /// Of what shows nothing no error is known: black is near enough to a dark scene.
  void addRow(ModeFigures row) {
    if (!row.firstPictureSeconds) {
      row.shown = {};
      row.judged.clear();
      row.blackFrames = 0;
      row.kept.clear();
    }
    found_.rows.push_back(std::move(row));
  }

  /// Judges the black screen before the first picture.
  void judgeBlack(ModeFigures& row, const Playback& playback) const {
    const Image<Rgb8> black(options_.screen.x, options_.screen.y);
    for (size_t k = 0; k < playback.shown.size() && !playback.shown[k].frame; k += options_.every) {
      judge(black, k, row.shown);
      row.judged.push_back(k);
      if (keeps(k, row.link)) {
        row.kept.emplace(k, black);
      }
    }
  }

  /// The frames that are on the screen where pictures are judged: frame of the path, and whose view it is.
  std::vector<std::pair<size_t, size_t>> judgedFrames(const Playback& playback) const {
    std::vector<std::pair<size_t, size_t>> frames;
    for (size_t k = 0; k < playback.shown.size(); k += options_.every) {
      if (playback.shown[k].frame) {
        frames.emplace_back(k, *playback.shown[k].frame);
      }
    }
    return frames;
  }

  void judgeShown(ModeFigures& row, size_t frame, size_t shownFrame, const Image<Rgb8>& picture) const {
    judge(picture, frame, row.shown);
    judge(picture, shownFrame, row.withoutLatency);
    row.judged.push_back(frame);
    if (keeps(frame, row.link)) {
      row.kept.emplace(frame, picture);
    }
  }

  void measureFrames() {
    const ColorCodec* const codec = findColorCodec(kJpegMode);
    if (codec == nullptr) {
      found_.leftOut.emplace_back("jpeg: this build has no JPEG (OCELLI_WITH_JPEG)");
      return;
    }
    for (const double quality : options_.jpegQualities) {
      FrameBytes frames(film_, *codec, quality);
      for (const FramePacing& pacing : framePacings()) {
        for (const LinkSpeed& link : options_.links) {
          tell(fmt::format("jpeg of quality {:g}, {}, over {}", quality, pacing.name, link.name()));
          const Playback playback = playFrames(options_.path, link, pacing, frames, options_.peerSeconds);
          ModeFigures row = figuresOf(kJpegMode, fmt::format("{:g}, {}", quality, pacing.name), link, playback);
          judgeBlack(row, playback);
          for (const auto& [frame, shownFrame] : judgedFrames(playback)) {
            judgeShown(row, frame, shownFrame, frames.picture(shownFrame));
          }
          addRow(std::move(row));
        }
      }
    }
  }

  void measureStreams(const StreamKind& kind) {
    const StreamEncoder encoder(kind);
    if (!encoder.isThere()) {
      found_.leftOut.push_back(std::string(kind.name) + ": " + encoder.missing());
      return;
    }
    film_.complete(progress_);
    std::map<double, StreamEncoder::Stream> streams;  // by the rate of the link that carries them
    for (const LinkSpeed& link : options_.links) {
      tell(fmt::format("{} over {}", kind.name, link.name()));
      if (!streams.contains(link.bytesPerSecond)) {
        streams.emplace(
            link.bytesPerSecond,
            encoder.encode(film_, {options_.streamFactor, streamBytesPerSecond(link, film_.framesPerSecond())},
                           progress_));
      }
      const StreamEncoder::Stream& stream = streams.at(link.bytesPerSecond);
      const Playback playback = playStream(options_.path, link, stream.frameBytes, options_.peerSeconds);
      ModeFigures row = figuresOf(kind.name, "", link, playback);
      judgeBlack(row, playback);
      std::map<size_t, std::vector<size_t>> framesOfShown;
      std::vector<size_t> shownFrames;
      for (const auto& [frame, shownFrame] : judgedFrames(playback)) {
        if (framesOfShown[shownFrame].empty()) {
          shownFrames.push_back(shownFrame);
        }
        framesOfShown[shownFrame].push_back(frame);
      }
      encoder.decode(stream, options_.screen, shownFrames, [&](size_t shownFrame, const Image<Rgb8>& picture) {
        for (const size_t frame : framesOfShown[shownFrame]) {
          judgeShown(row, frame, shownFrame, picture);
        }
      });
      addRow(std::move(row));
    }
    streams.clear();
    measureCurve(kind, encoder);
  }

  void measureCurve(const StreamKind& kind, const StreamEncoder& encoder) {
    StreamCurve curve{kind.name, {}, {}};
    std::vector<size_t> frames;
    for (size_t k = 0; k < film_.frames(); k += options_.every) {
      frames.push_back(k);
    }
    for (const double factor : options_.rateFactors) {
      tell(fmt::format("{} at a rate factor of {:g}", kind.name, factor));
      const StreamEncoder::Stream stream = encoder.encode(film_, {factor, std::nullopt}, progress_);
      PictureErrors errors;
      encoder.decode(stream, options_.screen, frames,
                     [&](size_t frame, const Image<Rgb8>& picture) { judge(picture, frame, errors); });
      size_t bytes = 0;
      for (const size_t each : stream.frameBytes) {
        bytes += bytesOnTheWire(each);
      }
      curve.points.push_back({factor, static_cast<double>(bytes), errors.meanFlip()});
      curve.flips.push_back(std::move(errors.flips));
    }
    found_.curves.push_back(std::move(curve));
  }

  const RemoteScene& scene_;
  const RemoteMeasureOptions& options_;
  const Progress& progress_;
  PathFilm film_;
  std::string stage_;
  RemoteMeasurement found_;
};

void checkOptions(const RemoteMeasureOptions& options) {
  std::string names;
  for (const RemoteModeName& mode : remoteModes()) {
    names += (names.empty() ? "" : ", ") + mode.name;
  }
  for (const std::string& mode : options.modes) {
    const std::vector<RemoteModeName> known = remoteModes();
    if (std::none_of(known.begin(), known.end(), [&](const RemoteModeName& each) { return each.name == mode; })) {
      throw InputError("there is no mode \"" + mode + "\"", "--modes", "one or more of: " + names);
    }
  }
  if (options.modes.empty() || options.links.empty() || options.path.views.empty() || options.every == 0) {
    throw InputError("there is nothing to measure", "--modes, --link, --frames",
                     "give at least one mode, one link and one frame");
  }
  validate(options.settings, "settings");
}

}  // namespace

std::vector<RemoteModeName> remoteModes() {
  std::vector<RemoteModeName> modes;
  for (const ImageMode& mode : imageModes()) {
    modes.push_back({mode.name, mode.meaning});
  }
  modes.push_back({kJpegMode, "each frame as a JPEG, of several qualities, asked for one by one or sent on"});
  for (const StreamKind& kind : streamKinds()) {
    modes.push_back({kind.name, kind.meaning});
  }
  return modes;
}

void PictureErrors::add(double flip, double squaredError) {
  flips.push_back(flip);
  squaredErrors += squaredError;
}

double PictureErrors::meanFlip() const {
  return meanOf(flips);
}

double PictureErrors::flip95() const {
  if (flips.empty()) {
    return 0;
  }
  std::vector<double> sorted = flips;
  std::sort(sorted.begin(), sorted.end());
  const auto rank = static_cast<size_t>(std::ceil(0.95 * static_cast<double>(sorted.size())));
  return sorted[std::max<size_t>(rank, 1) - 1];
}

double PictureErrors::psnrDecibels() const {
  return ocelli::psnrDecibels(flips.empty() ? 0 : squaredErrors / static_cast<double>(flips.size()));
}

double ModeFigures::pictureFlip() const {
  return meanOf(std::span(shown.flips).subspan(std::min(blackFrames, shown.flips.size())));
}

RemoteMeasurement measureRemote(const RemoteScene& scene, const RemoteMeasureOptions& options,
                                const Progress& progress) {
  checkOptions(options);
  return PathMeasurement(scene, options, progress).measure();
}

std::optional<double> bytesOfEqualStream(const RemoteMeasurement& measurement, const std::string& mode,
                                         const ModeFigures& row) {
  for (const StreamCurve& curve : measurement.curves) {
    if (curve.mode == mode && row.shown.flips.size() > row.blackFrames) {
      std::vector<RatePoint> points = curve.points;
      for (size_t i = 0; i < points.size(); ++i) {
        points[i].flip = meanOf(std::span(curve.flips[i]).subspan(row.blackFrames));
      }
      return bytesAtFlip(std::move(points), row.pictureFlip());
    }
  }
  return std::nullopt;
}

}  // namespace ocelli
