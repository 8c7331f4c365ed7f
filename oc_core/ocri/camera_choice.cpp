#include "oc_core/ocri/camera_choice.h"

#include <algorithm>
#include <chrono>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/ocri/nothing_seen.h"
#include "oc_core/ocri/ray_map_kind.h"
#include "oc_core/ocri/representation_kind.h"
#include "oc_core/ray_map/ray_map_file.h"
#include "oc_core/render/target_renderer.h"
#include "oc_core/scene/winding_number.h"

namespace ocelli {
namespace {

std::string listOfNames() {
  std::string names;
  for (const RepresentationKind& kind : representationKinds()) {
    names += names.empty() ? kind.name : std::string(", ") + kind.name;
  }
  return names;
}

CameraChoice namedCamera(const std::string& name, const ViewCell& cell, const std::string& where) {
  const std::optional<NamedRepresentation> found = findRepresentation(name);
  if (!found) {
    throw InputError(
        "there is no camera \"" + name + "\"", where,
        "use " + listOfNames() + ", a JSON file with a \"camera\" field, or the file of a ray map, RAYS.exr");
  }
  CameraChoice choice;
  choice.kind = found->kind;
  choice.name = name;
  if (choice.kind->prepare) {
    choice.kind->prepare(choice);
  }
  choice.count = found->count > 0 ? found->count : choice.count;
  setNumber(kCellSide, choice, static_cast<double>(cell.sideRadii));
  choice.cell.cell = cell;
  return choice;
}

void readOption(JsonFields& fields, const CameraOption& option, CameraChoice& choice) {
  if (!fields.has(option.name)) {
    return;
  }
  if (isDirection(option)) {
    const std::vector<double> values = fields.numbers(option.name, 3, option.min, option.max);
    setDirection(option, choice, glm::vec3(values[0], values[1], values[2]));
  } else if (isBoolean(option)) {
    setNumber(option, choice, fields.boolean(option.name, false) ? 1 : 0);
  } else if (isInteger(option)) {
    setNumber(option, choice, fields.integer(option.name, static_cast<int>(option.min), static_cast<int>(option.max)));
  } else {
    setNumber(option, choice, fields.number(option.name, option.min, option.max));
  }
  if (option.onOff.turn != nullptr) {
    option.onOff.turn(choice, true);
  }
}

ReferenceImages finished(ReferenceImages images, const RepresentationInputs& inputs) {
  size_t samples = 0;
  for (ReferenceImage& image : images) {
    samples += image.sampleCount();
    image.camera = inputs.choice.name;
  }
  if (samples == 0 && inputs.renderer != nullptr && !inputs.renderer->hasMesh()) {
    throw InputError("no ray of the view hits the scene", "view",
                     "turn \"target\" towards it; of a volume, a lower --opacity is reached sooner");
  }
  if (samples == 0) {
    failSeeingNothing(inputs.reference, inputs.mesh, "view");
  }
  return images;
}

ReferenceImages imagesOf(const RepresentationInputs& inputs,
                         const std::function<ReferenceImages(const RepresentationInputs&)>& make) {
  const CameraChoice& choice = inputs.choice;
  const RepresentationKind& kind = *choice.kind;
  if (!kind.images) {
    throw InputError("\"" + choice.name + "\" is a mesh and has no image", "--camera",
                     "measure it with `ocelli evaluate`, or write the scene with `ocelli scene export`");
  }
  if (inputs.renderer != nullptr && inputs.renderer->rays() == nullptr && *kind.needsCpu != '\0') {
    throw InputError("camera \"" + choice.name + "\" " + kind.needsCpu, "--camera",
                     "draw it without OpenGL, or choose another camera");
  }
  return finished(make(inputs), inputs);
}

ReferenceImages imagesOf(const RepresentationInputs& inputs) {
  return imagesOf(inputs, inputs.choice.kind->images);
}

/// The eye of the view, of cameras that see from there.
void requireEyeOutside(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh) {
  if (choice.kind->seesFromReference) {
    requireOutside(mesh, reference.eye(), "view");
  }
}

/// The ends of the segments of epipolar cameras; those that rasterise check them on their own.
void requireOutsideSegments(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh) {
  if (choice.kind->segments) {
    for (const glm::vec3& direction : choice.kind->segments(choice)) {
      requireOutsideEnds(segmentAround(reference.view(), direction, choice.cellSideRadii), mesh);
    }
  }
}

}  // namespace

CameraChoice::CameraChoice() : kind(&representationKinds().front().get()), name(kind->name) {}

bool CameraChoice::hasImages() const {
  return static_cast<bool>(kind->images);
}

bool CameraChoice::isForSegment() const {
  return kind->segments && kind->segments(*this).size() == 1;
}

std::vector<CameraName> cameraNames() {
  std::vector<CameraName> names;
  for (const RepresentationKind& kind : representationKinds()) {
    names.push_back({kind.name, kind.description});
  }
  return names;
}

bool namesCamera(const std::string& nameOrFile) {
  return nameOrFile.ends_with(".json") || namesRayMap(nameOrFile) || findRepresentation(nameOrFile);
}

CameraChoice cameraChoice(const std::string& nameOrFile, const ViewCell& cell) {
  if (namesRayMap(nameOrFile)) {
    return rayMapChoice(std::make_shared<const RayMap>(readRayMap(nameOrFile)));
  }
  if (!nameOrFile.ends_with(".json")) {
    return namedCamera(nameOrFile, cell, "--camera");
  }
  return readAs("oc_core/ocri/camera.schema.json", [&] {
    const nlohmann::json json = readJsonFile(nameOrFile);
    JsonFields fields(json, nameOrFile);
    const CameraChoice choice = readCameraChoice(fields, cell);
    fields.rejectUnknown();
    return choice;
  });
}

CameraChoice readCameraChoice(JsonFields& fields, const ViewCell& cell) {
  CameraChoice choice = namedCamera(fields.text("camera"), cell, fields.where() + ", field \"camera\"");
  choice.name = fields.text("name", choice.name);
  for (const CameraOption* option : choice.kind->options) {
    readOption(fields, *option, choice);
  }
  for (const CameraStructure* structure : choice.kind->structures) {
    if (fields.has(structure->name)) {
      structure->read(fields, choice);
    }
  }
  return choice;
}

ReferenceImages buildReferenceImages(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh,
                                     const Progress& progress) {
  return buildReferenceImages(choice, reference, mesh, progress, Construction::kRaster, nullptr);
}

ReferenceImages buildReferenceImages(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh,
                                     const Progress& progress, Construction wanted, const RayScene* rays,
                                     ConstructionReport* report) {
  const std::optional<size_t> crossover = choice.kind->rayCrossover;
  if (wanted == Construction::kRays && choice.hasImages() && !crossover) {
    throw InputError("camera \"" + choice.name + "\" is not constructed by rays", "--construction",
                     "use auto or raster");
  }
  ConstructionReport done{
      .byRays = choice.kind->castsRays ||
                (crossover && constructWithRays(wanted, *crossover, mesh.triangles.size(),
                                                rays != nullptr ? RayStructure::kStands : RayStructure::kNone)),
      .triangles = mesh.triangles.size()};
  if (rays == nullptr || !done.byRays) {
    requireEyeOutside(choice, reference, mesh);
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
    return imagesOf({choice, reference, mesh, progress});
  }
  const RayRenderer renderer(mesh, *rays);
  return imagesOf({choice, reference, mesh, progress, &renderer});
}

ReferenceImages buildReferenceImages(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh,
                                     const Progress& progress, const SceneRenderer& renderer) {
  requireEyeOutside(choice, reference, mesh);
  return imagesOf({choice, reference, mesh, progress, &renderer});
}

ReferenceImages buildReferenceImages(const CameraChoice& choice, const PinholeCamera& reference,
                                     const TargetRenderer& target, const Progress& progress) {
  if (!choice.hasImages()) {
    throw InputError("\"" + choice.name + "\" is made of triangles, and this scene has none", "--camera",
                     "choose another one; of a volume, --iso VALUE makes triangles");
  }
  return imagesOf({choice, reference, target.mesh(), progress, &target});
}

MovingImages::MovingImages(CameraChoice choice)
    : choice_(std::move(choice)), sequence_(choice_.kind->sequence ? choice_.kind->sequence() : nullptr) {}

MovingImages::~MovingImages() = default;

ReferenceImages MovingImages::next(const PinholeCamera& reference, const Mesh& mesh, const RayScene* rays,
                                   const Progress& progress) {
  requireEyeOutside(choice_, reference, mesh);
  std::optional<RayRenderer> renderer;
  if (rays != nullptr) {
    requireOutsideSegments(choice_, reference, mesh);
    renderer.emplace(mesh, *rays);
  }
  return imagesOf({choice_, reference, mesh, progress, renderer ? &*renderer : nullptr},
                  [&](const RepresentationInputs& inputs) {
                    ImageSequence::Next next =
                        sequence_ ? sequence_->next(inputs) : ImageSequence::Next{choice_.kind->images(inputs)};
                    ++starts_.images;
                    starts_.cold += next.warm ? 0 : 1;
                    lastBeganCold_ = remembers() && !next.warm;
                    return std::move(next.images);
                  });
}

ReferenceImage drawReferenceImage(Technique technique, const CameraChoice& choice, const PinholeCamera& reference,
                                  const Mesh& mesh, const Progress& progress) {
  requireEyeOutside(choice, reference, mesh);
  if (!choice.kind->draw) {
    throw InputError("\"" + choice.name + "\" is drawn in one way only", "--method", "use raster");
  }
  const RepresentationInputs inputs{choice, reference, mesh, progress};
  return finished({choice.kind->draw(technique, inputs)}, inputs).front();
}

std::vector<CameraMap> cameraMaps(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh,
                                  const ReferenceImages& images, const Progress& progress) {
  return choice.kind->maps ? choice.kind->maps({choice, reference, mesh, progress}, images) : std::vector<CameraMap>{};
}

std::vector<CameraMap> cameraMaps(const CameraChoice& choice, const PinholeCamera& reference,
                                  const TargetRenderer& target, const ReferenceImages& images,
                                  const Progress& progress) {
  return choice.kind->maps ? choice.kind->maps({choice, reference, target.mesh(), progress, &target}, images)
                           : std::vector<CameraMap>{};
}

std::vector<RayFunction> cameraRays(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh,
                                    const ReferenceImages& images, const Progress& progress) {
  std::vector<RayFunction> rays;
  for (CameraMap& map : cameraMaps(choice, reference, mesh, images, progress)) {
    rays.push_back(std::move(map.ray));
  }
  return rays;
}

ReferenceImage raycastReferenceImage(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh,
                                     const Progress& progress) {
  return drawReferenceImage(Technique::kRaycast, choice, reference, mesh, progress);
}

}  // namespace ocelli
