// Volumes along the rays of cameras: pictures, and the reference images of what rays hit first.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <limits>

#include "oc_core/constructor/camera_constructors.h"
#include "oc_core/image/png_file.h"
#include "oc_core/volume_camera/guided_volume.h"
#include "oc_core/volume_camera/volume_image_file.h"
#include "oc_core/volume_ocri/volume_first_hits.h"
#include "python/bindings/bindings.h"
#include "python/bindings/images.h"
#include "python/bindings/options.h"
#include "python/bindings/progress.h"
#include "python/bindings/volumes.h"

namespace py = pybind11;

namespace ocelli {
namespace {

/// A picture of a volume, with the camera that saw it.
struct PythonVolumeImage {
  VolumeImage image;
  VolumeCamera camera;
  double depthOpacity;
};

/// `constructor` is the name of a graph or curved ray camera's, or empty.
VolumeCamera cameraAt(const VolumeRenderer& renderer, const CameraArgument& camera, const std::string& constructor,
                      const PinholeCamera& reference, const Progress& progress) {
  if (!constructor.empty()) {
    return volumeCamera(constructor,
                        constructCameraFromJson(std::get<std::string>(camera), kCameraOptions,
                                                guidedVolume(renderer.scene()), reference),
                        renderer.scene());
  }
  const VolumeTarget firstHits(renderer);
  return volumeCamera(
      cameraChoiceOf(camera), reference, [&]() -> const RayTarget& { return firstHits; }, progress);
}

PythonVolumeImage drawVolume(const PythonVolume& volume, const CameraArgument& camera, const std::string& constructor,
                             const View& view, int width, int height, std::optional<double> step,
                             std::optional<double> opacity, const py::object& progress) {
  requireImageSize(width, height);
  VolumeRenderOptions options;
  options.step = step.value_or(options.step);
  if (!(options.step >= 1.0 / 64 && options.step <= 64)) {
    throw InputError("samples cannot lie that far apart", "step", "give from 1/64 to 64 voxels");
  }
  options.depthOpacity = depthOpacityOf(opacity);
  const PythonProgress told(progress);
  const py::gil_scoped_release released;
  const VolumeRenderer renderer(volume.scene, options);
  VolumeCamera seen = cameraAt(renderer, camera, constructor, PinholeCamera(view, width, height), told.function());
  VolumeImage image = renderer.render(seen.size.x, seen.size.y, seen.ray, told.function(), seen.hull, seen.isSmooth);
  if (factsOf(image).touched == 0) {
    failShowingNothing(seen, renderer.scene());
  }
  return {std::move(image), std::move(seen), options.depthOpacity};
}

ReferenceImages buildVolumeImages(const PythonVolume& volume, const CameraArgument& camera, const View& view, int width,
                                  int height, std::optional<double> opacity, const py::object& progress) {
  requireImageSize(width, height);
  const double depthOpacity = depthOpacityOf(opacity);
  const PythonProgress told(progress);
  const py::gil_scoped_release released;
  const CameraChoice choice = cameraChoiceOf(camera);
  const VolumeFirstHits hits(volume.scene, {.depthOpacity = depthOpacity});
  return buildReferenceImages(choice, PinholeCamera(view, width, height), hits.renderer(), told.function());
}

/// A property that is a view of a number, or several side by side, of each pixel.
template <class Value>
auto ofEachPixel(Value VolumePixel::*member) {
  return [member](const py::object& self) {
    using Number = typename Components<Value>::Number;
    const VolumeImage& image = self.cast<const PythonVolumeImage&>().image;
    std::vector<py::ssize_t> shape{image.height(), image.width()};
    std::vector<py::ssize_t> strides{static_cast<py::ssize_t>(sizeof(VolumePixel)) * image.width(),
                                     static_cast<py::ssize_t>(sizeof(VolumePixel))};
    if constexpr (Components<Value>::kCount > 1) {
      shape.push_back(Components<Value>::kCount);
      strides.push_back(sizeof(Number));
    }
    py::array_t<Number> view(shape, strides, reinterpret_cast<const Number*>(&(image.data()->*member)), self);
    view.attr("setflags")(py::arg("write") = false);
    return py::array(view);
  };
}

py::array pointsOfPicture(const PythonVolumeImage& picture) {
  Image<glm::vec3> points = [&] {
    const py::gil_scoped_release released;
    Image<glm::vec3> found = opaquePoints(picture.image, picture.camera);
    for (size_t i = 0; i < found.size(); ++i) {
      if (picture.image[i].opaqueT() == VolumePixel::kNowhere) {
        found[i] = glm::vec3(std::numeric_limits<float>::quiet_NaN());
      }
    }
    return found;
  }();
  return arrayOf(std::move(points));
}

void writePicture(const PythonVolumeImage& picture, const std::filesystem::path& path,
                  const std::array<float, 3>& background) {
  const py::gil_scoped_release released;
  if (path.extension() == ".exr") {
    writeVolumeImage(path, picture.image, picture.camera, picture.depthOpacity);
  } else if (path.extension() == ".png") {
    writePng(path, srgbFromLinear(imageBefore({background[0], background[1], background[2]}, picture.image)));
  } else {
    throw InputError("pictures of volumes are no such files", path, "give a name that ends in .png or .exr");
  }
}

}  // namespace

void bindVolumeImages(py::module_& module) {
  py::class_<PythonVolumeImage>(module, "VolumeImage", R"(A picture of a volume: what the ray of each pixel passes.

Arrays have the shape (height, width, ...), row 0 at the top, and are views that cannot be written to.)")
      .def_property_readonly(
          "camera", [](const PythonVolumeImage& picture) { return picture.camera.name; }, "The name of the camera.")
      .def_property_readonly("width", [](const PythonVolumeImage& picture) { return picture.image.width(); })
      .def_property_readonly("height", [](const PythonVolumeImage& picture) { return picture.image.height(); })
      .def_property_readonly("color", ofEachPixel(&VolumePixel::color),
                             "Linear RGB, multiplied by the opacity, and the opacity, (height, width, 4).")
      .def_property_readonly("t", ofEachPixel(&VolumePixel::t),
                             "The parameter of the ray where the opacity of what it has passed reaches `opacity`, "
                             "(height, width); infinite where it does not.")
      .def_property_readonly(
          "surface_t", ofEachPixel(&VolumePixel::surfaceT),
          "The parameter of the ray where a surface ends it, (height, width); infinite where none does.")
      .def_property_readonly("samples", ofEachPixel(&VolumePixel::samples),
                             "Places where the field was looked at, (height, width).")
      .def_readonly("opacity", &PythonVolumeImage::depthOpacity, "The opacity that `t` is told of, 0 to 1.")
      .def(
          "before",
          [](const PythonVolumeImage& picture, const std::array<float, 3>& background) {
            return arrayOf(imageBefore({background[0], background[1], background[2]}, picture.image));
          },
          py::arg("background") = std::array<float, 3>{0, 0, 0},
          "The picture before a background, both linear RGB, (height, width, 3). A new array.")
      .def("points", &pointsOfPicture,
           "Where each ray is opaque, in the scene, (height, width, 3); NaN where it is nowhere. A new array.")
      .def("write", &writePicture, py::arg("path"), py::arg("background") = std::array<float, 3>{0, 0, 0},
           "Writes a .png file, or an .exr with opacity, depth and points, as `ocelli render` does.")
      .def("__repr__", [](const PythonVolumeImage& picture) {
        return "<ocelli.VolumeImage by " + picture.camera.name + " of " + std::to_string(picture.image.width()) + "x" +
               std::to_string(picture.image.height()) + ">";
      });
  module.def("draw_volume", &drawVolume, py::arg("volume"), py::arg("camera"), py::arg("constructor"), py::arg("view"),
             py::arg("width"), py::arg("height"), py::arg("step"), py::arg("opacity"), py::arg("progress"));
  module.def("build_volume_images", &buildVolumeImages, py::arg("volume"), py::arg("camera"), py::arg("view"),
             py::arg("width"), py::arg("height"), py::arg("opacity"), py::arg("progress"));
}

}  // namespace ocelli
