#include "study/task/scene_view.h"

#include <fmt/format.h>

#include <algorithm>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

class PinholeView final : public SceneView {
 public:
  explicit PinholeView(std::string variant) : variant_(std::move(variant)) {}

  std::vector<TrialLayout::View> views(const Vantage& from) const override {
    std::vector<TrialLayout::View> views;
    for (const Vantage::Pane& pane : from.variant(variant_).pinholes) {
      views.emplace_back(pane.place, pane.camera);
    }
    return views;
  }

 private:
  std::string variant_;
};

class GraphView final : public SceneView {
 public:
  explicit GraphView(std::string variant) : variant_(std::move(variant)) {}

  std::vector<TrialLayout::View> views(const Vantage& from) const override { return from.variant(variant_).graph(); }

 private:
  std::string variant_;
};

}  // namespace

const Vantage& Vantage::variant(const std::string& asked) const {
  if (asked.empty()) {
    return *this;
  }
  const auto found =
      std::find_if(variants.begin(), variants.end(), [&](const Vantage& each) { return each.name == asked; });
  if (found == variants.end()) {
    std::string names;
    for (const Vantage& each : variants) {
      names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", each.name);
    }
    throw InputError(fmt::format("a condition asks for the variant \"{}\", but a block has {}", asked,
                                 names.empty() ? "none" : names),
                     "conditions, \"view\", \"variant\"",
                     "name it in \"variants\" of each block whose task has them, or leave \"variant\" away");
  }
  return *found;
}

std::shared_ptr<const SceneView> pinholeView(const std::string& variant) {
  return std::make_shared<PinholeView>(variant);
}

std::shared_ptr<const SceneView> graphView(const std::string& variant) {
  return std::make_shared<GraphView>(variant);
}

}  // namespace ocelli
