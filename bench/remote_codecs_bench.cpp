// Which images serve remote visualisation best: for each scene, the frames of a path that stays within what one image
// covers are resampled from that image after it was encoded and decoded, and compared by FLIP with what is drawn
// directly. Tables: --table plans, of settings; colors, of the formats of colours; depths, of those of depths and of
// their levels.
//
// Bytes and FLIP do not depend on the machine. Times are wall time of both cores, the least of --runs: on a machine
// that does other work they tell orders of magnitude.
#include <cmath>
#include <cstdio>

#include "bench/bench_program.h"
#include "bench/remote_frames.h"
#include "bench/timing.h"
#include "oc_core/evaluation/flip.h"
#include "oc_core/image/color.h"
#include "oc_core/image/image_error.h"
#include "oc_core/image_codecs/image_codec.h"
#include "oc_core/ocri/resample.h"
#include "oc_core/remote/depth_smoothing.h"
#include "oc_core/remote/remote_depth.h"
#include "oc_core/render/rasterize_gpc.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

struct RemoteBenchChoice {
  std::string table = "plans";
  std::vector<std::string> scenes;  ///< names of kRemoteCases; empty: all
  std::vector<std::string> settings;
  std::vector<double> qualities{50, 75, 85, 90, 95};
  std::vector<int> levels{32, 128, 512, 4096, 65535};
  size_t frames = 8;
  size_t moved = 6;
  RemoteRange range;
  int directSamples = 1;
  std::string folder;  ///< for frames as PNG; empty: none
  int runs = 1;
  int threads = 0;
  int width = 1280;
  int height = 720;
};

struct RemoteCase {
  const char* name;
  const char* scene;
  const char* view;
};

constexpr RemoteCase kRemoteCases[] = {
    {"statues", "builtin:statues", R"({"eye": [0, 0.3, 10], "target": [0, -0.12, 0], "fov_vertical_degrees": 6.5})"},
    {"canyon", "builtin:canyon", R"({"eye": [0.3, 0.3, 0.6], "target": [0, 0, 0], "fov_vertical_degrees": 50})"},
    {"room", "builtin:room,mesh=buddha.obj",
     R"({"eye": [0.1, 0.1, 0.6], "target": [0, 0, 0], "fov_vertical_degrees": 50})"},
    {"town", "builtin:town",
     R"({"eye": [0, -0.1063, 0.376], "target": [0, -0.1063, 0], "fov_vertical_degrees": 60, "z_near": 0.001, "z_far": 10})"}};

/// A scene, what a client looks at, and what it should see.
class RemoteTrial {
 public:
  RemoteTrial(const RemoteCase& each, const RemoteBenchChoice& choice)
      : name_(each.name),
        folder_(choice.folder),
        scene_(loadScene(each.scene), each.scene),
        screen_(choice.width, choice.height) {
    request_.view = viewFromJsonText(each.view, each.name);
    request_.screen = screen_;
    double nearest = 1e9;
    for (const float t : scene_.draw({PinholeCamera(request_.view, 640, 360), {.regions = {}}}).t) {
      nearest = t > 0 ? std::min(nearest, static_cast<double>(t)) : nearest;
    }
    turned_ = remotePath(request_.view, screen_, choice.range, false, nearest, choice.frames);
    moved_ = remotePath(request_.view, screen_, choice.range, true, nearest, choice.moved);
    for (const View& view : turned_) {
      turnedDirect_.push_back(directFrame(scene_, view, screen_, choice.directSamples));
    }
    for (const View& view : moved_) {
      movedDirect_.push_back(directFrame(scene_, view, screen_, choice.directSamples));
    }
  }

  const RemoteScene& scene() const { return scene_; }
  const RemoteRequest& request() const { return request_; }
  struct Score {
    double flip = 0;
    double holes = 0;
  };
  /// Of views from the image's own eye.
  Score turned(const ReferenceImages& images) const { return score(images, turned_, turnedDirect_, "turned"); }
  /// Of views from elsewhere.
  Score moved(const ReferenceImages& images) const { return score(images, moved_, movedDirect_, "moved"); }

 private:
  Score score(const ReferenceImages& images, const std::vector<View>& views, const std::vector<Image<Rgb8>>& direct,
              const char* kind) const {
    Score sum;
    for (size_t i = 0; i < views.size(); ++i) {
      const ResampledView frame = resample(images, PinholeCamera(views[i], screen_.x, screen_.y));
      const Image<Rgb8> shown = srgbFromLinear(frame.color);
      if (!folder_.empty()) {
        writePng(fmt::format("{}/{}_{}_{}.png", folder_, name_, kind, i), shown);
        writePng(fmt::format("{}/{}_{}_{}_direct.png", folder_, name_, kind, i), direct[i]);
      }
      sum.flip += flip(shown, direct[i]) / static_cast<double>(views.size());
      sum.holes += frame.holes() / static_cast<double>(views.size());
    }
    return sum;
  }

  std::string name_;
  std::string folder_;
  RemoteScene scene_;
  glm::ivec2 screen_;
  RemoteRequest request_;
  std::vector<View> turned_;
  std::vector<View> moved_;
  std::vector<Image<Rgb8>> turnedDirect_;
  std::vector<Image<Rgb8>> movedDirect_;
};

/// The least of so many runs.
template <class Work>
double leastProcessorMilliseconds(int runs, const Work& work) {
  double least = processorMilliseconds(work);
  for (int i = 1; i < runs; ++i) {
    least = std::min(least, processorMilliseconds(work));
  }
  return least;
}

ReferenceImage decoded(const RemoteImage& image) {
  return decodeRemoteImage(image.headerJson, image.color, image.depth);
}

void printPlans(const RemoteCase& each, const RemoteTrial& trial, const RemoteBenchChoice& choice) {
  for (const std::string& text : choice.settings) {
    const RemoteSettings settings = remoteSettingsFromJson(text, "--settings");
    const RemoteImage image = trial.scene().answer(trial.request(), settings, 1);
    const RemoteImageHeader header = remoteImageHeaderFromJson(image.headerJson);
    const ReferenceImages images{decoded(image)};
    const RemoteTrial::Score turned = trial.turned(images);
    const RemoteTrial::Score moved = trial.moved(images);
    fmt::print(
        "{:<8} {:<44} {:>4}x{:<4} {:>8} + {:>7} bytes, {:>5} levels, {:.1f} + {:.1f} s; FLIP {:.4f} ({:.2f} % holes), "
        "moved {:.4f} ({:.2f} %)\n",
        each.name, text, header.size.x, header.size.y, header.colorBytes, header.depthBytes, header.levels,
        header.drawSeconds, header.encodeSeconds, turned.flip, 100 * turned.holes, moved.flip, 100 * moved.holes);
    std::fflush(stdout);
  }
}

void printColors(const RemoteCase& each, const RemoteTrial& trial, const RemoteBenchChoice& choice) {
  const RemoteSettings settings;
  ReferenceImage drawn = trial.scene().draw(planRemoteImage(trial.request(), settings), settings.samples);
  const Image<Rgb8> colors = srgbFromLinear(drawn.color);
  const glm::ivec2 size(colors.width(), colors.height());
  for (const ColorCodec& codec : colorCodecs()) {
    for (const double quality : codec.isLossless ? std::vector<double>{100} : choice.qualities) {
      std::vector<std::byte> bytes;
      Image<Rgb8> back;
      const double encode = leastProcessorMilliseconds(choice.runs, [&] { bytes = codec.encode(colors, quality); });
      const double decode = leastProcessorMilliseconds(choice.runs, [&] { back = codec.decode(bytes, size); });
      for (size_t i = 0; i < back.size(); ++i) {
        drawn.color[i] = {linearFromSrgbByte(back[i].x), linearFromSrgbByte(back[i].y), linearFromSrgbByte(back[i].z)};
      }
      const RemoteTrial::Score turned = trial.turned({drawn});
      fmt::print("{:<8} {:<14} {:>4} {:>9} bytes {:>7.2f} s {:>6.2f} s {:>6.1f} dB FLIP {:.4f}\n", each.name,
                 codec.name, codec.isLossless ? "" : fmt::format("{:.0f}", quality), bytes.size(), encode / 1000,
                 decode / 1000, psnrDecibels(meanSquaredError(back, colors)), turned.flip);
      std::fflush(stdout);
    }
  }
}

/// By how many pixels rounded depths displace samples: the mean, and the greatest.
glm::dvec2 displacedPixels(const ReferenceImage& drawn, const RemoteDepth& depth, const RemoteRange& range) {
  const double moved = range.translation / depth.inverseNear * static_cast<double>(drawn.reference().focalPixels());
  glm::dvec2 error(0);
  size_t held = 0;
  for (size_t i = 0; i < drawn.t.size(); ++i) {
    if (depth.values[i] > 0) {
      const double off = std::abs(depth.inverseDepth(depth.values[i]) - 1 / static_cast<double>(drawn.t[i])) * moved;
      error = {error.x + off, std::max(error.y, off)};
      ++held;
    }
  }
  return {error.x / static_cast<double>(std::max<size_t>(held, 1)), error.y};
}

/// The same image with depths that are fractions of levels.
ReferenceImage withDepths(const ReferenceImage& drawn, const RemoteDepth& depth, const Image<float>& levels) {
  ReferenceImage image = drawn;
  for (size_t i = 0; i < image.t.size(); ++i) {
    image.t[i] = levels[i] > 0 ? static_cast<float>(1 / depth.inverseDepth(static_cast<double>(levels[i]))) : 0;
  }
  return image;
}

void printDepths(const RemoteCase& each, const RemoteTrial& trial, const RemoteBenchChoice& choice) {
  const RemoteSettings settings;
  const ReferenceImage drawn = trial.scene().draw(planRemoteImage(trial.request(), settings), settings.samples);
  const glm::ivec2 size(drawn.width(), drawn.height());
  for (const int levels : choice.levels) {
    const RemoteDepth depth = roundedDepth(drawn.t, levels);
    const RemoteTrial::Score moved = trial.moved({withDepths(drawn, depth, smoothedLevels(depth.values))});
    Image<float> plain(size.x, size.y);
    std::copy(depth.values.begin(), depth.values.end(), plain.begin());
    const RemoteTrial::Score unsmoothed = trial.moved({withDepths(drawn, depth, plain)});
    const glm::dvec2 error = displacedPixels(drawn, depth, choice.range);
    fmt::print(
        "{:<8} {:>5} levels: off by {:.3f} pixels, at most {:.3f}; moved FLIP {:.4f} ({:.2f} % holes), "
        "not smoothed {:.4f} ({:.2f} %)\n",
        each.name, levels, error.x, error.y, moved.flip, 100 * moved.holes, unsmoothed.flip, 100 * unsmoothed.holes);
    for (const DepthCodec& codec : depthCodecs()) {
      std::vector<std::byte> bytes;
      const double encode = leastProcessorMilliseconds(choice.runs, [&] { bytes = codec.encode(depth.values); });
      const double decode = leastProcessorMilliseconds(choice.runs, [&] { codec.decode(bytes, size); });
      fmt::print("    {:<10} {:>9} bytes {:>7.2f} s {:>6.2f} s\n", codec.name, bytes.size(), encode / 1000,
                 decode / 1000);
    }
    std::fflush(stdout);
  }
}

/// How the server's image is best drawn: along its rays, or piece by piece.
void printDraws(const RemoteCase& each, const RemoteTrial& trial, const RemoteBenchChoice& choice) {
  const RemotePlan plan = planRemoteImage(trial.request(), RemoteSettings{});
  const GpcCamera camera(plan.reference, plan.layout);
  const Mesh& mesh = trial.scene().mesh();
  double rays = 1e30;
  double pieces = 1e30;
  for (int run = 0; run < choice.runs; ++run) {
    rays = std::min(rays, processorMilliseconds([&] { trial.scene().draw(plan, 1); }));
    pieces = std::min(pieces, processorMilliseconds(
                                  [&] { referenceImage(rasterizeGpc(camera, mesh), mesh, plan.reference, "gpc"); }));
  }
  fmt::print("{:<8} {} triangles, {}x{}: rays {:.2f} s, pieces {:.2f} s\n", each.name, mesh.triangles.size(),
             plan.reference.width(), plan.reference.height(), rays / 1000, pieces / 1000);
  std::fflush(stdout);
}

struct RemoteTable {
  const char* name;
  void (*print)(const RemoteCase&, const RemoteTrial&, const RemoteBenchChoice&);
};

constexpr RemoteTable kRemoteTables[] = {
    {"plans", printPlans}, {"colors", printColors}, {"depths", printDepths}, {"draws", printDraws}};

void measure(const RemoteBenchChoice& choice) {
  for (const RemoteCase& each : kRemoteCases) {
    if (!choice.scenes.empty() &&
        std::find(choice.scenes.begin(), choice.scenes.end(), each.name) == choice.scenes.end()) {
      continue;
    }
    const RemoteTrial trial(each, choice);
    for (const RemoteTable& table : kRemoteTables) {
      if (table.name == choice.table) {
        table.print(each, trial, choice);
      }
    }
  }
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  CLI::App program("Images and formats of remote visualisation", "remote_codecs_bench");
  ocelli::RemoteBenchChoice choice;
  choice.settings = {"{}"};
  ocelli::addCommonOptions(program, choice);
  program.add_option("--table", choice.table, "Which")
      ->check(CLI::IsMember({"plans", "colors", "depths", "draws"}))
      ->capture_default_str();
  program.add_option("--scenes", choice.scenes, "statues, canyon, room, town; all where it is left out")
      ->delimiter(',');
  program.add_option("--settings", choice.settings, "Of --table plans: an object of JSON each");
  program.add_option("--qualities", choice.qualities, "Of --table colors")->delimiter(',')->capture_default_str();
  program.add_option("--levels", choice.levels, "Of --table depths")
      ->delimiter(',')
      ->check(CLI::Range(ocelli::RemoteDepth::kMinLevels, ocelli::RemoteDepth::kMaxLevels))
      ->capture_default_str();
  program.add_option("--frames", choice.frames, "Views from the image's own eye")->capture_default_str();
  program.add_option("--moved", choice.moved, "Views from elsewhere")->capture_default_str();
  program.add_option("--pan", choice.range.pan, "How far, by the screen's field of view")->capture_default_str();
  program.add_option("--zoom", choice.range.zoom, "At most")->capture_default_str();
  program.add_option("--translation", choice.range.translation, "By the distance of the nearest surface")
      ->capture_default_str();
  program
      .add_option("--direct-samples", choice.directSamples, "Along either axis of a pixel of what is drawn directly")
      ->capture_default_str();
  program.add_option("--frames-to", choice.folder, "A folder for all frames as PNG");
  return ocelli::runProgram(program, argumentCount, arguments, choice, ocelli::measure);
}
