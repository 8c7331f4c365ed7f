#include "tests/display_sim_slicing/triangle_samples.h"

#include "display_sim/slicing/slice_mesh.h"
#include "display_sim/slicing/slicer_kernels.h"
#include "display_sim/slicing/triangle_strips.h"
#include "display_sim/slicing/wide_triangles.h"

namespace ocelli::test {

std::vector<TriangleSamples> samplesOf(const Mesh& mesh, const DisplayProfile& profile) {
  static const TriangleStrips strips;
  const SliceMesh prepared(mesh);
  const SliceKernelSetup setup(profile, {});
  LitSamples lit(SliceMesh::kChunkVertices);
  std::vector<SweepPoint> points(SliceMesh::kChunkVertices + SliceMesh::kPadding);
  WideTriangles wide(SliceMesh::kChunkTriangles);
  const SliceSamples vertices{prepared.x(), prepared.y(), prepared.z(), nullptr, nullptr, nullptr, 0};
  std::vector<TriangleSamples> samples(mesh.triangles.size());
  for (size_t t = 0; t < samples.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      samples[t].points.push_back(mesh.positions[mesh.triangles[t][k]]);
    }
  }
  for (const SliceChunk& chunk : prepared.chunks()) {
    const SliceSamples own{vertices.x + chunk.firstVertex,
                           vertices.y + chunk.firstVertex,
                           vertices.z + chunk.firstVertex,
                           nullptr,
                           nullptr,
                           nullptr,
                           chunk.vertices};
    lightSamples(setup, own, points.data(), lit);
    const uint16_t* corners = prepared.corners() + 3 * size_t{chunk.firstTriangle};
    findWideTriangles(setup, points.data(), corners, chunk.triangles, wide);
    for (size_t i = 0; i < wide.count; ++i) {
      TriangleSamples& triangle = samples[chunk.firstTriangle + wide.number[i]];
      if (wide.pattern[i] == WideTriangles::kFoundExactly) {
        triangle = {true, {}};
      } else if (wide.pattern[i] != WideTriangles::kCornersSuffice) {
        const uint16_t* corner = corners + 3 * size_t{wide.number[i]};
        const uint32_t at[3] = {chunk.firstVertex + corner[0], chunk.firstVertex + corner[1],
                                chunk.firstVertex + corner[2]};
        const SampledTriangle sampled = strips.sampled(at, wide.pattern[i], wide.order[i]);
        SampleRoom room(sampled.samples);
        sampleTriangles(vertices, strips, &sampled, 1, room);
        for (size_t s = 0; s < room.count; ++s) {
          triangle.points.emplace_back(room.x[s], room.y[s], room.z[s]);
        }
      }
    }
  }
  return samples;
}

}  // namespace ocelli::test
