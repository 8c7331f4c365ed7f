// `--method gl` of the commands that slice and observe. The context is opened for one piece of work; `provider` is what
// --gl says. Both throw InputError where this program was built without OpenGL, and GlError where the GPU cannot.
#pragma once

#include <string>

#include "display_sim/observer.h"
#include "display_sim/slicer.h"

namespace ocelli {

/// As slice().
Volume sliceWithGl(const std::string& provider, const Mesh& mesh, const DisplayProfile& profile,
                   const SliceOptions& options);
/// As collectLight().
Image<glm::vec3> collectLightWithGl(const std::string& provider, const Volume& volume, const ObserverOptions& options);

}  // namespace ocelli
