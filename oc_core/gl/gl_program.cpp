#include "oc_core/gl/gl_program.h"

#include "oc_core/gl/gl_api.h"

namespace ocelli {
namespace {

[[noreturn]] void fail(const GlContext& context, const std::string& name, const std::string& what,
                       const std::string& log) {
  throw GlError("the driver " + what + ":", std::string(nameOf(context.info().provider)) + ", shader " + name,
                "update the graphics driver", log);
}

/// A shader lives until its program is linked.
class Shader {
 public:
  Shader(const GlContext& context, const std::string& name, const GlStage& stage, const std::string& head)
      : gl_(context.gl()), id_(gl_.CreateShader(stage.kind)) {
    std::vector<const char*> texts{head.data()};
    std::vector<GLint> lengths{static_cast<GLint>(head.size())};
    for (const std::string_view piece : stage.pieces) {
      texts.push_back(piece.data());
      lengths.push_back(static_cast<GLint>(piece.size()));
    }
    gl_.ShaderSource(id_, static_cast<GLsizei>(texts.size()), texts.data(), lengths.data());
    gl_.CompileShader(id_);
    GLint done = GL_FALSE;
    gl_.GetShaderiv(id_, GL_COMPILE_STATUS, &done);
    if (done == GL_FALSE) {
      std::string log(4096, '\0');
      GLsizei length = 0;
      gl_.GetShaderInfoLog(id_, static_cast<GLsizei>(log.size()), &length, log.data());
      log.resize(static_cast<size_t>(length));
      gl_.DeleteShader(id_);
      fail(context, name, "does not compile it", log);
    }
  }
  ~Shader() { gl_.DeleteShader(id_); }
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;

  GLuint id() const { return id_; }

 private:
  const GladGLContext& gl_;
  GLuint id_;
};

}  // namespace

GlObject makeProgram(GlContext& context, const std::string& name, const std::vector<GlStage>& stages,
                     const std::string& defines) {
  const GladGLContext& gl = context.gl();
  const std::string head = "#version 450 core\n" + defines;
  GlObject program(context, GlObjectKind::kProgram, gl.CreateProgram());
  {
    std::vector<std::unique_ptr<Shader>> shaders;
    for (const GlStage& stage : stages) {
      shaders.push_back(std::make_unique<Shader>(context, name, stage, head));
      gl.AttachShader(program.id(), shaders.back()->id());
    }
    gl.LinkProgram(program.id());
    for (const auto& shader : shaders) {
      gl.DetachShader(program.id(), shader->id());
    }
  }
  GLint done = GL_FALSE;
  gl.GetProgramiv(program.id(), GL_LINK_STATUS, &done);
  if (done == GL_FALSE) {
    std::string log(4096, '\0');
    GLsizei length = 0;
    gl.GetProgramInfoLog(program.id(), static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<size_t>(length));
    fail(context, name, "does not link it", log);
  }
  context.check("making the shader " + name);
  return program;
}

}  // namespace ocelli
