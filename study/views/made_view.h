// The base of views whose content is made of the scene, once for each moment that is looked at: they say how, and where
// from.
#pragma once

#include <memory>
#include <vector>

#include "study/task/scene_view.h"
#include "study/views/shown_cache.h"

namespace ocelli {

class MadeView : public SceneView, public std::enable_shared_from_this<MadeView> {
 public:
  std::vector<TrialLayout::View> views(const Vantage& from) const final {
    std::vector<TrialLayout::View> views;
    for (const Vantage::Pane& pane : from.pinholes) {
      // It holds the view: a layout may outlive the protocol.
      const auto show = [self = shared_from_this(), camera = pane.camera,
                         panes = from.pinholes.size()](const TrialLayout& layout) {
        return self->cache_.get(layout, camera, panes, [&] { return self->make(layout, camera); });
      };
      views.emplace_back(pane.place, eyeOf(pane.camera), show);
    }
    return views;
  }

 protected:
  /// Where the content is looked at from, for a pinhole of the task.
  virtual PinholeCamera eyeOf(const PinholeCamera& pinhole) const { return pinhole; }
  /// What is shown there; nothing of the scene where it cannot be made. Any thread may call it at any time.
  virtual std::shared_ptr<const ShownContent> make(const TrialLayout& layout, const PinholeCamera& pinhole) const = 0;

 private:
  mutable ShownCache cache_;
};

}  // namespace ocelli
