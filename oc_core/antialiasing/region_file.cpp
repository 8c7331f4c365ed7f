#include "oc_core/antialiasing/region_file.h"

#include <fmt/format.h>

#include <glm/common.hpp>

#include "oc_core/antialiasing/sample_positions.h"
#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

/// Shares that meet a border, as 0.9 + 0.1 does, may be rounded beyond it.
constexpr double kRounding = 1e-9;

RegionRequest readRegion(JsonFields& fields) {
  RegionRequest region;
  const auto pair = [&](const char* name, double least, const glm::dvec2& otherwise) {
    if (!fields.has(name)) {
      return otherwise;
    }
    const std::vector<double> values = fields.numbers(name, 2, least, 1);
    return glm::dvec2(values[0], values[1]);
  };
  region.center = pair("center", 0, region.center);
  region.extent = pair("extent", RegionRequest::kMinExtent, region.extent);
  region.side = fields.integer("samples_a_side", 1, SamplePattern::kMaxSide, 0);
  const glm::dvec2 lower = region.center - region.extent / 2.0;
  const glm::dvec2 upper = region.center + region.extent / 2.0;
  if (glm::min(lower.x, lower.y) < -kRounding || glm::max(upper.x, upper.y) > 1 + kRounding) {
    fields.fail("extent", fmt::format("makes the region reach from ({:.4g}, {:.4g}) to ({:.4g}, {:.4g}) of the image, "
                                      "whose corners are (0, 0) and (1, 1): move it, or make it smaller",
                                      lower.x, lower.y, upper.x, upper.y));
  }
  return region;
}

}  // namespace

std::vector<RegionRequest> regionsFromJsonText(const std::string& text, const std::string& where) {
  return readAs("oc_core/antialiasing/antialias_regions.schema.json", [&] {
    const JsonDocument document(text, where);
    JsonFields fields(document);
    std::vector<RegionRequest> regions;
    if (!fields.has("regions")) {
      fields.fail("regions", "is missing");
    }
    fields.forEach("regions", 1, RegionRequest::kMaxRegions,
                   [&](JsonFields& each) { regions.push_back(readRegion(each)); });
    fields.rejectUnknown();
    return regions;
  });
}

std::vector<RegionRequest> readRegionFile(const std::filesystem::path& path) {
  return regionsFromJsonText(readFile(path), path.string());
}

}  // namespace ocelli
