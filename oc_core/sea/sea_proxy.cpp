#include "oc_core/sea/sea_proxy.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

namespace ocelli {

SeaProxy::SeaProxy(Mesh mesh) : mesh_(std::make_unique<Mesh>(std::move(mesh))) {
  if (!mesh_->empty()) {
    const Box box = boundsOf(*mesh_);
    constexpr float kExtents = 100;
    far_ = std::max(kExtents * glm::distance(box.lower, box.upper), 1e-3f);
  }
}

const SeaProxy::Structures& SeaProxy::structures() const {
  std::call_once(isMade_, [&] { structures_ = std::make_unique<Structures>(*mesh_); });
  return *structures_;
}

}  // namespace ocelli
