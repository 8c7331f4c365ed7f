// Effects: reflections, refraction, shadows, relief and ambient light, by reference images and traced.
#include <pybind11/stl.h>

#include "oc_core/shade/prepared_effect.h"
#include "oc_core/shade/shade_report.h"
#include "python/bindings/bindings.h"
#include "python/bindings/images.h"
#include "python/bindings/progress.h"

namespace py = pybind11;

namespace ocelli {
namespace {

using ImageSizeArgument = std::optional<std::array<int, 2>>;

EffectRequest effectRequestOf(const std::string& scene, const std::string& effect, std::vector<std::string> ways,
                              const std::string& roles, const std::optional<View>& view, int width, int height,
                              const ImageSizeArgument& imageSize, std::optional<float> cell, int environmentHeight,
                              std::map<std::string, std::string> options, bool shaded) {
  requireImageSize(width, height);
  EffectRequest request{.source = scene,
                        .effect = effect,
                        .ways = std::move(ways),
                        .roles = roles,
                        .view = view,
                        .size = {width, height},
                        .cellSide = cell,
                        .environmentHeight = environmentHeight,
                        .options = std::move(options)};
  if (imageSize) {
    requireImageSize((*imageSize)[0], (*imageSize)[1]);
    request.referenceSize = glm::ivec2((*imageSize)[0], (*imageSize)[1]);
  }
  if (cell && !(*cell > 0 && *cell < 1e6F)) {
    throw InputError("no cell of viewpoints has this size", "cell", "give a side above 0, in the scene's units");
  }
  if (environmentHeight < 2 || environmentHeight > 16384) {
    throw InputError("no environment map has this height", "environment_height", "give from 2 to 16384 rows");
  }
  request.scene.shading = shaded ? Shading::kLambert : Shading::kNone;
  return request;
}

py::array drawEffect(const std::string& scene, const std::string& effect, const std::string& way,
                     const std::string& roles, const std::optional<View>& view, int width, int height,
                     const ImageSizeArgument& imageSize, std::optional<float> cell, int environmentHeight,
                     const std::map<std::string, std::string>& options, bool shaded, const py::object& progress) {
  const EffectRequest request = effectRequestOf(scene, effect, {way}, roles, view, width, height, imageSize, cell,
                                                environmentHeight, options, shaded);
  const PythonProgress told(progress);
  Image<glm::vec3> picture = [&] {
    const py::gil_scoped_release released;
    const PreparedEffect prepared = prepareEffect(request, {}, told.function());
    return prepared.stage->build(way)->draw(prepared.camera);
  }();
  return arrayOf(std::move(picture));
}

/// The JSON of `ocelli shade --json`, and (picture, {name of a map: its bytes}) of each way, the traced one first.
py::tuple compareEffect(const std::string& scene, const std::string& effect, const std::vector<std::string>& wanted,
                        const std::string& roles, const std::optional<View>& view, int width, int height,
                        const ImageSizeArgument& imageSize, std::optional<float> cell, int environmentHeight,
                        const std::map<std::string, std::string>& options, bool shaded, int runs,
                        const py::object& progress) {
  const EffectRequest request = effectRequestOf(scene, effect, wanted, roles, view, width, height, imageSize, cell,
                                                environmentHeight, options, shaded);
  if (runs < 1 || runs > 1000) {
    throw InputError("rays cannot be timed so often", "runs", "give from 1 to 1000");
  }
  const PythonProgress told(progress);
  std::string json;
  std::vector<ShadedWay> ways;
  {
    const py::gil_scoped_release released;
    PreparedEffect prepared = prepareEffect(request, {}, told.function());
    ShadeReport report{.scene = scene,
                       .effect = prepared.effect,
                       .version = OCELLI_VERSION,
                       .view = prepared.camera.view(),
                       .size = {width, height},
                       .runs = runs};
    report.ways.push_back(prepared.stage->measure(kTraced, prepared.camera, runs));
    for (const std::string& way : wanted) {
      if (way != kTraced) {
        report.ways.push_back(prepared.stage->measure(way, prepared.camera, runs));
      }
    }
    report.facts = prepared.stage->facts(prepared.camera);
    json = shadeJson(report);
    ways = std::move(report.ways);
  }
  py::list pictures;
  for (ShadedWay& way : ways) {
    py::dict maps;
    for (ShadedMap& map : way.maps) {
      static_assert(sizeof(Rgb8) == 3, "three bytes side by side");
      py::array_t<uint8_t> bytes({map.image.height(), map.image.width(), 3});
      std::memcpy(bytes.mutable_data(), map.image.data(), map.image.size() * sizeof(Rgb8));
      maps[py::str(map.name)] = bytes;
    }
    pictures.append(py::make_tuple(arrayOf(std::move(way.picture)), maps));
  }
  return py::make_tuple(json, pictures);
}

/// A dict for each effect, with its options and what its figures mean.
py::list effectRows() {
  py::list rows;
  for (const Effect& effect : shadeEffects()) {
    py::dict row;
    row["name"] = effect.name;
    row["meaning"] = effect.description;
    row["ways"] = offeredWays(effect);
    row["ways_meaning"] = effect.ways;
    py::list options;
    for (const EffectOption& option : effect.options) {
      py::dict each;
      each["name"] = option.name;
      each["values"] = option.values;
      each["default"] = option.initial;
      each["meaning"] = option.meaning;
      options.append(each);
    }
    row["options"] = options;
    py::dict figures;
    for (const FigureColumn& column : effect.columns) {
      figures[column.field] = column.meaning;
    }
    row["figures"] = figures;
    rows.append(row);
  }
  return rows;
}

}  // namespace

void bindEffects(py::module_& module) {
  module.def("effects", &effectRows);
  module.def("draw_effect", &drawEffect, py::arg("scene"), py::arg("effect"), py::arg("way"), py::arg("roles"),
             py::arg("view"), py::arg("width"), py::arg("height"), py::arg("image_size"), py::arg("cell"),
             py::arg("environment_height"), py::arg("options"), py::arg("shaded"), py::arg("progress"));
  module.def("compare_effect", &compareEffect, py::arg("scene"), py::arg("effect"), py::arg("ways"), py::arg("roles"),
             py::arg("view"), py::arg("width"), py::arg("height"), py::arg("image_size"), py::arg("cell"),
             py::arg("environment_height"), py::arg("options"), py::arg("shaded"), py::arg("runs"),
             py::arg("progress"));
}

}  // namespace ocelli
