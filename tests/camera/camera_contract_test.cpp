// The contract of camera.h, checked for every camera: each is one entry of `AllCameras` at the end of the fixture.
#include <gtest/gtest.h>

#include <limits>

#include "oc_core/camera/cylinder_camera.h"
#include "oc_core/camera/ddoc_camera.h"
#include "oc_core/camera/epipolar_camera.h"
#include "oc_core/camera/gpc_camera.h"
#include "oc_core/camera/panorama_camera.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/camera/reverse_pinhole_camera.h"
#include "oc_core/camera/spoc_camera.h"
#include "oc_core/ocri/ddoc_builder.h"
#include "oc_core/ocri/eoc_builder.h"
#include "oc_core/render/rasterize_spans.h"
#include "tests/camera/test_cell_cameras.h"
#include "tests/camera/test_curved_cameras.h"
#include "tests/camera/test_graph_cameras.h"
#include "tests/camera/test_ray_maps.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::kHeight;
using test::kWidth;
using test::smallCamera;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// For each camera: make() gives one with distortion, undistorted() one without (at the depths that it says), both of
// the small camera's view and, but for what the traits say, its size.
struct Traits {
  /// Heights above the origin, along the reference view direction, at which undistorted() is the pinhole.
  static constexpr std::array kUndistortedHeights{-2.0f, 0.0f, 0.9f, 5.0f};
  static constexpr double kUnsolvable = 0;        ///< share of image points that may lack a world point, or a ray
  static constexpr double kShort = 0;             ///< share of rays that may end before zFar besides those
  static constexpr double kAside = 0;             ///< share of the segments of rays that may lie off their pixel
  static constexpr double kErrorGrowth = 1;       ///< of an error of the pinhole's image point, at most
  static constexpr bool kRaysRunFromNear = true;  ///< all of them begin at zNear, and only some end before zFar
  static constexpr bool kZRunsAlongTheView = true;
  /// Of the t that a segment advances by: how far t may be off between its ends, where the segment stands for an arc.
  static constexpr float kArcError = 0;
  static glm::ivec2 size() { return {kWidth, kHeight}; }
  template <class Camera>
  static const View& viewOf(const Camera& camera) {
    return referenceOf(camera).view();
  }
  /// z of a point that may lie a hair beyond the end of its ray.
  template <class Camera>
  static float depthAtEnd(const Camera& camera, const glm::vec3& point) {
    return referenceOf(camera).cameraFromWorld(point).z;
  }
  /// How much an image point of the pinhole that is off by rounding makes that of the camera be off there.
  static float blowUp(const ImagePoint&) { return 1; }
  /// z of a point on the ray of a pixel, which is measured along the reference view direction.
  template <class Camera>
  static float depthOf(const Camera& camera, const glm::vec3& point, const glm::vec2&) {
    return referenceOf(camera).cameraFromWorld(point).z;
  }
  static bool sameRay(const RayPath& a, const RayPath& b) { return a == b; }
  /// Whether points on the ray of a pixel may have their image at another pixel, which shows the same.
  static bool isRepeated(const glm::vec2&) { return false; }
  /// The pinhole's image point of an undistorted one.
  template <class Camera>
  static glm::dvec2 pinholePoint(const Camera&, const ImagePoint& q) {
    return {q.u, q.v};
  }
};

struct Pinhole : Traits {
  static PinholeCamera make() { return smallCamera(); }
  static PinholeCamera undistorted() { return smallCamera(); }
};

struct SmoothDdoc : Traits {
  static DdocCamera make() { return {smallCamera(), test::wavyMap(kWidth, kHeight, 3, 40)}; }
  static DdocCamera undistorted() {
    return {smallCamera(), DistortionMap(kWidth, kHeight, DistortionMap::Lookup::kBilinear)};
  }
};

struct SceneDdoc : Traits {
  // Where the field of a built camera folds, ddoc_camera.h promises one of the solutions or none.
  static constexpr double kUnsolvable = 0.01;
  static constexpr double kAside = 0.01;
  static DdocCamera make() { return buildDdocCamera(smallCamera(), test::boxBeforeWall()); }
  static DdocCamera undistorted() { return buildDdocCamera(smallCamera(), test::tiltedPlane(0.5f)); }
};

/// With d_n > 0 the projection jumps at z_n, and the rays with it, which have four segments.
template <int kNearPixels>
struct SpocOf : Traits {
  // Nothing projects onto the disc of 5 pixels around the pole: pi 5^2 of 90 x 60 pixels, counted coarsely.
  static constexpr double kUnsolvable = 0.02;
  static constexpr double kAside = kNearPixels > 0 ? 0.26 : 0;
  /// A point goes around a circle of d(z) more than its way from the pole.
  static float blowUp(const ImagePoint& q) {
    const float displacement = make().displacementAt(q.t);
    return 1 + displacement / std::max(glm::distance(glm::vec2(q.u, q.v), kPole) - displacement, 1e-3f);
  }
  static SpocCamera make() { return {smallCamera(), {kPole, 9, 11, kNearPixels, 5}}; }
  static SpocCamera undistorted() { return {smallCamera(), {kPole, 9, 11, 0, 0}}; }

  static constexpr glm::vec2 kPole{45.3f, 29.8f};
};
using Spoc = SpocOf<0>;
using SteppingSpoc = SpocOf<2>;

struct ReversePinhole : Traits {
  // It displaces all that is not at the depth where its image is that of the reference: 10 from the eye.
  static constexpr std::array kUndistortedHeights{0.0f};
  static ReversePinholeCamera undistorted() { return make(); }
  // Straight rays, which cross each other there: in the plane z = 0 of the world.
  static bool sameRay(const RayPath& a, const RayPath& b) {
    const auto crossing = [](const RayPath& ray) {
      return ray.front() + (ray.back() - ray.front()) * (ray.front().z / (ray.front().z - ray.back().z));
    };
    return glm::distance(crossing(a), crossing(b)) < 1e-5f;  // ten roundings of lengths of 1
  }
  static ReversePinholeCamera make() {
    View view;
    view.zNear = 8;
    view.zFar = 13;
    return {PinholeCamera(view, kWidth, kHeight), 10, 20};
  }
};

/// One region with its transition, or two.
template <int kSampling>
struct GpcOf : Traits {
  static constexpr double kErrorGrowth = 4;  ///< the zoom
  static GpcLayout layout(float zoom) {
    return {&gpcSamplings()[kSampling],
            {{{0.3f, 0.4f}, {0.2f, 0.3f}, zoom, 1.0f}, {{0.8f, 0.7f}, {0.1f, 0.2f}, (zoom + 1) / 2, 1.5f}}};
  }
  /// Worked out in double precision, and the pinhole's in single: roundings of lengths of 10 and of 1000.
  static bool sameRay(const RayPath& a, const RayPath& b) {
    return glm::distance(a.front(), b.front()) < 1e-5f && glm::distance(a.back(), b.back()) < 1e-3f;
  }
  static GpcCamera make() { return {smallCamera(), layout(4)}; }
  static GpcCamera undistorted() { return {smallCamera(), layout(1)}; }
};
using LinearGpc = GpcOf<0>;
using QuadraticGpc = GpcOf<1>;
using CubicGpc = GpcOf<2>;

EpipolarCamera eocAt(const glm::vec3& right, const Mesh& mesh) {
  const PinholeCamera base = smallCamera();
  const EpipolarLines lines(base, right);
  const FragmentImage seen = rasterizeLines(base, lines, mesh);
  std::vector<std::vector<EpipolarEdge>> edges;
  for (int row = 0; row < lines.rowCount(); ++row) {
    std::vector<float> inverseZ;
    for (int j = 0; j < lines.length(row); ++j) {
      inverseZ.push_back(seen(j, row).covered() ? 1 / seen(j, row).t : 0);
    }
    edges.push_back(findEpipolarEdges(inverseZ, row, lines, base.view().zNear, 1 / 10.9f, {}));
  }
  return {base, right, edges};
}

struct Eoc : Traits {
  static constexpr bool kRaysRunFromNear = false;  // those that were added begin behind an occluder
  template <class Camera>
  static glm::dvec2 pinholePoint(const Camera& camera, const ImagePoint& q) {
    return camera.lines().imagePoint({q.v, q.u});
  }
};

struct EocAcross : Eoc {
  // The box adds ceil(f 1.6 (1/9.3 - 1/10.9)) = 8 columns to its rows. At any depth at most so many columns each have
  // ended, have not begun or are beyond their row: 3 * 8 of 98.
  static constexpr double kUnsolvable = 0.25;
  static constexpr double kAside = kUnsolvable;
  static glm::ivec2 size() { return {kWidth + 8, kHeight}; }
  static EpipolarCamera make() { return eocAt({1.6f, 0, 10}, test::boxBeforeWall()); }
  static EpipolarCamera undistorted() { return eocAt({1.6f, 0, 10}, test::tiltedPlane(0.5f)); }
};

struct EocForward : Eoc {
  // Rows of a ring around the middle are as long as the way to the border, between 30 and 55 of 55 pixels, 40 on
  // average: a quarter of the image has no ray. The box adds to that.
  static constexpr double kUnsolvable = 0.35;
  static constexpr double kAside = kUnsolvable;
  // Half a pixel from the middle an error turns as many rows as 54 pixels farther out, where they are a pixel apart.
  static constexpr double kErrorGrowth = 110;
  static glm::ivec2 size() {
    const EpipolarCamera camera = make();
    return {camera.width(), static_cast<int>(std::ceil(2 * kPi * std::hypot(kWidth / 2.0, kHeight / 2.0)))};
  }
  static EpipolarCamera make() { return eocAt({0, 0, 8.4f}, test::boxBeforeWall()); }
  // The epipole itself has no line: let it lie beside the points of the test.
  static EpipolarCamera undistorted() { return eocAt({0.05f, 0.03f, 8.4f}, test::tiltedPlane(0.5f)); }
};

/// Rays that turn: z is measured along them.
struct Graph : Traits {
  static constexpr bool kZRunsAlongTheView = false;
  template <class Camera>
  static float depthOf(const Camera& camera, const glm::vec3& point, const glm::vec2& pixel) {
    const std::optional<ExactImagePoint> q = camera.projectExactly(glm::dvec3(point));
    EXPECT_TRUE(q) << pixel.x << ", " << pixel.y;
    return q ? static_cast<float>(q->t) : 0;
  }
  /// A plane that is crossed without a turn is one more point of the ray.
  static bool sameRay(const RayPath& a, const RayPath& b) {
    return glm::distance(a.front(), b.front()) < 1e-5f && glm::distance(a.back(), b.back()) < 1e-3f;
  }
  static GraphCamera make() { return test::crossroads(); }
  static GraphCamera undistorted() {
    GraphCamera graph(smallCamera());
    graph.bend(0, test::turnAt({0, 0, 0.5}, {0.1, 0.2, -1}, {0, 0, 10}), "straight on");
    return graph;
  }
};

/// A graph camera whose rays end at walls.
struct LimitedGraph : Graph {
  static constexpr double kUnsolvable = 0.25;  ///< image points beyond the walls
  static constexpr double kShort = 1;
  static GraphCamera make() {
    GraphCamera graph = test::crossroads();
    for (int i = 1; i < static_cast<int>(graph.frusta().size()); ++i) {
      graph.limit(i, Plane::through({0, 0, -20}, {0.2, 0.1, -1}));
      graph.limit(i, Plane::through({30, 0, 0}, {1, 0, 0.1}));
    }
    return graph;
  }
};

struct CurvedRays : Graph {
  // An arc has 24 points. Half way between two, t is off by an eighth of what its growth changes by from one to the
  // next, more than 0.001 here.
  static constexpr float kArcError = 0.005f;
  static CurvedRayCamera make() { return test::bendingTwice(); }
  static CurvedRayCamera undistorted() {
    CurvedRayCamera straight(smallCamera());
    straight.bend(test::rightTurn(), {0, 0, 10});
    return straight;
  }
};

/// The same along polynomial arcs.
struct BezierRays : Graph {
  static constexpr float kArcError = CurvedRays::kArcError;
  static CurvedRayCamera make() { return test::bendingTwice(smallCamera(), ArcModel::kBezier); }
  static CurvedRayCamera undistorted() {
    CurvedRayCamera straight(smallCamera(), ArcModel::kBezier);
    straight.bend(test::rightTurn(), {0, 0, 10});
    return straight;
  }
};

/// Rays that end at the surfaces which they sample; a second viewpoint adds the pieces of its rays that the first
/// hides.
struct Cell : Traits {
  // Of nine depths two lie beyond all surfaces, and most of the 16 rows below the reference's 60 hold nothing: 2/9 of
  // 60 rows and nearly all of 16, of 76 rows, and what the occluder hides.
  static constexpr double kUnsolvable = 0.5;
  static constexpr double kShort = 1;
  static constexpr bool kRaysRunFromNear = false;  // those of the second viewpoint begin behind the occluder
  static glm::ivec2 size() { return {kWidth, kHeight + CellCamera::kTileSide}; }
  static const View& viewOf(const CellCamera& camera) { return camera.reference().view(); }
  static float depthAtEnd(const CellCamera& camera, const glm::vec3& point) {
    return camera.reference().cameraFromWorld(point).z;
  }
  static float depthOf(const CellCamera& camera, const glm::vec3& point, const glm::vec2&) {
    return depthAtEnd(camera, point);
  }
  static bool isRepeated(const glm::vec2& pixel) { return test::isRepeated(pixel); }
  static CellCamera make() { return test::twoViewpoints(); }
};

/// Straight rays in all directions, whose t is their length.
struct AllAround : Traits {
  template <class Camera>
  static const View& viewOf(const Camera& camera) {
    return camera.view();
  }
  template <class Camera>
  static float depthOf(const Camera& camera, const glm::vec3& point, const glm::vec2&) {
    return depthAtEnd(camera, point);
  }
  template <class Camera>
  static float depthAtEnd(const Camera& camera, const glm::vec3& point) {
    return static_cast<float>(glm::distance(glm::dvec3(point), glm::dvec3(camera.view().eye)));
  }
};
struct Panorama : AllAround {
  /// Longitudes come together at the poles.
  static float blowUp(const ImagePoint& q) {
    return 1 / static_cast<float>(std::sin(kPi * std::clamp(static_cast<double>(q.v) / kHeight, 1e-3, 1 - 1e-3)));
  }
  static PanoramaCamera make() { return PanoramaCamera(smallCamera()); }
};
struct Cylinder : AllAround {
  static CylinderCamera make() { return CylinderCamera(smallCamera()); }
};

/// The rays of another camera at its pixel centres, as a ray map.
template <class Source>
struct RayMapOf : Source {
  // Near the eye the ray's own near end is rounded as much as the point is.
  static constexpr double kErrorGrowth = 2;
  static const auto& original() {
    static const auto camera = Source::make();
    return camera;
  }
  static RayMapCamera make() {
    return test::cameraOf(test::mapOfCamera(original(), {.view = Source::viewOf(original())}));
  }
  static const View& viewOf(const RayMapCamera& camera) { return *camera.map().notes().view; }
  static float depthAtEnd(const RayMapCamera&, const glm::vec3& point) { return Source::depthAtEnd(original(), point); }
  static float depthOf(const RayMapCamera&, const glm::vec3& point, const glm::vec2& pixel) {
    return Source::depthOf(original(), point, pixel);
  }
};
template <class Source>
class CameraContract : public ::testing::Test {
 protected:
  using Camera = decltype(Source::make());
  // Building from a scene takes a while: once for all cases.
  static const Camera& camera() {
    static const Camera camera = Source::make();
    return camera;
  }

  // Unprojection of a distorted point stops within 1e-3 pixels. World coordinates of 10 units, those of the eye, round
  // by half of 1e-6, which moves an image point half an image width from the middle by that over z.
  static float pixels(float z) {
    return (1.5e-3f + kWidth / 2.0f * 1e-6f / z) * static_cast<float>(Source::kErrorGrowth);
  }
  static bool near(const ImagePoint& q, const glm::vec2& pixel) {
    const float tolerance = pixels(q.t) * Source::blowUp({pixel.x, pixel.y, q.t});
    return std::abs(q.u - pixel.x) < tolerance && std::abs(q.v - pixel.y) < tolerance;
  }

  static const View& view() { return Source::viewOf(camera()); }

  template <class Check>
  static void forGrid(const Check& check) {
    for (const float z : {0.02f, 5.0f, 8.5f, 9.3f, 9.6f, 10.2f, 10.9f, 12.5f, 500.0f}) {
      if (z < view().zNear || z > view().zFar) {
        continue;
      }
      for (int y = 0; y < camera().height(); y += 3) {
        for (int x = 0; x < camera().width(); x += 3) {
          check(ImagePoint{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f, z});
        }
      }
    }
  }
};

using AllCameras = ::testing::Types<Pinhole, SmoothDdoc, SceneDdoc, Spoc, SteppingSpoc, ReversePinhole, LinearGpc,
                                    QuadraticGpc, CubicGpc, EocAcross, EocForward, Graph, LimitedGraph, CurvedRays,
                                    BezierRays, Panorama, Cylinder, Cell, RayMapOf<Pinhole>, RayMapOf<Panorama>>;
TYPED_TEST_SUITE(CameraContract, AllCameras);

/// What holds besides for cameras that look through the window of a pinhole, and bend or displace its rays.
template <class Source>
class WindowContract : public CameraContract<Source> {};
using WindowCameras =
    ::testing::Types<Pinhole, SmoothDdoc, SceneDdoc, Spoc, SteppingSpoc, ReversePinhole, LinearGpc, QuadraticGpc,
                     CubicGpc, EocAcross, EocForward, Graph, LimitedGraph, CurvedRays, BezierRays>;
TYPED_TEST_SUITE(WindowContract, WindowCameras);

TYPED_TEST(CameraContract, hasItsSize) {
  EXPECT_EQ(this->camera().width(), TypeParam::size().x);
  EXPECT_EQ(this->camera().height(), TypeParam::size().y);
}

TYPED_TEST(CameraContract, projectOfUnprojectIsTheImagePoint) {
  size_t tried = 0;
  size_t unsolved = 0;
  this->forGrid([&](const ImagePoint& q) {
    ++tried;
    const std::optional<glm::vec3> point = this->camera().unproject(q);
    if (!point) {
      ++unsolved;
      return;
    }
    const std::optional<ImagePoint> back = this->camera().project(*point);
    ASSERT_TRUE(back) << q.u << " " << q.v << " " << q.t;
    EXPECT_TRUE(this->near(*back, {q.u, q.v}) || TypeParam::isRepeated({q.u, q.v})) << q.u << " " << q.v << " " << q.t;
    EXPECT_NEAR(back->t, q.t, 1e-6f * (1 + q.t)) << "rounding of world coordinates";
  });
  EXPECT_LE(static_cast<double>(unsolved), TypeParam::kUnsolvable * static_cast<double>(tried));
}

TYPED_TEST(CameraContract, rayPathProjectsToItsPixel) {
  size_t rays = 0;
  size_t none = 0;
  size_t broken = 0;
  for (int y = 0; y < this->camera().height(); ++y) {
    for (int x = 0; x < this->camera().width(); ++x) {
      const glm::vec2 pixel(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      const RayPath path = this->camera().rayPath(pixel);
      ASSERT_NE(path.size(), 1u);
      ++rays;
      none += path.empty();
      bool holds = true;
      for (const glm::vec3& point : path) {
        const std::optional<ImagePoint> q = this->camera().project(point);
        // The ends lie on the near and far plane: rounding may put them a hair outside. A ray that ends before the far
        // plane does so where it has no direction any more.
        const bool endsEarly =
            &point == &path.back() && TypeParam::depthAtEnd(this->camera(), point) < 0.999f * this->view().zFar;
        holds = holds && (endsEarly || TypeParam::isRepeated(pixel) ||
                          (!q ? (&point == &path.front() || &point == &path.back()) : this->near(*q, pixel)));
      }
      broken += !holds;
    }
  }
  EXPECT_EQ(broken, 0u) << "of " << rays;
  EXPECT_LE(static_cast<double>(none), TypeParam::kUnsolvable * static_cast<double>(rays));
}

TYPED_TEST(CameraContract, rayPathBetweenItsPointsProjectsNearItsPixel) {
  // A ray bends between the points of its polyline too. Half way between two of them, a quarter of a pixel apart, it
  // may be off by a quarter of what the slope of the field (below 1) changes by on that way.
  constexpr float kBend = 0.0625f;
  size_t joints = 0;
  size_t off = 0;
  for (int y = 0; y < this->camera().height(); y += 2) {
    for (int x = 0; x < this->camera().width(); x += 2) {
      const glm::vec2 pixel(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      const RayPath path = this->camera().rayPath(pixel);
      for (size_t i = 1; i < path.size(); ++i) {
        const std::optional<ImagePoint> q = this->camera().project((path[i - 1] + path[i]) * 0.5f);
        ASSERT_TRUE(q);
        ++joints;
        off += std::abs(q->u - pixel.x) > kBend || std::abs(q->v - pixel.y) > kBend;
      }
    }
  }
  EXPECT_LE(static_cast<double>(off), TypeParam::kAside * static_cast<double>(joints));
}

TYPED_TEST(CameraContract, rayPathRunsFromNearToFar) {
  int rays = 0;
  int shortRays = 0;
  for (int y = 0; y < this->camera().height(); y += 4) {
    for (int x = 0; x < this->camera().width(); x += 4) {
      const glm::vec2 pixel(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      const RayPath path = this->camera().rayPath(pixel);
      if (path.empty()) {
        continue;  // rayPathProjectsToItsPixel counts them
      }
      const auto depthOf = [&](const glm::vec3& point) { return TypeParam::depthOf(this->camera(), point, pixel); };
      for (size_t i = 1; i < path.size(); ++i) {
        EXPECT_GT(depthOf(path[i]), depthOf(path[i - 1]));
        EXPECT_GT(path.t(i), path.t(i - 1));
      }
      // World coordinates of 10 (near end) and 1000 (far end) units round by half a unit in their last place.
      EXPECT_TRUE(!TypeParam::kRaysRunFromNear || std::abs(depthOf(path.front()) - this->view().zNear) < 2e-6f);
      ++rays;
      shortRays += depthOf(path.back()) < this->view().zFar - 2e-4f;
    }
  }
  EXPECT_LE(shortRays, (TypeParam::kUnsolvable + TypeParam::kShort) * rays);
}

/// What project() says t is, at the points of the ray and between them, is what the ray says.
TYPED_TEST(CameraContract, rayPathGivesTheParameter) {
  size_t compared = 0;
  size_t different = 0;
  for (int y = 0; y < this->camera().height(); y += 3) {
    for (int x = 0; x < this->camera().width(); x += 3) {
      const RayPath path = this->camera().rayPath({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
      for (size_t i = 1; i < path.size(); ++i) {
        const float step = path.t(i) - path.t(i - 1);
        EXPECT_GT(step, 0) << "t grows";
        for (const float share : {0.5f, 1.0f}) {
          const RayPath::Position position{i - 1, share};
          const std::optional<ImagePoint> q = this->camera().project(path.pointAt(position));
          if (q) {  // the other tests count those without
            const float t = path.tAt(position);
            ++compared;
            // World coordinates of 10 units, and of t here, round by half of 1e-6; t is a sum of a few such lengths.
            different += std::abs(q->t - t) > 4e-6f * (1 + t) + TypeParam::kArcError * step;
          }
        }
      }
    }
  }
  EXPECT_GT(compared, 100u);
  EXPECT_LE(static_cast<double>(different), TypeParam::kAside * static_cast<double>(compared));
}

TYPED_TEST(WindowContract, imageBordersHaveRays) {
  const glm::vec2 size(this->camera().width(), this->camera().height());
  int withoutRay = 0;
  for (const glm::vec2 pixel :
       {glm::vec2(0, 0), glm::vec2(size.x, 0), glm::vec2(0, size.y - 0.25f), glm::vec2(size.x, size.y),
        glm::vec2(0.5f, size.y - 0.5f), glm::vec2(size.x - 0.5f, 0.5f)}) {
    if (this->camera().rayPath(pixel).empty()) {
      ++withoutRay;
      EXPECT_EQ(pixel.x, std::max(pixel.x, size.x - 0.5f)) << "all rows begin at the left border";
      continue;
    }
    EXPECT_GE(this->camera().rayPath(pixel).size(), 2u);
    const std::optional<glm::vec3> point = this->camera().unproject({pixel.x, pixel.y, 10});
    ASSERT_TRUE(point) << pixel.x << " " << pixel.y;
    const std::optional<ImagePoint> back = this->camera().project(*point);
    ASSERT_TRUE(back);
    EXPECT_TRUE(this->near(*back, pixel));
  }
  EXPECT_LE(withoutRay, TypeParam::kUnsolvable > 0 ? 3 : 0);
}

TYPED_TEST(WindowContract, pointsOutOfTheBordersHaveFiniteImages) {
  for (const glm::vec3 point : {glm::vec3(50, 0, 0), glm::vec3(0, -50, 0), glm::vec3(-1e6f, 1e6f, 0)}) {
    const std::optional<ImagePoint> q = this->camera().project(point);
    ASSERT_TRUE(q);
    EXPECT_TRUE(std::isfinite(q->u) && std::isfinite(q->v));
    EXPECT_FALSE(q->u >= 0 && q->u <= static_cast<float>(this->camera().width()) && q->v >= 0 &&
                 q->v <= static_cast<float>(this->camera().height()));
  }
}

TYPED_TEST(CameraContract, pointsWithoutAnImageHaveNone) {
  const auto hasNone = [&](const glm::vec3& point) {
    EXPECT_FALSE(this->camera().project(point)) << point.x << " " << point.y << " " << point.z;
  };
  hasNone({0, 0, 10});      // at the eye
  hasNone({0, 0, 9.995f});  // nearer than zNear
  if (TypeParam::kZRunsAlongTheView) {
    hasNone({0, 0, -990.5f});  // beyond zFar
  }
  hasNone({0, 0, -1e30f});
  hasNone({3e38f, -3e38f, 0});  // its image coordinates are no numbers
  for (int axis = 0; axis < 3; ++axis) {
    for (const float value : {kNan, kInfinity, -kInfinity}) {
      glm::vec3 point(0);
      point[axis] = value;
      hasNone(point);
    }
  }
}

TYPED_TEST(WindowContract, pointsBehindTheEyeHaveNoImage) {
  EXPECT_FALSE(this->camera().project({0, 0, 11}));
  EXPECT_FALSE(this->camera().project({3, -2, 1000}));
}

TYPED_TEST(CameraContract, imagePointsWithoutAWorldPointHaveNone) {
  const auto hasNone = [&](const ImagePoint& q) {
    EXPECT_FALSE(this->camera().unproject(q)) << q.u << " " << q.v << " " << q.t;
  };
  for (const float z : {0.0f, -1.0f, 0.0099f, 1000.1f, kNan, kInfinity, -kInfinity}) {
    hasNone({45, 30, z});
  }
  for (const float value : {kNan, kInfinity, -kInfinity}) {
    hasNone({value, 30, 10});
    hasNone({45, value, 10});
    EXPECT_TRUE(this->camera().rayPath({value, 30}).empty());
    EXPECT_TRUE(this->camera().rayPath({45, value}).empty());
  }
}

// The eye at (0, 0, 10) looks along -z: u = w/2 + f x / z, v = h/2 - f y / z with z = 10 - z_world, and the field of
// view holds the unit sphere: tan(fov / 2) = 1 / sqrt(10^2 - 1), f = h/2 * sqrt(99).
template <class Source>
void expectPinhole() {
  const auto camera = Source::undistorted();
  const double focal = kHeight / 2.0 * std::sqrt(99.0);
  for (const float x : {-1.2f, -0.3f, 0.0f, 0.7f}) {
    for (const float y : {-0.9f, 0.0f, 0.4f}) {
      for (const float z : Source::kUndistortedHeights) {
        const std::optional<ImagePoint> q = camera.project({x, y, z});
        ASSERT_TRUE(q);
        const double depth = 10.0 - z;
        const glm::dvec2 p = Source::pinholePoint(camera, *q);
        EXPECT_NEAR(p.x, kWidth / 2.0 + focal * x / depth, 1e-4);
        EXPECT_NEAR(p.y, kHeight / 2.0 - focal * y / depth, 1e-4);
        EXPECT_NEAR(q->t, depth, 2e-6);
        const std::optional<glm::vec3> back = camera.unproject(*q);
        ASSERT_TRUE(back);
        EXPECT_LT(glm::distance(*back, glm::vec3(x, y, z)), 1e-5f);
      }
    }
  }
  const ImagePoint pixel{12.5f, 40.5f, 10};
  const glm::vec2 inPinhole(Source::pinholePoint(camera, pixel));
  EXPECT_TRUE(Source::sameRay(camera.rayPath({pixel.u, pixel.v}), smallCamera().rayPath(inPinhole)));
}

TYPED_TEST(WindowContract, reducesToThePinholeWithoutDistortion) {
  expectPinhole<TypeParam>();
}

}  // namespace
}  // namespace ocelli
