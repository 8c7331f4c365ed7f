// What a portal camera shows to someone who walks, and how calm its images are beside the pinhole's.
//
// Random walks in mazes, 2 m/s and 90 degrees/s at 20 frames a second, as in tests/constructor/portal_walk_test.cpp.
// From each frame to the next: the mean absolute difference of linear colours over the image, and over the square block
// of a 16th of the image's width where it is largest. Pixels are averages of --samples x --samples rays, so that what
// is finer than a pixel counts as what it looks like. A step with a turn of the head is told from one without.
//
// "motion" is by how many pixels what is shown moves, whatever it looks like (tests/constructor/image_motion.h).
//
// To compare curves, name JSON files of portal cameras after --camera, or curves by name. `--svg` draws them; with
// `--walks 0` that is all.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "bench/bench_program.h"
#include "bench/portal_curve_figure.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/constructor/maze_openings.h"
#include "oc_core/constructor/portal_constructor.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/render/rasterize_graph.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/constructor/image_change.h"
#include "tests/constructor/image_motion.h"
#include "tests/constructor/random_walk.h"

namespace ocelli {
namespace {

constexpr float kStepMetres = 0.1f;
constexpr float kStepDegrees = 4.5f;

struct PortalWalkChoice {
  std::vector<std::string> cameras;
  std::string svg;
  int walks = 12;
  int first = 1;
  int cells = 6;
  int samples = 2;
  double turnShare = 1;
  bool each = false;
  int threads = 0;
  int width = 160;
  int height = 90;
};

NamedPortalCurve curveOf(const std::string& nameOrFile) {
  if (!nameOrFile.ends_with(".json")) {
    return {nameOrFile, portalCurve(nameOrFile)};
  }
  const nlohmann::json json = readJsonFile(nameOrFile);
  JsonFields fields(json, nameOrFile);
  fields.text("camera");
  NamedPortalCurve curve{nameOrFile, readPortalOptions(fields)};
  fields.rejectUnknown();
  return curve;
}

struct Change {
  double mean = 0;
  double block = 0;   ///< the mean of the block where it is largest
  double motion = 0;  ///< pixels by which what is shown moves, the mean over the image
};

Change changeOf(const Image<glm::vec3>& a, const Image<glm::vec3>& b) {
  const int side = std::max(1, a.width() / 16);
  Image<double> blocks((a.width() + side - 1) / side, (a.height() + side - 1) / side, 0.0);
  Change change;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const glm::vec3 d = glm::abs(a(x, y) - b(x, y));
      const double difference = static_cast<double>(d.x + d.y + d.z) / 3;
      change.mean += difference / static_cast<double>(a.size());
      blocks(x / side, y / side) += difference / (side * side);
    }
  }
  change.block = *std::max_element(blocks.begin(), blocks.end());
  return change;
}

/// Frame after frame of one camera.
class Frames {
 public:
  std::vector<Change> changes;

  void add(const GraphCamera& camera, FragmentImage fragments, const Mesh& mesh, int samples) {
    Image<glm::vec3> image = test::averaged(colorImage(fragments, mesh, glm::vec3(0)), samples);
    if (camera_) {
      changes.push_back(changeOf(image_, image));
      changes.back().motion = test::meanMotion(*camera_, fragments_, mesh, camera, samples);
    }
    camera_ = camera;
    fragments_ = std::move(fragments);
    image_ = std::move(image);
  }

 private:
  std::optional<GraphCamera> camera_;
  FragmentImage fragments_;
  Image<glm::vec3> image_;
};

struct Ratios {
  std::vector<double> walks;       ///< largest step of a walk, camera / pinhole
  std::vector<double> walkBlocks;  ///< the same of blocks
  std::vector<double> walkMoves;   ///< largest step without a turn of the head
  std::vector<double> walkMotion;  ///< largest motion of a step
  std::vector<double> moveMotion;  ///< motion of each step without a turn
  std::vector<double> turnMotion;  ///< of each with one
  std::vector<double> moves;       ///< each step without a turn
  std::vector<double> turns;       ///< each with one
  double camera = 0;
  double pinhole = 0;
  size_t steps = 0;
  size_t pinholeSteps = 0;
};

std::string distribution(std::vector<double> values) {
  if (values.empty()) {
    return "none";
  }
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<size_t>(share * static_cast<double>(values.size() - 1))];
  };
  const auto over = std::count_if(values.begin(), values.end(), [](double value) { return value > 1.0005; });
  return fmt::format("{:6} of {:6} above 1; median {:.3f}, 90 % {:.3f}, 99 % {:.3f}, largest {:.3f}", over,
                     values.size(), at(0.5), at(0.9), at(0.99), at(1));
}

PinholeCamera referenceOf(const View& view, const PortalWalkChoice& choice) {
  return {view, choice.width * choice.samples, choice.height * choice.samples};
}

/// Of each step, whether the head does not turn in it.
std::vector<bool> withoutTurn(const std::vector<View>& views) {
  std::vector<bool> moves;
  for (size_t i = 1; i < views.size(); ++i) {
    const glm::vec3 before = views[i - 1].target - views[i - 1].eye;
    const glm::vec3 now = views[i].target - views[i].eye;
    moves.push_back(glm::dot(before, now) > std::cos(0.01f));
  }
  return moves;
}

double largest(const std::vector<Change>& changes, double Change::*what, const std::vector<bool>& kept) {
  double most = 0;
  for (size_t i = 0; i < changes.size(); ++i) {
    most = kept.empty() || kept[i] ? std::max(most, changes[i].*what) : most;
  }
  return most;
}

void measure(const PortalWalkChoice& choice) {
  std::vector<NamedPortalCurve> curves;
  for (const std::string& each : choice.cameras) {
    curves.push_back(curveOf(each));
  }
  if (curves.empty()) {
    for (const PortalCurve& curve : portalCurves()) {
      curves.push_back({curve.name, curve.options});
    }
  }
  for (const NamedPortalCurve& curve : curves) {
    fmt::print("{}: turned by, %, for openings 1 to 8, 16 and 32 cells ahead:", curve.name);
    for (const int cells : {1, 2, 3, 4, 5, 6, 7, 8, 16, 32}) {
      fmt::print(" {:.0f}", 100 * shareAhead(curve.options, cells));
    }
    fmt::print("\n");
  }
  if (!choice.svg.empty()) {
    writeFile(choice.svg, svgText(portalCurveFigure(curves)));
  }
  if (choice.walks == 0) {
    return;
  }
  std::vector<Ratios> ratios(curves.size());
  for (int walk = choice.first; walk < choice.first + choice.walks; ++walk) {
    const GuidedScene scene = loadGuidedScene("builtin:maze,seed=" + std::to_string(walk), {.fit = false});
    const MeshBlocks blocks(scene.mesh);
    Random random(static_cast<uint64_t>(walk));
    const std::vector<glm::vec2> line = test::randomLine(*scene.guides.maze, static_cast<size_t>(choice.cells), random);
    const std::vector<View> views = test::walkAlong(line, 0, kStepMetres, kStepDegrees);
    Frames pinhole;
    for (const View& view : views) {
      const PinholeCamera reference = referenceOf(view, choice);
      pinhole.add(GraphCamera(reference), rasterize(reference, scene.mesh), scene.mesh, choice.samples);
    }
    const std::vector<View> slower =
        choice.turnShare < 1
            ? test::walkAlong(line, 0, kStepMetres, kStepDegrees * static_cast<float>(choice.turnShare))
            : views;
    const std::vector<bool> moves = withoutTurn(views);
    const std::vector<bool> slowerMoves = withoutTurn(slower);
    for (size_t k = 0; k < curves.size(); ++k) {
      Frames camera;
      for (const View& view : slower) {
        const GraphCamera made = buildPortalCamera(curves[k].options, scene.guides, referenceOf(view, choice));
        camera.add(made, rasterize(made, scene.mesh, blocks), scene.mesh, choice.samples);
      }
      Ratios& of = ratios[k];
      const std::vector<Change>& mine = camera.changes;
      const std::vector<Change>& theirs = pinhole.changes;
      of.walks.push_back(largest(mine, &Change::mean, {}) / largest(theirs, &Change::mean, {}));
      of.walkBlocks.push_back(largest(mine, &Change::block, {}) / largest(theirs, &Change::block, {}));
      of.walkMotion.push_back(largest(mine, &Change::motion, {}) / largest(theirs, &Change::motion, {}));
      of.walkMoves.push_back(largest(mine, &Change::mean, slowerMoves) / largest(theirs, &Change::mean, moves));
      of.steps += mine.size();
      of.pinholeSteps += theirs.size();
      for (size_t i = 0; choice.turnShare == 1 && i < mine.size(); ++i) {
        (moves[i] ? of.moveMotion : of.turnMotion).push_back(mine[i].motion / std::max(theirs[i].motion, 1e-9));
        (moves[i] ? of.moves : of.turns).push_back(mine[i].mean / std::max(theirs[i].mean, 1e-9));
        of.camera += mine[i].mean;
        of.pinhole += theirs[i].mean;
      }
      if (choice.each) {
        const auto at = std::max_element(mine.begin(), mine.end(),
                                         [](const Change& a, const Change& b) { return a.mean < b.mean; });
        const auto index = static_cast<size_t>(at - mine.begin());
        fmt::print("{} walk {}: {:.4f}, motion {:.4f}, at step {} of {}, {}; there {:.4f} of the pinhole's\n",
                   curves[k].name, walk, of.walks.back(), of.walkMotion.back(), index, mine.size(),
                   slowerMoves[index] ? "straight" : "turning",
                   choice.turnShare == 1 ? mine[index].mean / std::max(theirs[index].mean, 1e-9) : 0);
      }
    }
  }
  for (size_t k = 0; k < curves.size(); ++k) {
    const Ratios& of = ratios[k];
    fmt::print("\n{}, change of the image, camera / pinhole\n", curves[k].name);
    if (choice.turnShare == 1) {
      fmt::print("  all steps together            {:.4f}\n", of.camera / of.pinhole);
    } else {
      fmt::print("  steps                         {:.4f} times as many\n",
                 static_cast<double>(of.steps) / static_cast<double>(of.pinholeSteps));
    }
    fmt::print("  largest step of each walk     {}\n", distribution(of.walks));
    fmt::print("  largest block of each walk    {}\n", distribution(of.walkBlocks));
    fmt::print("  largest straight step of each {}\n", distribution(of.walkMoves));
    fmt::print("  each straight step            {}\n", distribution(of.moves));
    fmt::print("  each step with a turn         {}\n", distribution(of.turns));
    fmt::print("  largest motion of each walk   {}\n", distribution(of.walkMotion));
    fmt::print("  motion of straight steps      {}\n", distribution(of.moveMotion));
    fmt::print("  motion of steps with a turn   {}\n", distribution(of.turnMotion));
  }
}

}  // namespace
}  // namespace ocelli

int main(int argc, char** argv) {
  ocelli::PortalWalkChoice choice;
  CLI::App program{"Portal cameras on random walks in mazes, beside a pinhole", "portal_walk_bench"};
  program.add_option("--camera", choice.cameras, "Names of curves, or JSON files of portal cameras");
  program.add_option("--svg", choice.svg, "Draws how much rays turn from where");
  program.add_option("--walks", choice.walks, "How many")->check(CLI::Range(0, 100000))->capture_default_str();
  program.add_option("--first", choice.first, "Seed of the first maze")->capture_default_str();
  program.add_option("--cells", choice.cells, "Of a walk")->check(CLI::Range(2, 1000))->capture_default_str();
  program.add_option("--samples", choice.samples, "Of a pixel, along each axis")->check(CLI::Range(1, 16));
  program
      .add_option("--turn-share", choice.turnShare,
                  "Of the pinhole's turn in a frame, by which the head turns at most with the camera")
      ->check(CLI::Range(0.1, 1.0));
  program.add_flag("--each", choice.each, "Print the largest step of each walk");
  program.add_option("--threads", choice.threads, "0 stands for all cores")->check(CLI::Range(0, 1024));
  program.add_option("--width", choice.width, "Pixels")->check(CLI::Range(16, 4096))->capture_default_str();
  program.add_option("--height", choice.height, "Pixels")->check(CLI::Range(16, 4096))->capture_default_str();
  return ocelli::runProgram(program, argc, argv, choice, ocelli::measure);
}
