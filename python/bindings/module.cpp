#include "python/bindings/bindings.h"

PYBIND11_MODULE(_ocelli, module) {
  module.doc() = "The C++ side of ocelli: see the package's own modules.";
  module.attr("__version__") = OCELLI_VERSION;
  // In the order in which signatures name each other's classes.
  ocelli::bindErrors(module);
  ocelli::bindViews(module);
  ocelli::bindScenes(module);
  ocelli::bindImages(module);
  ocelli::bindRays(module);
  ocelli::bindCameras(module);
  ocelli::bindVolumes(module);
  ocelli::bindVolumeImages(module);
  ocelli::bindEvaluation(module);
  ocelli::bindDisplays(module);
  ocelli::bindStudies(module);
  ocelli::bindAnalysis(module);
  ocelli::bindEffects(module);
  ocelli::bindDevices(module);
  ocelli::bindSeas(module);
}
