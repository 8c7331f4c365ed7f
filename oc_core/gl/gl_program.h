// Shader programs from pieces of GLSL. Sources stand in .glsl files, which CMake compiles into the program
// (ocelli_embed_shaders); "#version 450 core" and `defines` come before them.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "oc_core/gl/gl_object.h"

namespace ocelli {

/// A stage made of pieces that follow each other, so that several programs can share some.
struct GlStage {
  uint32_t kind = 0;  ///< GL_VERTEX_SHADER, GL_COMPUTE_SHADER, ...
  std::vector<std::string_view> pieces;
};

/// `defines` are lines such as "#define LEVELS 4\n". Throws GlError with the compiler's log: a driver that refuses a
/// shader is not one that we can work with. Hold a GlScope.
GlObject makeProgram(GlContext& context, const std::string& name, const std::vector<GlStage>& stages,
                     const std::string& defines = {});

}  // namespace ocelli
