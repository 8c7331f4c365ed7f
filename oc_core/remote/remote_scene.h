// A scene that a server draws images of, for any number of clients.
#pragma once

#include <cstdint>
#include <string>

#include "oc_core/ocri/reference_image.h"
#include "oc_core/remote/remote_image.h"
#include "oc_core/remote/remote_plan.h"
#include "oc_core/render/raycast.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// Any thread may call any function at any time.
class RemoteScene {
 public:
  /// Builds the structure that rays are cast against. `name` is what clients are told; `view` is where they begin.
  explicit RemoteScene(Mesh mesh, std::string name = "", const View& view = {});
  RemoteScene(const RemoteScene&) = delete;
  RemoteScene& operator=(const RemoteScene&) = delete;

  const std::string& name() const { return name_; }
  const View& defaultView() const { return view_; }
  const Mesh& mesh() const { return mesh_; }
  Box bounds() const { return rays_.bounds(); }

  /// The image of a plan. Each colour is the mean of `samples` x `samples` rays over the pixel; depth and what is held
  /// are those of the ray through its centre. Black where nothing is seen.
  ReferenceImage draw(const RemotePlan& plan, int samples = 1) const;
  /// Plans, draws and encodes. Throws InputError where settings are not valid.
  RemoteImage answer(const RemoteRequest& request, const RemoteSettings& settings, uint32_t id) const;

 private:
  std::string name_;
  View view_;
  Mesh mesh_;
  RayScene rays_;
};

}  // namespace ocelli
