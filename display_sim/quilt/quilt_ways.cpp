#include "display_sim/quilt/quilt_ways.h"

#include "display_sim/quilt/color_and_depth.h"
#include "display_sim/quilt/quilt_render.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

QuiltPicture byEpipolarImages(const QuiltWayInputs& in) {
  report(in.progress, "images", 0);
  if (in.images.sampling == 1) {
    return quiltFromLines(in.views, quiltLines(in.views, in.scene, in.images), in.depths);
  }
  Mesh wider = in.scene;
  in.views.stretchScene(wider, in.images.sampling);
  return quiltFromLines(in.views, quiltLines(in.views, wider, in.images), in.depths);
}

QuiltPicture byColorAndDepth(const QuiltWayInputs& in) {
  const ColorAndDepth pair = colorAndDepth(middleDepthImage(in.views, in.scene));
  return quiltFromDepthImage(in.views, depthImageOf(pair, in.views), in.depths);
}

std::vector<QuiltWay> builtinWays() {
  return {
      {"eoc-h", "images of epipolar occlusion cameras along the views, drawn for every view", byEpipolarImages},
      {"render", "every view from all triangles: the slow reference",
       [](const QuiltWayInputs& in) { return quiltByRender(in.views, in.scene, in.depths, in.progress); }},
      {"rgbd", "what a display makes of a colour-and-depth pair of the middle view", byColorAndDepth},
      {"di", "the same with depths of full precision",
       [](const QuiltWayInputs& in) {
         return quiltFromDepthImage(in.views, middleDepthImage(in.views, in.scene), in.depths);
       }},
  };
}

Registry<QuiltWay>& wayRegistry() {
  static Registry<QuiltWay> registry("way to make a quilt", builtinWays());
  return registry;
}

}  // namespace

Rows<QuiltWay> quiltWays() {
  return wayRegistry().rows();
}

void registerQuiltWay(QuiltWay way) {
  wayRegistry().add(std::move(way));
}

const QuiltWay& quiltWayNamed(const std::string& name, const std::string& where) {
  std::string names;
  for (const QuiltWay& way : quiltWays()) {
    if (way.name == name) {
      return way;
    }
    names += (names.empty() ? "" : ", ") + way.name;
  }
  throw InputError("a quilt is not made by \"" + name + "\"", where, "one of " + names);
}

}  // namespace ocelli
