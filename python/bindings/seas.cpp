// Seas of images: built, and read image by image.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <nlohmann/json.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/sea/sea_build.h"
#include "oc_core/sea/sea_file.h"
#include "oc_core/sea_input/hidden_points.h"
#include "oc_core/sea_input/sea_input.h"
#include "python/bindings/bindings.h"
#include "python/bindings/images.h"
#include "python/bindings/progress.h"

namespace py = pybind11;

namespace ocelli {
namespace {

using SharedSea = std::shared_ptr<SeaFile>;

/// The defaults but for the fields that `chosen`, an object in JSON, has. Those that the images decide are not chosen.
SeaSettings settingsOf(const std::string& chosen, const SeaInput& input) {
  SeaSettings defaults;
  defaults.refinement = input.arePosesExact ? "none" : "bobyqa";
  defaults.source = input.source->description();
  defaults.projection = input.source->projection();
  const nlohmann::ordered_json given = nlohmann::ordered_json::parse(chosen);
  if (given.contains("hidden") && given["hidden"].is_string()) {
    defaults.hidden = given["hidden"].get<std::string>();  // brings fields of its own
  }
  nlohmann::ordered_json fields = nlohmann::ordered_json::parse(jsonText(defaults));
  for (const auto& [name, value] : given.items()) {
    if (name == "source" || name == "projection") {
      throw InputError("the images decide this", name, "leave it out");
    }
    fields[name] = value;
  }
  return seaSettingsFromJson(fields.dump(), "settings");
}

std::string build(const std::string& source, const std::filesystem::path& path, const SeaInputOptions& options,
                  bool shaded, const std::string& settings, bool startOver, const py::object& progress) {
  const PythonProgress told(progress);
  const py::gil_scoped_release released;
  SceneOptions scene;
  scene.shading = shaded ? Shading::kLambert : Shading::kNone;
  const SeaInput input = openSeaInput(source, scene, options, told.function());
  const SeaSettings chosen = settingsOf(settings, input);
  const SeaBuildReport report =
      buildSea(*input.source, input.proxy, chosen, path, startOver, told.function(), hiddenPointsOf(chosen));
  return nlohmann::ordered_json{{"images", report.images},      {"i_nodes", report.inner},
                                {"resumed", report.resumed},    {"bytes", report.fileBytes},
                                {"raw_bytes", report.rawBytes}, {"seconds", report.seconds}}
      .dump();
}

uint32_t imageNumber(const SeaFile& sea, py::ssize_t image) {
  const auto count = static_cast<py::ssize_t>(sea.count());
  const py::ssize_t number = image < 0 ? image + count : image;
  if (number < 0 || number >= count) {
    throw py::index_error("this sea has the images 0 to " + std::to_string(count - 1));
  }
  return static_cast<uint32_t>(number);
}

py::array imageOf(const SeaFile& sea, py::ssize_t image) {
  const uint32_t number = imageNumber(sea, image);
  Image<Rgb8> decoded = [&] {
    const py::gil_scoped_release released;
    return sea.image(number);
  }();
  return arrayOf(std::move(decoded));
}

py::array viewBetween(const SeaFile& sea, const std::array<double, 3>& position, double yawDegrees) {
  const SeaPose pose{{position[0], position[1], position[2]},
                     glm::angleAxis(radiansFromDegrees(yawDegrees), glm::dvec3(0, 1, 0))};
  Image<Rgb8> view = [&] {
    const py::gil_scoped_release released;
    return sea.view(pose);
  }();
  return arrayOf(std::move(view));
}

py::array_t<double> positionsOf(const SeaFile& sea) {
  const std::vector<glm::dvec3> positions = sea.positions();
  py::array_t<double> rows({static_cast<py::ssize_t>(positions.size()), py::ssize_t{3}});
  std::memcpy(rows.mutable_data(), positions.data(), positions.size() * sizeof(glm::dvec3));
  return rows;
}

}  // namespace

void bindSeas(py::module_& module) {
  py::class_<SeaFile, SharedSea>(module, "Sea", "A sea of images, to be read. Made by ocelli.sea.build() and read().")
      .def(py::init([](const std::filesystem::path& path) { return std::make_shared<SeaFile>(path); }), py::arg("path"))
      .def("__len__", &SeaFile::count)
      .def("__getitem__", &imageOf, py::arg("image"),
           "An image, decoded now: (height, width, 3), bytes of sRGB, row 0 at the top.")
      .def("view", &viewBetween, py::arg("position"), py::arg("yaw") = 0.0,
           "What is seen from (x, y, z), of the nearest three images, as (height, width, 3), bytes of sRGB. `yaw` "
           "degrees to the left.")
      .def_property_readonly("positions", &positionsOf, "Where each image was taken: (images, 3).")
      .def_property_readonly("names", &SeaFile::names, "Of the images; none where they have numbers alone.")
      .def_property_readonly("bytes", &SeaFile::fileBytes, "Of the file.")
      .def(
          "settings_json", [](const SeaFile& sea) { return jsonText(sea.settings()); },
          "How it was built, as JSON: ocelli.sea.settings() gives it as a dict.")
      .def(
          "verify",
          [](const SeaFile& sea, bool decode, const py::object& progress) {
            const PythonProgress told(progress);
            const py::gil_scoped_release released;
            sea.verify(decode, told.function());
          },
          py::arg("decode") = false, py::arg("progress") = py::none(),
          "Checks every byte, and with `decode` that each image can be had. Raises InputError where it is damaged.");
  module.def(
      "build_sea",
      [](const std::string& source, const std::filesystem::path& path, const std::array<int, 2>& size, int samples,
         const std::string& positions, std::optional<double> spacing, const std::string& grid, double eyeHeight,
         size_t first, size_t count, const std::string& proxy, size_t proxyTriangles, bool shaded,
         const std::string& settings, bool startOver, const py::object& progress) {
        requireImageSize(size[0], size[1]);
        const SeaInputOptions options{.size = {size[0], size[1]},
                                      .samples = samples,
                                      .positions = positions,
                                      .spacing = spacing,
                                      .grid = grid,
                                      .eyeHeight = eyeHeight,
                                      .first = first,
                                      .count = count,
                                      .proxy = proxy,
                                      .proxyTriangles = proxyTriangles};
        return build(source, path, options, shaded, settings, startOver, progress);
      },
      py::arg("source"), py::arg("path"), py::arg("size"), py::arg("samples"), py::arg("positions"), py::arg("spacing"),
      py::arg("grid"), py::arg("eye_height"), py::arg("first"), py::arg("count"), py::arg("proxy"),
      py::arg("proxy_triangles"), py::arg("shaded"), py::arg("settings"), py::arg("start_over"), py::arg("progress"));
}

}  // namespace ocelli
