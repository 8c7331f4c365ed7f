// A scene as `ocelli shade` takes it apart by the roles of its objects (object_roles.h).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/shade/tiled_scene.h"
#include "oc_core/worlds/object_roles.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {

/// An object that sends rays on.
struct SpecularObject {
  Mesh mesh;
  std::vector<glm::vec3> normals;
  double refractiveIndex = 1;  ///< of one that refracts
  bool isCast = false;         ///< of one that mirrors: whether rays of others meet it, through depth images
};

struct ShadedScene {
  std::string source = {};  ///< as errors say it
  std::vector<SpecularObject> mirrors;
  std::vector<SpecularObject> lenses;
  Mesh cast;          ///< what depth images stand for, but for mirrors among it
  Mesh billboards;    ///< what rays meet exactly, whatever stands for the rest
  Mesh surroundings;  ///< the rest, which is met through an environment map alone
  /// Of each triangle of `cast`, then of `billboards`, then of `surroundings`: whether its object has the role
  /// `receive`.
  std::vector<uint8_t> receives = {};
  /// Their panels are parts of `surroundings`.
  std::vector<AreaLight> lights = {};
  /// All objects together, with the guides of the scene: for light from all sides, and for constructors of cameras.
  /// Objects that come to the scene have identities above its own.
  GuidedScene whole = {};
  std::vector<uint32_t> rolesOfTriangle = {};  ///< of `whole`: bits of object_roles.h
  /// What relief tiles are made of, where an object has that role; nothing elsewhere. Its objects are also in the
  /// meshes above, by their other roles.
  std::shared_ptr<const TiledScene> tiled = {};
};

/// The file of roles beside the file of a scene: "teapot.roles.json" beside "teapot.obj".
std::string rolesFileBeside(const std::string& source);

/// The roles: of the file, where one is given; else of the file beside the scene, if there is one, or of the built-in
/// scene. Where nothing says them: none where they are not needed, else throws InputError.
std::vector<RoledObject> rolesFor(const std::string& source, const std::string& rolesFile, bool needed = true);

/// Throws InputError where a role is of an object that the scene lacks.
ShadedScene loadShadedScene(const std::string& source, const std::vector<RoledObject>& roles,
                            const SceneOptions& options = {}, const Progress& progress = {});

/// Throws InputError where nothing has the role `cast`.
void requireCast(const ShadedScene& scene);

/// The view with the least vertical field that holds the box in pictures of these proportions (width / height), with
/// some room around; at most 90 degrees. The box lies before its eye.
View viewAround(View view, const Box& box, double proportions);

/// The default view of a picture: from where the default view of other commands looks, towards what sends the rays,
/// and as wide as the sphere around that.
View pictureView(const Box& senders);

/// What becomes of objects beside and behind what sends rays to them, which no image plane holds.
enum class WhatLiesAround { kIsAnError, kMayBeLost };

/// The view that a reference image of the cast objects is made for: from the middle of what sends rays to them, towards
/// them, and as wide as they are from there, with a margin. Throws InputError where they lie around that place, so that
/// no image plane holds them; or, where what lies around may be lost, gives a view of 100 degrees then.
View referenceView(const Mesh& cast, const Box& senders, int width, int height,
                   WhatLiesAround around = WhatLiesAround::kIsAnError);
/// The same; nothing where referenceView() throws.
std::optional<View> planeView(const Mesh& cast, const Box& senders, int width, int height);
/// A view for objects that lie all around: from the middle of what sends rays straight towards +z, whence the default
/// view looks, 90 degrees high. Images of one plane show those there; panoramas and graph cameras see more.
View aroundView(const Mesh& cast, const Box& senders);

/// The picture's view, where it shows anything of what lies in `senders`; where other objects hide all of that, raised
/// about its target in steps of 15 degrees up to 75, to where they hide half of it at most. As it is where that is
/// nowhere.
View unhiddenView(const View& view, const ShadedScene& scene, const Box& senders);

Box boundsOf(const std::vector<SpecularObject>& objects);

}  // namespace ocelli
