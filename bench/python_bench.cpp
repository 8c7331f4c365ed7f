// What a call from Python costs beside the same call from C++: both in one process, turn by turn, on the same scene. A
// share of 95 % says that Python takes 1 / 0.95 of the time. Times are of the CPU, all threads together, the least of
// --runs after one that is not counted.
//
// To add a call, add a row to kCalls: its C++ and its Python, with `scene`, `images`, `view` and `volume` to work on.
#include <fmt/format.h>
#include <pybind11/embed.h>

#include <CLI/CLI.hpp>
#include <limits>

#include "bench/bench_program.h"
#include "bench/timing.h"
#include "display_sim/frames/display_profile.h"
#include "display_sim/observing/observer.h"
#include "display_sim/slicing/slicer.h"
#include "oc_core/evaluation/evaluation.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/resample.h"
#include "oc_core/ocri/union_mesh.h"
#include "oc_core/worlds/scene_source.h"

namespace py = pybind11;

namespace ocelli {
namespace {

struct BenchChoice {
  std::string scene = "builtin:statues";
  int runs = 9;
  int threads = 0;
  int width = 720;
  int height = 480;
};

/// What the calls of C++ work on; those of Python have their own.
struct Work {
  Mesh mesh;
  PinholeCamera reference;
  PinholeCamera desired;
  ReferenceImages images;
  DisplayProfile display;
  Volume volume;
};

struct Call {
  const char* name;
  void (*cpp)(const Work& work);
  const char* python;
};

constexpr Call kCalls[] = {
    {"render, pinhole", [](const Work& w) { buildReferenceImages(cameraChoice("di"), w.reference, w.mesh); },
     "ocelli.render(scene, 'di', size=size, progress=False)"},
    {"ocri build, ddoc", [](const Work& w) { buildReferenceImages(cameraChoice("ddoc"), w.reference, w.mesh); },
     "ocelli.ocri.build(scene, 'ddoc', size=size, progress=False)"},
    {"ocri mesh", [](const Work& w) { unionMesh(w.images); }, "ocelli.ocri.mesh(images)"},
    {"resample", [](const Work& w) { resample(w.images, w.desired); }, "ocelli.resample(images, view, size=size)"},
    {"evaluate, two cameras, two viewpoints",
     [](const Work& w) {
       EvaluationOptions options;
       options.view = w.reference.view();
       options.width = w.reference.width();
       options.height = w.reference.height();
       options.interiorViews = 2;
       options.edgeViews = 0;
       options.compareImages = false;
       options.runs = 1;
       evaluate(w.mesh, {cameraChoice("di"), cameraChoice("ddoc")}, options);
     },
     "ocelli.evaluate(scene, ['di', 'ddoc'], size=size, interior_views=2, edge_views=0, compare_images=False, runs=1, "
     "progress=False)"},
    {"slice", [](const Work& w) { slice(w.mesh, w.display); }, "ocelli.slice(scene, 'perspecta', progress=False)"},
    {"observe",
     [](const Work& w) {
       ObserverOptions options;
       options.eye = {0, 0, static_cast<float>(w.display.viewingDistanceRadii())};
       options.width = 768;
       options.height = 768;
       observe(w.volume, options);
     },
     "ocelli.observe(volume)"}};

void measure(const BenchChoice& choice) {
  const View view;
  const View moved = movedEye(view, {0.4F, 0.2F, 0});
  Mesh mesh = loadScene(choice.scene);
  const PinholeCamera reference(view, choice.width, choice.height);
  const DisplayProfile display = loadProfile("perspecta");
  const ReferenceImages images = buildReferenceImages(cameraChoice("ddoc"), reference, mesh);
  const Volume volume = slice(mesh, display);
  const Work work{std::move(mesh), reference, PinholeCamera(moved, choice.width, choice.height),
                  images,          display,   volume};

  const py::scoped_interpreter interpreter;
  py::module_::import("sys").attr("path").attr("insert")(0, OCELLI_PYTHON_DIR);
  py::dict names;
  names["ocelli"] = py::module_::import("ocelli");
  names["source"] = choice.scene;
  names["size"] = py::make_tuple(choice.width, choice.height);
  py::exec(R"(
scene = ocelli.scene.load(source, progress=False)
images = ocelli.ocri.build(scene, 'ddoc', size=size, progress=False)
view = ocelli.View().moved((0.4, 0.2, 0))
volume = ocelli.slice(scene, 'perspecta', progress=False)
)",
           names);
  fmt::print("{:40} {:>10} {:>10} {:>8}\n", "CPU ms", "C++", "Python", "share");
  for (const Call& call : kCalls) {
    const py::object code = py::module_::import("builtins").attr("compile")(call.python, call.name, "eval");
    const py::object eval = py::module_::import("builtins").attr("eval");
    double cpp = std::numeric_limits<double>::infinity();
    double python = cpp;
    for (int run = 0; run <= choice.runs; ++run) {
      const double ofCpp = processorMilliseconds([&] { call.cpp(work); });
      const double ofPython = processorMilliseconds([&] { eval(code, names); });
      if (run > 0) {
        cpp = std::min(cpp, ofCpp);
        python = std::min(python, ofPython);
      }
    }
    fmt::print("{:40} {:10.2f} {:10.2f} {:7.1f}%\n", call.name, cpp, python, 100 * cpp / python);
  }
}

}  // namespace
}  // namespace ocelli

int main(int argc, char** argv) {
  CLI::App program{"What calls from Python cost beside the same calls from C++"};
  ocelli::BenchChoice choice;
  program.add_option("--scene", choice.scene, "What is drawn")->capture_default_str();
  ocelli::addCommonOptions(program, choice);
  return ocelli::runProgram(program, argc, argv, choice, [](const ocelli::BenchChoice& c) { ocelli::measure(c); });
}
