// VTK's ray caster on the CPU, vtkFixedPointVolumeRayCastMapper, without a window: vtkRenderWindow has the size and the
// camera, and the mapper's image is taken before it would be drawn.
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkFixedPointRayCastImage.h>
#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <cstring>

#include "bench/volume_peer.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {
}  // namespace
}  // namespace ocelli
