#include "study/task/scene_view.h"

namespace ocelli {
namespace {

class PinholeView final : public SceneView {
 public:
  std::vector<TrialLayout::View> views(const Vantage& from) const override {
    std::vector<TrialLayout::View> views;
    for (const Vantage::Pane& pane : from.pinholes) {
      views.emplace_back(pane.place, pane.camera);
    }
    return views;
  }
};

class GraphView final : public SceneView {
 public:
  std::vector<TrialLayout::View> views(const Vantage& from) const override { return from.graph(); }
};

}  // namespace

std::shared_ptr<const SceneView> pinholeView() {
  return std::make_shared<PinholeView>();
}

std::shared_ptr<const SceneView> graphView() {
  return std::make_shared<GraphView>();
}

}  // namespace ocelli
