// Ray maps: cameras as arrays, from Python and to it.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <limits>

#include "oc_core/camera_rays/camera_rays.h"
#include "oc_core/constructor/camera_constructors.h"
#include "oc_core/ray_map/ray_map_file.h"
#include "python/bindings/arrays.h"
#include "python/bindings/bindings.h"
#include "python/bindings/images.h"
#include "python/bindings/options.h"
#include "python/bindings/progress.h"

namespace py = pybind11;

namespace ocelli {
namespace {

using SharedRays = std::shared_ptr<RayMap>;

SharedRays shared(RayMap map) {
  return std::make_shared<RayMap>(std::move(map));
}

RayFrame frameFromName(const std::string& name) {
  for (const RayFrame frame : kRayFrames) {
    if (name == nameOf(frame)) {
      return frame;
    }
  }
  throw InputError("there is no frame \"" + name + "\"", "frame", "use world or view");
}

/// Vectors of an array of shape (height, width, 3), row after row.
std::span<const glm::vec3> vectorsOf(const DenseArray<float>& array) {
  static_assert(sizeof(glm::vec3) == 3 * sizeof(float));
  return {reinterpret_cast<const glm::vec3*>(array.data()), static_cast<size_t>(array.size() / 3)};
}

SharedRays straightRays(const DenseArray<float>& origins, const DenseArray<float>& directions, float near, float far,
                        const std::string& name, const std::string& frame, bool wrapsAround,
                        const std::optional<View>& view) {
  const auto isImage = [](const DenseArray<float>& array) { return array.ndim() == 3 && array.shape(2) == 3; };
  if (!isImage(origins) || !isImage(directions) || origins.shape(0) != directions.shape(0) ||
      origins.shape(1) != directions.shape(1)) {
    throw InputError("origins and directions need one shape, (height, width, 3)", "rays of \"" + name + "\"",
                     "give one origin and one direction for each pixel; numpy.broadcast_to() repeats one of them");
  }
  const auto [width, height] = std::pair(origins.shape(1), origins.shape(0));
  if (width > std::numeric_limits<int>::max() || height > std::numeric_limits<int>::max()) {
    throw InputError("no image is as large", "rays of \"" + name + "\"", "give fewer rays");
  }
  const glm::ivec2 size(static_cast<int>(width), static_cast<int>(height));
  requireImageSize(size.x, size.y);
  const RayMapNotes notes{.name = name, .frame = frameFromName(frame), .view = view, .wrapsAround = wrapsAround};
  const py::gil_scoped_release released;
  return shared(RayMap::ofStraightRays(size, vectorsOf(origins), vectorsOf(directions), near, far, notes,
                                       "rays of \"" + name + "\""));
}

/// A vector of each pixel's ray; `missing` where it has none.
template <class Value, class OfRay>
py::array eachRay(const RayMap& map, const Value& missing, const OfRay& ofRay) {
  Image<Value> values(map.width(), map.height(), missing);
  {
    const py::gil_scoped_release released;
    for (int y = 0; y < map.height(); ++y) {
      for (int x = 0; x < map.width(); ++x) {
        if (const RayMapRay ray = map.ray(x, y); !ray.empty()) {
          values(x, y) = ofRay(ray);
        }
      }
    }
  }
  return arrayOf(std::move(values));
}

py::tuple rayAt(const py::object& self, int x, int y) {
  const auto& map = self.cast<const RayMap&>();
  if (x < 0 || y < 0 || x >= map.width() || y >= map.height()) {
    throw py::index_error("pixels are from (0, 0) to (" + std::to_string(map.width() - 1) + ", " +
                          std::to_string(map.height() - 1) + ")");
  }
  const RayMapRay ray = map.ray(x, y);
  const auto count = static_cast<py::ssize_t>(ray.points.size());
  return py::make_tuple(viewOf(ray.points.data(), {count}, self), viewOf(ray.parameters.data(), {count}, self));
}

SharedRays raysOfChoice(const CameraArgument& camera, const Mesh* mesh, const View& view, int width, int height,
                        int image, const py::object& progress) {
  requireImageSize(width, height);
  const PythonProgress told(progress);
  const py::gil_scoped_release released;
  const CameraChoice choice = cameraChoiceOf(camera);
  if (mesh == nullptr && needsScene(choice)) {
    throw InputError("the rays of \"" + choice.name + "\" depend on the scene", "scene",
                     "give one, or choose a camera that is made from the view alone, such as di or panorama");
  }
  return shared(
      rayMapOf(choice, PinholeCamera(view, width, height), mesh != nullptr ? *mesh : Mesh{}, image, told.function()));
}

SharedRays raysOfConstructed(const GuidedScene& scene, const std::string& options, const std::string& name,
                             const View& view, int width, int height, const py::object& progress) {
  requireImageSize(width, height);
  const PythonProgress told(progress);
  const py::gil_scoped_release released;
  const PinholeCamera reference(view, width, height);
  return shared(
      rayMapOf(constructCameraFromJson(options, kCameraOptions, scene, reference), name, view, told.function()));
}

}  // namespace

void bindRays(py::module_& module) {
  const glm::vec3 none(std::numeric_limits<float>::quiet_NaN());
  py::class_<RayMap, SharedRays>(module, "Rays",
                                 R"(A camera as arrays: the ray of each pixel, straight or bent.

origins and directions have the shape (height, width, 3), row 0 at the top; a pixel whose direction is 0 or not finite
has no ray. near and far are distances from the origin. frame: "world", or "view": right, up and backward from the eye
of the view that an image is drawn at.)")
      .def(py::init(&straightRays), py::arg("origins"), py::arg("directions"), py::kw_only(), py::arg("near") = 0.0F,
           py::arg("far") = RayMap::kDefaultFar, py::arg("name") = RayMapNotes{}.name,
           py::arg("frame") = nameOf(RayMapNotes{}.frame), py::arg("wraps_around") = false,
           py::arg("view") = py::none())
      .def_static(
          "read",
          [](const std::filesystem::path& path) {
            const py::gil_scoped_release released;
            return shared(readRayMap(path));
          },
          py::arg("path"), "The rays of a file that `write()` or `ocelli camera rays` wrote.")
      .def(
          "write",
          [](const RayMap& map, const std::filesystem::path& path) {
            const py::gil_scoped_release released;
            writeRayMap(path, map);
          },
          py::arg("path"), "Writes an OpenEXR file, which `--camera` of the program takes.")
      .def_property_readonly("width", &RayMap::width)
      .def_property_readonly("height", &RayMap::height)
      .def_property_readonly("name", [](const RayMap& map) { return map.notes().name; })
      .def_property_readonly("frame", [](const RayMap& map) { return nameOf(map.notes().frame); })
      .def_property_readonly("view", [](const RayMap& map) { return map.notes().view; })
      .def_property_readonly("wraps_around", [](const RayMap& map) { return map.notes().wrapsAround; })
      .def_property_readonly("ray_count", &RayMap::rayCount, "Pixels that have a ray.")
      .def_property_readonly("max_segments", &RayMap::maxSegments, "Straight segments of the ray that has most.")
      .def_property_readonly(
          "origins",
          [none](const RayMap& map) {
            return eachRay(map, none, [](const RayMapRay& ray) { return ray.points.front(); });
          },
          "Where each ray begins, (height, width, 3); NaN where there is none.")
      .def_property_readonly(
          "directions",
          [none](const RayMap& map) {
            return eachRay(map, none,
                           [](const RayMapRay& ray) { return glm::normalize(ray.points[1] - ray.points[0]); });
          },
          "Where each ray goes first, of length 1, (height, width, 3); NaN where there is none.")
      .def("ray", &rayAt, py::arg("x"), py::arg("y"),
           "(points, t) of the ray of a pixel: (n, 3) and (n), from near to far; n is 2 for straight rays, 0 for none.")
      .def("__repr__", [](const RayMap& map) {
        return "<ocelli.Rays " + map.notes().name + " of " + std::to_string(map.width()) + "x" +
               std::to_string(map.height()) + ">";
      });
  module.def("rays_of", &raysOfChoice, py::arg("camera"), py::arg("mesh").none(true), py::arg("view"), py::arg("width"),
             py::arg("height"), py::arg("image"), py::arg("progress"));
  module.def("rays_of_constructed", &raysOfConstructed, py::arg("scene"), py::arg("options"), py::arg("name"),
             py::arg("view"), py::arg("width"), py::arg("height"), py::arg("progress"));
}

}  // namespace ocelli
