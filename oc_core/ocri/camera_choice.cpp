#include "oc_core/ocri/camera_choice.h"

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/render/raycast.h"
#include "oc_core/scene/winding_number.h"

namespace ocelli {
namespace {

std::string listOfNames() {
  std::string names;
  for (const CameraName& camera : cameraNames()) {
    names += names.empty() ? camera.name : std::string(", ") + camera.name;
  }
  return names;
}

CameraChoice namedCamera(const std::string& name, const std::string& where) {
  CameraChoice choice;
  choice.name = name;
  if (name == "di" || name == "ppc") {
    choice.model = CameraChoice::Model::kDepthImage;
  } else if (name == "ddoc") {
    choice.model = CameraChoice::Model::kDdoc;
  } else if (name == "ddoc-constant") {
    choice.model = CameraChoice::Model::kDdoc;
    choice.ddoc = DdocOptions::paper();
  } else {
    throw InputError("there is no camera \"" + name + "\"", where,
                     "use " + listOfNames() + ", or a JSON file with a \"camera\" field");
  }
  return choice;
}

void readDdocOptions(JsonFields& fields, DdocOptions& options) {
  const auto readFloat = [&](const char* name, double least, double most, float& value) {
    value = static_cast<float>(fields.number(name, least, most, value));
  };
  if (fields.has("constant_radius_pixels")) {
    options.radius = DdocOptions::Radius::kConstant;
    readFloat("constant_radius_pixels", 0, 1000, options.constantRadiusPixels);
  }
  readFloat("cell_side_radii", 1e-3, 100, options.cellSideRadii);
  readFloat("safety_factor", 0.01, 100, options.safetyFactor);
  readFloat("most_hidden_pixels", 0, 1000, options.mostHiddenPixels);
  readFloat("room_per_hidden", 0.01, 100, options.roomPerHidden);
  readFloat("most_hidden_per_room", 0.01, 100, options.mostHiddenPerRoom);
  readFloat("steepest_band_growth", 0, 1000, options.steepestBandGrowth);
  readFloat("smoothing_sigma_pixels", 0, 50, options.smoothingSigmaPixels);
  options.feedbackRounds = fields.integer("feedback_rounds", 0, 1000, options.feedbackRounds);
  readFloat("feedback_shrink", 0, 1, options.feedbackShrink);
  readFloat("harmless_per_hidden_pixel", 0, 1000, options.harmlessPerHiddenPixel);
  readFloat("longest_edge_pixels", 0.1, 100, options.subdivision.longestEdgePixels);
}

ReferenceImage finished(ReferenceImage image, const CameraChoice& choice) {
  if (image.sampleCount() == 0) {
    throw InputError("the view sees nothing of the scene", "view",
                     "turn \"target\" towards the scene; a fitted scene lies in the unit sphere around the origin");
  }
  image.camera = choice.name;
  return image;
}

}  // namespace

const std::vector<CameraName>& cameraNames() {
  static const std::vector<CameraName> names{
      {"di", "depth image of the planar pinhole camera (ppc is the same)"},
      {"ddoc", "depth discontinuity occlusion camera, radii from the view cell"},
      {"ddoc-constant", "the same as the dissertation has it, with a constant radius of 15 pixels"},
  };
  return names;
}

CameraChoice cameraChoice(const std::string& nameOrFile, float cellSideRadii) {
  if (!nameOrFile.ends_with(".json")) {
    CameraChoice choice = namedCamera(nameOrFile, "--camera");
    choice.ddoc.cellSideRadii = cellSideRadii;
    return choice;
  }
  const nlohmann::json json = readJsonFile(nameOrFile);
  JsonFields fields(json, nameOrFile);
  CameraChoice choice = namedCamera(fields.text("camera"), nameOrFile + ", field \"camera\"");
  choice.ddoc.cellSideRadii = cellSideRadii;
  choice.name = fields.text("name", choice.name);
  if (choice.model == CameraChoice::Model::kDdoc) {
    readDdocOptions(fields, choice.ddoc);
  }
  fields.rejectUnknown();
  return choice;
}

ReferenceImages buildReferenceImages(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh,
                                     const Progress& progress) {
  requireOutside(mesh, reference.eye(), "view");
  switch (choice.model) {
    case CameraChoice::Model::kDepthImage:
      return {finished(buildDepthImage(reference, mesh), choice)};
    case CameraChoice::Model::kDdoc:
      return {finished(buildDdocImage(reference, mesh, choice.ddoc, progress), choice)};
  }
  OC_CHECK(false, "every camera model has a builder");
}

ReferenceImage raycastReferenceImage(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh,
                                     const Progress& progress) {
  requireOutside(mesh, reference.eye(), "view");
  const RayScene scene(mesh);
  const auto cast = [&](const Camera auto& camera) {
    return finished(referenceImage(raycast(camera, mesh, scene), mesh, reference, choice.name), choice);
  };
  switch (choice.model) {
    case CameraChoice::Model::kDepthImage:
      return cast(reference);
    case CameraChoice::Model::kDdoc:
      return cast(buildDdocCamera(reference, mesh, choice.ddoc, progress));
  }
  OC_CHECK(false, "every camera model has a builder");
}

}  // namespace ocelli
