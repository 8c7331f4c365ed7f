#include "tests/camera_shader/shader_cases.h"

#include "oc_core/camera/graph_camera.h"
#include "oc_core/camera_rays/camera_rays.h"
#include "oc_core/camera_shader/closed_form_shader.h"
#include "oc_core/camera_shader/ray_texture_shader.h"
#include "oc_core/ocri/representation_kind.h"
#include "tests/camera/test_ray_maps.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli::test {
namespace {

CameraChoice gpcOf(const char* sampling, std::vector<GpcRegion> regions) {
  CameraChoice choice = cameraChoice("gpc");
  choice.gpc = {findGpcSampling(sampling), std::move(regions)};
  return choice;
}

/// Two with more detail and one with less, which leave a part of the image as it is.
std::vector<GpcRegion> threeRegions() {
  return {{{0.25f, 0.3f}, {0.2f, 0.2f}, 3, 1},
          {{0.75f, 0.3f}, {0.1f, 0.3f}, 8, 0.7f},
          {{0.4f, 0.8f}, {0.12f, 0.1f}, 0.8f, 2}};
}

class Cases {
 public:
  explicit Cases(std::filesystem::path folder) : folder_(std::move(folder)) {}

  void addClosedForm(const std::string& name, const CameraChoice& choice, const PinholeCamera& reference) {
    const ClosedForm* form = findClosedForm(choice);
    cases_.push_back({name, closedFormShader(*form, choice, reference), "", rayMapOf(choice, reference, Mesh{}, 0),
                      cameraMaps(choice, reference, Mesh{}, {}).front().ray});
  }
  void addTexture(const std::string& name, const RayMap& rays) {
    cases_.push_back(
        {name, rayTextureShader(rays, texturePath(folder_, name).string()), rayTextureBytes(rays), rays, {}});
  }
  std::vector<ShaderCase> take() { return std::move(cases_); }

 private:
  std::filesystem::path folder_;
  std::vector<ShaderCase> cases_;
};

RayMap ofCameraInScene(const char* name, const PinholeCamera& reference) {
  return rayMapOf(cameraChoice(name), reference, boxBeforeWall(), 0);
}

/// A lens that stands nowhere: its rays in the space of a view, z backward, and none beside its circle.
RayMap lensMap() {
  return straightMap({31, 31},
                     [](double u, double v) {
                       const glm::dvec2 p = glm::dvec2(u, v) / 15.5 - 1.0;
                       return std::pair(glm::dvec3(0.01 * p.x, -0.02 * p.y, -0.03),
                                        glm::length(p) <= 1 ? glm::dvec3(p.x, -p.y, -0.5) : glm::dvec3(0));
                     },
                     0.1f, 50, {.name = "lens", .frame = RayFrame::kView});
}

}  // namespace

std::filesystem::path texturePath(const std::filesystem::path& folder, const std::string& name) {
  return folder / (name + "_rays.exr");
}

View obliqueView() {
  return {.eye = {-3, 4.5f, 2},
          .target = {0.5f, 0.25f, -1},
          .up = {0.2f, 1, 0.1f},
          .fovVerticalDegrees = 70,
          .zNear = 0.5f,
          .zFar = 40,
          .centerShift = {0.2f, -0.1f}};
}

std::vector<ShaderCase> shaderCases(const std::filesystem::path& folder) {
  const PinholeCamera plain(View{}, 90, 60);
  const PinholeCamera oblique(obliqueView(), 101, 67);
  const PinholeCamera large(obliqueView(), 960, 540);
  Cases cases(folder);
  for (const ClosedForm& form : closedForms()) {
    const std::string name = form.kind;
    cases.addClosedForm(name, cameraChoice(name), plain);
    cases.addClosedForm(name + "_oblique", cameraChoice(name), oblique);
  }
  cases.addClosedForm("di_large", cameraChoice("di"), large);
  for (const GpcSampling& sampling : gpcSamplings()) {
    cases.addClosedForm(std::string("gpc_") + sampling.name, gpcOf(sampling.name, threeRegions()), oblique);
  }
  cases.addClosedForm("gpc_large", gpcOf("cubic", threeRegions()), large);
  cases.addTexture("di_texture", rayMapOf(cameraChoice("di"), oblique, Mesh{}, 0));
  cases.addTexture("rppc_texture", ofCameraInScene("rppc", plain));
  cases.addTexture("eoc_texture", ofCameraInScene("eoc-forward", plain));
  cases.addTexture("cell_texture", ofCameraInScene("cell", plain));
  cases.addTexture("graph_texture", rayMapOf(GraphCamera(plain), "graph", plain.view()));
  cases.addTexture("push_broom_texture", pushBroomMap({41, 17}));
  cases.addTexture("random_texture", randomMap(5, {50, 30}));
  cases.addTexture("lens_texture", lensMap());
  return cases.take();
}

}  // namespace ocelli::test
