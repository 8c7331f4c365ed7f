#include "display_sim/viewer/scene_pane.h"

#include "display_sim/viewer/viewer_colors.h"
#include "oc_core/gl/gl_api.h"

namespace ocelli {

bool ScenePane::draw(const ViewerState& state, const ViewerData& data, const std::optional<PickedPixel>& picked,
                     const glm::ivec2& size, float lineScale, MeshDraw& meshes) {
  const Key key{state.scene, state.reconstruction.view, picked, data.version, size, lineScale};
  if (key == drawn_) {
    return false;
  }
  drawn_ = key;
  target_.begin(size.x, size.y, rgb(kPaneColor));
  shown_ = {};
  if (!data.scene) {
    return true;
  }
  const PinholeCamera camera(state.scene.view, size.x, size.y);
  if (data.camera) {
    const RayKey rayKey{data.version, state.scene.rayColumns, state.scene.rayRows};
    if (rayKey != raysOf_) {
      rays_ =
          data.rays ? rayGrid(*data.camera, *data.rays, data.scene->bounds, rayKey.columns, rayKey.rows) : RayGrid();
      raysOf_ = rayKey;
    }
    shown_ = sceneLines(state, *data.camera, rays_, data.scene->bounds, lineScale);
    if (picked && data.rays) {
      const SampledRay ray = sampledRay(*data.camera, *data.rays, data.scene->bounds, *picked);
      addPolyline(shown_.lines, ray.toSample, opaque(kPickedColor), 2.5f * lineScale);
      addPolyline(shown_.lines, ray.beyond, withOpacity(kPickedColor, 0.4f), 2.5f * lineScale);
    }
  }
  Box drawn = data.scene->bounds;
  for (const ColoredLine& line : shown_.lines) {
    drawn.add(line.from);
    drawn.add(line.to);
  }
  const DepthRange range = depthRange(camera, drawn);
  if (state.scene.samples && data.cameraMesh) {
    meshes.drawVertices(*data.cameraMesh, camera, range, lineScale);
  } else if (data.sceneMesh) {
    meshes.draw(*data.sceneMesh, camera, range);
  }
  constexpr float kSeenThrough = 0.3f;
  lines_.draw(shown_.lines, camera, range, kSeenThrough);
  return true;
}

}  // namespace ocelli
