// The renderer on the GPU against the one on the CPU, camera by camera.
#include "oc_core/gl/gl_renderer.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <functional>

#include "oc_core/gl/gl_api.h"
#include "oc_core/ocri/ddoc_builder.h"
#include "oc_core/ocri/eoc_builder.h"
#include "oc_core/ocri/spoc_builder.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/render/rasterize_gpc.h"
#include "oc_core/render/rasterize_spans.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/gl/gl_test_context.h"

namespace ocelli {
namespace {

constexpr int kWidth = 360;
constexpr int kHeight = 240;

PinholeCamera pinhole() {
  return {View{}, kWidth, kHeight};
}

/// How two images of one camera differ.
struct Difference {
  size_t samples = 0;         ///< that either holds
  size_t differing = 0;       ///< by more than 1e-3 of the depth range or 1/255 of colour, or held by one alone
  size_t onSurfaces = 0;      ///< of these, those that are not beside a silhouette of the first image
  size_t otherTriangles = 0;  ///< with another triangle, though they do not differ
};

std::ostream& operator<<(std::ostream& out, const Difference& d) {
  return out << d.differing << " of " << d.samples << " samples differ, " << d.onSurfaces << " of them on surfaces, "
             << d.otherTriangles << " show another triangle";
}

/// A pixel whose neighbours do not all continue its surface.
bool besideSilhouette(const FragmentImage& image, int x, int y, float step) {
  const Fragment& middle = image(x, y);
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (!image.contains(x + dx, y + dy) || image(x + dx, y + dy).covered() != middle.covered() ||
          std::abs(image(x + dx, y + dy).t - middle.t) > step) {
        return true;
      }
    }
  }
  return false;
}

Difference compare(const FragmentImage& expected, const FragmentImage& got, const Mesh& mesh) {
  EXPECT_EQ(expected.width(), got.width());
  EXPECT_EQ(expected.height(), got.height());
  float least = 1e30f;
  float most = 0;
  for (const Fragment& f : expected) {
    if (f.covered()) {
      least = std::min(least, f.t);
      most = std::max(most, f.t);
    }
  }
  const float range = std::max(most - least, 0.0f);
  Difference difference;
  for (int y = 0; y < expected.height(); ++y) {
    for (int x = 0; x < expected.width(); ++x) {
      const Fragment& a = expected(x, y);
      const Fragment& b = got(x, y);
      if (!a.covered() && !b.covered()) {
        continue;
      }
      ++difference.samples;
      bool differs = a.covered() != b.covered();
      if (!differs) {
        const glm::vec3 step = glm::abs(colorOf(a, mesh) - colorOf(b, mesh));
        differs = std::abs(a.t - b.t) > 1e-3f * range || std::max({step.x, step.y, step.z}) > 1.0f / 255;
        difference.otherTriangles += !differs && a.triangle != b.triangle;
      }
      if (differs) {
        ++difference.differing;
        difference.onSurfaces += !besideSilhouette(expected, x, y, 0.02f * range);
      }
    }
  }
  return difference;
}

/// Names a camera, and draws it on the CPU and on the GPU.
struct CameraCase {
  const char* name;
  std::function<FragmentImage(const Mesh&)> onCpu;
  std::function<FragmentImage(const Mesh&, const GlRenderer&)> onGpu;
};

EpipolarCamera epipolar(const Mesh& mesh, const glm::vec3& direction) {
  return buildEpipolarCamera(pinhole(), segmentAround(View{}, direction, 1.6f), mesh);
}

template <class Build>
CameraCase caseOf(const char* name, const Build& build) {
  return {name, [build](const Mesh& mesh) { return rasterize(build(mesh), mesh); },
          [build](const Mesh& mesh, const GlRenderer& renderer) {
            const GlScope scope(renderer.context());
            return renderer.drawOnGpu(build(mesh)).read();
          }};
}

CameraCase gpcCase(const char* name, const char* sampling) {
  const GpcCamera camera(pinhole(), {findGpcSampling(sampling),
                                     {{{0.35f, 0.5f}, {0.3f, 0.4f}, 3, 0.8f}, {{0.85f, 0.4f}, {0.1f, 0.3f}, 2, 1.2f}}});
  return {name, [camera](const Mesh& mesh) { return rasterizeGpc(camera, mesh); },
          [camera](const Mesh&, const GlRenderer& renderer) {
            const GlScope scope(renderer.context());
            return renderer.drawOnGpu(camera).read();
          }};
}

std::vector<CameraCase> cameraCases() {
  return {
      caseOf("pinhole", [](const Mesh&) { return pinhole(); }),
      caseOf("spoc", [](const Mesh& mesh) { return buildSpocCamera(pinhole(), mesh); }),
      caseOf("rppc", [](const Mesh& mesh) { return buildReversePinhole(pinhole(), mesh); }),
      caseOf("ddoc", [](const Mesh& mesh) { return buildDdocCamera(pinhole(), mesh); }),
      gpcCase("gpc-linear", "linear"),
      gpcCase("gpc-quadratic", "quadratic"),
      gpcCase("gpc-cubic", "cubic"),
      caseOf("eoc-h", [](const Mesh& mesh) { return epipolar(mesh, kHorizontalSegment); }),
      caseOf("eoc-v", [](const Mesh& mesh) { return epipolar(mesh, kVerticalSegment); }),
      caseOf("eoc-forward",
             [](const Mesh& mesh) {
               return epipolar(mesh, {0, 0, -1});
             }),
      caseOf("eoc-slanted",
             [](const Mesh& mesh) {
               return epipolar(mesh, {1, 0, 0.3f});
             }),
  };
}

class GlRendererTest : public testing::TestWithParam<GlProvider> {
 protected:
  std::unique_ptr<GlContext> context_ = openTestContext(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Providers, GlRendererTest, kOffscreenProviders, providerName);

void expectAgreement(GlContext& context, const std::string& scene) {
  const Mesh mesh = loadScene(scene, {}, {});
  const GlRenderer renderer(context, mesh);
  for (const CameraCase& each : cameraCases()) {
    const Difference d = compare(each.onCpu(mesh), each.onGpu(mesh, renderer), mesh);
    EXPECT_GT(d.samples, 1000u) << scene << ", " << each.name;
    EXPECT_LE(static_cast<double>(d.differing), 0.005 * static_cast<double>(d.samples))
        << scene << ", " << each.name << ": " << d;
    // A tenth of that may lie where surfaces only touch or fold, which looks like no silhouette.
    EXPECT_LE(static_cast<double>(d.onSurfaces), 0.0005 * static_cast<double>(d.samples))
        << scene << ", " << each.name << ": " << d;
    testing::Test::RecordProperty(each.name, testing::PrintToString(d));
  }
}

TEST_P(GlRendererTest, agreesOnStatues) {
  expectAgreement(*context_, "builtin:statues");
}
TEST_P(GlRendererTest, agreesOnTeapotInRoom) {
  expectAgreement(*context_, "builtin:room");
}
TEST_P(GlRendererTest, agreesOnFence) {
  expectAgreement(*context_, "builtin:fence,gap=4");
}
TEST_P(GlRendererTest, agreesOnDoors) {
  expectAgreement(*context_, "builtin:doors");
}
TEST_P(GlRendererTest, agreesOnBoxes) {
  expectAgreement(*context_, "builtin:boxes");
}
TEST_P(GlRendererTest, agreesOnScan) {
  const char* folder = std::getenv("OCELLI_DATA_DIR");
  if (folder == nullptr) {
    GTEST_SKIP() << "set OCELLI_DATA_DIR to a folder with bunny.obj";
  }
  expectAgreement(*context_, "builtin:room,mesh=" + (std::filesystem::path(folder) / "bunny.obj").string());
}

// The text's map is discontinuous: it tears the image, and folds it, so that two places of a wall that faces the view
// come to one pixel at one depth. Which of these is kept is up to rounding. All else agrees.
TEST_P(GlRendererTest, agreesOnTheTextsMapButForTies) {
  for (const char* scene : {"builtin:fence,gap=4", "builtin:boxes"}) {
    const Mesh mesh = loadScene(scene, {}, {});
    const DdocCamera camera = buildDdocCamera(pinhole(), mesh, DdocOptions::paper());
    const FragmentImage onCpu = rasterize(camera, mesh);
    FragmentImage onGpu = GlRenderer(*context_, mesh).draw(camera, rasterize(pinhole(), mesh), {});
    size_t ties = 0;
    for (size_t i = 0; i < onGpu.size(); ++i) {
      const float z = onCpu[i].t;
      const bool tie = onGpu[i].covered() && onCpu[i].covered() && std::abs(onGpu[i].t - z) < 2e-6f * z;
      ties += tie && onGpu[i] != onCpu[i];
      onGpu[i] = tie ? onCpu[i] : onGpu[i];
    }
    const Difference d = compare(onCpu, onGpu, mesh);
    EXPECT_LE(d.differing, d.samples / 200) << scene << ": " << d << ", " << ties << " ties";
  }
}

TEST(GlRendererTest, providersDrawTheSameBytes) {
  const Mesh mesh = loadScene("builtin:statues", {}, {});
  const auto egl = openTestContext(GlProvider::kEgl);
  const auto osMesa = openTestContext(GlProvider::kOsMesa);
  if (!egl->info().isSoftware) {
    GTEST_SKIP() << "EGL draws on a GPU, " << egl->info().renderer << ": it rounds in its own way";
  }
  const GlRenderer one(*egl, mesh);
  const GlRenderer other(*osMesa, mesh);
  for (const CameraCase& each : cameraCases()) {
    EXPECT_EQ(each.onGpu(mesh, one), each.onGpu(mesh, other)) << each.name;
  }
}

TEST_P(GlRendererTest, drawsTheSameBytesAgain) {
  const Mesh mesh = loadScene("builtin:boxes", {}, {});
  const GlRenderer renderer(*context_, mesh);
  for (const CameraCase& each : cameraCases()) {
    EXPECT_EQ(each.onGpu(mesh, renderer), each.onGpu(mesh, renderer)) << each.name;
  }
}

// The unit square at z = 5 in front of an eye at the origin: known pixels, depths and weights.
TEST_P(GlRendererTest, square) {
  const Mesh square{{{-1, -1, -5}, {1, -1, -5}, {1, 1, -5}, {-1, 1, -5}},
                    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}},
                    {{0, 1, 2}, {0, 2, 3}}};
  View view;
  view.eye = {0, 0, 0};
  view.target = {0, 0, -1};
  view.fovVerticalDegrees = 90;
  const PinholeCamera camera(view, 100, 100);  // focal length 50: the square covers 20x20 pixels
  const GlRenderer renderer(*context_, square);
  const FragmentImage image = renderer.draw(camera);
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 100; ++x) {
      const bool inside = x >= 40 && x < 60 && y >= 40 && y < 60;
      ASSERT_EQ(image(x, y).covered(), inside) << x << ", " << y;
      if (inside) {
        EXPECT_NEAR(image(x, y).t, 5, 1e-5);
        const glm::vec3 expected((static_cast<float>(x) + 0.5f - 50) / 10, (50 - static_cast<float>(y) - 0.5f) / 10,
                                 -5);
        EXPECT_LT(glm::distance(positionOf(image(x, y), square), expected), 1e-4f);
      }
    }
  }
  // Colours are resolved on the GPU.
  const GlScope scope(*context_);
  const GlFragments fragments = renderer.drawOnGpu(camera);
  const glm::vec3 background(0.25f, 0.5f, 0.75f);
  const GlObject texture = renderer.colors(fragments, background);
  const auto colors = readTexture<glm::vec4>(*context_, texture, 100, 100, GL_RGBA, GL_FLOAT);
  for (size_t i = 0; i < colors.size(); ++i) {
    const bool covered = image[i].covered();
    EXPECT_EQ(colors[i].w, covered ? 1.0f : 0.0f);
    EXPECT_LT(glm::distance(glm::vec3(colors[i]), covered ? colorOf(image[i], square) : background), 1e-6f);
  }
}

// A floor that runs from behind the eye to the horizon is clipped, not dropped; what is nearer than zNear is not seen.
TEST_P(GlRendererTest, floorThatRunsUnderTheEye) {
  const Mesh floor{{{-1000, -1, 1000}, {1000, -1, 1000}, {0, -1, -3000}}, {}, {{0, 1, 2}}};
  View view;
  view.eye = {0, 0, 0};
  view.target = {0, -0.5f, -1};
  view.fovVerticalDegrees = 60;
  view.zNear = 1.5f;
  const PinholeCamera camera(view, 120, 80);
  const GlRenderer renderer(*context_, floor);
  // At the horizon the CPU's grid of 1/256 pixel is 1 % of the depth: what counts is that each fragment lies on
  // the ray of its pixel. Weights are floats, so that a fragment lies beside its place by some 2^-24 of the distance to
  // the corners, 3000 away; four roundings make it 2^-22.
  constexpr float kBeside = 3000.0f / 4194304.0f;
  const FragmentImage expected = rasterize(camera, floor);
  const FragmentImage image = renderer.draw(camera);
  size_t covered = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const Fragment& fragment = image(x, y);
      ASSERT_EQ(fragment.covered(), expected(x, y).covered()) << x << ", " << y;
      if (fragment.covered()) {
        ++covered;
        const std::optional<ImagePoint> q = camera.project(positionOf(fragment, floor));
        ASSERT_TRUE(q) << x << ", " << y;
        const float pixels = 1e-2f + camera.focalPixels() * kBeside / q->t;
        EXPECT_NEAR(q->u, static_cast<float>(x) + 0.5f, pixels);
        EXPECT_NEAR(q->v, static_cast<float>(y) + 0.5f, pixels);
        EXPECT_NEAR(fragment.t, q->t, kBeside + 1e-4f * q->t);
      }
    }
  }
  EXPECT_GT(covered, 2000u);
  const SpocCamera spoc(camera, {{60, 40}, 1.6f, 30, 0, 9});
  const Difference displaced = compare(rasterize(spoc, floor), renderer.draw(spoc), floor);
  EXPECT_GT(displaced.samples, 2000u);
  EXPECT_LE(displaced.differing, displaced.samples / 200) << displaced;
}

TEST_P(GlRendererTest, firstOfCoincidentTrianglesIsSeen) {
  Mesh mesh{{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, {}, {{0, 1, 2}, {0, 1, 2}, {0, 1, 2}}};
  const GlRenderer renderer(*context_, mesh);
  const SpocCamera spoc(pinhole(), {{100, 100}, 5, 9, 0, 9});
  const auto drawSpoc = [&] { return renderer.draw(spoc); };
  for (const FragmentImage& image : {renderer.draw(pinhole()), drawSpoc()}) {
    size_t covered = 0;
    for (const Fragment& f : image) {
      covered += f.covered();
      EXPECT_TRUE(!f.covered() || f.triangle == 0);
    }
    EXPECT_GT(covered, 1000u);
  }
}

TEST_P(GlRendererTest, nothingToSee) {
  const Mesh hidden{{{0, 0, 50}, {1, 0, 50}, {0, 1, 50}}, {}, {{0, 1, 2}}};  // behind the eye
  const Mesh none;
  const Mesh broken{
      {{0, 0, 0}, {1, 0, 0}, {0, std::numeric_limits<float>::quiet_NaN(), 0}}, {}, {{0, 1, 2}, {0, 0, 0}}};
  const glm::vec3 right = View{}.eye + glm::vec3(1.6f, 0, 0);
  const std::vector<std::vector<EpipolarEdge>> noEdges(kHeight);
  for (const Mesh* mesh : {&hidden, &none, &broken}) {
    const GlRenderer renderer(*context_, *mesh);
    const FragmentImage seen = renderer.draw(pinhole());
    const FragmentImage displaced = renderer.draw(SpocCamera(pinhole(), {{100, 100}, 5, 9, 0, 9}));
    const EpipolarCamera eoc(pinhole(), right, noEdges);
    for (const FragmentImage& image : {seen, displaced, renderer.draw(eoc, seen)}) {
      EXPECT_EQ(std::count_if(image.begin(), image.end(), [](const Fragment& f) { return f.covered(); }), 0);
    }
  }
}

// Lists of pieces hold a million: a triangle that fills a large image goes through them several times.
TEST_P(GlRendererTest, morePiecesThanAListHolds) {
  const Mesh mesh{{{-5, -5, 1}, {5, -5, -1}, {0, 8, 0}}, {}, {{0, 1, 2}}};
  const PinholeCamera large(View{}, 900, 600);
  const SpocCamera camera(large, {{450, 300}, 5, 9.5f, 0, 24});
  const GlRenderer renderer(*context_, mesh);
  const Difference d = compare(rasterize(camera, mesh), renderer.draw(camera), mesh);
  EXPECT_GT(d.samples, 500000u);
  EXPECT_LE(d.differing, d.samples / 1000) << d;
}

// Drivers may end a shader whose loops are long: rows of many pixels are drawn in parts.
TEST_P(GlRendererTest, longEpipolarLines) {
  // A wall of two triangles, and a bar before it.
  const Mesh mesh{
      {{-9, -9, -1}, {9, -9, -1}, {9, 9, -1}, {-9, 9, -1}, {-0.2f, -9, 1}, {0, -9, 1}, {0, 9, 1}, {-0.2f, 9, 1}},
      {},
      {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}}};
  View view;
  view.fovVerticalDegrees = 0.015;  // 12 degrees wide
  const PinholeCamera wide(view, 10000, 12);
  const GlRenderer renderer(*context_, mesh);
  for (const glm::vec3& direction : {glm::vec3(1, 0, 0), glm::vec3(1, 0, 0.1f)}) {
    const EpipolarCamera camera = buildEpipolarCamera(wide, segmentAround(view, direction, 0.02f), mesh);
    const GlScope scope(*context_);
    const Difference d = compare(rasterize(camera, mesh), renderer.drawOnGpu(camera).read(), mesh);
    EXPECT_GT(d.samples, 110000u);
    EXPECT_LE(d.differing, d.samples / 1000) << d;
  }
}

int checksUntilFailure = 0;

GLenum failingGetError() {
  return --checksUntilFailure == 0 ? GL_OUT_OF_MEMORY : GL_NO_ERROR;
}

// Wherever drawing breaks off, the next drawing starts anew.
TEST_P(GlRendererTest, drawsAfterAFailure) {
  const Mesh mesh = loadScene("builtin:boxes", {}, {});
  const SpocCamera camera(pinhole(), {{100, 100}, 5, 9.5f, 0, 9});
  const FragmentImage expected = GlRenderer(*context_, mesh).draw(camera);
  const auto getError = context_->functions().GetError;
  int failures = 0;
  for (int checks = 1; checks <= 16; ++checks) {
    const GlRenderer renderer(*context_, mesh);
    checksUntilFailure = checks;
    context_->functions().GetError = failingGetError;
    try {
      renderer.draw(camera);
    } catch (const GlError&) {
      ++failures;
    }
    context_->functions().GetError = getError;
    EXPECT_EQ(renderer.draw(camera), expected) << checks;
  }
  EXPECT_GE(failures, 12) << "what failed must have said so";
}

TEST_P(GlRendererTest, leavesNoObjects) {
  const Mesh mesh = loadScene("builtin:boxes", {}, {});
  {
    const GlRenderer renderer(*context_, mesh);
    const std::vector<CameraCase> cases = cameraCases();
    for (const CameraCase& each : cases) {
      each.onGpu(mesh, renderer);
    }
    const int once = context_->liveObjects();
    for (const CameraCase& each : cases) {
      each.onGpu(mesh, renderer);
    }
    EXPECT_EQ(context_->liveObjects(), once) << "drawing again keeps nothing more";
  }
  EXPECT_EQ(context_->liveObjects(), 0);
}

}  // namespace
}  // namespace ocelli
