// Cameras by name and options: their images.
#include <pybind11/stl.h>

#include <variant>

#include "oc_core/constructor/camera_constructors.h"
#include "oc_core/multiperspective/multiperspective_image.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/camera_option.h"
#include "oc_core/ocri/nothing_seen.h"
#include "oc_core/ocri/placed_image.h"
#include "oc_core/ocri/representation_kind.h"
#include "oc_core/ocri/technique_names.h"
#include "python/bindings/bindings.h"
#include "python/bindings/images.h"
#include "python/bindings/options.h"
#include "python/bindings/progress.h"

namespace py = pybind11;

namespace ocelli {
namespace {

/// Nothing for "raster": a camera builds its image in its own way. Throws InputError for a name that is unknown.
std::optional<Technique> techniqueOf(const std::string& method) {
  const std::optional<Technique> technique = techniqueNamed(method);
  if (!technique && method != "raster") {
    std::string names = "use raster";
    for (const TechniqueName& each : kTechniqueNames) {
      names += std::string(", ") + each.name;
    }
    throw InputError("there is no method \"" + method + "\"", "method", names);
  }
  return technique;
}

ReferenceImages buildImages(const Mesh& mesh, const CameraArgument& camera, const View& view, int width, int height,
                            const std::string& construction, const py::object& progress) {
  requireImageSize(width, height);
  const Construction wanted = constructionFromText(construction, "construction");
  const PythonProgress told(progress);
  const py::gil_scoped_release released;
  return buildReferenceImages(cameraChoiceOf(camera), PinholeCamera(view, width, height), mesh, told.function(), wanted,
                              nullptr);
}

ReferenceImages drawImages(const Mesh& mesh, const CameraArgument& camera, const View& view, int width, int height,
                           const std::string& method, const py::object& progress) {
  requireImageSize(width, height);
  const std::optional<Technique> technique = techniqueOf(method);
  const PythonProgress told(progress);
  const py::gil_scoped_release released;
  const CameraChoice choice = cameraChoiceOf(camera);
  const PinholeCamera reference(view, width, height);
  return technique ? ReferenceImages{drawReferenceImage(*technique, choice, reference, mesh, told.function())}
                   : buildReferenceImages(choice, reference, mesh, told.function());
}

/// Of a graph or curved ray camera.
ReferenceImages constructImages(const GuidedScene& scene, const std::string& options, const View& view, int width,
                                int height, const std::string& construction) {
  requireImageSize(width, height);
  const bool byRays = constructionFromText(construction, "construction") == Construction::kRays;
  const py::gil_scoped_release released;
  const PinholeCamera reference(view, width, height);
  const MultiperspectiveCamera camera = constructCameraFromJson(options, kCameraOptions, scene, reference);
  const FragmentImage fragments = byRays ? raycast(camera, scene.mesh) : rasterize(camera, scene.mesh);
  const ReferenceImage image = std::visit(
      [&](const auto& each) { return placedImage(each, fragments, scene.mesh, view, "constructed"); }, camera);
  if (image.sampleCount() == 0) {
    failSeeingNothing(reference, scene.mesh, "camera");
  }
  return {image};
}

template <class Rows>
std::vector<std::pair<std::string, std::string>> namesOf(const Rows& rows) {
  std::vector<std::pair<std::string, std::string>> names;
  for (const auto& row : rows) {
    names.emplace_back(row.name, row.description);
  }
  return names;
}

/// What a representation may be told: a dict for each option.
py::list optionsOf(const std::string& name) {
  const CameraChoice defaults = cameraChoice(name);
  py::list rows;
  for (const CameraOption* option : defaults.kind->options) {
    py::dict row;
    row["name"] = option->name;
    row["meaning"] = option->meaning;
    row["unit"] = option->unit;
    if (isDirection(*option)) {
      const glm::vec3 direction = directionOf(*option, defaults);
      row["default"] = py::make_tuple(direction.x, direction.y, direction.z);
    } else if (isBoolean(*option)) {
      row["default"] = numberOf(*option, defaults) != 0;
    } else if (isInteger(*option)) {
      row["default"] = static_cast<int>(numberOf(*option, defaults));
    } else {
      row["default"] = numberOf(*option, defaults);
    }
    if (!isBoolean(*option)) {
      row["min"] = option->min;
      row["max"] = option->max;
    }
    rows.append(row);
  }
  return rows;
}

}  // namespace

void bindCameras(py::module_& module) {
  module.def("representations", [] { return namesOf(cameraNames()); });
  module.def("constructors", [] { return namesOf(cameraConstructors()); });
  module.def("camera_options", &optionsOf, py::arg("name"));
  module.def("build_images", &buildImages, py::arg("mesh"), py::arg("camera"), py::arg("view"), py::arg("width"),
             py::arg("height"), py::arg("construction"), py::arg("progress"));
  module.def("draw_images", &drawImages, py::arg("mesh"), py::arg("camera"), py::arg("view"), py::arg("width"),
             py::arg("height"), py::arg("method"), py::arg("progress"));
  module.def("construct_images", &constructImages, py::arg("scene"), py::arg("options"), py::arg("view"),
             py::arg("width"), py::arg("height"), py::arg("construction"));
}

}  // namespace ocelli
