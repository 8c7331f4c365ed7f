// The JSON form of a setup.
#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/output_file.h"
#include "oc_core/feeds/feed_fields.h"
#include "oc_core/feeds/feed_setup.h"

namespace ocelli {
namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr const char* kSetupSchema = "oc_core/feeds/feeds_setup.schema.json";
constexpr size_t kMaxSourceLength = 4096;
constexpr size_t kMaxOptions = 32;
constexpr const char* kDevicePrefix = "v4l2:";

FeedLens readLens(JsonFields fields, const Feed& feed) {
  FeedLens lens;
  const std::vector<double> focal = fields.numbers("focal", 2, 1, 1e6);
  lens.focal = {focal[0], focal[1]};
  lens.center = {feed.width / 2.0, feed.height / 2.0};
  if (fields.has("center")) {
    const std::vector<double> center = fields.numbers("center", 2, -kMaxFeedPixels, 2.0 * kMaxFeedPixels);
    lens.center = {center[0], center[1]};
  }
  lens.k1 = fields.number("k1", -10, 10, 0);
  lens.k2 = fields.number("k2", -10, 10, 0);
  lens.p1 = fields.number("p1", -1, 1, 0);
  lens.p2 = fields.number("p2", -1, 1, 0);
  lens.k3 = fields.number("k3", -10, 10, 0);
  fields.rejectUnknown();
  return lens;
}

FeedPose readPose(JsonFields fields) {
  FeedPose pose;
  pose.eye = readFeedPoint(fields, "eye");
  pose.target = readFeedPoint(fields, "target");
  if (fields.has("up")) {
    pose.up = readFeedPoint(fields, "up");
  }
  const glm::dvec3 ahead = pose.target - pose.eye;
  if (!(glm::length(ahead) > 0) || !(glm::length(glm::cross(ahead, pose.up)) > 1e-9 * glm::length(ahead))) {
    fields.fail("target", "is where the eye is, or up is along the view direction");
  }
  fields.rejectUnknown();
  return pose;
}

Feed readFeed(JsonFields& fields) {
  Feed feed;
  feed.name = fields.shortText("name", kMaxFeedNameLength);
  feed.source = fields.shortText("source", kMaxSourceLength);
  feed.ffmpegOptions = fields.texts("ffmpeg_options", 0, kMaxOptions, kMaxSourceLength);
  feed.framesPerSecond = fields.number("frames_per_second", 0, 1000, 0);
  feed.width = fields.integer("width", 16, kMaxFeedPixels);
  feed.height = fields.integer("height", 16, kMaxFeedPixels);
  feed.lens = readLens(fields.inner("lens"), feed);
  feed.pose = readPose(fields.inner("pose"));
  feed.clockOffsetSeconds = fields.number("clock_offset_seconds", -1e9, 1e9, 0);
  if (fields.has("background")) {
    feed.background = fields.shortText("background", kMaxSourceLength);
  }
  return feed;
}

FeedFrustum readFrustum(JsonFields& fields) {
  FeedFrustum frustum;
  frustum.feed = fields.shortText("feed", kMaxFeedNameLength);
  if (fields.has("parent")) {
    frustum.parent = fields.shortText("parent", kMaxFeedNameLength);
    frustum.near = readFeedCorners(fields, "near");
  }
  return frustum;
}

FeedSetup readSetup(JsonFields fields, const std::string& where) {
  FeedSetup setup;
  fields.forEach("feeds", 1, kMaxFeeds, [&](JsonFields& each) { setup.feeds.push_back(readFeed(each)); });
  fields.forEach("frusta", 1, kMaxFeeds, [&](JsonFields& each) { setup.frusta.push_back(readFrustum(each)); });
  JsonFields output = fields.inner("output");
  setup.output.width = output.integer("width", 16, kMaxFeedPixels);
  setup.output.height = output.integer("height", 16, kMaxFeedPixels);
  setup.output.fovVerticalDegrees = output.number("fov_vertical_degrees", 1, 170);
  const bool hasTarget = output.has("target");
  if (hasTarget) {
    setup.output.target = readFeedPoint(output, "target");
  }
  output.rejectUnknown();
  setup.floorHeight = fields.number("floor", -kMaxFeedMetres, kMaxFeedMetres, 0);
  setup.fadeMetres = fields.number("fade", 0, 100, 0.3);
  if (fields.has("places")) {
    setup.places = readPlacesFields(fields.inner("places"));
  }
  fields.rejectUnknown();
  orderFrusta(setup, where);
  if (!hasTarget) {
    setup.output.target = setup.feeds[static_cast<size_t>(setup.feedIndex(setup.frusta[0].feed))].pose.target;
  }
  return setup;
}

OrderedJson jsonOf(const Feed& feed) {
  const FeedLens& lens = feed.lens;
  OrderedJson json{{"name", feed.name},
                   {"source", feed.source},
                   {"width", feed.width},
                   {"height", feed.height},
                   {"lens",
                    {{"focal", {lens.focal.x, lens.focal.y}},
                     {"center", {lens.center.x, lens.center.y}},
                     {"k1", lens.k1},
                     {"k2", lens.k2},
                     {"p1", lens.p1},
                     {"p2", lens.p2},
                     {"k3", lens.k3}}},
                   {"pose",
                    {{"eye", jsonOfPoint(feed.pose.eye)},
                     {"target", jsonOfPoint(feed.pose.target)},
                     {"up", jsonOfPoint(feed.pose.up)}}},
                   {"clock_offset_seconds", feed.clockOffsetSeconds}};
  if (!feed.ffmpegOptions.empty()) {
    json["ffmpeg_options"] = feed.ffmpegOptions;
  }
  if (feed.framesPerSecond > 0) {
    json["frames_per_second"] = feed.framesPerSecond;
  }
  if (!feed.background.empty()) {
    json["background"] = feed.background;
  }
  return json;
}

}  // namespace

bool isFeedFile(const std::string& source) {
  return !source.empty() && source.find("://") == std::string::npos && !source.starts_with(kDevicePrefix);
}

FeedSetup feedSetupFromJsonText(const std::string& text, const std::string& where) {
  const JsonDocument document(text, where);
  return readAs(kSetupSchema, [&] { return readSetup(JsonFields(document), where); });
}

FeedSetup readFeedSetup(const std::filesystem::path& path) {
  FeedSetup setup = feedSetupFromJsonText(readFile(path), path.string());
  const std::filesystem::path folder = path.parent_path();
  const auto resolve = [&](std::string& file) {
    if (isFeedFile(file)) {
      file = (folder / file).string();
    }
  };
  for (Feed& feed : setup.feeds) {
    resolve(feed.source);
    resolve(feed.background);
  }
  return setup;
}

void writeFeedSetup(FeedSetup setup, const std::filesystem::path& path) {
  const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
  for (Feed& feed : setup.feeds) {
    for (std::string* file : {&feed.source, &feed.background}) {
      if (isFeedFile(*file)) {
        *file = std::filesystem::absolute(*file).lexically_proximate(folder).string();
      }
    }
  }
  OutputFile file(path);
  file.write(jsonText(setup));
  file.commit();
}

std::string jsonText(const FeedSetup& setup) {
  OrderedJson feeds = OrderedJson::array();
  for (const Feed& feed : setup.feeds) {
    feeds.push_back(jsonOf(feed));
  }
  OrderedJson frusta = OrderedJson::array();
  for (const FeedFrustum& frustum : setup.frusta) {
    OrderedJson json{{"feed", frustum.feed}};
    if (!frustum.isRoot()) {
      json["parent"] = frustum.parent;
      json["near"] = jsonOfCorners(frustum.near);
    }
    frusta.push_back(json);
  }
  OrderedJson json{{"feeds", feeds},
                   {"frusta", frusta},
                   {"output",
                    {{"width", setup.output.width},
                     {"height", setup.output.height},
                     {"fov_vertical_degrees", setup.output.fovVerticalDegrees},
                     {"target", jsonOfPoint(setup.output.target)}}},
                   {"floor", setup.floorHeight},
                   {"fade", setup.fadeMetres}};
  if (!setup.places.tags.empty() || !setup.places.corners.empty()) {
    json["places"] = jsonOfPlaces(setup.places);
  }
  return textOfJson(json, 2) + "\n";
}

}  // namespace ocelli
