// Meshes and scenes.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>

#include "oc_core/ocri/union_mesh.h"
#include "oc_core/scene/ply_file.h"
#include "oc_core/scene/texture_bake.h"
#include "oc_core/worlds/builtin_scenes.h"
#include "oc_core/worlds/scene_source.h"
#include "python/bindings/arrays.h"
#include "python/bindings/bindings.h"
#include "python/bindings/progress.h"
#include "python/bindings/warnings.h"

namespace py = pybind11;

namespace ocelli {
namespace {

Mesh meshOf(const DenseArray<float>& positions, const DenseArray<uint32_t>& triangles,
            const std::optional<DenseArray<float>>& colors) {
  Mesh mesh;
  mesh.positions = rowsOf<glm::vec3>(positions, "Mesh(positions=)");
  mesh.triangles = rowsOf<glm::uvec3>(triangles, "Mesh(triangles=)");
  if (colors) {
    mesh.colors = rowsOf<glm::vec3>(*colors, "Mesh(colors=)");
  }
  validate(mesh, "Mesh");
  return mesh;
}

GuidedScene sceneOfMesh(const Mesh& mesh, bool fit) {
  GuidedScene scene;
  scene.mesh = mesh;
  scene.objectOfTriangle.assign(mesh.triangles.size(), 1);
  if (fit) {
    scene.worldFromScene = unitFromWorld(mesh, "Scene(mesh)");
    transform(scene.mesh, scene.worldFromScene);
  }
  return scene;
}

GuidedScene load(const std::string& source, bool fit, bool shaded, bool textures, std::optional<double> seconds,
                 std::optional<double> iso, const std::string& labels, size_t textureTriangles,
                 const py::object& progress) {
  std::vector<std::string> warnings;
  SceneOptions options;
  options.fit = fit;
  options.shading = shaded ? Shading::kLambert : Shading::kNone;
  options.textures = textures;
  options.motion.seconds = seconds;
  options.iso = iso;
  options.labels.file = labels;
  options.textureTriangles = std::min(textureTriangles, kMaxTextureTriangles);
  options.warn = [&](const std::string& warning) { warnings.push_back(warning); };
  const PythonProgress told(progress);
  GuidedScene scene = [&] {
    const py::gil_scoped_release released;
    return loadGuidedScene(source, options, told.function());
  }();
  warnOf(warnings);
  return scene;
}

}  // namespace

void bindScenes(py::module_& module) {
  py::class_<Mesh>(module, "Mesh", R"(Triangles with colours.

Mesh(positions, triangles, colors=None): positions (n, 3); triangles (m, 3), indices of vertices, counter-clockwise seen
from outside; colors (n, 3), linear RGB, white where there are none. Arrays are copied once. len() is the number of
triangles.)")
      .def(py::init(&meshOf), py::arg("positions"), py::arg("triangles"), py::arg("colors") = py::none())
      .def_property_readonly(
          "positions", [](const py::object& self) { return viewOf(self.cast<const Mesh&>().positions, self); },
          "Vertices, (n, 3), world coordinates.")
      .def_property_readonly(
          "triangles", [](const py::object& self) { return viewOf(self.cast<const Mesh&>().triangles, self); },
          "Indices of vertices, (m, 3).")
      .def_property_readonly(
          "colors",
          [](const py::object& self) -> py::object {
            const Mesh& mesh = self.cast<const Mesh&>();
            return mesh.colors.empty() ? py::object(py::none()) : viewOf(mesh.colors, self);
          },
          "Of vertices, (n, 3), linear RGB; None where all are white.")
      .def(
          "write_ply",
          [](const Mesh& mesh, const std::filesystem::path& path) {
            const py::gil_scoped_release released;
            writePly(path, mesh);
          },
          py::arg("path"), "Writes a binary PLY file.")
      .def_static(
          "read_ply",
          [](const std::filesystem::path& path) {
            const py::gil_scoped_release released;
            return readPly(path);
          },
          py::arg("path"), "Reads a PLY file as it is: ocelli.scene.load() fits scenes into the unit sphere.")
      .def("__len__", [](const Mesh& mesh) { return mesh.triangles.size(); })
      .def("__repr__", [](const Mesh& mesh) {
        return "<ocelli.Mesh of " + std::to_string(mesh.triangles.size()) + " triangles, " +
               std::to_string(mesh.positions.size()) + " vertices>";
      });

  py::class_<GuidedScene>(module, "Scene",
                          R"(A mesh with what cameras know of it: objects, portals, mazes, walkable floor.

ocelli.scene.load() reads one; Scene(mesh, fit=False) makes one of a mesh of your own, fitted into the unit sphere where
fit is true.)")
      .def(py::init(&sceneOfMesh), py::arg("mesh"), py::kw_only(), py::arg("fit") = false)
      .def_property_readonly(
          "mesh", [](const GuidedScene& scene) -> const Mesh& { return scene.mesh; },
          py::return_value_policy::reference_internal, "Its `Mesh`, not a copy.")
      .def_property_readonly(
          "object_of_triangle",
          [](const py::object& self) { return viewOf(self.cast<const GuidedScene&>().objectOfTriangle, self); },
          "Which object each triangle belongs to, (m).")
      .def_property_readonly(
          "world_from_scene",
          [](const GuidedScene& scene) {
            py::array_t<float> matrix({4, 4});
            for (int row = 0; row < 4; ++row) {
              for (int column = 0; column < 4; ++column) {
                matrix.mutable_at(row, column) = scene.worldFromScene[column][row];
              }
            }
            return matrix;
          },
          "From the coordinates of the scene's file to those of the world, (4, 4), for columns.")
      .def("__repr__", [](const GuidedScene& scene) {
        return "<ocelli.Scene of " + std::to_string(scene.mesh.triangles.size()) + " triangles>";
      });

  module.def("load_scene", &load, py::arg("source"), py::arg("fit"), py::arg("shaded"), py::arg("textures"),
             py::arg("seconds"), py::arg("iso"), py::arg("labels"),
             py::arg("texture_triangles"), py::arg("progress"));
  module.def("builtin_scenes", [] {
    std::vector<std::pair<std::string, std::string>> rows;
    for (const BuiltinScene& scene : listBuiltinScenes()) {
      rows.emplace_back(scene.name, scene.summary);
    }
    return rows;
  });
}

}  // namespace ocelli
