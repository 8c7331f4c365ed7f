// Reference images, their files, meshes and resampled views.
#include "python/bindings/images.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <limits>

#include "oc_core/image/color.h"
#include "oc_core/image/png_file.h"
#include "oc_core/ocri/reference_image_file.h"
#include "oc_core/ocri/resample.h"
#include "oc_core/ocri/union_mesh.h"
#include "python/bindings/bindings.h"

namespace py = pybind11;

namespace ocelli {
namespace {

/// A property that is a view of an image of each sample; None where the image is empty.
template <class Pixel>
auto viewed(Image<Pixel> ReferenceImage::*image) {
  return [image](const py::object& self) -> py::object {
    const Image<Pixel>& pixels = self.cast<const ReferenceImage&>().*image;
    return pixels.empty() ? py::object(py::none()) : viewOf(pixels, self);
  };
}

/// The world point of each sample; NaN where there is none.
Image<glm::vec3> pointsOf(const ReferenceImage& image) {
  Image<glm::vec3> points(image.width(), image.height(), glm::vec3(std::numeric_limits<float>::quiet_NaN()));
  const PinholeCamera pinhole = image.reference();
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (const auto point = image.pointOf(x, y, pinhole)) {
        points(x, y) = *point;
      }
    }
  }
  return points;
}

size_t indexOf(const ReferenceImages& images, py::ssize_t index) {
  const auto count = static_cast<py::ssize_t>(images.size());
  if (index < -count || index >= count) {
    throw py::index_error("there are " + std::to_string(count) + " images");
  }
  return static_cast<size_t>(index < 0 ? index + count : index);
}

void bindReferenceImage(py::module_& module) {
  py::class_<ReferenceImage>(module, "ReferenceImage", R"(What a camera samples of a scene: one sample a pixel.

Arrays have the shape (height, width, ...), row 0 at the top, and are views that cannot be written to; None where the
camera needs no such array.)")
      .def_readonly("camera", &ReferenceImage::camera, "The name of the camera.")
      .def_readonly("view", &ReferenceImage::view, "The reference view.")
      .def_property_readonly("width", &ReferenceImage::width)
      .def_property_readonly("height", &ReferenceImage::height)
      .def_property_readonly("color", viewed(&ReferenceImage::color), "Linear RGB, (height, width, 3).")
      .def_property_readonly("t", viewed(&ReferenceImage::t),
                             "The parameter of the ray at each sample, (height, width): z, but for cameras that "
                             "displace no pinhole's image.")
      .def_property_readonly("held", viewed(&ReferenceImage::held), "1 where there is a sample, else 0.")
      .def_property_readonly("displacement", viewed(&ReferenceImage::displacement),
                             "From where a pinhole has each sample to where this camera has it, pixels.")
      .def_property_readonly("position", viewed(&ReferenceImage::position),
                             "Where each sample is, (height, width, 3), world coordinates, of cameras that displace no "
                             "pinhole's image; else None.")
      .def_property_readonly(
          "direction", viewed(&ReferenceImage::direction),
          "The way of the ray at each sample, (height, width, 3), unit vectors; of the same cameras.")
      .def_property_readonly("sample_count", &ReferenceImage::sampleCount, "Pixels that have a sample.")
      .def(
          "points",
          [](const ReferenceImage& image) {
            Image<glm::vec3> points = [&] {
              const py::gil_scoped_release released;
              return pointsOf(image);
            }();
            return arrayOf(std::move(points));
          },
          "Where each sample is, (height, width, 3), world coordinates; NaN where there is none. A new array.")
      .def(
          "write_png",
          [](const ReferenceImage& image, const std::filesystem::path& path) {
            const py::gil_scoped_release released;
            writePng(path, srgbFromLinear(image.color));
          },
          py::arg("path"), "Writes the colours as a PNG file, sRGB.")
      .def("__repr__", [](const ReferenceImage& image) {
        return "<ocelli.ReferenceImage " + image.camera + " of " + std::to_string(image.width()) + "x" +
               std::to_string(image.height()) + ">";
      });
}

void bindReferenceImages(py::module_& module) {
  py::class_<ReferenceImages>(module, "ReferenceImages",
                              "The reference images of a camera: one, or those of a union. A sequence.")
      .def("__len__", [](const ReferenceImages& images) { return images.size(); })
      .def(
          "__getitem__",
          [](const ReferenceImages& images, py::ssize_t index) -> const ReferenceImage& {
            return images[indexOf(images, index)];
          },
          py::return_value_policy::reference_internal)
      .def(
          "__iter__", [](const ReferenceImages& images) { return py::make_iterator(images.begin(), images.end()); },
          py::keep_alive<0, 1>())
      .def(
          "write",
          [](const ReferenceImages& images, const std::filesystem::path& path) {
            const py::gil_scoped_release released;
            writeReferenceImages(path, images);
          },
          py::arg("path"), "Writes an OpenEXR file, as `ocelli ocri build` does.")
      .def(
          "mesh",
          [](const ReferenceImages& images) {
            const py::gil_scoped_release released;
            return unionMesh(images);
          },
          "The bounded `Mesh` of the samples, world coordinates.")
      .def("__repr__", [](const ReferenceImages& images) {
        return "<ocelli.ReferenceImages: " + std::to_string(images.size()) + " of " + images.front().camera + ">";
      });
  module.def(
      "read_reference_images",
      [](const std::filesystem::path& path) {
        const py::gil_scoped_release released;
        return readReferenceImages(path);
      },
      py::arg("path"));
}

void bindResampled(py::module_& module) {
  py::class_<ResampledView>(module, "ResampledView", "What a pinhole would see, of what reference images hold.")
      .def_property_readonly(
          "color", [](const py::object& self) { return viewOf(self.cast<const ResampledView&>().color, self); },
          "Linear RGB, (height, width, 3).")
      .def_property_readonly(
          "t", [](const py::object& self) { return viewOf(self.cast<const ResampledView&>().t, self); },
          "z of what was warped, (height, width), world units; 0 where there is nothing, or rays were looked up.")
      .def_property_readonly(
          "hole", [](const py::object& self) { return viewOf(self.cast<const ResampledView&>().hole, self); },
          "1 where nothing is known, (height, width).")
      .def_property_readonly("holes", &ResampledView::holes, "Pixels where nothing is known.")
      .def_readonly("is_warped", &ResampledView::isWarped,
                    "Whether it was warped by depth; otherwise rays were looked up.");
  module.def(
      "resample",
      [](const ReferenceImages& images, const View& view, int width, int height) {
        requireImageSize(width, height);
        const py::gil_scoped_release released;
        return resample(images, PinholeCamera(view, width, height));
      },
      py::arg("images"), py::arg("view"), py::arg("width"), py::arg("height"));
}

}  // namespace

void requireImageSize(int width, int height) {
  if (width < 1 || height < 1 || width > PinholeCamera::kMaxPixelsASide || height > PinholeCamera::kMaxPixelsASide ||
      int64_t{width} * height > PinholeCamera::kMaxPixels) {
    throw InputError("no image can have this size: " + std::to_string(width) + "x" + std::to_string(height), "size",
                     "give (width, height), each from 1 to 32768, of 2^26 pixels at most");
  }
}

void bindImages(py::module_& module) {
  bindReferenceImage(module);
  bindReferenceImages(module);
  bindResampled(module);
  module.def(
      "srgb_from_linear",
      [](const DenseArray<float>& linear) {
        if (linear.ndim() != 3 || linear.shape(2) != 3) {
          throw InputError("an array of shape (height, width, 3) is needed", "srgb(linear)", "give linear RGB");
        }
        Image<glm::vec3> image(static_cast<int>(linear.shape(1)), static_cast<int>(linear.shape(0)));
        std::memcpy(static_cast<void*>(image.data()), linear.data(), image.size() * sizeof(glm::vec3));
        const Image<Rgb8> bytes = srgbFromLinear(image);
        py::array_t<uint8_t> result({linear.shape(0), linear.shape(1), py::ssize_t{3}});
        static_assert(sizeof(Rgb8) == 3, "three bytes side by side");
        std::memcpy(result.mutable_data(), bytes.data(), bytes.size() * sizeof(Rgb8));
        return result;
      },
      py::arg("linear"));
}

}  // namespace ocelli
