#include "oc_core/ocri/camera_choice.h"

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/ocri/spoc_builder.h"
#include "oc_core/render/hybrid_raycast.h"
#include "oc_core/render/points.h"
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

CameraChoice namedCamera(const std::string& name, float cellSideRadii, const std::string& where) {
  CameraChoice choice;
  choice.name = name;
  if (name == "di" || name == "ppc") {
    choice.model = CameraChoice::Model::kDepthImage;
  } else if (name == "rppc") {
    choice.model = CameraChoice::Model::kReversePinhole;
  } else if (name == "spoc") {
    choice.model = CameraChoice::Model::kSpoc;
  } else if (name == "ddoc") {
    choice.model = CameraChoice::Model::kDdoc;
  } else if (name == "ddoc-constant") {
    choice.model = CameraChoice::Model::kDdoc;
    choice.ddoc = DdocOptions::paper();
  } else if (name == "cell") {
    choice.model = CameraChoice::Model::kCell;
  } else {
    throw InputError("there is no camera \"" + name + "\"", where,
                     "use " + listOfNames() + ", or a JSON file with a \"camera\" field");
  }
  choice.ddoc.cellSideRadii = cellSideRadii;
  choice.cell.cell.sideRadii = cellSideRadii;
  return choice;
}

constexpr double kLeastCellSide = 1e-3;
constexpr double kMostCellSide = 100;

void readCellOptions(JsonFields& fields, CellOptions& options) {
  options.cell.sideRadii =
      static_cast<float>(fields.number("cell_side_radii", kLeastCellSide, kMostCellSide, options.cell.sideRadii));
  options.mostSamples = static_cast<float>(fields.number("most_samples", 1, 100, options.mostSamples));
  options.mostSatellites = fields.integer("most_satellites", 0, 1000, options.mostSatellites);
}

void readDdocOptions(JsonFields& fields, DdocOptions& options) {
  const auto readFloat = [&](const char* name, double least, double most, float& value) {
    value = static_cast<float>(fields.number(name, least, most, value));
  };
  if (fields.has("constant_radius_pixels")) {
    options.radius = DdocOptions::Radius::kConstant;
    readFloat("constant_radius_pixels", 0, 1000, options.constantRadiusPixels);
  }
  readFloat("cell_side_radii", kLeastCellSide, kMostCellSide, options.cellSideRadii);
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
      {"rppc", "reverse pinhole: its straight rays meet behind the scene"},
      {"spoc", "single pole occlusion camera around the foreground"},
      {"ddoc", "depth discontinuity occlusion camera, radii from the view cell"},
      {"cell", "view-region occlusion camera: what is seen from anywhere in the view cell, in one image"},
      {"ddoc-constant", "the same as the dissertation has it, with a constant radius of 15 pixels"},
  };
  return names;
}

CameraChoice cameraChoice(const std::string& nameOrFile, float cellSideRadii) {
  if (!nameOrFile.ends_with(".json")) {
    return namedCamera(nameOrFile, cellSideRadii, "--camera");
  }
  const nlohmann::json json = readJsonFile(nameOrFile);
  JsonFields fields(json, nameOrFile);
  CameraChoice choice = namedCamera(fields.text("camera"), cellSideRadii, nameOrFile + ", field \"camera\"");
  choice.name = fields.text("name", choice.name);
  if (choice.model == CameraChoice::Model::kDdoc) {
    readDdocOptions(fields, choice.ddoc);
  } else if (choice.model == CameraChoice::Model::kCell) {
    readCellOptions(fields, choice.cell);
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
    case CameraChoice::Model::kReversePinhole:
      return {finished(buildReversePinholeImage(buildReversePinhole(reference, mesh), reference, mesh), choice)};
    case CameraChoice::Model::kSpoc:
      return {finished(buildSpocImage(buildSpocCamera(reference, mesh), mesh), choice)};
    case CameraChoice::Model::kDdoc:
      return {finished(buildDdocImage(reference, mesh, choice.ddoc, progress), choice)};
    case CameraChoice::Model::kCell:
      return {finished(buildCellImage(buildCellCamera(reference, mesh, choice.cell, progress), mesh), choice)};
  }
  OC_CHECK(false, "every camera model has a builder");
}

ReferenceImage drawReferenceImage(Technique technique, const CameraChoice& choice, const PinholeCamera& reference,
                                  const Mesh& mesh, const Progress& progress) {
  requireOutside(mesh, reference.eye(), "view");
  const auto draw = [&](const BoundedCamera auto& camera) {
    const auto fragments = [&] {
      switch (technique) {
        case Technique::kPoints:
          return renderPoints(camera, mesh);
        case Technique::kHybrid:
          return hybridRaycast(camera, mesh);
        case Technique::kRaycast:
          return raycast(camera, mesh, RayScene(mesh));
      }
      OC_CHECK(false, "every technique draws");
    };
    return finished(referenceImage(fragments(), mesh, reference, choice.name), choice);
  };
  switch (choice.model) {
    case CameraChoice::Model::kDepthImage:
      return draw(reference);
    case CameraChoice::Model::kReversePinhole:
      return draw(buildReversePinhole(reference, mesh));
    case CameraChoice::Model::kSpoc:
      return draw(buildSpocCamera(reference, mesh));
    case CameraChoice::Model::kDdoc:
      return draw(buildDdocCamera(reference, mesh, choice.ddoc, progress));
    case CameraChoice::Model::kCell: {
      if (technique != Technique::kRaycast) {
        throw InputError(
            "camera \"" + choice.name + "\" is drawn from several viewpoints, not by points or hybrid rays", "--method",
            "use raster or raycast");
      }
      const CellCamera camera = buildCellCamera(reference, mesh, choice.cell, progress);
      return finished(cellImage(camera, raycast(camera, mesh, RayScene(mesh)), mesh), choice);
    }
  }
  OC_CHECK(false, "every camera model is drawn");
}

ReferenceImage raycastReferenceImage(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh,
                                     const Progress& progress) {
  return drawReferenceImage(Technique::kRaycast, choice, reference, mesh, progress);
}

}  // namespace ocelli
