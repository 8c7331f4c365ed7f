// Volumetric displays: slices of a mesh, their files, and what an eye sees of them.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "display_sim/dither_score/dither_fields.h"
#include "display_sim/frames/display_profile.h"
#include "display_sim/frames/svol_file.h"
#include "display_sim/observing/observer.h"
#include "display_sim/slicing/exact_slicer.h"
#include "display_sim/slicing/slicer.h"
#include "display_sim/volume_solidity/masked_volume.h"
#include "display_sim/volume_solidity/shown_volume.h"
#include "oc_core/base/conventions.h"
#include "python/bindings/bindings.h"
#include "python/bindings/images.h"
#include "python/bindings/progress.h"
#include "python/bindings/volumes.h"

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

/// What both kinds of slicers are told, by the names of `ocelli slice`.
SliceOptions sliceOptionsOf(const std::string& dither, bool undithered, bool antialias, double evenLight) {
  SliceOptions options{.angularAntialiasing = antialias, .evenLightRadius = evenLight};
  if (!(evenLight >= 0 && evenLight <= 1)) {
    throw InputError("no radius of a display is like that", "even_light", "give from 0 to 1");
  }
  const auto* const named = std::ranges::find(kNamedDithers, dither, &NamedDither::name);
  if (named == std::end(kNamedDithers)) {
    std::string names;
    for (const NamedDither& each : kNamedDithers) {
      names += (names.empty() ? "" : ", ") + std::string(each.name);
    }
    throw InputError("there is no dither \"" + dither + "\"", "dither", "use one of " + names);
  }
  options.colors = undithered ? ColorReduction::kOccupancy : named->colors;
  return options;
}

Volume sliced(const Mesh& mesh, const std::string& profile, bool exact, const std::string& dither, bool undithered,
              bool antialias, double evenLight) {
  const SliceOptions options = sliceOptionsOf(dither, undithered, antialias, evenLight);
  const py::gil_scoped_release released;
  const DisplayProfile display = loadProfile(profile);
  return exact || needsExactSlicer(options) ? sliceExactly(mesh, display, options) : slice(mesh, display, options);
}

/// What of a volume is shown.
struct ShownPart {
  std::optional<double> iso;
  std::optional<std::array<double, 2>> values;
  const PythonVolume* mask;  ///< or nullptr
  double lightGain;
  double gradientLight;
  std::optional<double> cutaway;
  std::optional<double> seenOpacity;
  std::vector<std::array<float, 3>> viewers;
};

/// Throws InputError outside of [min, max].
void requireWithin(std::optional<double> number, double min, double max, const char* name) {
  if (number && !(*number >= min && *number <= max)) {
    throw InputError(std::to_string(*number) + " is out of range", name,
                     "give from " + std::to_string(min) + " to " + std::to_string(max));
  }
}

ShownVolumeOptions shownOptionsOf(const PythonVolume& volume, const ShownPart& part) {
  requireWithin(part.lightGain, 1e-3, 1e3, "light_gain");
  requireWithin(part.gradientLight, 0, 1, "gradient_light");
  requireWithin(part.cutaway, -1, 1, "cutaway");
  requireWithin(part.seenOpacity, 0.01, 0.99, "seen_opacity");
  ShownVolumeOptions options;
  options.sampling.fullLightGradient = part.gradientLight;
  options.light.gain = part.lightGain;
  options.surface = part.iso;
  if (part.iso) {
    requireSurface(volume.scene, *part.iso, volume.source());
  }
  if (part.values) {
    options.light.shown = ValueRange{(*part.values)[0], (*part.values)[1]};
  }
  if (part.mask != nullptr) {
    // Nobody sees its colours: any absolute ones will do, which a mask of one value has too.
    VolumeScene mask = volumeSceneAt(*part.mask->series, part.mask->index, {.fit = false, .transfer = "ct-bone"});
    options.mask = std::make_shared<const VolumeScene>(placedMask(std::move(mask), volume.scene));
  }
  options.cutaway = part.cutaway;
  options.seenOpacity = part.seenOpacity;
  if (part.cutaway || part.seenOpacity) {
    for (const std::array<float, 3>& eye : part.viewers) {
      options.eyes.emplace_back(eye[0], eye[1], eye[2]);
    }
    if (options.eyes.empty()) {
      options.eyes.emplace_back(0, 0, kDefaultEyeDistance);
    }
  }
  return options;
}

/// A volume of scalars, straight from its field.
Volume slicedVolume(const PythonVolume& volume, const std::string& profile, const std::string& dither, bool undithered,
                    std::optional<double> iso, const std::optional<std::array<double, 2>>& values,
                    const PythonVolume* mask, double lightGain, double gradientLight, std::optional<double> cutaway,
                    std::optional<double> seenOpacity, const std::vector<std::array<float, 3>>& viewers,
                    const py::object& progress) {
  const SliceOptions options = sliceOptionsOf(dither, undithered, false, 0);
  const PythonProgress told(progress);
  const py::gil_scoped_release released;
  const DisplayProfile display = loadProfile(profile);
  const ShownVolume shown(
      volume.scene, display,
      shownOptionsOf(volume, {iso, values, mask, lightGain, gradientLight, cutaway, seenOpacity, viewers}),
      told.function());
  VolumeSlicer slicer(display, options);
  slicer.slice(shown.samples(), shown.light());
  return slicer.takeVolume();
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
  module.def("slice", &sliced, py::arg("mesh"), py::arg("profile"), py::arg("exact"), py::arg("dither"),
             py::arg("undithered"), py::arg("antialias"), py::arg("even_light"));
  module.def("slice_volume", &slicedVolume, py::arg("volume"), py::arg("profile"), py::arg("dither"),
             py::arg("undithered"), py::arg("iso"), py::arg("values"), py::arg("mask"), py::arg("light_gain"),
             py::arg("gradient_light"), py::arg("cutaway"), py::arg("seen_opacity"), py::arg("viewers"),
             py::arg("progress"));
  module.def("dithers", [] {
    std::vector<std::string> names;
    for (const NamedDither& each : kNamedDithers) {
      names.emplace_back(each.name);
    }
    return names;
  });
  module.def("observe", &observed, py::arg("volume"), py::arg("eye"), py::arg("width"), py::arg("height"),
             py::arg("fov_vertical_degrees"), py::arg("exposure_seconds"), py::arg("gain"));
}

}  // namespace ocelli
