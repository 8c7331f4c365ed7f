#include "oc_core/miv/miv_writer.h"

#include <nlohmann/json.hpp>

#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_document.h"
#include "oc_core/base/output_folder.h"
#include "oc_core/miv/miv_pose.h"
#include "oc_core/miv/miv_samples.h"

namespace ocelli {
namespace {

using Json = nlohmann::ordered_json;

Json cameraOf(const MivView& view, const MivDepthRange& range, double unitsPerMetre) {
  const PinholeCamera camera(view.view, view.color.width(), view.color.height());
  const MivPose pose = mivPose(camera, unitsPerMetre);
  Json json{{"Name", view.name},         {"Position", pose.position},
            {"Rotation", pose.rotation}, {"Depthmap", 1},
            {"Background", 0},           {"Depth_range", {range.near, range.far}},
            {"HasInvalidDepth", true},   {"Resolution", {view.color.width(), view.color.height()}}};
  if (view.isPanorama) {
    json["Projection"] = "Equirectangular";
    json["Hor_range"] = {-180, 180};
    json["Ver_range"] = {-90, 90};
  } else {
    json["Projection"] = "Perspective";
    json["Focal"] = {camera.focalPixels(), camera.focalPixels()};
    json["Principle_point"] = {camera.centerPixels().x, camera.centerPixels().y};
  }
  json["BitDepthColor"] = kMivColorBits;
  json["BitDepthDepth"] = kMivDepthBits;
  json["ColorSpace"] = "YUV420";
  json["DepthColorSpace"] = "YUV420";
  return json;
}

}  // namespace

void writeMivSequence(const std::filesystem::path& folder, const MivSequence& sequence, const Progress& progress) {
  validate(sequence);
  makeFolder(folder);
  Json names = Json::array();
  Json cameras = Json::array();
  std::array<double, 3> center{};
  for (const MivView& view : sequence.views) {
    report(progress, "writing views", static_cast<double>(names.size()) / static_cast<double>(sequence.views.size()));
    const int width = view.color.width();
    const int height = view.color.height();
    const MivDepthRange range = depthRangeOf(view, sequence.unitsPerMetre);
    writeFile(folder / mivTextureFile(view.name, width, height), mivTextureBytes(view.color));
    writeFile(folder / mivDepthFile(view.name, width, height),
              mivDepthBytes(view.depth, range, sequence.unitsPerMetre));
    names.push_back(view.name);
    cameras.push_back(cameraOf(view, range, sequence.unitsPerMetre));
    for (size_t axis = 0; axis < 3; ++axis) {
      center[axis] += cameras.back()["Position"][axis].get<double>() / static_cast<double>(sequence.views.size());
    }
  }
  const Json json{
      {"Version", "4.0"},   {"Content_name", sequence.content}, {"BoundingBox_center", center}, {"Fps", 30},
      {"Frames_number", 1}, {"lengthsInMeters", true},          {"sourceCameraNames", names},   {"cameras", cameras}};
  writeFile(folder / (sequence.content + ".json"), textOfJson(json, 2) + "\n");
}

}  // namespace ocelli
