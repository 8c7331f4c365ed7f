#include "oc_core/pack/cluster_cut.h"

#include "oc_core/base/parallel.h"
#include "oc_core/scene/share_vertices.h"

namespace ocelli {

std::vector<ClusterChoice> allClusters(const PackedScene& scene) {
  return chooseClusters(
      scene, [](const Sphere&) { return true; }, [](const Sphere&, float) { return false; });
}

std::vector<ClusterChoice> coarsestClusters(const PackedScene& scene, float maxError) {
  return chooseClusters(
      scene, [](const Sphere&) { return true; }, [&](const Sphere&, float error) { return error <= maxError; });
}

Mesh meshOf(const PackedScene& scene, const std::vector<ClusterChoice>& chosen) {
  struct Place {
    size_t vertex = 0;
    size_t triangle = 0;
  };
  std::vector<Place> places(chosen.size() + 1);
  for (size_t i = 0; i < chosen.size(); ++i) {
    const PackedClusterInfo cluster = scene.cluster(chosen[i].group, chosen[i].cluster);
    places[i + 1] = {places[i].vertex + cluster.vertices, places[i].triangle + cluster.triangles};
  }
  Mesh mesh;
  mesh.positions.resize(places.back().vertex);
  mesh.colors.resize(places.back().vertex);
  mesh.triangles.resize(places.back().triangle);
  parallelFor(chosen.size(), 64, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const size_t vertices = places[i + 1].vertex - places[i].vertex;
      scene.read(chosen[i].group, chosen[i].cluster, std::span(mesh.positions).subspan(places[i].vertex, vertices),
                 std::span(mesh.colors).subspan(places[i].vertex, vertices),
                 std::span(mesh.triangles).subspan(places[i].triangle, places[i + 1].triangle - places[i].triangle),
                 static_cast<uint32_t>(places[i].vertex));
    }
  });
  return mesh;
}

Mesh weldedMeshOf(const PackedScene& scene, const std::vector<ClusterChoice>& chosen) {
  Mesh mesh = meshOf(scene, chosen);
  shareVertices(mesh);
  return mesh;
}

}  // namespace ocelli
