// What a view condition shows of a scene: the planar pinhole cameras or the graph camera of the task (chapter 7), or
// anything else that is made of them. The kinds that protocols can name are the rows of study/views/view_registry.h.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "study/task/trial_layout.h"
#include "study/trial/view_condition.h"

namespace ocelli {

/// Where a task looks at its scene from, at one moment of a trial.
struct Vantage {
  /// A planar pinhole camera and its place on the screen.
  struct Pane {
    PixelRect place;
    PinholeCamera camera;
  };
  std::vector<Pane> pinholes;  ///< one at the eye, or several laid by hand; never none
  /// The views by the graph camera that the task makes; made when it is called.
  std::function<std::vector<TrialLayout::View>()> graph;
  /// Other places to look from, which the block names and a view condition asks for.
  std::vector<Vantage> variants{};
  std::string name{};  ///< of a variant

  /// The variant of that name; all of this where it is empty. Throws InputError where there is none.
  const Vantage& variant(const std::string& asked) const;
};

/// The same vantage always gives the same views. Any thread may call it at any time.
class SceneView {
 public:
  virtual ~SceneView() = default;
  /// At least one; each as large as its place, which lies within those of the vantage.
  virtual std::vector<TrialLayout::View> views(const Vantage& from) const = 0;
  /// Whether the eye moves by itself during a trial: for tasks in which nothing else moves (TaskBlock::isStill()).
  virtual bool movesEye() const { return false; }
  /// Whether a view from that pinhole can show what is within the box, where nothing hides it and it is in sight.
  virtual bool reaches(const PinholeCamera& /*pinhole*/, const Box& /*box*/) const { return true; }
};

/// The pinholes of the task, or of a variant of its vantage, as they are.
std::shared_ptr<const SceneView> pinholeView(const std::string& variant = {});
/// The graph camera of the task, or of a variant.
std::shared_ptr<const SceneView> graphView(const std::string& variant = {});

/// The conditions of a study: their names, and what they show. Tasks take the view of a trial's condition from here.
struct StudyConditions {
  ViewConditions names = defaultConditions();
  std::vector<std::shared_ptr<const SceneView>> views{pinholeView(), graphView()};  ///< one a condition

  std::vector<TrialLayout::View> viewsOf(TrialView view, const Vantage& from) const {
    return views.at(indexOfCondition(view))->views(from);
  }
};

}  // namespace ocelli
