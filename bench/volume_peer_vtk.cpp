// VTK's ray caster on the CPU, vtkFixedPointVolumeRayCastMapper. Its rays alone: what it would draw of them into a
// window is taken from its image.
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkFixedPointRayCastImage.h>
#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cstring>
#include <memory>

#include "bench/volume_peer.h"
#include "oc_core/base/check.h"
#include "oc_core/base/parallel.h"
#include "oc_core/scene/shading.h"

namespace ocelli {
namespace {

int vtkTypeOf(VoxelType type) {
  switch (type) {
    case VoxelType::kUint8:
      return VTK_UNSIGNED_CHAR;
    case VoxelType::kInt8:
      return VTK_SIGNED_CHAR;
    case VoxelType::kUint16:
      return VTK_UNSIGNED_SHORT;
    case VoxelType::kInt16:
      return VTK_SHORT;
    case VoxelType::kUint32:
      return VTK_UNSIGNED_INT;
    case VoxelType::kInt32:
      return VTK_INT;
    case VoxelType::kFloat32:
      return VTK_FLOAT;
    case VoxelType::kFloat64:
      break;
  }
  return VTK_DOUBLE;
}

struct VtkScene {
  vtkNew<vtkImageData> image;
  vtkNew<vtkColorTransferFunction> colors;
  vtkNew<vtkPiecewiseFunction> opacities;
  vtkNew<vtkVolumeProperty> property;
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  vtkNew<vtkVolume> volume;
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkLight> light;
  double length = 1;  ///< of the mean distance of voxels, in the scene
};

/// For volumes that stand upright in the scene, and whose values are the numbers in voxels.
std::shared_ptr<VtkScene> vtkSceneOf(const VolumeScene& scene) {
  const auto made = std::make_shared<VtkScene>();
  const ScalarVolume& volume = *scene.volume;
  const glm::ivec3& size = volume.grid().size;
  const glm::dmat4& m = scene.worldFromIndex;
  OC_CHECK(volume.scale() == 1 && volume.offset() == 0, "values are numbers");
  OC_CHECK(m[0].x > 0 && m[1].y > 0 && m[2].z > 0 && m[0].y == 0 && m[0].z == 0 && m[1].x == 0 && m[1].z == 0 &&
               m[2].x == 0 && m[2].y == 0,
           "the volume stands upright");
  made->image->SetDimensions(size.x, size.y, size.z);
  made->image->SetSpacing(m[0].x, m[1].y, m[2].z);
  made->image->SetOrigin(m[3].x, m[3].y, m[3].z);
  made->image->AllocateScalars(vtkTypeOf(volume.type()), 1);
  std::memcpy(made->image->GetScalarPointer(), volume.voxels().data(), volume.voxels().size());
  for (const TransferPoint& point : scene.appearance.transfer.points()) {
    made->colors->AddRGBPoint(point.value, point.color.r, point.color.g, point.color.b);
    made->opacities->AddPoint(point.value, std::min(point.opacity, TransferFunction::kMaxOpacity));
  }
  const VolumeShading& shading = scene.appearance.shading;
  made->property->SetColor(made->colors);
  made->property->SetScalarOpacity(made->opacities);
  made->property->SetScalarOpacityUnitDistance(scene.appearance.transfer.opacityLength() * scene.sceneLengthOfUnit());
  made->property->SetInterpolationTypeToLinear();
  made->property->SetShade(shading.isOn);
  made->property->SetAmbient(shading.ambient);
  made->property->SetDiffuse(shading.diffuse);
  made->property->SetSpecular(shading.specular);
  made->property->SetSpecularPower(shading.shininess);
  made->mapper->SetInputData(made->image);
  made->mapper->AutoAdjustSampleDistancesOff();
  made->mapper->LockSampleDistanceToInputSpacingOff();
  made->mapper->SetImageSampleDistance(1);
  made->mapper->SetNumberOfThreads(threadCount());
  made->volume->SetMapper(made->mapper);
  made->volume->SetProperty(made->property);
  made->renderer->AddVolume(made->volume);
  made->window->AddRenderer(made->renderer);
  made->light->SetLightTypeToSceneLight();
  const glm::vec3 toLight = directionToLight() * 1000.0f;
  made->light->SetPosition(toLight.x, toLight.y, toLight.z);
  made->light->SetFocalPoint(0, 0, 0);
  made->renderer->AddLight(made->light);
  made->length = scene.volume->grid().meanSpacing() * scene.sceneLengthOfUnit();
  return made;
}

Image<glm::vec4> castByVtk(VtkScene& scene, const PinholeCamera& camera) {
  const View& view = camera.view();
  const glm::vec3 target = camera.eye() + camera.forward();
  const glm::vec3 up = -camera.down();
  scene.window->SetSize(camera.width(), camera.height());
  vtkCamera* eye = scene.renderer->GetActiveCamera();
  eye->SetPosition(camera.eye().x, camera.eye().y, camera.eye().z);
  eye->SetFocalPoint(target.x, target.y, target.z);
  eye->SetViewUp(up.x, up.y, up.z);
  eye->SetViewAngle(2 * std::atan(camera.height() / 2.0 / static_cast<double>(camera.focalPixels())) * 180 /
                    3.14159265358979);
  eye->SetClippingRange(view.zNear, view.zFar);
  double origin[3];
  double spacing[3];
  int extent[6];
  const int isReady = scene.mapper->PerImageInitialization(scene.renderer, scene.volume, 0, origin, spacing, extent);
  OC_CHECK(isReady != 0, "VTK sees the volume");
  scene.mapper->PerVolumeInitialization(scene.renderer, scene.volume);
  scene.mapper->PerSubVolumeInitialization(scene.renderer, scene.volume, 0);
  scene.mapper->RenderSubVolume();
  vtkFixedPointRayCastImage* seen = scene.mapper->GetRayCastImage();
  int memory[2];
  int used[2];
  int first[2];
  seen->GetImageMemorySize(memory);
  seen->GetImageInUseSize(used);
  seen->GetImageOrigin(first);
  Image<glm::vec4> image(camera.width(), camera.height(), glm::vec4(0));
  const unsigned short* pixels = seen->GetImage();
  for (int y = 0; y < used[1]; ++y) {
    for (int x = 0; x < used[0]; ++x) {
      const unsigned short* pixel = pixels + 4 * (y * memory[0] + x);
      // Rows begin at the bottom.
      const int row = camera.height() - 1 - (y + first[1]);
      if (image.contains(x + first[0], row)) {
        image(x + first[0], row) = glm::vec4(pixel[0], pixel[1], pixel[2], pixel[3]) / 32767.0f;
      }
    }
  }
  return image;
}

}  // namespace

std::vector<VolumePeer> volumePeers() {
  return {{"VTK, fixed point", [](const VolumeScene& scene) {
             return [made = vtkSceneOf(scene)](double step) -> VolumePeer::Picture {
               return [made, step](const PinholeCamera& camera) {
                 made->mapper->SetSampleDistance(static_cast<float>(step * made->length));
                 return castByVtk(*made, camera);
               };
             };
           }}};
}

}  // namespace ocelli
