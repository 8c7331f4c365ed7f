#include "oc_core/isosurface/isosurface.h"

#include <fmt/format.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "oc_core/isosurface/surface_fit.h"
#include "oc_core/isosurface/surface_quads.h"
#include "oc_core/scene/shading.h"
#include "oc_core/volume/volume_gradient.h"

namespace ocelli {
namespace {

/// Two triangles for each quadrilateral, along the shorter of its diagonals. `isMirrored`: turned round.
std::vector<glm::uvec3> trianglesOf(const SurfaceQuads& surface, const std::vector<glm::vec3>& positions,
                                    bool isMirrored) {
  std::vector<glm::uvec3> triangles(2 * surface.quads.size());
  parallelFor(surface.quads.size(), 1 << 12, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      std::array<uint32_t, 4> q = surface.quads[i];
      if (isMirrored) {
        std::swap(q[1], q[3]);
      }
      const auto length = [&](size_t a, size_t b) { return glm::distance(positions[q[a]], positions[q[b]]); };
      const bool isFirstShorter = length(0, 2) <= length(1, 3);
      triangles[2 * i] = isFirstShorter ? glm::uvec3(q[0], q[1], q[2]) : glm::uvec3(q[0], q[1], q[3]);
      triangles[2 * i + 1] = isFirstShorter ? glm::uvec3(q[0], q[2], q[3]) : glm::uvec3(q[1], q[2], q[3]);
    }
  });
  return triangles;
}

/// Of each vertex the sum of its triangles' normals, weighted by their areas.
std::vector<glm::vec3> normalSums(const Mesh& mesh) {
  std::vector<glm::vec3> sums(mesh.positions.size(), glm::vec3(0));
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::vec3 normal = areaNormal(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]);
    sums[t.x] += normal;
    sums[t.y] += normal;
    sums[t.z] += normal;
  }
  return sums;
}

/// Multiplies the colours with the shade of the normals: against the gradient between the outermost voxel centres;
/// those of the triangles beyond them, where the box closes the surface, and where there is no gradient.
void shade(Mesh& mesh, const std::vector<glm::vec3>& points, const VolumeScene& scene) {
  const std::vector<glm::vec3> ofTriangles = normalSums(mesh);
  // From the world of the grid, by way of index coordinates.
  const glm::dmat3 sceneFromGrid =
      worldGradientFromIndex(scene.worldFromIndex) * glm::transpose(glm::dmat3(scene.volume->grid().worldFromIndex));
  parallelFor(points.size(), 1 << 10, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      glm::dvec3 outward(0);
      if (isBetweenCenters(scene.volume->grid(), points[i])) {
        outward = -(sceneFromGrid * gradientAt(*scene.volume, points[i]));
      }
      const double length = glm::length(outward);
      mesh.colors[i] *= length > 0 ? lambertShade(glm::vec3(outward / length)) : shadeOfSum(ofTriangles[i]);
    }
  });
}

void requireSurface(const SurfaceQuads& surface, const IsosurfaceOptions& options, const std::string& where) {
  if (surface.crossings > options.maxTriangles / 2) {
    throw InputError(fmt::format("this surface has more than the {} triangles that fit into memory as one mesh",
                                 options.maxTriangles),
                     where, "give a smaller volume, or another value of --iso");
  }
  const ValueRange& range = surface.range;
  if (surface.brokenVoxels > 0) {
    throw InputError(fmt::format("{} voxels of this volume are no numbers", surface.brokenVoxels), where,
                     "give them values in the program that wrote the file");
  }
  if (range.least == range.greatest) {
    throw InputError(fmt::format("this volume has no surface: all of its voxels have the value {:g}", range.least),
                     where, "give a volume whose values differ");
  }
  if (!(options.value >= range.least && options.value < range.greatest)) {
    throw InputError(fmt::format("no surface of this volume has the value {:g}: its values run from {:g} to {:g}",
                                 options.value, range.least, range.greatest),
                     where, fmt::format("give --iso a value between {:g} and {:g}", range.least, range.greatest));
  }
}

}  // namespace

Mesh isosurface(const VolumeScene& scene, const IsosurfaceOptions& options, const std::string& where,
                const Progress& progress) {
  SurfaceQuads surface = surfaceQuads(*scene.volume, options.value, options.maxTriangles / 2, progress);
  requireSurface(surface, options, where);
  report(progress, "fitting the surface", 0);
  fitToField(surface.points, *scene.volume, options.value);
  Mesh mesh;
  mesh.positions.resize(surface.points.size());
  parallelFor(surface.points.size(), 1 << 12, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      mesh.positions[i] = glm::vec3(scene.worldFromIndex * glm::dvec4(glm::dvec3(surface.points[i]), 1));
    }
  });
  mesh.triangles = trianglesOf(surface, mesh.positions, glm::determinant(glm::dmat3(scene.worldFromIndex)) < 0);
  surface.quads = {};
  mesh.colors.assign(mesh.positions.size(), glm::vec3(scene.appearance.transfer.at(options.value).color));
  if (options.isShaded) {
    report(progress, "shading the surface", 0);
    shade(mesh, surface.points, scene);
  }
  if (const VoxelStore* store = scene.volume->store()) {
    store->release(0, store->bytes().size());
  }
  report(progress, "shading the surface", 1);
  return mesh;
}

}  // namespace ocelli
