// Volumetric displays: slices of a mesh, their files, and what an eye sees of them.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <array>

#include "display_sim/frames/display_profile.h"
#include "display_sim/frames/svol_file.h"
#include "display_sim/observing/observer.h"
#include "display_sim/slicing/exact_slicer.h"
#include "display_sim/slicing/slicer.h"
#include "python/bindings/bindings.h"
#include "python/bindings/images.h"

namespace py = pybind11;

namespace ocelli {
namespace {

int sliceIndex(const Volume& volume, int slice) {
  if (slice < 0 || slice >= volume.slices()) {
    throw py::index_error("there are " + std::to_string(volume.slices()) + " slices");
  }
  return slice;
}

/// (height, width, 3) bytes: how much red, green and blue each voxel shows, 0 to 255.
py::array levelsOf(const Volume& volume, int slice) {
  const Image<Rgb8> image = sliceImage(volume, sliceIndex(volume, slice));
  py::array_t<uint8_t> levels({image.height(), image.width(), 3});
  static_assert(sizeof(Rgb8) == 3, "three bytes side by side");
  std::memcpy(levels.mutable_data(), image.data(), image.size() * sizeof(Rgb8));
  return levels;
}

Volume sliced(const Mesh& mesh, const std::string& profile, bool exact) {
  const py::gil_scoped_release released;
  const DisplayProfile display = loadProfile(profile);
  return exact ? sliceExactly(mesh, display) : slice(mesh, display);
}

py::array observed(const Volume& volume, const std::optional<std::array<float, 3>>& eye, int width, int height,
                   double fovVerticalDegrees, double exposureSeconds, double gain) {
  requireImageSize(width, height);
  ObserverOptions options;
  options.eye = {0, 0, static_cast<float>(volume.profile().viewingDistanceRadii())};
  if (eye) {
    options.eye = {(*eye)[0], (*eye)[1], (*eye)[2]};
  }
  options.width = width;
  options.height = height;
  options.fovVerticalDegrees = fovVerticalDegrees;
  options.exposureSeconds = exposureSeconds;
  options.tone.gain = gain;
  Image<glm::vec3> light = [&] {
    const py::gil_scoped_release released;
    return observe(volume, options);
  }();
  return arrayOf(std::move(light));
}

}  // namespace

void bindDisplays(py::module_& module) {
  py::class_<Volume>(module, "DisplayVolume", R"(The bit planes of a volumetric display: slices of voxels.

len() is the number of slices.)")
      .def_property_readonly(
          "profile", [](const Volume& volume) { return volume.profile().name; }, "The name of the display.")
      .def_property_readonly("slices", &Volume::slices, "Slices of a refresh.")
      .def_property_readonly("width", &Volume::width, "Of a slice, pixels.")
      .def_property_readonly("height", &Volume::height, "Of a slice, pixels.")
      .def_property_readonly("bits_per_channel", &Volume::bitsPerChannel, "Of red, green and blue each.")
      .def_property_readonly("lit_voxels", &Volume::litVoxels, "Voxels that are not black.")
      .def("levels", &levelsOf, py::arg("slice"),
           "How much red, green and blue each voxel of a slice shows, (height, width, 3), 0 to 255. A new array.")
      .def(
          "bit_planes",
          [](const py::object& self, int slice) {
            const Volume& volume = self.cast<const Volume&>();
            const VolumeLayout& layout = volume.layout();
            return viewOf(
                volume.slice(sliceIndex(volume, slice)).data(),
                {static_cast<py::ssize_t>(layout.planes), volume.height(), static_cast<py::ssize_t>(layout.rowBytes)},
                self);
          },
          py::arg("slice"),
          "The packed bits of a slice as displays take them, (planes, height, bytes of a row). A view.")
      .def(
          "write",
          [](const Volume& volume, const std::filesystem::path& path) {
            const py::gil_scoped_release released;
            writeSvol(path, volume);
          },
          py::arg("path"), "Writes an .svol file.")
      .def_static(
          "read",
          [](const std::filesystem::path& path, size_t frame) {
            const py::gil_scoped_release released;
            return readSvol(path, frame);
          },
          py::arg("path"), py::arg("frame") = 0, "Reads a frame of an .svol file.")
      .def("__len__", &Volume::slices)
      .def("__eq__", [](const Volume& a, const Volume& b) { return a == b; })
      .def("__repr__", [](const Volume& volume) {
        return "<ocelli.DisplayVolume for " + volume.profile().name + ": " + std::to_string(volume.slices()) +
               " slices of " + std::to_string(volume.width()) + "x" + std::to_string(volume.height()) + ">";
      });
  module.def("profiles", &builtinProfileNames);
  module.def("slice", &sliced, py::arg("mesh"), py::arg("profile"), py::arg("exact"));
  module.def("observe", &observed, py::arg("volume"), py::arg("eye"), py::arg("width"), py::arg("height"),
             py::arg("fov_vertical_degrees"), py::arg("exposure_seconds"), py::arg("gain"));
}

}  // namespace ocelli
