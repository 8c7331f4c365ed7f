#include "oc_core/worlds/labelled_scene.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/labels/label_mesh.h"
#include "oc_core/scene/scene_file.h"
#include "oc_core/worlds/builtin_scenes.h"

namespace ocelli {
namespace {

/// Around the boxes of all copies.
Box boxOfCopies(const Scene& scene) {
  std::vector<Box> boxes;
  for (const Mesh& mesh : scene.meshes) {
    boxes.push_back(boundsOf(mesh));
  }
  Box box;
  for (const Instance& instance : scene.instances) {
    const Box& own = boxes[instance.mesh];
    if (own.empty()) {
      continue;
    }
    for (const glm::vec3& corner : cornersOf(own)) {
      box.add(glm::vec3(instance.worldFromMesh * glm::vec4(corner, 1)));
    }
  }
  return box;
}

Mesh labelsFor(const Box& box, const LabelOptions& options) {
  LabelLook look;
  const double diagonal = box.empty() ? 0 : glm::length(glm::dvec3(box.upper) - glm::dvec3(box.lower));
  look.size = diagonal > 0 ? kLabelShare * diagonal : look.size;
  look.facing = options.facing;
  return meshOfLabels(readLabels(options.file), look, options.file);
}

class LabelledMotion final : public MovingScene {
 public:
  LabelledMotion(std::unique_ptr<MovingScene> scene, const LabelOptions& options) : scene_(std::move(scene)) {
    MovedMesh first;
    scene_->moveTo(0, first);
    labels_ = labelsFor(boundsOf(first.mesh), options);
  }

  double durationSeconds() const override { return scene_->durationSeconds(); }
  MotionFacts facts() const override { return scene_->facts(); }
  std::vector<double> sampleTimes() const override { return scene_->sampleTimes(); }

  void moveTo(double seconds, MovedMesh& moved) const override {
    // The scene finds what it left, but for colours and flags that it may not have given: it touches them in no
    // topology.
    if (moved.topology != 0) {
      const size_t vertices = moved.mesh.positions.size() - labels_.positions.size();
      moved.mesh.positions.resize(vertices);
      moved.mesh.colors.resize(vertices);
      moved.mesh.triangles.resize(moved.mesh.triangles.size() - labels_.triangles.size());
      moved.unlit.resize(vertices);
    }
    const uint64_t before = moved.topology;
    scene_->moveTo(seconds, moved);
    const size_t vertices = moved.mesh.positions.size();
    if (moved.topology != before && moved.unlit.size() != vertices) {
      moved.unlit.clear();
    }
    moved.mesh.colors.resize(vertices, glm::vec3(1));
    moved.unlit.resize(vertices, 0);
    append(moved.mesh, labels_);
    moved.unlit.resize(moved.mesh.positions.size(), 1);
  }

 private:
  std::unique_ptr<MovingScene> scene_;
  Mesh labels_;
};

}  // namespace

Scene readLabelledScene(const std::string& source, const SceneOptions& options, const Progress& progress) {
  Scene scene =
      isBuiltinScene(source) ? makeBuiltinScene(source) : readSceneFile(source, fileOptionsOf(options), progress);
  if (!options.labels.file.empty()) {
    scene.add(labelsFor(boxOfCopies(scene), options.labels));
    scene.instances.back().isLit = false;
  }
  return scene;
}

std::unique_ptr<MovingScene> withLabels(std::unique_ptr<MovingScene> scene, const LabelOptions& labels) {
  return scene == nullptr || labels.file.empty() ? std::move(scene)
                                                 : std::make_unique<LabelledMotion>(std::move(scene), labels);
}

void refuseLabels(const LabelOptions& labels, const std::string& what, const std::string& next) {
  if (!labels.file.empty()) {
    throw InputError(what + " takes no labels", "--labels", next);
  }
}

void refuseLabelsOfVolume(const LabelOptions& labels) {
  refuseLabels(labels, "a volume", "write its surface with ocelli scene export --iso VALUE, and label that");
}

}  // namespace ocelli
