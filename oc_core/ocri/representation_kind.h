// What can stand for a scene: one row a kind, and nothing else in the toolkit asks which kind it has.
//
// Recipe for a new representation, two places:
//   1. oc_core/ocri/NAME_builder.h and .cpp: what builds its reference images.
//   2. oc_core/ocri/representation_kinds.cpp: its row. Options of its own are described in
//      oc_core/ocri/camera_option.cpp.
// tests/ocri/camera_choice_test.cpp runs over all rows; tests/ocri/camera_schema_test.cpp then says what
// oc_core/ocri/camera.schema.json and docs/cameras.md lack.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/camera_option.h"

namespace ocelli {

/// What builders get. `renderer` draws the images that the construction takes, where it is not null.
struct RepresentationInputs {
  const CameraChoice& choice;
  const PinholeCamera& reference;
  const Mesh& mesh;
  const Progress& progress;
  const SceneRenderer* renderer = nullptr;
};

struct RepresentationKind {
  const char* name;
  const char* description;
  /// In the order in which forms and tables show them.
  std::vector<const CameraOption*> options = {};
  /// What the name stands for, of that which is no option.
  std::function<void(CameraChoice&)> prepare = {};
  /// Names that end in another number: "ldi-N" for N up to this, beside the row's own; 0 for none.
  int maxCount = 0;
  /// The reference images; empty for what is a mesh alone.
  std::function<ReferenceImages(const RepresentationInputs&)> images = {};
  /// What is a mesh alone, of so many triangles as the depth image's mesh has.
  std::function<Mesh(const Mesh& mesh, size_t triangles)> mesh = {};
  /// Triangles from which on rays are faster; nothing where it is built by rasterisation only.
  std::optional<size_t> rayCrossover = {};
  /// Directions of the view segments that it is made for; empty where it is made for a cell, or the reference eye.
  std::function<std::vector<glm::vec3>(const CameraChoice&)> segments = {};
  /// The image drawn in another way; empty where there is one way only. Throws InputError for ways that it lacks.
  std::function<ReferenceImage(Technique, const RepresentationInputs&)> draw = {};
  /// The rays of each image. Builds the cameras, so it takes about as long.
  std::function<std::vector<RayFunction>(const RepresentationInputs&, const ReferenceImages&)> rays = {};
  /// Whether no renderer draws it but along its rays: `auto` then makes the acceleration structure too.
  bool castsRays = false;
  /// Why OpenGL cannot draw it; empty where it can.
  const char* needsCpu = "";
};

/// The rows, in the order of the list that users see.
const std::vector<RepresentationKind>& representationKinds();

}  // namespace ocelli
