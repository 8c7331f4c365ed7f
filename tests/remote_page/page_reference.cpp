// What the page of remote visualisation is compared with: numbers and pictures of the C++ code.
//
//   page_reference numbers
//     prints JSON: maps of general pinholes, rays of views, what images cover, views ahead, plans, when a client asks,
//     and coded depths
//   page_reference picture HEADER COLOR DEPTH VIEW WIDTHxHEIGHT OUT.png
//     what a view of the image shows that these files hold as it came over the link; DEPTH may be empty
#include <algorithm>
#include <deque>
#include <filesystem>
#include <fstream>
#include <glm/common.hpp>
#include <iostream>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "oc_core/camera/gpc_map.h"
#include "oc_core/image/png_file.h"
#include "oc_core/image_codecs/image_codec.h"
#include "oc_core/ocri/resample.h"
#include "oc_core/remote/client/image_cover.h"
#include "oc_core/remote/client/remote_client.h"
#include "oc_core/remote/client/view_motion.h"
#include "oc_core/remote/depth_smoothing.h"
#include "oc_core/remote/remote_image.h"
#include "oc_core/remote/remote_plan.h"

namespace ocelli {
namespace {

using Json = nlohmann::ordered_json;

Json numbers(const glm::dvec2& v) {
  return {v.x, v.y};
}
Json numbers(const glm::dvec3& v) {
  return {v.x, v.y, v.z};
}

std::string bytesOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Two regions that nearly touch, one of them narrower than its transition is wide.
GpcLayout twoRegions(const GpcSampling& sampling) {
  return {.sampling = &sampling,
          .regions = {{.center = {0.3f, 0.45f}, .extent = {0.25f, 0.3f}, .zoom = 3, .transitionWidth = 0.8f},
                      {.center = {0.77f, 0.6f}, .extent = {0.1f, 0.2f}, .zoom = 6, .transitionWidth = 1.9f}}};
}

Json mapNumbers() {
  Json maps = Json::array();
  std::mt19937 random(7);
  for (const GpcSampling& sampling : gpcSamplings()) {
    const glm::dvec2 size(1920, 1080);
    const GpcMap map(twoRegions(sampling), 1920, 1080);
    Json points = Json::array();
    for (int i = 0; i < 400; ++i) {
      std::uniform_real_distribution<double> share(0, 1);
      const glm::dvec2 p = glm::dvec2(share(random), share(random)) * size;
      points.push_back({{"point", numbers(p)},
                        {"pinhole", numbers(map.pinholeFromImage(p))},
                        {"image", numbers(map.imageFromPinhole(p))},
                        {"rate", map.rateAt(p)}});
    }
    maps.push_back({{"layout", Json::parse(jsonText(map.layout()))}, {"size", numbers(size)}, {"points", points}});
  }
  return maps;
}

View lookingAround() {
  View view;
  view.eye = {0.5f, 1.5f, 6};
  view.target = {-0.25f, 0.25f, 0};
  view.fovVerticalDegrees = 30;
  return view;
}

Json viewNumbers() {
  View sheared = lookingAround();
  sheared.centerShift = {0.25f, -0.125f};
  Json views = Json::array();
  for (const View& view : {lookingAround(), sheared, View{}}) {
    const PinholeCamera camera(view, 640, 360);
    views.push_back({{"view", Json::parse(jsonText(view))},
                     {"right", numbers(glm::dvec3(camera.right()))},
                     {"down", numbers(glm::dvec3(camera.down()))},
                     {"forward", numbers(glm::dvec3(camera.forward()))},
                     {"focal", camera.focalPixels()},
                     {"center", numbers(glm::dvec2(camera.centerPixels()))}});
  }
  return views;
}

/// Views beside lookingAround(), as a user moves.
std::vector<View> movedViews() {
  std::vector<View> views;
  for (int i = 0; i < 12; ++i) {
    View view = movedEye(lookingAround(), {0.02f * static_cast<float>(i % 4), 0, 0.05f * static_cast<float>(i % 3)});
    view.target.x += 0.2f * static_cast<float>(i);
    view.fovVerticalDegrees = 30.0 - 2 * i;
    views.push_back(view);
  }
  return views;
}

Json coverNumbers() {
  RemoteRequest request;
  request.view = lookingAround();
  request.screen = {640, 360};
  const RemoteSettings settings;
  const RemotePlan plan = planRemoteImage(request, settings);
  const ImageCover cover(plan.reference, plan.layout, 4.5);
  Json loads = Json::array();
  for (const View& view : movedViews()) {
    const CoverLoad load = coverLoad(cover, view, request.screen, {});
    loads.push_back(
        {{"view", Json::parse(jsonText(view))}, {"reach", load.reach}, {"detail", load.detail}, {"shift", load.shift}});
  }
  return {{"request", Json::parse(jsonText(request))},
          {"settings", Json::parse(jsonText(settings))},
          {"planned",
           {{"view", Json::parse(jsonText(plan.reference.view()))},
            {"size", {plan.reference.width(), plan.reference.height()}},
            {"layout", Json::parse(jsonText(plan.layout))}}},
          {"near", cover.nearZ},
          {"loads", loads}};
}

Json motionNumbers() {
  Json motions = Json::array();
  for (const View& view : movedViews()) {
    const ViewMotion motion = motionBetween(lookingAround(), view, 0.1);
    motions.push_back({{"to", Json::parse(jsonText(view))},
                       {"eye", numbers(motion.eyePerSecond)},
                       {"turn", numbers(motion.turnPerSecond)},
                       {"zoom", motion.zoomPerSecond},
                       {"ahead", Json::parse(jsonText(viewAhead(view, motion, 0.05)))}});
  }
  return {{"from", Json::parse(jsonText(lookingAround()))}, {"motions", motions}};
}

/// What a user looks at, so many seconds from the beginning: rests, a turn, a zoom, and a step to the side.
View pathView(double seconds) {
  const auto part = [&](double begin, double end) {
    return static_cast<float>(std::clamp(seconds, begin, end) - begin);
  };
  View view = movedEye(lookingAround(), {0.4f * part(4.2, 5.2), 0, 0});
  view.target.x += 1.3f * part(1, 2.5);
  view.fovVerticalDegrees = 30 - 12 * static_cast<double>(part(3.2, 4.2));
  return view;
}

/// When the client asks along this path, and for what, with images of a wall that come 0.4 s later.
Json requestNumbers() {
  constexpr double kFrame = 1.0 / 32;
  constexpr double kTrip = 0.4;
  constexpr float kWallZ = 5;
  const glm::ivec2 screen(160, 90);
  const RemoteSettings settings;
  const auto planned = [&](const View& view) {
    return planRemoteImage(RemoteRequest{.view = view, .screen = screen}, settings);
  };
  RemoteClient client(screen, [&](const View& view) {
    const RemotePlan plan = planned(view);
    return ImageCover(plan.reference, plan.layout);
  });
  std::deque<std::pair<double, ImageWish>> underWay;
  Json frames = Json::array();
  Json asked = Json::array();
  for (int i = 0; i * kFrame < 7; ++i) {
    const double seconds = i * kFrame;
    while (!underWay.empty() && underWay.front().first <= seconds) {
      const auto [due, wish] = underWay.front();
      underWay.pop_front();
      const RemotePlan plan = planned(wish.view);
      ReferenceImage image =
          blankReferenceImage("gpc", plan.reference.view(), plan.reference.width(), plan.reference.height());
      image.layout = plan.layout;
      for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
          image.set(x, y, kWallZ, glm::vec3(1));
        }
      }
      client.receive(wish.sequence, image, true, seconds);
    }
    const View view = pathView(seconds);
    frames.push_back(Json::parse(jsonText(view)));
    if (const std::optional<ImageWish> wish = client.look(view, seconds)) {
      const RemotePlan plan = planned(wish->view);
      underWay.emplace_back(seconds + kTrip, *wish);
      asked.push_back({{"frame", i},
                       {"view", Json::parse(jsonText(wish->view))},
                       {"planned", Json::parse(jsonText(plan.reference.view()))},
                       {"size", {plan.reference.width(), plan.reference.height()}},
                       {"layout", Json::parse(jsonText(plan.layout))}});
    }
  }
  return {{"screen", {screen.x, screen.y}},
          {"settings", Json::parse(jsonText(settings))},
          {"frame_seconds", kFrame},
          {"trip", kTrip},
          {"near", kWallZ},
          {"frames", frames},
          {"asked", asked}};
}

/// A slope, a step and noise: every branch of the prediction.
Json depthNumbers() {
  Image<uint16_t> image(67, 43);
  std::mt19937 random(3);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const int value = x < 42   ? 1000 + (4 * x + 7 * y) / 10  // levels of a plane, which are smoothed
                        : x < 47 ? 0
                                 : static_cast<int>(random() % 65536);
      image(x, y) = static_cast<uint16_t>(value);
    }
  }
  const Image<float> smoothed = smoothedLevels(image);
  Json coded = Json::object();
  for (const DepthCodec& codec : depthCodecs()) {
    if (codec.inBrowsers) {
      Json bytes = Json::array();
      for (const std::byte each : codec.encode(image)) {
        bytes.push_back(static_cast<int>(each));
      }
      coded[codec.name] = bytes;
    }
  }
  return {{"size", {image.width(), image.height()}},
          {"values", std::vector<int>(image.begin(), image.end())},
          {"smoothed", std::vector<float>(smoothed.begin(), smoothed.end())},
          {"coded", coded}};
}

void printNumbers() {
  const Json all{{"maps", mapNumbers()},      {"views", viewNumbers()},       {"cover", coverNumbers()},
                 {"motion", motionNumbers()}, {"requests", requestNumbers()}, {"depth", depthNumbers()}};
  std::cout << all.dump() << '\n';
}

void writePicture(char** files) {
  const auto asBytes = [](const std::string& text) {
    return std::span(reinterpret_cast<const std::byte*>(text.data()), text.size());
  };
  const std::string color = bytesOf(files[1]);
  const std::string depth = bytesOf(files[2]);
  const ReferenceImage image = decodeRemoteImage(bytesOf(files[0]), asBytes(color), asBytes(depth));
  int width = 0;
  int height = 0;
  char by = 0;
  std::istringstream(files[4]) >> width >> by >> height;
  const PinholeCamera camera(readView(files[3]), width, height);
  writePng(files[5], srgbFromLinear(resample({image}, camera).color));
}

}  // namespace
}  // namespace ocelli

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  try {
    if (what == "numbers" && argc == 2) {
      ocelli::printNumbers();
    } else if (what == "picture" && argc == 8) {
      ocelli::writePicture(argv + 2);
    } else {
      std::cerr << "usage: page_reference numbers | picture HEADER COLOR DEPTH VIEW WIDTHxHEIGHT OUT.png\n";
      return 2;
    }
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
