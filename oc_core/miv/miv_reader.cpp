#include "oc_core/miv/miv_reader.h"

#include <fmt/format.h>

#include <cmath>

#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/miv/miv_pose.h"
#include "oc_core/miv/miv_samples.h"

namespace ocelli {
namespace {

constexpr double kMaxMetres = 1e6;
constexpr int kMaxMivViews = 1000;

std::array<double, 3> threeOf(JsonFields& fields, const char* name, double most) {
  const std::vector<double> numbers = fields.numbers(name, 3, -most, most);
  return {numbers[0], numbers[1], numbers[2]};
}

std::string frameOf(const std::filesystem::path& file, int width, int height) {
  std::string bytes = readFile(file);
  if (bytes.size() != mivFrameBytes(width, height)) {
    throw InputError(fmt::format("it has {} bytes, and a frame of {}x{} has {}", bytes.size(), width, height,
                                 mivFrameBytes(width, height)),
                     file.string(), "write it again with ocelli sea export --miv");
  }
  return bytes;
}

/// Field of view and shift from what the image of a pinhole looks like.
void setPinhole(JsonFields& fields, int width, int height, View& view) {
  const std::vector<double> focal = fields.numbers("Focal", 2, 1e-3, 1e9);
  const std::vector<double> center = fields.numbers("Principle_point", 2, -1e6, 1e6);
  if (focal[0] != focal[1]) {
    fields.fail("Focal", "must be the same along both axes");
  }
  view.fovVerticalDegrees = degreesFromRadians(2 * std::atan(height / 2.0 / focal[0]));
  view.centerShift = glm::vec2((center[0] - width / 2.0) / height, (center[1] - height / 2.0) / height);
}

MivView readMivView(JsonFields& fields, const std::filesystem::path& folder, double unitsPerMetre) {
  MivView view;
  view.name = fields.shortText("Name", 100);
  MivPose pose;
  pose.position = threeOf(fields, "Position", kMaxMetres);
  pose.rotation = threeOf(fields, "Rotation", 360);
  fields.integer("Depthmap", 1, 1);
  fields.integer("Background", 0, 0);
  const std::vector<double> range = fields.numbers("Depth_range", 2, 0, kMivInfinityMetres);
  if (!(range[0] > 0 && range[0] < range[1])) {
    fields.fail("Depth_range", "must be a near that is positive, and a far that is more");
  }
  if (!fields.boolean("HasInvalidDepth", false)) {
    fields.fail("HasInvalidDepth", "must be true: level 0 is nothing");
  }
  const std::vector<double> size = fields.numbers("Resolution", 2, 2, PinholeCamera::kMaxPixelsASide);
  const int width = static_cast<int>(size[0]);
  const int height = static_cast<int>(size[1]);
  if (width != size[0] || height != size[1] || int64_t{width} * height > PinholeCamera::kMaxPixels) {
    fields.fail("Resolution", "must be whole numbers, of 2^26 pixels at most");
  }
  View pinhole;
  view.isPanorama = fields.choice("Projection", {"Perspective", "Equirectangular"}) == "Equirectangular";
  if (view.isPanorama) {
    if (fields.numbers("Hor_range", 2, -180, 180) != std::vector<double>{-180, 180} ||
        fields.numbers("Ver_range", 2, -90, 90) != std::vector<double>{-90, 90}) {
      fields.fail("Hor_range", "must be all around: -180 to 180, and -90 to 90");
    }
    pinhole.fovVerticalDegrees = 90;
  } else {
    setPinhole(fields, width, height, pinhole);
  }
  fields.integer("BitDepthColor", kMivColorBits, kMivColorBits);
  fields.integer("BitDepthDepth", kMivDepthBits, kMivDepthBits);
  fields.choice("ColorSpace", {"YUV420"});
  fields.choice("DepthColorSpace", {"YUV420"});
  view.view = viewOfMivPose(pose, unitsPerMetre, pinhole);
  view.color =
      colorsOfMivTexture(frameOf(folder / mivTextureFile(view.name, width, height), width, height), width, height);
  view.depth = depthsOfMivDepth(frameOf(folder / mivDepthFile(view.name, width, height), width, height), width, height,
                                {range[0], range[1]}, unitsPerMetre);
  return view;
}

}  // namespace

MivSequence readMivSequence(const std::filesystem::path& file, double unitsPerMetre) {
  return readAs("docs/views_with_depth.md", [&] {
    const JsonDocument document(readFile(file, kMaxTextBytes), file.string());
    JsonFields fields(document);
    MivSequence sequence;
    sequence.unitsPerMetre = unitsPerMetre;
    fields.choice("Version", {"4.0"});
    sequence.content = fields.shortText("Content_name", 100);
    threeOf(fields, "BoundingBox_center", kMaxMetres);
    fields.number("Fps", 1, 1000);
    fields.integer("Frames_number", 1, 1);
    if (!fields.boolean("lengthsInMeters", false)) {
      fields.fail("lengthsInMeters", "must be true");
    }
    const std::vector<std::string> names = fields.texts("sourceCameraNames", 1, kMaxMivViews, 100);
    fields.forEach("cameras", 1, kMaxMivViews, [&](JsonFields& each) {
      sequence.views.push_back(readMivView(each, file.parent_path(), unitsPerMetre));
      const size_t place = sequence.views.size() - 1;
      if (place >= names.size() || names[place] != sequence.views.back().name) {
        each.fail("Name", "must be that of sourceCameraNames at the same place");
      }
    });
    fields.rejectUnknown();
    if (names.size() != sequence.views.size()) {
      fields.fail("sourceCameraNames", "must name as many as there are cameras");
    }
    validate(sequence);
    return sequence;
  });
}

}  // namespace ocelli
