// A SCENE with the labels that the user gives it.
#pragma once

#include <memory>
#include <string>

#include "oc_core/scene/moving_scene.h"
#include "oc_core/scene/scene.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {

/// A scene file or a built-in scene, with its labels as a further mesh, whose colours no light changes. Labels of no
/// size are kLabelShare of the diagonal of the box around the scene high.
Scene readLabelledScene(const std::string& source, const SceneOptions& options, const Progress& progress);

inline constexpr double kLabelShare = 0.025;

/// The scene itself where no labels are given; otherwise with labels, which stand still.
std::unique_ptr<MovingScene> withLabels(std::unique_ptr<MovingScene> scene, const LabelOptions& labels);

/// Throws InputError where labels are given for a scene that takes none; `what` it is, such as "a volume".
void refuseLabels(const LabelOptions& labels, const std::string& what, const std::string& next);
void refuseLabelsOfVolume(const LabelOptions& labels);

}  // namespace ocelli
