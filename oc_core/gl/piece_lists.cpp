#include "oc_core/gl/piece_lists.h"

#include "oc_core/gl/gl_api.h"

namespace ocelli {

glm::uvec4 sumGroups(GlContext& context, const GlObject& prefixSum, const GlObject& groups, uint32_t count) {
  const GladGLContext& gl = context.gl();
  gl.UseProgram(prefixSum.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, kGroupsBinding, groups.id());
  gl.Uniform1ui(0, count);
  gl.DispatchCompute(1, 1, 1);
  gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
  glm::uvec4 total(0);
  gl.GetNamedBufferSubData(groups.id(), static_cast<GLintptr>(count * sizeof(total)), sizeof(total), &total);
  return total;
}

}  // namespace ocelli
