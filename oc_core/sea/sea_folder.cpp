#include "oc_core/sea/sea_folder.h"

#include <fmt/format.h>

#include <glm/gtc/quaternion.hpp>

#include "oc_core/base/csv.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/output_folder.h"
#include "oc_core/base/parallel.h"
#include "oc_core/scene/ply_file.h"

namespace ocelli {
namespace {

/// PNG, whatever they were before.
std::vector<std::string> fileNames(const SeaFile& sea) {
  std::vector<std::string> names = sea.names();
  if (names.empty()) {
    for (uint32_t i = 0; i < sea.count(); ++i) {
      names.push_back(fmt::format("image{:05}", i));
    }
  }
  for (std::string& name : names) {
    name = std::filesystem::path(name).replace_extension(".png").string();
  }
  return names;
}

std::string positionTable(const SeaFile& sea, const std::vector<std::string>& names) {
  std::string text = "file,x,y,z,qw,qx,qy,qz\n";
  for (uint32_t i = 0; i < sea.count(); ++i) {
    const SeaPose pose = sea.pose(i);
    const glm::dquat& q = pose.worldFromCamera;
    text += fmt::format("{},{},{},{},{},{},{},{}\n", csvText(names[i]), pose.position.x, pose.position.y,
                        pose.position.z, q.w, q.x, q.y, q.z);
  }
  return text;
}

/// COLMAP's cameras look along +z with y down; its poses take the world to the camera.
std::string colmapImages(const SeaFile& sea, const std::vector<std::string>& names) {
  std::string text = "# IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME, and a line of points\n";
  for (uint32_t i = 0; i < sea.count(); ++i) {
    const SeaPose pose = sea.pose(i);
    const glm::dquat q = glm::conjugate(pose.worldFromCamera * glm::dquat(0, 1, 0, 0));
    const glm::dvec3 t = -(q * pose.position);
    text += fmt::format("{} {} {} {} {} {} {} {} 1 {}\n\n", i + 1, q.w, q.x, q.y, q.z, t.x, t.y, t.z, names[i]);
  }
  return text;
}

}  // namespace

void writeSeaFolder(const SeaFile& sea, const std::filesystem::path& folder, const Progress& progress) {
  makeFolder(folder);
  const std::vector<std::string> names = fileNames(sea);
  const SeaProjection& projection = sea.settings().projection;
  if (projection.kind == SeaProjectionKind::kPanorama) {
    writeFile(folder / "positions.csv", positionTable(sea, names));
  } else {
    writeFile(folder / "cameras.txt",
              fmt::format("# CAMERA_ID MODEL WIDTH HEIGHT PARAMS\n1 PINHOLE {} {} {} {} {} {}\n", projection.width,
                          projection.height, projection.focal.x, projection.focal.y, projection.center.x,
                          projection.center.y));
    writeFile(folder / "images.txt", colmapImages(sea, names));
  }
  if (!sea.proxy().mesh().empty()) {
    writePly(folder / "proxy.ply", sea.proxy().mesh());
  }
  // Within each range in order: neighbours hang on the same image.
  parallelFor(sea.count(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const std::filesystem::path path = pathInFolder(folder, names[i], "the names of the sea's images");
      writePng(path, sea.image(static_cast<uint32_t>(i)));
    }
    report(progress, "writing images", static_cast<double>(end) / sea.count());
  });
}

}  // namespace ocelli
