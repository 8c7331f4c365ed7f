#include "oc_core/feeds_calibration/calibrate_feeds.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <nlohmann/json.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/json_document.h"
#include "oc_core/feeds_video/video_reader.h"

namespace ocelli {
namespace {

constexpr double kSourceWaitSeconds = 10;
constexpr size_t kMaxBoardFrames = 100000;
/// A second of video has no more than this many views that differ; looking for boards is slow.
constexpr double kBoardFrameSeconds = 0.2;
constexpr double kDoubtfulPixels = 2;

std::vector<std::string> sourcesOf(const std::string& source) {
  if (!std::filesystem::is_directory(source)) {
    return {source};
  }
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(source)) {
    if (entry.is_regular_file() && !entry.path().filename().string().starts_with('.')) {
      files.push_back(entry.path().string());
    }
  }
  std::ranges::sort(files);
  if (files.empty()) {
    throw InputError("the folder has no files", source, "put images of the board into it");
  }
  return files;
}

void checkSize(const Image<Rgb8>& image, int width, int height, const std::string& where, const std::string& next) {
  if (image.width() != width || image.height() != height) {
    throw InputError(
        fmt::format("an image has {}x{} pixels, and {}x{} are expected", image.width(), image.height(), width, height),
        where, next);
  }
}

std::vector<Image<Rgb8>> firstImages(const Feed& feed, size_t count, double maxWaitSeconds) {
  const std::atomic<bool> stop{false};
  VideoReader reader({feed.source, feed.width, feed.height, feed.framesPerSecond, feed.ffmpegOptions}, maxWaitSeconds,
                     stop);
  std::vector<Image<Rgb8>> images;
  VideoFrame frame;
  while (images.size() < count && reader.next(frame)) {
    checkSize(frame.image, feed.width, feed.height, "feed \"" + feed.name + "\"",
              "a lens holds for one size of image: set the camera to it, or calibrate the lens again");
    images.push_back(std::move(frame.image));
  }
  if (images.empty()) {
    throw InputError("there is no image in " + feed.source, "feed \"" + feed.name + "\"", "check it with `ffprobe`");
  }
  return images;
}

struct NamedPoints {
  std::vector<WorldPoint> points;
  std::vector<std::string> names;
};

void addTag(NamedPoints& points, const SeenTag& seen, const KnownTag& known) {
  for (size_t c = 0; c < seen.corners.size(); ++c) {
    points.points.push_back({seen.corners[c], known.corners[c]});
    points.names.push_back(fmt::format("tag {}", seen.id));
  }
}

/// The feeds that see each tag.
using TagViews = std::map<int, std::vector<std::string>>;

void calibrateFeed(Feed& feed, const KnownPlaces& places, const std::string& where,
                   const PoseCalibrationOptions& options, TagViews& views, FeedCalibration& result) {
  NamedPoints points;
  std::vector<const KnownTag*> known;
  if (!places.tags.empty()) {
    std::vector<std::vector<SeenTag>> seen;
    for (const Image<Rgb8>& image : firstImages(feed, options.images, options.maxWaitSeconds)) {
      seen.push_back(tagsIn(image));
    }
    for (const SeenTag& tag : meanTags(seen)) {
      views[tag.id].push_back(feed.name);
      const KnownTag* place = places.tag(tag.id);
      if (place == nullptr) {
        ++result.unknown;
        continue;
      }
      ++result.tags;
      known.push_back(place);
      addTag(points, tag, *place);
    }
  }
  size_t number = 0;
  for (const ClickedCorner& corner : places.corners) {
    ++number;
    if (corner.feed == feed.name) {
      points.points.push_back({corner.pixel, corner.point});
      points.names.push_back(fmt::format("corner {}", number));
    }
  }
  const std::string place = "feed \"" + feed.name + "\" with " + where;
  const SolvedPose solved = options.hasNoLens ? solvePoseAndFocal(points.points, feed.width, feed.height, place)
                                              : solvePose(points.points, feed.lens, place);
  for (const KnownTag* tag : known) {
    if (!(glm::dot(solved.pose.eye - tag->corners[0], frontOf(*tag)) > 0)) {
      throw InputError(fmt::format("tag {} is seen from behind", tag->id), place,
                       "its corners are in the order of a mirror, or its normal goes into the wall: give the corners "
                       "as seen from the front, from top left to top right");
    }
  }
  feed.pose = solved.pose;
  feed.lens = solved.lens;
  result.points = points.points.size();
  result.rmsPixels = solved.rmsPixels;
  result.maxPixels = solved.maxPixels;
  result.worst = points.names[solved.worst];
  if (result.rmsPixels > kDoubtfulPixels) {
    result.warning = fmt::format(
        "feed \"{}\" fits badly, by {:.1f} pixels, worst at {} ({:.1f}): measure that again, "
        "or calibrate the lens",
        feed.name, result.rmsPixels, result.worst, result.maxPixels);
  }
}

/// What runs will check poses by: the tags that were seen, and the corners.
KnownPlaces usedPlaces(const KnownPlaces& places, const TagViews& views) {
  KnownPlaces used;
  for (const KnownTag& tag : places.tags) {
    if (const auto seen = views.find(tag.id); seen != views.end()) {
      used.tags.push_back(tag);
      used.tags.back().seenBy = seen->second;
    }
  }
  used.corners = places.corners;
  return used;
}

}  // namespace

LensCalibration calibrateLensFrom(const std::string& source, const CalibrationBoard& board, const Progress& progress) {
  const std::vector<std::string> files = sourcesOf(source);
  std::vector<BoardView> views;
  int width = 0;
  int height = 0;
  size_t looked = 0;
  for (size_t i = 0; i < files.size(); ++i) {
    const std::atomic<bool> stop{false};
    VideoReader reader({.name = files[i]}, kSourceWaitSeconds, stop);
    VideoFrame frame;
    double next = -HUGE_VAL;
    while (looked < kMaxBoardFrames && reader.next(frame)) {
      if (width == 0) {
        width = frame.image.width();
        height = frame.image.height();
      }
      checkSize(frame.image, width, height, files[i], "give images of one camera with one size");
      if (frame.seconds < next) {
        continue;
      }
      next = frame.seconds + kBoardFrameSeconds;
      ++looked;
      BoardView view = boardViewIn(frame.image, board);
      if (!view.empty()) {
        views.push_back(std::move(view));
      }
      report(progress, fmt::format("{} of {} images show the board", views.size(), looked),
             static_cast<double>(i) / static_cast<double>(files.size()));
    }
  }
  return calibrateLens(differentViews(views, width), width, height, source);
}

std::string jsonText(const FeedLens& lens) {
  const nlohmann::ordered_json json{{"focal", {lens.focal.x, lens.focal.y}},
                                    {"center", {lens.center.x, lens.center.y}},
                                    {"k1", lens.k1},
                                    {"k2", lens.k2},
                                    {"p1", lens.p1},
                                    {"p2", lens.p2},
                                    {"k3", lens.k3}};
  return textOfJson(json, 2) + "\n";
}

PoseCalibration calibratePoses(FeedSetup& setup, const KnownPlaces& places, const std::string& where,
                               const PoseCalibrationOptions& options, const Progress& progress) {
  for (const ClickedCorner& corner : places.corners) {
    if (setup.feedIndex(corner.feed) < 0) {
      throw InputError("a corner names the feed \"" + corner.feed + "\", which does not exist", where,
                       "use the name of one of the feeds of the setup");
    }
  }
  PoseCalibration result;
  TagViews seen;
  for (Feed& feed : setup.feeds) {
    report(progress, "looks for tags in feed \"" + feed.name + "\"",
           static_cast<double>(result.feeds.size()) / static_cast<double>(setup.feeds.size()));
    result.feeds.push_back({});
    result.feeds.back().feed = feed.name;
    try {
      calibrateFeed(feed, places, where, options, seen, result.feeds.back());
    } catch (const Error& error) {
      result.feeds.back().failure = error.what();
    }
    if (!result.feeds.back().warning.empty()) {
      result.warnings.push_back(result.feeds.back().warning);
    }
  }
  for (const KnownTag& tag : places.tags) {
    if (!seen.contains(tag.id)) {
      result.warnings.push_back(fmt::format(
          "no camera sees tag {}: check its light, its white margin, and that it is 20 pixels wide", tag.id));
    }
  }
  setup.places = usedPlaces(places, seen);
  return result;
}

PoseCheck checkPose(const FeedSetup& setup, size_t index, const Image<Rgb8>& image, const KnownPlaces& places,
                    double movedPixels) {
  const Feed& feed = setup.feeds[index];
  const std::string camera = fmt::format("camera {} ({})", index + 1, feed.name);
  checkSize(image, feed.width, feed.height, "feed \"" + feed.name + "\"",
            "a lens holds for one size of image: set the camera to it, or calibrate again");
  PoseCheck check;
  check.feed = feed.name;
  check.shouldSeeTags = std::ranges::any_of(
      places.tags, [&](const KnownTag& tag) { return std::ranges::find(tag.seenBy, feed.name) != tag.seenBy.end(); });
  std::vector<double> errors;
  for (const SeenTag& seen : tagsIn(image)) {
    const KnownTag* known = places.tag(seen.id);
    if (known == nullptr) {
      continue;
    }
    ++check.tags;
    for (size_t c = 0; c < seen.corners.size(); ++c) {
      const auto pixel = pixelOfPoint(feed.lens, feed.pose, known->corners[c]);
      errors.push_back(pixel ? glm::distance(*pixel, seen.corners[c]) : std::hypot(feed.width, feed.height));
    }
  }
  if (errors.empty()) {
    check.message = camera + " sees no known tag: whether it has moved is unknown; look at its image for the tags";
    return check;
  }
  const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
  std::nth_element(errors.begin(), middle, errors.end());
  check.medianPixels = *middle;
  check.hasMoved = check.medianPixels > movedPixels;
  if (check.hasMoved) {
    check.message = fmt::format("{} has moved: {:.0f} pixels; put it back, or run `ocelli feeds calibrate pose`",
                                camera, check.medianPixels);
  }
  return check;
}

std::vector<PoseCheck> checkPoses(const FeedSetup& setup, const KnownPlaces& places, double movedPixels,
                                  const PoseCalibrationOptions& options) {
  std::vector<PoseCheck> checks;
  for (size_t i = 0; i < setup.feeds.size(); ++i) {
    checks.push_back(
        checkPose(setup, i, firstImages(setup.feeds[i], 1, options.maxWaitSeconds)[0], places, movedPixels));
  }
  return checks;
}

}  // namespace ocelli
