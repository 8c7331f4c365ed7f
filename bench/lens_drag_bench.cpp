// How many pictures a second a general pinhole's lenses get while one is dragged (section 5.3.2.1): each sampling by
// rasterisation, along rays, and by OpenGL; and what a person sees of it in the viewer.
//
// A drag is a circle of --steps places, drawn in turn by all; --runs of them, after one that is not counted, the
// fastest counts: what else the machine does hardly does. The eye stands still, so rasterisation keeps the projected
// mesh and rays their structure. A picture is the whole way to sRGB bytes; OpenGL's stays on the GPU, and as a software
// renderer takes long, it draws one place only.
#include <cmath>
#include <cstdio>
#include <functional>
#include <thread>

#include "bench/bench_program.h"
#include "bench/timing.h"
#include "display_sim/viewer/lens_choice.h"
#include "display_sim/viewer/viewer.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_renderer.h"

namespace ocelli {
namespace {

struct LensDragChoice {
  std::string scene = "builtin:dna";
  std::string camera = "docs/cameras/examples/dna_lenses.json";
  std::string view = "docs/cameras/examples/dna_view.json";
  std::string provider = "auto";
  int runs = 3;
  int steps = 6;
  int threads = 0;
  int width = 1280;
  int height = 720;
  double viewerSeconds = 5;
  bool gl = true;
};

/// The first lens goes around where it was.
GpcLayout draggedLayout(const GpcLayout& start, int step, int steps, const glm::dvec2& size) {
  constexpr double kReach = 0.05;
  const double angle = 2 * kPi * step / steps;
  GpcLayout layout = start;
  moveLens(layout, 0, glm::dvec2(start.regions[0].center) + kReach * glm::dvec2(std::cos(angle), std::sin(angle)),
           size);
  return layout;
}

struct DragTechnique {
  std::string name;
  std::function<void(const GpcLayout&)> draw;
  const GpcSampling* sampling;
  int steps;
  double milliseconds = 1e30;  ///< a picture
  double cpuMilliseconds = 1e30;
};

void measureDrawing(const LensDragChoice& choice, GlContext& context, const View& view, const GpcLayout& start,
                    const std::shared_ptr<const LoadedScene>& scene) {
  const GlScope scope(context);
  const GlRenderer gl(context, scene->mesh);
  const PinholeCamera pinhole(view, choice.width, choice.height);
  LensPainter raster;
  LensPainter rays;
  const auto paint = [&](LensPainter& painter, LensesShown::Method method, const GpcLayout& layout) {
    LensWanted wanted;
    wanted.scene = scene;
    wanted.view = view;
    wanted.size = {choice.width, choice.height};
    wanted.layout = layout;
    wanted.method = method;
    painter.paint(wanted, wanted.size);
  };
  std::vector<DragTechnique> techniques;
  for (const char* name : {"cubic", "quadratic", "linear"}) {
    const GpcSampling* sampling = findGpcSampling(name);
    techniques.push_back({"raster", [&](const GpcLayout& l) { paint(raster, LensesShown::Method::kRaster, l); },
                          sampling, choice.steps});
    techniques.push_back(
        {"raycast", [&](const GpcLayout& l) { paint(rays, LensesShown::Method::kRays, l); }, sampling, choice.steps});
    if (choice.gl) {
      techniques.push_back({"gl",
                            [&](const GpcLayout& l) {
                              gl.encodedColors(gl.drawOnGpu(GpcCamera(pinhole, l)), glm::vec3(0));
                              context.gl().Finish();
                            },
                            sampling, 1});
    }
  }
  for (int run = 0; run <= choice.runs; ++run) {
    for (DragTechnique& each : techniques) {
      double cpu = 0;
      const double wall = milliseconds([&] {
        cpu = processorMilliseconds([&] {
          for (int step = 0; step < each.steps; ++step) {
            GpcLayout layout = draggedLayout(start, step, choice.steps, {choice.width, choice.height});
            layout.sampling = each.sampling;
            each.draw(layout);
          }
        });
      });
      if (run > 0) {
        each.milliseconds = std::min(each.milliseconds, wall / each.steps);
        each.cpuMilliseconds = std::min(each.cpuMilliseconds, cpu / each.steps);
      }
    }
  }
  for (const DragTechnique& each : techniques) {
    fmt::print("{:<10} {:<8} {:>8.1f} ms a picture, {:>5.1f} Hz; {:>8.1f} ms of CPU time\n", each.sampling->name,
               each.name, each.milliseconds, 1000 / each.milliseconds, each.cpuMilliseconds);
  }
  std::fflush(stdout);
}

/// The viewer as a person has it, its lens pane alone in this size.
void measureViewer(const LensDragChoice& choice, GlContext& context, const View& view, const GpcSampling& sampling) {
  constexpr int kBars = 58;  // of the pane and the window
  constexpr double kFrameSeconds = 1.0 / 60;
  ViewerOptions options;
  options.source = choice.scene;
  options.camera = cameraChoice(choice.camera);
  options.camera.gpc.sampling = &sampling;
  options.reference = view;
  options.width = choice.width;
  options.height = choice.height;
  Viewer viewer(context, options);
  viewer.handle(ResizeEvent{choice.width, choice.height + kBars, 1, 1});
  for (const Key key : {Key::kG, Key::k6}) {
    viewer.handle(KeyEvent{key, true, {}});
    viewer.handle(KeyEvent{key, false, {}});
  }
  do {
    viewer.waitUntilMade();
    viewer.update(0);
    viewer.draw();
  } while (viewer.isMaking() || viewer.hasWaitingEvents() || viewer.isSettling());
  const PaneLayout pane = *viewerLayout(viewer.state(), {choice.width, choice.height + kBars}, 1).find(Pane::kLenses);
  const LensPointer::Frame frame = lensFrame(viewer.state(), pane.image, 1);
  const glm::dvec2 middle(viewer.state().work.camera.gpc.regions[0].center);
  const auto moveTo = [&](const glm::dvec2& share) {
    const glm::dvec2 at = frame.corner + share * frame.size;
    viewer.handle(PointerMoveEvent{at.x, at.y});
  };
  moveTo(middle);
  viewer.handle(PointerButtonEvent{PointerButton::kLeft, true, {}});
  size_t frames = 0;
  size_t pictures = 0;
  size_t wholes = 0;
  std::shared_ptr<const LensPicture> last;
  const auto start = std::chrono::steady_clock::now();
  double seconds = 0;
  while (seconds < choice.viewerSeconds) {
    const double before = seconds;
    seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    moveTo(middle + 0.05 * glm::dvec2(std::cos(2 * seconds), std::sin(2 * seconds)));
    viewer.update(seconds - before);
    viewer.draw();
    ++frames;
    // As a window does, which waits for its screen.
    std::this_thread::sleep_until(start + std::chrono::duration<double>(static_cast<double>(frames) * kFrameSeconds));
    if (const auto& picture = viewer.facts().lenses.picture; picture != last) {
      last = picture;
      ++pictures;
      wholes += picture->isWhole ? 1 : 0;
    }
  }
  fmt::print("{:<10} in the viewer: {:.1f} frames a second, {:.1f} pictures a second, {:.0f} % of them whole\n",
             sampling.name, static_cast<double>(frames) / seconds, static_cast<double>(pictures) / seconds,
             pictures > 0 ? 100.0 * static_cast<double>(wholes) / static_cast<double>(pictures) : 0.0);
  std::fflush(stdout);
}

void measureDrag(const LensDragChoice& choice) {
  const std::unique_ptr<GlContext> context = openGlContext(choice.provider, "--provider");
  const View view = readView(choice.view);
  const GpcLayout start = cameraChoice(choice.camera).gpc;
  LoadedScene loaded{choice.scene, 1, loadScene(choice.scene), {}};
  loaded.bounds = boundsOf(loaded.mesh);
  fmt::print("{}: {} triangles, {}x{}, OpenGL on {}\n", choice.scene, loaded.mesh.triangles.size(), choice.width,
             choice.height, context->info().renderer);
  measureDrawing(choice, *context, view, start, std::make_shared<const LoadedScene>(std::move(loaded)));
  if (choice.viewerSeconds > 0) {
    for (const char* name : {"cubic", "quadratic", "linear"}) {
      measureViewer(choice, *context, view, *findGpcSampling(name));
    }
  }
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  CLI::App program("Pictures a second while a lens is dragged", "lens_drag_bench");
  ocelli::LensDragChoice choice;
  ocelli::addCommonOptions(program, choice);
  program.add_option("--scene", choice.scene, "Scene")->capture_default_str();
  program.add_option("--camera", choice.camera, "Lenses; the first one is dragged")->capture_default_str();
  program.add_option("--view", choice.view, "View")->capture_default_str();
  program.add_option("--provider", choice.provider, "auto, egl or osmesa")->capture_default_str();
  program.add_option("--steps", choice.steps, "Places of a drag")->capture_default_str();
  program.add_option("--viewer-seconds", choice.viewerSeconds, "Of each drag in the viewer; 0 leaves it out")
      ->capture_default_str();
  program.add_flag("!--no-gl", choice.gl, "Leave OpenGL out, which takes longest by a software renderer");
  return ocelli::runProgram(program, argumentCount, arguments, choice, ocelli::measureDrag);
}
