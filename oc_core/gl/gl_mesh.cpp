#include "oc_core/gl/gl_mesh.h"

#include "oc_core/base/check.h"
#include "oc_core/gl/gl_api.h"

namespace ocelli {

GlMesh::GlMesh(GlContext& context, const Mesh& mesh)
    : context_(&context),
      vertexCount_(mesh.positions.size()),
      triangleCount_(mesh.triangles.size()),
      positions_(makeBuffer(context, mesh.positions)),
      colors_(
          makeBuffer(context, mesh.colors.empty() ? std::vector<glm::vec3>(vertexCount_, glm::vec3(1)) : mesh.colors)),
      triangles_(makeBuffer(context, mesh.triangles)),
      vertexArray_(makeVertexArray(context)) {
  const GladGLContext& gl = context.gl();
  GLuint location = 0;
  for (const GlObject* buffer : {&positions_, &colors_}) {
    gl.VertexArrayVertexBuffer(vertexArray_.id(), location, buffer->id(), 0, sizeof(glm::vec3));
    gl.VertexArrayAttribFormat(vertexArray_.id(), location, 3, GL_FLOAT, GL_FALSE, 0);
    gl.VertexArrayAttribBinding(vertexArray_.id(), location, location);
    gl.EnableVertexArrayAttrib(vertexArray_.id(), location);
    ++location;
  }
  gl.VertexArrayAttribIFormat(vertexArray_.id(), kDrawNumber, 1, GL_UNSIGNED_INT, 0);
  gl.VertexArrayAttribBinding(vertexArray_.id(), kDrawNumber, kDrawNumber);
  gl.VertexArrayBindingDivisor(vertexArray_.id(), kDrawNumber, 1);
  gl.VertexArrayElementBuffer(vertexArray_.id(), triangles_.id());
  context.check("uploading the scene");
}

void GlMesh::move(size_t first, std::span<const glm::vec3> positions) const {
  OC_CHECK(first + positions.size() <= vertexCount_, "vertices that move are those of the mesh");
  if (!positions.empty()) {
    context_->gl().NamedBufferSubData(positions_.id(), static_cast<GLintptr>(first * sizeof(glm::vec3)),
                                      static_cast<GLsizeiptr>(positions.size_bytes()), positions.data());
  }
}

}  // namespace ocelli
