// From what a user writes after `--camera` to a reference image: a name, a JSON file with a name and options
// (camera.schema.json), or the file of a ray map (oc_core/ray_map).
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/camera/gpc_layout.h"
#include "oc_core/ocri/cell_builder.h"
#include "oc_core/ocri/construction.h"
#include "oc_core/ocri/ddoc_builder.h"
#include "oc_core/ocri/eoc_builder.h"
#include "oc_core/ocri/reference_image.h"
#include "oc_core/ocri/spoc_builder.h"

namespace ocelli {

class JsonFields;
class TargetRenderer;
struct RepresentationKind;
class RayMap;
class ImageSequence;

/// A representation with its options; the depth image of the reference view by default.
struct CameraChoice {
  CameraChoice();

  const RepresentationKind* kind;
  std::string name;  ///< what tables and files call it
  int count = 0;     ///< of corners, or layers
  float cellSideRadii = 1.6f;
  glm::vec3 segmentDirection{1, 0, 0};  ///< of an EOC: right, up and backward in the reference view
  SpocOptions spoc;
  EocOptions eoc;
  DdocOptions ddoc;
  CellOptions cell;
  GpcLayout gpc;
  /// Options that registered representations have of their own, by name; 0 where `prepare` of the row sets no other
  /// default.
  std::map<std::string, float> ownOptions;
  /// Of a ray map (ray_map_kind.h) its rays.
  std::shared_ptr<const RayMap> rayMap;

  /// Whether there are reference images; otherwise only buildRepresentation() makes it.
  bool hasImages() const;
  /// Whether it is made for a view segment along `segmentDirection`, and not for a cell.
  bool isForSegment() const;
};

struct CameraName {
  const char* name;
  const char* description;
};

/// The names that cameraChoice() knows now.
std::vector<CameraName> cameraNames();

/// Whether that is a name that cameraChoice() knows, or one of a file that it reads.
bool namesCamera(const std::string& nameOrFile);

/// A camera that is built for a view cell takes this one (all but the cell camera its size alone), unless its file
/// sets another. Throws InputError for an unknown name, and for a file that is wrong.
CameraChoice cameraChoice(const std::string& nameOrFile, const ViewCell& cell = {});

/// The same from the fields of an object: what stands in such a file. Others are left for the caller to ask for, and to
/// reject. Throws InputError naming the field.
CameraChoice readCameraChoice(JsonFields& fields, const ViewCell& cell = {});

/// The reference images of a camera: one, but for those that are unions. Throws InputError where the eye lies inside an
/// object, or the view sees nothing of the scene, and for choices that have no image.
ReferenceImages buildReferenceImages(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh,
                                     const Progress& progress = {});

struct StartedImages {
  size_t images = 0;
  size_t cold = 0;  ///< began by themselves, and not from what the last one knew
};

/// The reference images of an eye that moves, or of a scene that does. Each begins from what the last one knew, where
/// the row of the choice has a way to (representation_kind.h), and the eye has not jumped. Called by one thread at a
/// time.
class MovingImages {
 public:
  explicit MovingImages(CameraChoice choice);
  ~MovingImages();

  const CameraChoice& choice() const { return choice_; }
  /// By rasterisation, or by `rays` against the acceleration structure of the mesh where there is one. Throws as
  /// buildReferenceImages() does, which gives an image of about the same errors.
  ReferenceImages next(const PinholeCamera& reference, const Mesh& mesh, const RayScene* rays = nullptr,
                       const Progress& progress = {});

  /// Whether images may begin from the last one.
  bool remembers() const { return sequence_ != nullptr; }
  const StartedImages& starts() const { return starts_; }
  /// Whether the last one began by itself, though it could have begun from one before: it took longer than most.
  bool lastBeganCold() const { return lastBeganCold_; }

 private:
  CameraChoice choice_;
  std::unique_ptr<ImageSequence> sequence_;
  StartedImages starts_;
  bool lastBeganCold_ = false;
};

/// The same by rasterisation or by rays. `rays` is the acceleration structure of the mesh where one stands; where rays
/// are wanted and none does, it is built. Whether a viewpoint lies inside an object takes a look at all triangles:
/// where a structure stands, the caller must have checked that. Throws InputError where rays are wanted for a camera
/// that is built by rasterisation only.
ReferenceImages buildReferenceImages(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh,
                                     const Progress& progress, Construction wanted, const RayScene* rays,
                                     ConstructionReport* report = nullptr);

/// The same from images that `renderer` draws of the mesh, such as a GPU's renderer. Throws InputError for a camera
/// that takes other images.
ReferenceImages buildReferenceImages(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh,
                                     const Progress& progress, const SceneRenderer& renderer);

/// The same of what is no mesh: from images that `target` draws of it. Throws InputError for choices that take
/// triangles, and where the view hits nothing.
ReferenceImages buildReferenceImages(const CameraChoice& choice, const PinholeCamera& reference,
                                     const TargetRenderer& target, const Progress& progress = {});

/// How an image is drawn (section 6.1), other than as buildReferenceImages() does, with the fastest.
enum class Technique { kPoints, kHybrid, kRaycast };

/// The image of the same camera, drawn as told. Throws InputError as buildReferenceImages() does, and for cameras that
/// cannot be drawn so.
ReferenceImage drawReferenceImage(Technique technique, const CameraChoice& choice, const PinholeCamera& reference,
                                  const Mesh& mesh, const Progress& progress = {});
/// The ray of a pixel of one reference image; empty where it has none.
using RayFunction = std::function<RayPath(const glm::vec2& pixel)>;

/// One function for each of the images that buildReferenceImages() makes of this choice, in their order. Builds the
/// cameras, so it takes about as long, and throws as it does.
std::vector<RayFunction> cameraRays(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh,
                                    const ReferenceImages& images, const Progress& progress = {});

/// Cast along the rays: the reference for all others.
ReferenceImage raycastReferenceImage(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh,
                                     const Progress& progress = {});

}  // namespace ocelli
