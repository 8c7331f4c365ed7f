#include "display_sim/solidity/solidity_report.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

using Json = nlohmann::ordered_json;

/// Infinity has no JSON form.
Json numberOrNull(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

Json jsonOf(const SolidityErrors& errors) {
  return {{"hidden_light", errors.hiddenShare()},
          {"psnr_db", numberOrNull(errors.psnrDecibels())},
          {"ssim", errors.meanSsim()},
          {"flip", errors.meanFlip()}};
}

}  // namespace

std::string solidityTable(const SolidityOptions& options, const std::vector<SolidityFigures>& rows) {
  std::string text = fmt::format("{:<18} {:>10} {:>11}", "", "", "");
  std::string names = fmt::format("{:<18} {:>10} {:>11}", "shown", "triangles", "lit voxels");
  for (const EyeGroup& group : options.groups) {
    text += fmt::format("   {:^35}", group.name);
    names += fmt::format("   {:>12} {:>8} {:>6} {:>6}", "hidden light", "PSNR dB", "SSIM", "FLIP");
  }
  text += "\n" + names + "\n";
  for (const SolidityFigures& row : rows) {
    text += fmt::format("{:<18} {:>10} {:>11}", row.name, row.triangles, row.litVoxels);
    for (const SolidityErrors& errors : row.groups) {
      text += fmt::format("   {:>10.2f} % {:>8.2f} {:>6.3f} {:>6.3f}", 100 * errors.hiddenShare(),
                          errors.psnrDecibels(), errors.meanSsim(), errors.meanFlip());
    }
    text += "\n";
  }
  return text;
}

std::string solidityJson(const std::string& scene, const SolidityOptions& options,
                         const std::vector<SolidityFigures>& rows) {
  Json json;
  json["scene"] = scene;
  json["profile"] = options.profile.name;
  json["image_side"] = options.imageSide > 0 ? options.imageSide : options.profile.height;
  json["eyes"] = Json::object();
  for (const EyeGroup& group : options.groups) {
    Json eyes = Json::array();
    for (const glm::vec3& eye : group.eyes) {
      eyes.push_back({eye.x, eye.y, eye.z});
    }
    json["eyes"][group.name] = eyes;
  }
  json["representations"] = Json::array();
  for (const SolidityFigures& row : rows) {
    Json entry{{"name", row.name}, {"triangles", row.triangles}, {"lit_voxels", row.litVoxels}, {"gain", row.gain}};
    for (size_t i = 0; i < row.groups.size(); ++i) {
      entry[options.groups[i].name] = jsonOf(row.groups[i]);
    }
    json["representations"].push_back(entry);
  }
  // A path need not be UTF-8.
  return textOfJson(json, 2) + "\n";
}

}  // namespace ocelli
