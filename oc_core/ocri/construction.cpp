#include "oc_core/ocri/construction.h"

#include <fmt/format.h>

#include "oc_core/base/error.h"
#include "oc_core/render/rasterize.h"

namespace ocelli {
namespace {

/// Of the images that the crossovers were measured with.
constexpr double kCrossoverPixels = 720 * 480;

/// With a comma between thousands.
std::string grouped(size_t number) {
  return number < 1000 ? fmt::format("{}", number) : fmt::format("{},{:03}", grouped(number / 1000), number % 1000);
}

}  // namespace

bool constructWithRays(Construction wanted, size_t crossover, size_t triangleCount, RayStructure structure,
                       const RefitCost& refit) {
  switch (wanted) {
    case Construction::kAuto:
      switch (structure) {
        case RayStructure::kNone:
          return false;
        case RayStructure::kStands:
          return triangleCount >= crossover;
        case RayStructure::kRefits:
          return static_cast<double>(triangleCount) * (1 - refit.share) >=
                 static_cast<double>(crossover) * static_cast<double>(refit.pixels) / kCrossoverPixels;
      }
      OC_CHECK(false, "every structure is decided");
    case Construction::kRaster:
      return false;
    case Construction::kRays:
      return true;
  }
  OC_CHECK(false, "every construction is decided");
}

Construction constructionFromText(const std::string& text, const std::string& where) {
  if (text == "auto") {
    return Construction::kAuto;
  }
  if (text == "raster") {
    return Construction::kRaster;
  }
  if (text == "rays") {
    return Construction::kRays;
  }
  throw InputError(fmt::format("there is no construction \"{}\"", text), where, "use auto, raster or rays");
}

std::string describe(const ConstructionReport& report) {
  if (!report.byRays) {
    return "by rasterisation";
  }
  const std::string built = report.buildSeconds > 0 ? fmt::format("built in {:.1f} s", report.buildSeconds) : "at hand";
  return fmt::format("by rays (BVH of {} triangles {})", grouped(report.triangles), built);
}

FragmentImage seenFrom(const PinholeCamera& camera, const Mesh& mesh, const SceneRenderer* renderer) {
  return renderer != nullptr ? renderer->draw(camera) : rasterize(camera, mesh);
}

}  // namespace ocelli
