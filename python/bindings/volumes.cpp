// Volumes of scalars: their voxels, of files and of arrays, and what they look like.
#include "python/bindings/volumes.h"

#include <pybind11/stl.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "oc_core/isosurface/isosurface.h"
#include "oc_core/volume/transfer_presets.h"
#include "oc_core/volume/volume_record.h"
#include "oc_core/volume/volume_summary_json.h"
#include "oc_core/volume_camera/volume_surfaces.h"
#include "oc_core/volume_render/volume_renderer.h"
#include "python/bindings/arrays.h"
#include "python/bindings/bindings.h"
#include "python/bindings/progress.h"
#include "python/bindings/warnings.h"

namespace py = pybind11;

namespace ocelli {
namespace {

using SharedSeries = std::shared_ptr<VolumeSeries>;

/// What stands for an array in messages.
constexpr const char* kArraySource = "array";

/// Keeps an object of Python, whichever thread lets it go.
std::shared_ptr<const void> keptAlive(py::object object) {
  return {static_cast<const void*>(object.release().ptr()), [](const void* kept) {
            const py::gil_scoped_acquire interpreter;
            Py_DECREF(static_cast<PyObject*>(const_cast<void*>(kept)));
          }};
}

VoxelType voxelTypeOf(const py::dtype& type) {
  std::string names;
  for (int i = 0; i <= static_cast<int>(VoxelType::kFloat64); ++i) {
    const auto each = static_cast<VoxelType>(i);
    const std::string name(nameOf(each));
    if (type.equal(py::dtype(name))) {
      return each;
    }
    names += (names.empty() ? "" : ", ") + name;
  }
  throw InputError("voxels cannot be of the type " + type.attr("__str__")().cast<std::string>(), kArraySource,
                   "convert them with array.astype() to one of " + names);
}

/// Rows of an affine matrix, (3, 4).
using AffineRows = std::array<std::array<double, 4>, 3>;

glm::dmat4 matrixOf(const AffineRows& rows) {
  glm::dmat4 matrix(1);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      matrix[column][row] = rows[static_cast<size_t>(row)][static_cast<size_t>(column)];
    }
  }
  const double volume = std::abs(glm::determinant(glm::dmat3(matrix)));
  const double numbers =
      glm::length(matrix[0]) + glm::length(matrix[1]) + glm::length(matrix[2]) + glm::length(matrix[3]);
  if (!(volume > 0) || !std::isfinite(volume) || !std::isfinite(numbers)) {
    throw InputError("voxels have no volume there", "spacing, origin and orientation",
                     "give positive spacings, finite numbers, and three directions that span space");
  }
  return matrix;
}

py::array matrixArray(const glm::dmat4& matrix) {
  py::array_t<double> rows({4, 4});
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      rows.mutable_at(row, column) = matrix[column][row];
    }
  }
  return rows;
}

/// `voxels[k, j, i]`, dense and in the byte order of this machine: they are looked at where they are.
SharedSeries seriesOfArray(const py::array& voxels, const AffineRows& worldFromIndex, const std::string& unit,
                           bool isAnatomical, double scale, double offset, const std::string& modality,
                           const std::string& valueUnit) {
  const VoxelType type = voxelTypeOf(voxels.dtype());
  if (voxels.ndim() != 3 || (voxels.flags() & py::array::c_style) == 0) {
    throw InputError("a dense array of shape (k, j, i) is needed", kArraySource, "numpy.ascontiguousarray() makes one");
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (voxels.shape(axis) < 1 || voxels.shape(axis) > VolumeRecord::kMaxEdge) {
      throw InputError("an array of " + std::to_string(voxels.shape(axis)) + " voxels along an axis is no volume",
                       kArraySource, "give from 1 to " + std::to_string(VolumeRecord::kMaxEdge));
    }
  }
  if (!std::isfinite(scale) || !std::isfinite(offset) || scale == 0) {
    throw InputError("voxels would mean nothing", "scale and offset", "give finite numbers, and a scale other than 0");
  }
  VolumeGrid grid{.size = glm::ivec3(voxels.shape(2), voxels.shape(1), voxels.shape(0)),
                  .worldFromIndex = matrixOf(worldFromIndex),
                  .unit = unit,
                  .isAnatomical = isAnatomical};
  const std::span<const std::byte> bytes(static_cast<const std::byte*>(voxels.data()),
                                         static_cast<size_t>(voxels.nbytes()));
  auto volume = std::make_shared<ScalarVolume>(std::move(grid), type, bytes, keptAlive(voxels), scale, offset);
  volume->setFacts({.modality = modality, .valueUnit = valueUnit});
  auto series = std::make_shared<VolumeSeries>();
  series->source = kArraySource;
  series->volumes.push_back(std::move(volume));
  return series;
}

SharedSeries loadSeries(const std::string& source, const std::string& series, const py::object& progress) {
  const PythonProgress told(progress);
  const py::gil_scoped_release released;
  return std::make_shared<VolumeSeries>(loadVolumeSeries(source, series, told.function()));
}

/// (normal, distance) of each.
std::vector<ClipPlane> clipsOf(const std::vector<std::array<double, 4>>& planes) {
  std::vector<ClipPlane> clips;
  for (const auto& [x, y, z, distance] : planes) {
    const double length = std::hypot(x, y, z);
    if (!(length > 0) || !std::isfinite(length) || !std::isfinite(distance / length)) {
      throw InputError("a half space needs a normal that is not 0, and finite numbers", "clips",
                       "give (x, y, z, distance): (0, 0, 1, 0.2) shows where z is 0.2 or more");
    }
    clips.push_back({glm::dvec3(x, y, z) / length, distance / length});
  }
  return clips;
}

/// `transferText` is the JSON of a transfer function, or empty: then `transfer` counts.
PythonVolume volumeAt(const SharedSeries& series, std::optional<double> seconds, bool fit, const std::string& transfer,
                      const std::string& transferText, std::optional<bool> shaded,
                      const std::vector<std::array<double, 4>>& clips, const py::object& progress) {
  std::vector<std::string> warnings;
  VolumeSceneOptions options;
  options.fit = fit;
  options.transfer = transfer;
  options.clips = clipsOf(clips);
  options.warn = [&](const std::string& warning) { warnings.push_back(warning); };
  const PythonProgress told(progress);
  PythonVolume volume = [&] {
    const py::gil_scoped_release released;
    const size_t index = seconds ? series->indexAt(*seconds) : 0;
    return PythonVolume{
        series, index,
        transferText.empty()
            ? volumeSceneAt(*series, index, options, told.function())
            : volumeSceneAt(*series, index, transferFromJsonText(transferText, "transfer"), options, told.function())};
  }();
  VolumeShading& shading = volume.scene.appearance.shading;
  shading.isOn = shaded.value_or(shading.isOn);
  warnOf(warnings);
  return volume;
}

PythonVolume withSurfaces(const PythonVolume& volume, const Mesh& mesh, const std::string& frame, bool shaded) {
  if (frame != "volume" && frame != "scene") {
    throw InputError("there is no frame \"" + frame + "\"", "surfaces_frame", "use volume or scene");
  }
  PythonVolume changed = volume;
  const py::gil_scoped_release released;
  addSurfaces(changed.scene, mesh, frame == "volume" ? SurfaceFrame::kVolume : SurfaceFrame::kScene, shaded,
              "surfaces");
  return changed;
}

/// (k, j, i), as the voxels lie in memory.
py::array arrayOfVoxels(const py::object& self) {
  const ScalarVolume& volume = self.cast<const PythonVolume&>().whole();
  const glm::ivec3& size = volume.grid().size;
  return visitVoxels(volume, [&](const auto* first) { return viewOf(first, {size.z, size.y, size.x}, self); });
}

std::string infoOf(const PythonVolume& volume, const py::object& progress) {
  const PythonProgress told(progress);
  const py::gil_scoped_release released;
  return volumeSummaryJson(volume.source(), summaryOf(*volume.series, volume.index, {}, told.function()));
}

Mesh isosurfaceOf(const PythonVolume& volume, double value, bool shaded, std::optional<size_t> maxTriangles,
                  const py::object& progress) {
  IsosurfaceOptions options{.value = value, .isShaded = shaded};
  options.maxTriangles = maxTriangles.value_or(options.maxTriangles);
  const PythonProgress told(progress);
  const py::gil_scoped_release released;
  return isosurface(volume.scene, options, volume.source(), told.function());
}

std::string reprOf(const PythonVolume& volume) {
  const glm::ivec3& size = volume.whole().grid().size;
  return "<ocelli.Volume of " + std::to_string(size.x) + " x " + std::to_string(size.y) + " x " +
         std::to_string(size.z) + " voxels, " + std::string(nameOf(volume.whole().type())) + ">";
}

void bindVolumeClass(py::module_& module) {
  py::class_<VolumeSeries, SharedSeries>(module, "VolumeSeries", "Voxels of one grid, at one time or several.")
      .def_readonly("source", &VolumeSeries::source, "What it was loaded of.")
      .def_readonly("times", &VolumeSeries::times, "s, rising; empty where it stands still.")
      .def("__len__", [](const VolumeSeries& series) { return series.volumes.size(); });
  py::class_<PythonVolume>(module, "Volume", R"(A volume of scalars, and what it looks like in a scene.

ocelli.volume() makes one. It cannot be changed: ocelli.volume(volume, transfer=...) is another one of the same voxels.)")
      .def_property_readonly("array", &arrayOfVoxels,
                             "What voxels hold, (k, j, i), of the type that they have: a view, of a mapped file too. "
                             "What they mean is scale * array + offset.")
      .def_property_readonly(
          "shape",
          [](const PythonVolume& volume) {
            const glm::ivec3& size = volume.whole().grid().size;
            return py::make_tuple(size.z, size.y, size.x);
          },
          "Voxels along k, j and i: that of `array`.")
      .def_property_readonly(
          "spacing",
          [](const PythonVolume& volume) {
            const glm::dvec3 spacing = volume.whole().grid().spacing();
            return py::make_tuple(spacing.x, spacing.y, spacing.z);
          },
          "Edges of a voxel along i, j and k, in `unit`.")
      .def_property_readonly(
          "unit", [](const PythonVolume& volume) { return volume.whole().grid().unit; },
          "Of lengths: \"mm\"; \"\" where nothing says it.")
      .def_property_readonly(
          "scale", [](const PythonVolume& volume) { return volume.whole().scale(); },
          "What a voxel means is this times what it holds, plus `offset`.")
      .def_property_readonly(
          "offset", [](const PythonVolume& volume) { return volume.whole().offset(); },
          "What a voxel of 0 means, in the unit of its values.")
      .def_property_readonly(
          "world_from_index",
          [](const PythonVolume& volume) { return matrixArray(volume.whole().grid().worldFromIndex); },
          "From (i, j, k, 1) to the coordinates of its file, of patients LPS, (4, 4), for columns.")
      .def_property_readonly(
          "scene_from_index",
          [](const PythonVolume& volume) {
            const VolumeScene& scene = volume.scene;
            const glm::dmat4 levelFromWhole =
                glm::inverse(scene.volume->grid().worldFromIndex) * volume.whole().grid().worldFromIndex;
            return matrixArray(scene.worldFromIndex * levelFromWhole);
          },
          "From (i, j, k, 1) to the scene that images show, (4, 4), for columns.")
      .def_property_readonly(
          "series", [](const PythonVolume& volume) { return std::const_pointer_cast<VolumeSeries>(volume.series); },
          "What it is a moment of: `.times`, and len(), the number of moments.")
      .def_property_readonly(
          "transfer", [](const PythonVolume& volume) { return transferToJsonText(describe(volume.scene.appearance)); },
          "Its transfer function as the JSON of a file, with absolute values.")
      .def("__repr__", &reprOf);
}

}  // namespace

double depthOpacityOf(std::optional<double> wanted) {
  const double opacity = wanted.value_or(VolumeRenderOptions{}.depthOpacity);
  if (!(opacity >= 0.001 && opacity <= 0.999)) {
    throw InputError("nothing is opaque at this opacity", "opacity", "give from 0.001 to 0.999");
  }
  return opacity;
}

void bindVolumes(py::module_& module) {
  bindVolumeClass(module);
  module.def("is_volume_source", &isVolumeSource, py::arg("source"));
  module.def("load_volume_series", &loadSeries, py::arg("source"), py::arg("series"), py::arg("progress"));
  module.def("volume_series_of_array", &seriesOfArray, py::arg("voxels"), py::arg("world_from_index"), py::arg("unit"),
             py::arg("anatomical"), py::arg("scale"), py::arg("offset"), py::arg("modality"), py::arg("value_unit"));
  module.def("volume_at", &volumeAt, py::arg("series"), py::arg("seconds"), py::arg("fit"), py::arg("transfer"),
             py::arg("transfer_text"), py::arg("shaded"), py::arg("clips"), py::arg("progress"));
  module.def("volume_with_surfaces", &withSurfaces, py::arg("volume"), py::arg("mesh"), py::arg("frame"),
             py::arg("shaded"));
  module.def("volume_info", &infoOf, py::arg("volume"), py::arg("progress"));
  module.def("isosurface", &isosurfaceOf, py::arg("volume"), py::arg("value"), py::arg("shaded"),
             py::arg("max_triangles"), py::arg("progress"));
  module.def("transfer_presets", [] {
    std::vector<std::tuple<std::string, std::string, std::string>> rows;
    for (const TransferPreset& preset : transferPresets()) {
      rows.emplace_back(preset.name, preset.summary, transferToJsonText(preset.description));
    }
    return rows;
  });
}

}  // namespace ocelli
