// The GPU slicer against sliceExactly() and against the definition of a lit voxel.
#include "display_sim/gl/gl_slicer.h"

#include <gtest/gtest.h>

#include "tests/display_sim_slicing/flood_fill.h"
#include "tests/display_sim_slicing/slicer_reference.h"
#include "tests/display_sim_slicing/test_meshes.h"
#include "tests/display_sim_slicing/test_profiles.h"
#include "tests/display_sim_slicing/volume_checks.h"
#include "tests/gl/gl_test_context.h"

namespace ocelli {
namespace {

using test::addTriangle;
using test::contains;
using test::PointSource;
using test::smallProfile;

class GlSlicerTest : public testing::TestWithParam<GlProvider> {
 protected:
  Volume sliced(GlSlicer& slicer, const Mesh& mesh, const DisplayProfile& profile, const SliceOptions& options = {}) {
    const GlScope scope(*context_);
    const GlMesh onGpu(*context_, mesh);
    GlVolume volume(*context_, profile);
    slicer.slice(onGpu, volume, options);
    return volume.read();
  }

  const std::unique_ptr<GlContext> context_ = openTestContext(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Providers, GlSlicerTest, kOffscreenProviders, providerName);

/// A mesh whose coordinates reach so far, in display radii.
struct NamedMesh {
  const char* name;
  Mesh mesh;
  double reach = 1;
};

Mesh soup(float size) {
  PointSource source(11);
  Mesh mesh;
  for (int i = 0; i < 150; ++i) {
    const glm::vec3 center = source.point(0.9f);
    addTriangle(mesh, center + source.point(size), center + source.point(size), center + source.point(size));
  }
  return mesh;
}

Mesh slivers() {
  PointSource source(12);
  Mesh mesh;
  for (int i = 0; i < 150; ++i) {
    const glm::vec3 a = source.point(0.9f);
    const glm::vec3 b = source.point(0.9f);
    addTriangle(mesh, a, b, a + (b - a) * source.uniform(0, 1) + source.point(1e-5f));
  }
  return mesh;
}

Mesh aroundTheAxis() {
  PointSource source(13);
  Mesh mesh;
  for (int i = 0; i < 100; ++i) {
    const glm::vec3 onAxis(0, source.uniform(-0.9f, 0.9f), 0);
    const float size = i % 2 == 0 ? 0.3f : 0.003f;
    addTriangle(mesh, onAxis + source.point(size), onAxis + source.point(size), onAxis + source.point(size));
    addTriangle(mesh, onAxis, onAxis + source.point(size), onAxis + source.point(size));
  }
  return mesh;
}

/// Points and lines.
Mesh degenerate() {
  PointSource source(14);
  Mesh mesh;
  for (int i = 0; i < 100; ++i) {
    const glm::vec3 a = source.point(0.9f);
    const glm::vec3 b = source.point(0.9f);
    addTriangle(mesh, a, a, a);
    addTriangle(mesh, a, b, a);
    addTriangle(mesh, a, b, a + (b - a) * 0.5f);
  }
  return mesh;
}

/// Walls over all slices or along one, and far beyond the display.
Mesh walls() {
  Mesh mesh;
  addTriangle(mesh, {-9, 0.31f, -9}, {9, 0.32f, -9}, {0, 0.33f, 9});
  addTriangle(mesh, {0.01f, -9, -9}, {0.02f, 9, -9}, {0.03f, 0, 9});
  addTriangle(mesh, {0, -9, 0.3f}, {0, 9, 0.3f}, {7, 0, 2});
  addTriangle(mesh, {0, -0.5f, 0}, {0, 0.5f, 0}, {1, 0, 0});
  return mesh;
}

std::vector<NamedMesh> meshes() {
  return {{"small soup", soup(0.02f)},
          {"soup", soup(0.2f), 1.2},
          {"large soup", soup(1.5f), 2.5},
          {"slivers", slivers()},
          {"around the axis", aroundTheAxis()},
          {"degenerate", degenerate()},
          {"walls", walls(), 9},
          {"torus through the axis", test::torus(0.4, 0.2, 90, 40, {0.37, 0.01, 0.1})},
          {"box on cell borders", test::box({-0.5f, -0.75f, -0.25f}, {0.5f, 0.75f, 0.5f})}};
}

std::vector<DisplayProfile> profiles() {
  DisplayProfile low = smallProfile(9, 24, 10);
  low.halfHeightRadii = 0.5;
  return {smallProfile(24, 32, 32),
          smallProfile(7, 13, 11),
          low,
          smallProfile(2, 12, 12),
          smallProfile(5, 16, 14, SecondHalfTurn::kOwn),
          smallProfile(5, 13, 14, SecondHalfTurn::kOwn)};
}

TEST_P(GlSlicerTest, lightsWhatTheCpuDoes) {
  GlSlicer slicer(*context_);
  for (const DisplayProfile& profile : profiles()) {
    for (const NamedMesh& named : meshes()) {
      SCOPED_TRACE(named.name + std::string(" ") + jsonText(profile));
      const Volume onGpu = sliced(slicer, named.mesh, profile);
      EXPECT_GT(onGpu.litVoxels(), 0u);
      if (context_->info().isSoftware) {  // whose rounding is the CPU's
        EXPECT_EQ(onGpu, sliceExactly(named.mesh, profile));
      }
      const double rounding = kSliceRounding * named.reach;
      EXPECT_TRUE(contains(onGpu, sliceReference(named.mesh, profile, {.margin = -rounding}))) << "a cell is missing";
      EXPECT_TRUE(contains(sliceReference(named.mesh, profile, {.margin = rounding}), onGpu)) << "lit in vain";
    }
  }
}

TEST_P(GlSlicerTest, singlePrecisionMovesCellsByItsRoundingAlone) {
  GlSlicer slicer(*context_, GlPrecision::kSingle);
  for (const DisplayProfile& profile : profiles()) {
    for (const NamedMesh& named : meshes()) {
      SCOPED_TRACE(named.name + std::string(" ") + jsonText(profile));
      const Volume onGpu = sliced(slicer, named.mesh, profile);
      const double rounding = singleSliceRounding(profile) * named.reach;
      EXPECT_TRUE(contains(onGpu, sliceReference(named.mesh, profile, {.margin = -rounding}))) << "a cell is missing";
      EXPECT_TRUE(contains(sliceReference(named.mesh, profile, {.margin = rounding}), onGpu)) << "lit in vain";
    }
  }
}

/// Boxes whose sides lie along a border of two sectors, where single precision could see them in neither.
Mesh boxesOnSectorBorders(int slices) {
  Mesh mesh;
  for (int i = 0; i < 2 * slices; i += 3) {
    const double angle = (i + 0.5) * kPi / slices;
    const glm::vec3 along(static_cast<float>(std::cos(angle)), 0, static_cast<float>(std::sin(angle)));
    const glm::vec3 across(-along.z, 0, along.x);
    Mesh box = test::box({0.4f, -0.5f, 0}, {0.9f, 0.5f, 0.09f});
    for (glm::vec3& p : box.positions) {
      p = along * p.x + across * p.z + glm::vec3(0, p.y, 0);
    }
    append(mesh, box);
  }
  return mesh;
}

// What is inside on the CPU, where nothing leaks, must be inside on the GPU.
TEST_P(GlSlicerTest, closedSurfacesHoldInSinglePrecision) {
  const DisplayProfile profile = smallProfile(48, 80, 80);
  GlSlicer slicer(*context_, GlPrecision::kSingle);
  for (const Mesh& mesh :
       {test::sphere(0.9, 40), test::sphere(0.4, 30, {-0.4, 0, 0}), test::torus(0.4, 0.2, 90, 40, {0.37, 0.01, 0.1}),
        boxesOnSectorBorders(48), test::box({-0.5f, -0.75f, -0.25f}, {0.5f, 0.75f, 0.5f}),
        test::box({0, -0.5f, 0}, {0.6f, 0.5f, 0.6f})}) {
    const Volume volume = sliced(slicer, mesh, profile);
    const Volume CPUs = sliceExactly(mesh, profile);
    const test::FloodFill flood(volume);
    const test::FloodFill processorsFlood(CPUs);
    size_t inside = 0;
    for (int i = 0; i < profile.slicesPerHalfTurn; ++i) {
      for (int row = 0; row < profile.height; ++row) {
        for (int column = 0; column < profile.width; ++column) {
          const bool dark = volume.colorBits(i, column, row) == 0 && CPUs.colorBits(i, column, row) == 0;
          if (dark && !processorsFlood.reached({i, column, row})) {
            ++inside;
            EXPECT_FALSE(flood.reached({i, column, row})) << i << " " << column << " " << row;
          }
        }
      }
    }
    EXPECT_GT(inside, 500u);
  }
}

TEST_P(GlSlicerTest, reducesColorsAsTheCpuDoes) {
  GlSlicer slicer(*context_);
  Mesh mesh = test::torus(0.6, 0.3, 40, 30);
  for (const glm::vec3& p : mesh.positions) {
    mesh.colors.push_back(glm::abs(p));
  }
  append(mesh, test::box({-0.3f, -0.9f, -0.2f}, {0.2f, 0.9f, 0.3f}));  // white
  mesh.colors.back() = {0, 0, 0};
  for (const SecondHalfTurn half : {SecondHalfTurn::kMirrored, SecondHalfTurn::kOwn}) {
    for (const ColorReduction colors : {ColorReduction::kDither, ColorReduction::kOccupancy}) {
      const DisplayProfile profile = smallProfile(30, 49, 40, half);
      const Volume onGpu = sliced(slicer, mesh, profile, {colors});
      const Volume CPUs = sliceExactly(mesh, profile, {colors});
      // A colour that another GPU rounds otherwise can be that of a threshold, of which there are 2^23.
      EXPECT_LE(test::differingVoxels(onGpu, CPUs), context_->info().isSoftware ? 0 : onGpu.litVoxels() / 1000);
    }
  }
}

TEST_P(GlSlicerTest, replacesWhatTheVolumeHeld) {
  const GlScope scope(*context_);
  GlSlicer slicer(*context_);
  GlVolume volume(*context_, smallProfile(24, 32, 32));
  slicer.slice(GlMesh(*context_, walls()), volume);
  slicer.slice(GlMesh(*context_, test::sphere(0.5, 8)), volume);
  EXPECT_EQ(volume.read().litVoxels(), sliceExactly(test::sphere(0.5, 8), volume.profile()).litVoxels());
  slicer.slice(GlMesh(*context_, Mesh{}), volume);
  EXPECT_EQ(volume.read().litVoxels(), 0u);
}

// More than 65535 groups of 64.
TEST_P(GlSlicerTest, takesMillionsOfTriangles) {
  Mesh mesh;
  addTriangle(mesh, {5, 5, 5}, {5, 5, 6}, {5, 6, 5});
  mesh.triangles.resize((size_t{1} << 22) + 1000, mesh.triangles.front());
  addTriangle(mesh, {0.2f, 0.3f, 0.1f}, {0.3f, 0.3f, 0.1f}, {0.2f, 0.4f, 0.1f});
  GlSlicer slicer(*context_);
  const DisplayProfile profile = smallProfile(24, 32, 32);
  EXPECT_EQ(sliced(slicer, mesh, profile).litVoxels(), sliceExactly(mesh, profile).litVoxels());
}

// So many parts of large triangles that the queue grows, and far more work than the 65535 turns of loops after which
// software renderers end a shader.
TEST_P(GlSlicerTest, takesManyLargeTriangles) {
  PointSource source(21);
  Mesh mesh;
  for (int i = 0; i < 250; ++i) {
    const glm::vec3 inside = source.point(0.5f);
    const glm::vec3 u = source.point(5);
    const glm::vec3 v = source.point(5);
    addTriangle(mesh, inside - u - v, inside + u, inside + v);
  }
  for (glm::vec3& p : mesh.positions) {
    mesh.colors.push_back(glm::abs(p) * 0.003f);  // or all voxels would be lit
  }
  const DisplayProfile profile = smallProfile(180, 1100, 400);
  GlSlicer slicer(*context_);
  const Volume onGpu = sliced(slicer, mesh, profile);
  const Volume CPUs = sliceExactly(mesh, profile);
  EXPECT_LT(CPUs.litVoxels(), size_t{180} * 1100 * 400 / 2);
  EXPECT_LE(test::differingVoxels(onGpu, CPUs), context_->info().isSoftware ? 0 : CPUs.litVoxels() / 1000);
}

TEST_P(GlSlicerTest, leavesNothingBehind) {
  {
    GlSlicer slicer(*context_);
    sliced(slicer, walls(), smallProfile(24, 32, 32));
    EXPECT_GT(context_->liveObjects(), 0);
  }
  EXPECT_EQ(context_->liveObjects(), 0);
}

// Two contexts of one machine's software renderer.
TEST(GlSlicerTest, providersAgree) {
  Mesh mesh = test::torus(0.6, 0.3, 90, 40);
  for (const glm::vec3& p : mesh.positions) {
    mesh.colors.push_back(glm::abs(p));
  }
  std::vector<Volume> volumes;
  for (const GlProvider provider : {GlProvider::kEgl, GlProvider::kOsMesa}) {
    const auto context = openTestContext(provider);
    if (!context->info().isSoftware) {
      GTEST_SKIP() << "another renderer than OSMesa's";
    }
    const GlScope scope(*context);
    GlSlicer slicer(*context, GlPrecision::kSingle);
    GlVolume volume(*context, smallProfile(48, 80, 80));
    slicer.slice(GlMesh(*context, mesh), volume);
    volumes.push_back(volume.read());
  }
  EXPECT_EQ(volumes[0], volumes[1]);
}

}  // namespace
}  // namespace ocelli
