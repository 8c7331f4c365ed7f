// The extension module `ocelli._ocelli`: one function a subject adds its classes and functions to the module. The
// Python files of python/ocelli/ are what users see; they turn paths, keywords and defaults into what stands here.
//
// Every call that works for long releases the interpreter (py::gil_scoped_release) and takes a PythonProgress, so that
// other threads run and Ctrl-C ends it (progress.h). Arrays are views of the memory of the C++ objects (arrays.h).
#pragma once

#include <pybind11/pybind11.h>

namespace ocelli {

void bindErrors(pybind11::module_& module);
void bindScenes(pybind11::module_& module);
void bindViews(pybind11::module_& module);
void bindImages(pybind11::module_& module);
void bindRays(pybind11::module_& module);
void bindCameras(pybind11::module_& module);
void bindEvaluation(pybind11::module_& module);
void bindVolumes(pybind11::module_& module);
void bindVolumeImages(pybind11::module_& module);
void bindDisplays(pybind11::module_& module);
void bindStudies(pybind11::module_& module);
void bindAnalysis(pybind11::module_& module);
void bindEffects(pybind11::module_& module);
void bindDevices(pybind11::module_& module);
void bindSeas(pybind11::module_& module);

}  // namespace ocelli
