// Views: where the eye is, where it looks, and how wide.
#include <pybind11/numpy.h>

#include <array>

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/camera/view.h"
#include "python/bindings/bindings.h"

namespace py = pybind11;

namespace ocelli {
namespace {

using Point = std::array<float, 3>;

glm::vec3 vectorOf(const Point& point) {
  return {point[0], point[1], point[2]};
}

py::tuple tupleOf(const glm::vec3& point) {
  return py::make_tuple(point.x, point.y, point.z);
}

}  // namespace

void bindViews(py::module_& module) {
  py::class_<View>(module, "View", R"(Where an eye is, where it looks, and how wide.

View(eye=(0, 0, 10), target=(0, 0, 0), up=(0, 1, 0), fov_vertical_degrees=0, near=..., far=..., center_shift=(0, 0)):
world coordinates, degrees; a field of view of 0 just holds the unit sphere. center_shift is where the view direction
meets the image, from its middle, to the right and down, in image heights. It cannot be changed: make another.)")
      .def(py::init([](const Point& eye, const Point& target, const Point& up, double fovVerticalDegrees, float near,
                       float far, const std::array<float, 2>& centerShift) {
             const View view{vectorOf(eye),
                             vectorOf(target),
                             vectorOf(up),
                             fovVerticalDegrees,
                             near,
                             far,
                             {centerShift[0], centerShift[1]}};
             validate(view, "View");
             return view;
           }),
           py::kw_only(), py::arg("eye") = Point{0, 0, kDefaultEyeDistance}, py::arg("target") = Point{0, 0, 0},
           py::arg("up") = Point{0, 1, 0}, py::arg("fov_vertical_degrees") = 0.0, py::arg("near") = View{}.zNear,
           py::arg("far") = View{}.zFar, py::arg("center_shift") = std::array<float, 2>{0, 0})
      .def_property_readonly(
          "eye", [](const View& view) { return tupleOf(view.eye); }, "(x, y, z), world coordinates.")
      .def_property_readonly(
          "target", [](const View& view) { return tupleOf(view.target); }, "What it looks at, (x, y, z).")
      .def_property_readonly(
          "up", [](const View& view) { return tupleOf(view.up); }, "What is up in the image, (x, y, z).")
      .def_property_readonly("fov_vertical_degrees", &View::resolvedFovVerticalDegrees,
                             "Of the whole image, degrees; of the unit sphere where 0 was given.")
      .def_readonly("near", &View::zNear, "Distance of the near plane, world units.")
      .def_readonly("far", &View::zFar, "Distance of the far plane, world units.")
      .def(
          "moved",
          [](const View& view, const Point& offset) {
            View moved = movedEye(view, vectorOf(offset));
            validate(moved, "View.moved()");
            return moved;
          },
          py::arg("offset"), "The same view with its eye moved by (right, up, back), looking at the same target.")
      .def(
          "json", [](const View& view) { return jsonText(view); }, "As text, as files of views are.")
      .def_static(
          "from_json", [](const std::string& text) { return viewFromJsonText(text, "View.from_json()"); },
          py::arg("text"), "Of a text that json() gave.")
      .def_static(
          "read", [](const std::filesystem::path& path) { return readView(path); }, py::arg("path"),
          "Of a JSON file, as --view takes it.")
      .def("__eq__", [](const View& a, const View& b) { return a == b; })
      .def("__repr__", [](const View& view) { return "View.from_json('" + jsonText(view) + "')"; });
}

}  // namespace ocelli
