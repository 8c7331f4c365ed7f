#include "oc_core/ocri/camera_choice.h"

#include <algorithm>
#include <chrono>
#include <memory>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/ocri/corner_depth_images.h"
#include "oc_core/ocri/eoc_builder.h"
#include "oc_core/ocri/layered_depth_image.h"
#include "oc_core/ocri/nothing_seen.h"
#include "oc_core/ocri/set_difference.h"
#include "oc_core/ocri/spoc_builder.h"
#include "oc_core/ocri/wide_depth_image.h"
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

struct NamedModel {
  CameraName name;
  CameraChoice::Model model;
  int count = 0;
  glm::vec3 direction = kHorizontalSegment;
};

const std::vector<NamedModel>& namedModels() {
  using Model = CameraChoice::Model;
  static const std::vector<NamedModel> models{
      {{"di", "depth image of the planar pinhole camera (ppc is the same)"}, Model::kDepthImage},
      {{"di-wide", "depth image as wide as what the view cell sees beside the reference frustum"},
       Model::kWideDepthImage},
      {{"corners-4",
        "depth images of the reference view and of the four corners of the view cell nearest to the scene"},
       Model::kCornerDepthImages,
       4},
      {{"corners-8", "the same with all eight corners"}, Model::kCornerDepthImages, 8},
      {{"ldi-4", "layered depth image of four layers (any number from ldi-1 to ldi-16)"}, Model::kLayeredDepthImage, 4},
      {{"rppc", "reverse pinhole: its straight rays meet behind the scene"}, Model::kReversePinhole},
      {{"spoc", "single pole occlusion camera around the foreground"}, Model::kSpoc},
      {{"di+spoc", "depth image, and what the single pole occlusion camera adds to it"}, Model::kSpocUnion},
      {{"ddoc", "depth discontinuity occlusion camera, radii from the view cell"}, Model::kDdoc},
      {{"ddoc-constant", "the same as the dissertation has it, with a constant radius of 15 pixels"}, Model::kDdoc},
      {{"eoc-h", "epipolar occlusion camera for a horizontal segment as long as the view cell"}, Model::kEoc},
      {{"eoc-v", "the same for a vertical segment"}, Model::kEoc, 0, kVerticalSegment},
      {{"eoc-forward", "the same for a segment along the view"}, Model::kEoc, 0, kForwardSegment},
      {{"eoc-hv", "union of eoc-h and of what eoc-v adds to it"}, Model::kCrossedEocs},
      {{"eoc-hv+ddoc", "union of eoc-hv and of what ddoc adds to it"}, Model::kCrossedEocsDdoc},
      {{"cell", "view-region occlusion camera: what is seen from anywhere in the view cell, in one image"},
       Model::kCell},
      {{"simplified", "the scene with as many triangles as the depth image's mesh: a mesh, no image"},
       Model::kSimplified},
      {{"simplified-sloppy", "the same faster, by clusters of vertices: a mesh, no image"}, Model::kSimplifiedSloppy},
      {{"geometry", "the scene itself: a mesh, no image"}, Model::kGeometry},
  };
  return models;
}

/// N of "ldi-N", 0 where it is none.
int layersFromName(const std::string& name) {
  for (int layers = 1; layers <= kMostLayers; ++layers) {
    if (name == "ldi-" + std::to_string(layers)) {
      return layers;
    }
  }
  return 0;
}

CameraChoice namedCamera(const std::string& name, const ViewCell& cell, const std::string& where) {
  const int layers = layersFromName(name);
  const std::string listed = name == "ppc" ? "di" : layers > 0 ? "ldi-4" : name;
  const auto& models = namedModels();
  const auto found =
      std::find_if(models.begin(), models.end(), [&](const NamedModel& each) { return each.name.name == listed; });
  if (found == models.end()) {
    throw InputError("there is no camera \"" + name + "\"", where,
                     "use " + listOfNames() + ", or a JSON file with a \"camera\" field");
  }
  CameraChoice choice;
  choice.model = found->model;
  choice.name = name;
  choice.count = layers > 0 ? layers : found->count;
  choice.segmentDirection = found->direction;
  choice.cellSideRadii = cell.sideRadii;
  if (name == "ddoc-constant") {
    choice.ddoc = DdocOptions::paper();
  }
  choice.ddoc.cellSideRadii = cell.sideRadii;
  choice.cell.cell = cell;
  return choice;
}

constexpr double kLeastCellSide = 1e-3;
constexpr double kMostCellSide = 100;

float readCellSide(JsonFields& fields, float otherwise) {
  return static_cast<float>(fields.number("cell_side_radii", kLeastCellSide, kMostCellSide, otherwise));
}

void readEocOptions(JsonFields& fields, CameraChoice& choice) {
  choice.cellSideRadii = readCellSide(fields, choice.cellSideRadii);
  if (fields.has("segment_direction")) {
    const std::vector<double> direction = fields.numbers("segment_direction", 3, -1, 1);
    for (int i = 0; i < 3; ++i) {
      choice.segmentDirection[i] = static_cast<float>(direction[static_cast<size_t>(i)]);
    }
  }
}

void readCellOptions(JsonFields& fields, CellOptions& options) {
  options.cell.sideRadii = readCellSide(fields, options.cell.sideRadii);
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
  options.cellSideRadii = readCellSide(fields, options.cellSideRadii);
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

ReferenceImages finished(ReferenceImages images, const CameraChoice& choice, const PinholeCamera& reference,
                         const Mesh& mesh) {
  size_t samples = 0;
  for (ReferenceImage& image : images) {
    samples += image.sampleCount();
    image.camera = choice.name;
  }
  if (samples == 0) {
    failSeeingNothing(reference, mesh, "view");
  }
  return images;
}

ReferenceImages layeredDepthImage(const PinholeCamera& reference, const Mesh& mesh, int layers) {
  ReferenceImages images = buildLayeredDepthImage(reference, mesh, layers);
  for (size_t i = 0; i < images.size(); ++i) {
    images[i].layer = static_cast<int>(i);
  }
  return images;
}

ReferenceImages spocUnion(const PinholeCamera& reference, const Mesh& mesh, const SceneDrawer* drawer) {
  ReferenceImages images{buildDepthImage(reference, mesh, drawer),
                         buildSpocImage(buildSpocCamera(reference, mesh, {}, drawer), mesh, drawer)};
  subtract(images[1], images[0], [&](const glm::vec3& point) { return reference.project(point); });
  images[1].triangleBound = 0;
  return images;
}

/// Two EOCs whose segments cross at the reference eye, and a DDOC if wanted; each without what those before it hold.
ReferenceImages crossedEocs(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh, bool withDdoc,
                            const Progress& progress, const SceneDrawer* drawer) {
  ReferenceImages images;
  std::vector<Projection> projections;
  const auto add = [&](ReferenceImage image, Projection projection) {
    for (size_t i = 0; i < images.size(); ++i) {
      subtract(image, images[i], projections[i]);
    }
    image.triangleBound = 0;
    images.push_back(std::move(image));
    projections.push_back(std::move(projection));
  };
  for (const glm::vec3& direction : {kHorizontalSegment, kVerticalSegment}) {
    const ViewSegment segment = segmentAround(reference.view(), direction, choice.cellSideRadii);
    const auto camera = std::make_shared<EpipolarCamera>(buildEpipolarCamera(reference, segment, mesh, {}, drawer));
    add(buildEocImage(*camera, mesh, drawer), [camera](const glm::vec3& point) { return camera->project(point); });
  }
  if (withDdoc) {
    const auto camera = std::make_shared<DdocCamera>(buildDdocCamera(reference, mesh, choice.ddoc, progress, drawer));
    add(buildDdocImage(*camera, mesh, choice.ddoc.subdivision, drawer),
        [camera](const glm::vec3& point) { return camera->project(point); });
  }
  return images;
}

ReferenceImages imagesOf(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh,
                         const Progress& progress, const SceneDrawer* drawer) {
  const ViewCell cell{.sideRadii = choice.cellSideRadii};
  switch (choice.model) {
    case CameraChoice::Model::kDepthImage:
      return {buildDepthImage(reference, mesh, drawer)};
    case CameraChoice::Model::kWideDepthImage:
      return {buildWideDepthImage(reference, mesh, wideFactor(reference, mesh, cell), drawer)};
    case CameraChoice::Model::kCornerDepthImages:
      return buildCornerDepthImages(reference, mesh, cell, choice.count, drawer);
    case CameraChoice::Model::kLayeredDepthImage:
      if (drawer != nullptr) {
        throw InputError("camera \"" + choice.name + "\" peels layers, which only rasterisation on the processor does",
                         "--camera", "draw it without OpenGL, or choose another camera");
      }
      return layeredDepthImage(reference, mesh, choice.count);
    case CameraChoice::Model::kReversePinhole:
      return {buildReversePinholeImage(buildReversePinhole(reference, mesh, drawer), reference, mesh, drawer)};
    case CameraChoice::Model::kSpoc:
      return {buildSpocImage(buildSpocCamera(reference, mesh, {}, drawer), mesh, drawer)};
    case CameraChoice::Model::kSpocUnion:
      return spocUnion(reference, mesh, drawer);
    case CameraChoice::Model::kDdoc:
      return {buildDdocImage(reference, mesh, choice.ddoc, progress, drawer)};
    case CameraChoice::Model::kEoc:
      return {buildEocImage(reference, segmentAround(reference.view(), choice.segmentDirection, choice.cellSideRadii),
                            mesh, {}, drawer)};
    case CameraChoice::Model::kCrossedEocs:
      return crossedEocs(choice, reference, mesh, false, progress, drawer);
    case CameraChoice::Model::kCrossedEocsDdoc:
      return crossedEocs(choice, reference, mesh, true, progress, drawer);
    case CameraChoice::Model::kCell:
      return {buildCellImage(buildCellCamera(reference, mesh, choice.cell, progress, drawer), mesh, drawer)};
    case CameraChoice::Model::kSimplified:
    case CameraChoice::Model::kSimplifiedSloppy:
    case CameraChoice::Model::kGeometry:
      throw InputError("\"" + choice.name + "\" is a mesh and has no image", "--camera",
                       "measure it with `ocelli evaluate`, or write the scene with `ocelli scene export`");
  }
  OC_CHECK(false, "every camera model has a builder");
}

/// Triangles from which on rays are faster; nothing for models that are built by rasterisation only.
std::optional<size_t> rayCrossover(CameraChoice::Model model) {
  switch (model) {
    case CameraChoice::Model::kDepthImage:
      return RayCrossover::kDepthImage;
    case CameraChoice::Model::kSpoc:
    case CameraChoice::Model::kSpocUnion:
      return RayCrossover::kSpoc;
    case CameraChoice::Model::kDdoc:
      return RayCrossover::kDdoc;
    case CameraChoice::Model::kEoc:
    case CameraChoice::Model::kCrossedEocs:
    case CameraChoice::Model::kCrossedEocsDdoc:
      return RayCrossover::kEoc;
    case CameraChoice::Model::kCell:
      return RayCrossover::kCell;
    case CameraChoice::Model::kWideDepthImage:
    case CameraChoice::Model::kCornerDepthImages:
    case CameraChoice::Model::kLayeredDepthImage:
    case CameraChoice::Model::kReversePinhole:
    case CameraChoice::Model::kSimplified:
    case CameraChoice::Model::kSimplifiedSloppy:
    case CameraChoice::Model::kGeometry:
      return std::nullopt;
  }
  OC_CHECK(false, "every camera model is known");
}

/// The ends of the segments of epipolar cameras; those that rasterise check them on their own.
void requireOutsideSegments(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh) {
  std::vector<glm::vec3> directions;
  if (choice.model == CameraChoice::Model::kEoc) {
    directions = {choice.segmentDirection};
  } else if (choice.model == CameraChoice::Model::kCrossedEocs ||
             choice.model == CameraChoice::Model::kCrossedEocsDdoc) {
    directions = {kHorizontalSegment, kVerticalSegment};
  }
  for (const glm::vec3& direction : directions) {
    requireOutsideEnds(segmentAround(reference.view(), direction, choice.cellSideRadii), mesh);
  }
}

}  // namespace

const std::vector<CameraName>& cameraNames() {
  static const std::vector<CameraName> names = [] {
    std::vector<CameraName> all;
    for (const NamedModel& each : namedModels()) {
      all.push_back(each.name);
    }
    return all;
  }();
  return names;
}

CameraChoice cameraChoice(const std::string& nameOrFile, const ViewCell& cell) {
  if (!nameOrFile.ends_with(".json")) {
    return namedCamera(nameOrFile, cell, "--camera");
  }
  return readAs("oc_core/ocri/camera.schema.json", [&] {
    const nlohmann::json json = readJsonFile(nameOrFile);
    JsonFields fields(json, nameOrFile);
    CameraChoice choice = namedCamera(fields.text("camera"), cell, nameOrFile + ", field \"camera\"");
    choice.name = fields.text("name", choice.name);
    if (choice.model == CameraChoice::Model::kDdoc) {
      readDdocOptions(fields, choice.ddoc);
    } else if (choice.model == CameraChoice::Model::kCell) {
      readCellOptions(fields, choice.cell);
    } else if (choice.model == CameraChoice::Model::kEoc) {
      readEocOptions(fields, choice);
    } else if (choice.model == CameraChoice::Model::kWideDepthImage ||
               choice.model == CameraChoice::Model::kCornerDepthImages ||
               choice.model == CameraChoice::Model::kCrossedEocs ||
               choice.model == CameraChoice::Model::kCrossedEocsDdoc) {
      choice.cellSideRadii = readCellSide(fields, choice.cellSideRadii);
    }
    fields.rejectUnknown();
    return choice;
  });
}

ReferenceImages buildReferenceImages(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh,
                                     const Progress& progress) {
  return buildReferenceImages(choice, reference, mesh, progress, Construction::kRaster, nullptr);
}

ReferenceImages buildReferenceImages(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh,
                                     const Progress& progress, Construction wanted, const RayScene* rays,
                                     ConstructionReport* report) {
  const std::optional<size_t> crossover = rayCrossover(choice.model);
  if (wanted == Construction::kRays && choice.hasImages() && !crossover) {
    throw InputError("camera \"" + choice.name + "\" is not constructed by rays", "--construction",
                     "use auto or raster");
  }
  ConstructionReport done{
      .byRays = crossover && constructWithRays(wanted, *crossover, mesh.triangles.size(), rays != nullptr),
      .triangles = mesh.triangles.size()};
  if (rays == nullptr || !done.byRays) {
    requireOutside(mesh, reference.eye(), "view");
  }
  std::optional<RayScene> built;
  if (done.byRays && rays == nullptr) {
    requireOutsideSegments(choice, reference, mesh);
    ocelli::report(progress, "acceleration structure", 0);
    const auto start = std::chrono::steady_clock::now();
    built.emplace(mesh);
    done.buildSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    rays = &*built;
  }
  if (report != nullptr) {
    *report = done;
  }
  if (!done.byRays) {
    return finished(imagesOf(choice, reference, mesh, progress, nullptr), choice, reference, mesh);
  }
  const RayDrawer drawer(mesh, *rays);
  return finished(imagesOf(choice, reference, mesh, progress, &drawer), choice, reference, mesh);
}

ReferenceImages buildReferenceImages(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh,
                                     const Progress& progress, const SceneDrawer& drawer) {
  requireOutside(mesh, reference.eye(), "view");
  return finished(imagesOf(choice, reference, mesh, progress, &drawer), choice, reference, mesh);
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
    return finished({referenceImage(fragments(), mesh, reference, choice.name)}, choice, reference, mesh).front();
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
      return finished({cellImage(camera, raycast(camera, mesh, RayScene(mesh)), mesh)}, choice, reference, mesh)
          .front();
    }
    case CameraChoice::Model::kEoc: {
      if (technique != Technique::kRaycast) {
        throw InputError("camera \"" + choice.name + "\" is drawn by epipolar spans or ray casting", "--method",
                         "use raster or raycast");
      }
      const EpipolarCamera camera = buildEpipolarCamera(
          reference, segmentAround(reference.view(), choice.segmentDirection, choice.cellSideRadii), mesh);
      return finished({eocImage(raycast(camera, mesh, RayScene(mesh)), camera, mesh)}, choice, reference, mesh).front();
    }
    case CameraChoice::Model::kWideDepthImage:
    case CameraChoice::Model::kCornerDepthImages:
    case CameraChoice::Model::kLayeredDepthImage:
    case CameraChoice::Model::kSpocUnion:
    case CameraChoice::Model::kCrossedEocs:
    case CameraChoice::Model::kCrossedEocsDdoc:
    case CameraChoice::Model::kSimplified:
    case CameraChoice::Model::kSimplifiedSloppy:
    case CameraChoice::Model::kGeometry:
      throw InputError("\"" + choice.name + "\" is drawn in one way only", "--method", "use raster");
  }
  OC_CHECK(false, "every camera model is drawn");
}

ReferenceImage raycastReferenceImage(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh,
                                     const Progress& progress) {
  return drawReferenceImage(Technique::kRaycast, choice, reference, mesh, progress);
}

}  // namespace ocelli
