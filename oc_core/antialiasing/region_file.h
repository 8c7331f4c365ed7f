// Regions to be supersampled, from a JSON file (antialias_regions.schema.json), in shares of the image, so that they
// fit every size.
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

namespace ocelli {

struct RegionRequest {
  static constexpr size_t kMaxRegions = 256;
  static constexpr double kMinExtent = 1e-4;

  glm::dvec2 center{0.5};  ///< shares of the image's width and height, from the top left
  glm::dvec2 extent{1};    ///< its width and height, the same shares
  int side = 0;            ///< n of n x n samples a pixel; 0: what fits the tile
};

/// Throws InputError, naming file, line and field, for what the schema does not allow, and for regions that reach out
/// of the image.
std::vector<RegionRequest> readRegionFile(const std::filesystem::path& path);
std::vector<RegionRequest> regionsFromJsonText(const std::string& text, const std::string& where);

}  // namespace ocelli
