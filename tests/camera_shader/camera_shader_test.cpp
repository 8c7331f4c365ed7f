// The rays of cameras as shaders are those of the cameras.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <regex>

#include "oc_core/base/error.h"
#include "oc_core/camera_rays/camera_rays.h"
#include "oc_core/camera_shader/closed_form_shader.h"
#include "oc_core/camera_shader/osl_text.h"
#include "oc_core/camera_shader/ray_texture_shader.h"
#include "tests/base/temporary_folder.h"
#include "tests/camera/test_ray_maps.h"
#include "tests/camera_shader/run_shaders.h"
#include "tests/camera_shader/shader_cases.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::vector<ShaderCase>& cases() {
  static const std::vector<ShaderCase> all = shaderCases(OCELLI_SHADER_FOLDER);
  return all;
}

/// World points in camera space: axes by hand, in double precision.
class Space {
 public:
  explicit Space(const RayMapNotes& notes) : isLens_(notes.frame == RayFrame::kView) {
    const View view = notes.view.value_or(View{});
    eye_ = view.eye;
    forward_ = glm::normalize(glm::dvec3(view.target) - eye_);
    right_ = glm::normalize(glm::cross(forward_, glm::dvec3(view.up)));
  }
  glm::dvec3 direction(const glm::dvec3& d) const {
    return isLens_ ? glm::dvec3(d.x, d.y, -d.z)
                   : glm::dvec3(glm::dot(d, right_), glm::dot(d, glm::cross(right_, forward_)), glm::dot(d, forward_));
  }
  glm::dvec3 point(const glm::dvec3& p) const { return isLens_ ? direction(p) : direction(p - eye_); }

 private:
  bool isLens_;
  glm::dvec3 eye_;
  glm::dvec3 forward_;
  glm::dvec3 right_;
};

glm::vec2 rasterOf(const glm::vec2& pixel, const RayMap& map) {
  return {pixel.x / static_cast<float>(map.width()), 1 - pixel.y / static_cast<float>(map.height())};
}

/// The greatest differences of positions and directions.
struct Deviation {
  double position = 0;
  double direction = 0;
  size_t rays = 0;
  size_t wrong = 0;  ///< pixels with a ray that should have none, or the other way round

  void add(const ShaderRay& got, const RayMapRay& want, const Space& space) {
    wrong += (got.throughput == glm::vec3(want.empty() ? 0 : 1)) ? 0 : 1;
    if (want.empty()) {
      return;
    }
    ++rays;
    const glm::dvec3 from(want.points.front());
    const glm::dvec3 way = glm::normalize(space.direction(glm::dvec3(want.points.back()) - from));
    position = std::max(position, glm::distance(glm::dvec3(got.position), space.point(from)));
    direction = std::max(direction, glm::distance(glm::dvec3(got.direction), way));
  }
};

Deviation deviationOf(const ShaderCase& each, Filtering filtering) {
  Deviation deviation;
  const Space space(each.rays.notes());
  for (int y = 0; y < each.rays.height(); ++y) {
    for (int x = 0; x < each.rays.width(); ++x) {
      const glm::vec2 raster = rasterOf(glm::vec2(x, y) + 0.5f, each.rays);
      deviation.add(runShader(each.name, raster, filtering), each.rays.ray(x, y), space);
    }
  }
  return deviation;
}

/// What is asked for. Both sides are of single precision, in units of the scene and of unit vectors.
constexpr double kSameRay = 1e-5;

TEST(CameraShader, raysAreThoseOfTheCamera) {
  size_t without = 0;
  Deviation worst;
  for (const ShaderCase& each : cases()) {
    const Deviation deviation = deviationOf(each, Filtering::kClosest);
    EXPECT_LT(deviation.position, kSameRay) << each.name;
    EXPECT_LT(deviation.direction, kSameRay) << each.name;
    EXPECT_EQ(deviation.wrong, 0u) << each.name;
    EXPECT_EQ(deviation.rays, each.rays.rayCount()) << each.name;
    without += static_cast<size_t>(each.rays.width() * each.rays.height()) - deviation.rays;
    worst.position = std::max(worst.position, deviation.position);
    worst.direction = std::max(worst.direction, deviation.direction);
  }
  EXPECT_GT(without, 100u) << "pixels without a ray are among them";
  EXPECT_EQ(shaderNames().size(), cases().size());
  RecordProperty("position", std::to_string(worst.position * 1e6) + "e-6");
  RecordProperty("direction", std::to_string(worst.direction * 1e6) + "e-6");
}

TEST(CameraShader, formulasHoldBetweenThePixels) {
  for (const ShaderCase& each : cases()) {
    if (!each.rayAt) {
      continue;
    }
    const Space space(each.rays.notes());
    Deviation deviation;
    const glm::vec2 size(each.rays.width(), each.rays.height());
    for (int i = 0; i < 4000; ++i) {
      // Golden ratios spread them over the image.
      const glm::vec2 place(std::fmod(static_cast<float>(i) * 0.618034f, 1.0f),
                            std::fmod(static_cast<float>(i) * 0.7548777f, 1.0f));
      const RayPath path = each.rayAt(place * size);
      const std::array<glm::vec3, 2> points{path.front(), path.back()};
      const std::array<float, 2> parameters{path.tMin(), path.tMax()};
      deviation.add(runShader(each.name, rasterOf(place * size, each.rays)), {points, parameters}, space);
    }
    EXPECT_LT(deviation.position, kSameRay) << each.name;
    EXPECT_LT(deviation.direction, kSameRay) << each.name;
    EXPECT_EQ(deviation.rays, 4000u);
  }
}

TEST(CameraShader, renderersThatFilterTexturesReadTheSameRays) {
  // A place in an image is rounded by 2^-24 of its side: by less than 1e-5 texels here, which is the share of the
  // neighbour that comes in. Neighbours differ by no more than some units.
  constexpr double kFiltered = 1e-4;
  for (const ShaderCase& each : cases()) {
    if (each.texture.empty()) {
      continue;
    }
    const Deviation deviation = deviationOf(each, Filtering::kLinear);
    EXPECT_LT(deviation.position, kFiltered) << each.name;
    EXPECT_LT(deviation.direction, kFiltered) << each.name;
    EXPECT_EQ(deviation.wrong, 0u) << each.name;
  }
}

TEST(CameraShader, anyPlaceWithinAPixelReadsItsRay) {
  const auto found = std::find_if(cases().begin(), cases().end(),
                                  [](const ShaderCase& each) { return each.name == "random_texture"; });
  ASSERT_NE(found, cases().end());
  const ShaderRay middle = runShader(found->name, rasterOf({12.5f, 7.5f}, found->rays));
  for (const glm::vec2& pixel : {glm::vec2(12.02f, 7.02f), glm::vec2(12.98f, 7.02f), glm::vec2(12.02f, 7.98f)}) {
    EXPECT_EQ(runShader(found->name, rasterOf(pixel, found->rays)).direction, middle.direction);
  }
  // Filters of pixels reach beyond the image.
  EXPECT_EQ(runShader(found->name, {-0.01f, 1.01f}).direction, runShader(found->name, {0.01f, 0.99f}).direction);
  EXPECT_EQ(runShader(found->name, {1.01f, -0.01f}).direction, runShader(found->name, {0.99f, 0.01f}).direction);
}

/// The perspective camera that the manual of Blender has as its example: the place on the sensor, from its middle,
/// through the focal length; x to the right, y up, z forward.
TEST(CameraShader, aPinholeIsTheExampleOfTheManual) {
  const View view;
  const glm::dvec2 sensor(36, 24);
  const double focal = sensor.y / 2 / std::tan(radiansFromDegrees(view.resolvedFovVerticalDegrees()) / 2);
  for (const glm::dvec2& raster : {glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0.25, 1), glm::dvec2(0.7, 0.4)}) {
    const glm::dvec2 place = (raster - 0.5) * sensor / focal;
    const ShaderRay got = runShader("di", glm::vec2(raster));
    EXPECT_LT(glm::distance(glm::dvec3(got.direction), glm::normalize(glm::dvec3(place, 1))), 1e-6);
  }
  const ShaderRay topLeft = runShader("di", {0, 1});
  EXPECT_LT(topLeft.direction.x, 0);
  EXPECT_GT(topLeft.direction.y, 0);
  EXPECT_GT(topLeft.direction.z, 0.9f);
}

TEST(CameraShader, theTextOfAPinhole) {
  const View view{.eye = {0, 0, 10}, .target = {0, 0, 0}, .fovVerticalDegrees = 90, .zNear = 0.25f};
  const CameraChoice choice = cameraChoice("di");
  const std::string text = closedFormShader(*findClosedForm(choice), choice, PinholeCamera(view, 300, 200));
  EXPECT_EQ(
      text,
      R"(// The camera "di" of Ocelli, 300x200 pixels, for renderers that take cameras in the Open Shading Language.
//
// position and direction are in the space of the camera: x to the right, y up, z forward; lengths are those of
// the scene. The image that is rendered needs 300:200 as the ratio of its sides.
//
// Where the camera stands, as the matrix_world of a camera object. In a world whose y axis points up, as
// that of the scene does:
//     (1, 0, 0, 0),
//     (0, 1, 0, 0),
//     (0, 0, 1, 10),
//     (0, 0, 0, 1)
// Where the import turned the scene so that z points up, and y along what was -z:
//     (1, 0, 0, 0),
//     (0, 0, -1, -10),
//     (0, 1, 0, 0),
//     (0, 0, 0, 1)
shader ocelli_di(
    output point position = point(0.0),
    output vector direction = vector(0.0),
    output color throughput = color(0.0))
{
    float width = 300.0;  // of the camera's image, pixels
    float height = 200.0;
    float begin = 0.25;  // the distance at which rays begin
    point raster = camera_shader_raster_position();
    float x = raster[0] * width;  // from the top left
    float y = (1 - raster[1]) * height;
    float focal = 100.0;  // length, pixels
    float centerX = 150.0;  // where the view direction meets the image, pixels
    float centerY = 100.0;
    vector ray = vector((x - centerX) / focal, (centerY - y) / focal, 1);
    position = point(ray[0] * begin, ray[1] * begin, begin);
    direction = normalize(ray);
    throughput = color(1.0);
}
)");
}

/// The matrices that a text says, row by row: one of a world with y up, one with z up.
std::vector<glm::dmat4> matricesOf(const std::string& text) {
  const std::regex row(R"(//     \(([^,()]+), ([^,()]+), ([^,()]+), ([^,()]+)\))");
  std::vector<glm::dmat4> matrices;
  int rows = 0;
  for (std::sregex_iterator each(text.begin(), text.end(), row), end; each != end; ++each, ++rows) {
    if (rows % 4 == 0) {
      matrices.emplace_back(0.0);
    }
    for (int column = 0; column < 4; ++column) {
      matrices.back()[column][rows % 4] = std::stod((*each)[static_cast<size_t>(column) + 1]);
    }
  }
  return matrices;
}

/// What a renderer does with a camera object that looks along its -z: rays as they are in its world.
TEST(CameraShader, theMatrixPutsTheCameraWhereItStands) {
  for (const char* name : {"di_oblique", "gpc_oblique", "di_texture", "cell_texture", "push_broom_texture"}) {
    const auto found =
        std::find_if(cases().begin(), cases().end(), [&](const ShaderCase& each) { return each.name == name; });
    ASSERT_NE(found, cases().end()) << name;
    const std::vector<glm::dmat4> matrices = matricesOf(found->text);
    ASSERT_EQ(matrices.size(), 2u) << name;
    const glm::ivec2 pixel(found->rays.width() / 5, found->rays.height() / 3);
    const ShaderRay got = runShader(name, rasterOf(glm::vec2(pixel) + 0.5f, found->rays));
    const RayMapRay want = found->rays.ray(pixel.x, pixel.y);
    const glm::dvec3 from(want.points.front());
    const glm::dvec3 way = glm::normalize(glm::dvec3(want.points.back()) - from);
    const auto zUp = [](const glm::dvec3& p) { return glm::dvec3(p.x, -p.z, p.y); };
    for (size_t i = 0; i < 2; ++i) {
      const glm::dvec3 position(matrices[i] * glm::dvec4(got.position.x, got.position.y, -got.position.z, 1));
      const glm::dvec3 direction(matrices[i] * glm::dvec4(got.direction.x, got.direction.y, -got.direction.z, 0));
      EXPECT_LT(glm::distance(position, i == 0 ? from : zUp(from)), kSameRay) << name;
      EXPECT_LT(glm::distance(direction, i == 0 ? way : zUp(way)), kSameRay) << name;
    }
  }
}

TEST(CameraShader, textsSayWhatTheyRead) {
  for (const ShaderCase& each : cases()) {
    const bool reads = each.text.find("texture(rays") != std::string::npos;
    EXPECT_EQ(reads, !each.texture.empty()) << each.name;
    EXPECT_EQ(each.text.find("matrix_world") != std::string::npos, each.name != "lens_texture") << each.name;
  }
  const RayMap named =
      straightMap({2, 1}, [](double u, double) { return std::pair(glm::dvec3(u, 0, 0), glm::dvec3(0, 0, -1)); }, 0, 1,
                  {.name = "a \"name\"\nof lines"});
  const std::string text = rayTextureShader(named, "C:\\rays \"1\".exr");
  EXPECT_THAT(text, AllOf(HasSubstr("string rays = \"C:\\\\rays \\\"1\\\".exr\""),
                          HasSubstr("shader ocelli_a__name__of_lines("),
                          HasSubstr("// The camera \"a \"name\" of lines\" of Ocelli")));
  EXPECT_EQ(oslNumber(3), "3.0");
  EXPECT_EQ(oslNumber(1e-7), "1e-07");
  EXPECT_EQ(oslNumber(0.1), "0.1");
}

TEST(CameraShader, raysThatBendAreRefused) {
  const RayMap bent = rayMapOf(cameraChoice("ddoc"), smallCamera(), boxBeforeWall(), 0);
  const RayMapFacts facts = factsOf(bent);
  ASSERT_GT(facts.bent, 0u);
  const auto errorOf = [&](const auto& write) -> std::string {
    try {
      write();
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(errorOf([&] { rayTextureShader(bent, "rays.exr"); }),
              AllOf(HasSubstr(std::to_string(facts.bent) + " of its "), HasSubstr("rays bend"), HasSubstr("ddoc"),
                    HasSubstr("ocelli camera rays")));
  EXPECT_THAT(errorOf([&] { rayTextureBytes(bent); }), HasSubstr("one straight ray a pixel"));
}

/// The compiler of the language itself, where there is one.
TEST(OslCompiler, takesTheTexts) {
  if (std::system("oslc --version >/dev/null 2>&1") != 0) {
    GTEST_SKIP() << "needs oslc, the compiler of the Open Shading Language";
  }
  const TemporaryFolder folder;
  for (const ShaderCase& each : cases()) {
    std::string text = "point camera_shader_raster_position() { return P; }\n";  // Cycles declares it to camera shaders
    text += each.text;
    const std::string path = folder.write(each.name + ".osl", text);
    std::string command = "oslc -q -o '" + path;
    command.append(".oso' '").append(path).append("'");
    EXPECT_EQ(std::system(command.c_str()), 0) << each.name;
  }
}

}  // namespace
}  // namespace ocelli::test
