// What can stand for a scene: one row a kind, and nothing else in the toolkit asks which kind it has.
//
// A program outside of the tree registers a row of its own with registerRepresentation():
// examples/add_a_representation. The row of a camera is castRepresentation() of cast_representation.h:
// examples/add_a_camera.
//
// Recipe for a new representation, two places:
//   1. oc_core/ocri/NAME_builder.h and .cpp: what builds its reference images.
//   2. oc_core/ocri/representation_kinds.cpp: its row.
// Options of its own stand in CameraChoice (camera_choice.h) and are described in oc_core/ocri/camera_option.cpp.
// tests/ocri/camera_choice_test.cpp runs over all rows; tests/ocri/camera_schema_test.cpp then says what
// oc_core/ocri/camera.schema.json and docs/cameras.md lack.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "oc_core/base/registry.h"
#include "oc_core/camera/ray_hull.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/camera_option.h"
#include "oc_core/ocri/set_difference.h"

namespace ocelli {

/// What builders get. `renderer` draws the images that the construction takes, where it is not null.
struct RepresentationInputs {
  const CameraChoice& choice;
  const PinholeCamera& reference;
  const Mesh& mesh;
  const Progress& progress;
  const SceneRenderer* renderer = nullptr;
};

/// What of a scene a construction may look at, beside what the reference view shows.
struct ViewedPart {
  float reach = 0;         ///< its viewpoints lie within this distance of the reference eye, display radii
  float marginPixels = 0;  ///< it sees no farther than this beside the reference's image
  float detail = 1;        ///< samples for each one of the reference image, along either axis, where they are densest
};

/// Between the pixels of an image and the world, both ways: a camera whose type is not known.
struct CameraMap {
  RayFunction ray;
  Projection project;
  glm::ivec2 size{0};        ///< of its image; 0 where a row from outside does not tell it
  RayHull hull = {};         ///< where its rays run; empty where that is not known
  bool wrapsAround = false;  ///< the last column of its image is next to the first
  bool isSmooth = false;     ///< kHasSmoothRays
};

/// One map for each of the images that buildReferenceImages() makes of this choice: as cameraRays(), which are their
/// rays.
std::vector<CameraMap> cameraMaps(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh,
                                  const ReferenceImages& images, const Progress& progress = {});

/// The same of what is no mesh, for images that were built of `target`.
std::vector<CameraMap> cameraMaps(const CameraChoice& choice, const PinholeCamera& reference,
                                  const TargetRenderer& target, const ReferenceImages& images,
                                  const Progress& progress = {});

/// The images of an eye that moves, each from what the last one knew. Called by one thread at a time.
class ImageSequence {
 public:
  struct Next {
    ReferenceImages images;
    bool warm = false;  ///< whether it began from what the last one knew
  };
  virtual ~ImageSequence() = default;
  virtual Next next(const RepresentationInputs& inputs) = 0;
};

/// Its functions are called from any thread, and from several at once.
struct RepresentationKind {
  /// Both texts must stay until the program ends, as string literals do.
  const char* name;
  const char* description;
  /// In the order in which forms and tables show them.
  std::vector<const CameraOption*> options = {};
  /// Options that are no numbers.
  std::vector<const CameraStructure*> structures = {};
  /// What the name stands for, of that which is no option.
  std::function<void(CameraChoice&)> prepare = {};
  /// Another name of the same; empty for none.
  const char* otherName = "";
  /// Names that end in another number: "ldi-N" for N up to this, beside the row's own; 0 for none.
  int maxCount = 0;
  /// The reference images; empty for what is a mesh alone.
  std::function<ReferenceImages(const RepresentationInputs&)> images = {};
  /// What makes them for an eye that moves; empty where each is made by itself.
  std::function<std::unique_ptr<ImageSequence>()> sequence = {};
  /// What is a mesh alone, of so many triangles as the depth image's mesh has.
  std::function<Mesh(const Mesh& mesh, size_t triangles)> mesh = {};
  /// Triangles from which on rays are faster; nothing where it is built by rasterisation only.
  std::optional<size_t> rayCrossover = {};
  /// Of a scene that moves: what refitting the acceleration structure takes, as a share of drawing the triangles.
  double refitShare = RefitShare::kOther;
  /// Directions of the view segments that it is made for; empty where it is made for a cell, or the reference eye.
  std::function<std::vector<glm::vec3>(const CameraChoice&)> segments = {};
  /// What it looks at, where that is less than the whole scene; empty, or nothing: the whole scene.
  std::function<std::optional<ViewedPart>(const CameraChoice&, const PinholeCamera& reference)> viewed = {};
  /// The image drawn in another way; empty where there is one way only. Throws InputError for ways that it lacks.
  std::function<ReferenceImage(Technique, const RepresentationInputs&)> draw = {};
  /// The map of each image. Builds the cameras, so it takes about as long.
  std::function<std::vector<CameraMap>(const RepresentationInputs&, const ReferenceImages&)> maps = {};
  /// Where its image has samples more densely, of a camera that is a pinhole otherwise (gpc_camera.h).
  std::function<GpcLayout(const CameraChoice&)> layout = {};
  /// Whether no renderer draws it but along its rays: `auto` then makes the acceleration structure too.
  bool castsRays = false;
  /// Whether its camera is made from the reference view and the options alone, whatever the scene.
  bool ofViewAlone = false;
  /// Why OpenGL cannot draw it; empty where it can.
  const char* needsCpu = "";
  /// Whether its rays begin around the eye of the reference view, which must not lie inside an object then.
  bool seesFromReference = true;
};

/// The rows, in the order of the list that users see: the built-in ones, then those that were registered. A row stays
/// where it is until the program ends. Any thread may call it at any time.
Rows<RepresentationKind> representationKinds();

/// The row that answers to a name, and the number at the end of the name, where it is one of several ("ldi-7"), or 0;
/// nothing where none does.
struct NamedRepresentation {
  const RepresentationKind* kind;
  int count = 0;
};
std::optional<NamedRepresentation> findRepresentation(std::string_view name);

/// Adds a row. From then on cameraChoice() knows its name, and everything that takes a CameraChoice takes it: builders,
/// evaluation, the viewer's list, cameraSchemaText(). Any thread may call it at any time; it is best done before
/// anything else, as lists that were made before lack it. Throws InputError where the name is empty, ends in ".json",
/// or some row answers to it already ("di", "ppc", "ldi-7"), and where the row has both `images` and `mesh`, or
/// neither.
void registerRepresentation(RepresentationKind kind);

}  // namespace ocelli
