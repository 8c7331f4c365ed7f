// A scene as `ocelli shade` takes it apart by the roles of its objects (object_roles.h).
#pragma once

#include <string>
#include <vector>

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/worlds/object_roles.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {

/// An object that sends rays on.
struct SpecularObject {
  Mesh mesh;
  std::vector<glm::vec3> normals;
  double refractiveIndex = 1;  ///< of one that refracts
};

struct ShadedScene {
  std::string source = {};  ///< as errors say it
  std::vector<SpecularObject> mirrors;
  std::vector<SpecularObject> lenses;
  Mesh cast;          ///< what depth images stand for
  Mesh billboards;    ///< what rays meet exactly, whatever stands for the rest
  Mesh surroundings;  ///< the rest, which is met through an environment map alone
  /// Of each triangle of `cast`, then of `billboards`, then of `surroundings`: whether its object has the role
  /// `receive`.
  std::vector<uint8_t> receives = {};
  /// Their panels are parts of `surroundings`.
  std::vector<AreaLight> lights = {};
};

/// The file of roles beside the file of a scene: "teapot.roles.json" beside "teapot.obj".
std::string rolesFileBeside(const std::string& source);

/// The roles: of the file, where one is given; else of the file beside the scene, if there is one, or of the built-in
/// scene. Throws InputError where nothing says them.
std::vector<RoledObject> rolesFor(const std::string& source, const std::string& rolesFile);

/// Throws InputError where a role is of an object that the scene lacks.
ShadedScene loadShadedScene(const std::string& source, const std::vector<RoledObject>& roles,
                            const SceneOptions& options = {}, const Progress& progress = {});

/// Throws InputError where nothing has the role `cast`.
void requireCast(const ShadedScene& scene);

/// The default view of a picture: from where the default view of other commands looks, towards what sends the rays,
/// and as wide as the sphere around that.
View pictureView(const Box& senders);

/// The view that a reference image of the cast objects is made for: from the middle of what sends rays to them, towards
/// them, and as wide as they are from there, with a margin. Throws InputError where they lie around that place, so that
/// no image plane holds them.
View referenceView(const Mesh& cast, const Box& senders, int width, int height);

Box boundsOf(const std::vector<SpecularObject>& objects);

}  // namespace ocelli
