#include "oc_core/volume_gl/gl_volume_march.h"

#include <array>
#include <string>
#include <vector>

#include "oc_core/camera/ray_path.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_program.h"
#include "oc_core/gl/shaders.h"
#include "oc_core/volume/volume_bricks.h"
#include "oc_core/volume_gl/shaders.h"

namespace ocelli {
namespace {

/// Turns of the loops of a pixel in a pass. Software renderers end a shader after 65535 turns, which it does for up to
/// 16 pixels together; where these take different turns, the turns of all of them count.
constexpr uint32_t kMaxSoftwareIterations = 3500;
/// So that no pass takes a GPU long enough to be reset.
constexpr uint32_t kMaxGpuIterations = 16384;

/// In the layout std430, as the shader has it.
constexpr size_t kBytesOfStop = 4 * sizeof(uint32_t);

std::string defineOf(const char* name, int value) {
  return std::string("#define ") + name + " " + std::to_string(value) + "\n";
}

}  // namespace

const GlObject& GlVolumeMarch::programOf(const VolumeMarchKind& kind) {
  const auto found = programs_.find(kind);
  if (found != programs_.end()) {
    return found->second;
  }
  std::vector<std::string_view> pieces{shaders::kVolumeRay, shaders::kVoxelField, shaders::kEmptyBricks,
                                       shaders::kOpticalTable, shaders::kVolumeLight};
  if (kind.rays == VolumeRaysFrom::kList) {
    pieces.push_back(shaders::kListedRays);
  } else {
    pieces.insert(pieces.end(), {shaders::kPinhole, shaders::kPinholeRays});
  }
  pieces.push_back(shaders::kVolumeMarchComp);
  const std::string defines = defineOf("BRICK_EDGE", VolumeBricks::kEdge) + defineOf("SHADING", kind.isShaded ? 1 : 0) +
                              defineOf("LENSES", kind.rays == VolumeRaysFrom::kLenses ? 1 : 0) +
                              defineOf("SURFACES", kind.hasSurfaces ? 1 : 0) +
                              defineOf("HARDWARE_FILTER", kind.isFilteredByHardware ? 1 : 0) +
                              defineOf("MAX_CLIPS", kMaxShaderClips);
  return programs_.emplace(kind, makeProgram(*context_, "volume_march", {{GL_COMPUTE_SHADER, pieces}}, defines))
      .first->second;
}

void GlVolumeMarch::run(const VolumeMarchKind& kind, const VolumeMarchNumbers& numbers, int width, int firstRow,
                        int endRow, double longest) {
  const GladGLContext& gl = context_->gl();
  const int rows = endRow - firstRow;
  const uint32_t maxIterations = context_->info().isSoftware ? kMaxSoftwareIterations : kMaxGpuIterations;
  const GlObject stops = makeBuffer(*context_, kBytesOfStop * static_cast<size_t>(width) * static_cast<size_t>(rows));
  const GlObject unfinished = makeBuffer(*context_, sizeof(uint32_t));
  gl.UseProgram(programOf(kind).id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, stops.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, unfinished.id());
  gl.Uniform1i(0, firstRow);
  gl.Uniform1i(1, endRow);
  gl.Uniform1f(2, numbers.step);
  gl.Uniform1f(3, numbers.endTransmittance);
  gl.Uniform1f(4, numbers.depthTransmittance);
  gl.Uniform2f(5, numbers.entriesByTexel, numbers.firstEntry);
  gl.Uniform1ui(6, maxIterations);
  // A slab takes one turn of each loop. Each part of a ray that leaves the volume and enters it again ends with a slab
  // that may be shorter.
  const double parts = kind.rays == VolumeRaysFrom::kList ? double{RayPath::kMaxPoints} : 1;
  const double turns = 2 * (longest / static_cast<double>(numbers.step) + 1 + parts);
  uint32_t left = 1;
  for (bool isFirst = true; left > 0; isFirst = false) {
    const uint32_t none = 0;
    gl.NamedBufferSubData(unfinished.id(), 0, sizeof(none), &none);
    gl.Uniform1i(7, isFirst ? 1 : 0);
    gl.DispatchCompute(static_cast<GLuint>((width + 7) / 8), static_cast<GLuint>((rows + 7) / 8), 1);
    gl.MemoryBarrier(GL_ALL_BARRIER_BITS);
    context_->check("marching through a volume");
    left = 0;
    if (turns > static_cast<double>(maxIterations)) {
      readBuffer(*context_, unfinished, sizeof(left), &left);
    }
  }
}

}  // namespace ocelli
