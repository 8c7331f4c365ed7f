#include "cli/gl_drawing.h"

#include <CLI/CLI.hpp>

#include "oc_core/base/error.h"
#ifdef OCELLI_WITH_OPENGL
#include "oc_core/gl/gl_renderer.h"
#include "oc_core/gl_rays/gl_ray_caster.h"
#endif

namespace ocelli {

namespace {

constexpr const char* kWhereFrom = "Where OpenGL comes from; auto takes EGL, or else OSMesa";

CLI::Option& addProviderOption(CLI::App& command, std::string& provider, const std::string& text) {
  return *command.add_option("--gl", provider, text)
              ->check(CLI::IsMember({"auto", "egl", "osmesa"}))
              ->type_name("NAME");
}

}  // namespace

void addGlOption(CLI::App& command, std::string& provider) {
  addProviderOption(command, provider, kWhereFrom).capture_default_str();
}

void addGlSwitch(CLI::App& command, std::string& provider, const std::string& use) {
  addProviderOption(command, provider, use + ". " + kWhereFrom);
}

void addMethodOption(CLI::App& command, std::string& method) {
  command
      .add_option("--method", method, "How: on the CPU, or with OpenGL")
      // The name of earlier versions.
      ->transform(CLI::Validator(
          [](std::string& name) { return name = name == "processor" ? "cpu" : name, std::string(); }, ""))
      ->check(CLI::IsMember({"cpu", "gl"}))
      ->type_name("NAME")
      ->capture_default_str();
}

void requireGlUsed(const std::string& provider, bool used, const std::string& by) {
  if (provider != "auto" && !used) {
    throw InputError("nothing draws with OpenGL here", "--gl " + provider, "add " + by + ", or leave --gl out");
  }
}

void failWithoutOpenGl(const std::string& where) {
  throw InputError("this program was built without OpenGL", where,
                   "leave \"gl\" out, or build with -DOCELLI_WITH_OPENGL=ON");
}

#ifdef OCELLI_WITH_OPENGL

struct GlDrawing::Impl {
  std::unique_ptr<GlContext> context;
  std::unique_ptr<GlRenderer> renderer;
};

GlDrawing::GlDrawing(const std::string& provider) : impl_(std::make_unique<Impl>()) {
  impl_->context = openGlContext(provider, "--gl");
}

const SceneRenderer& GlDrawing::rendererOf(const Mesh& mesh) {
  impl_->renderer = std::make_unique<GlRenderer>(*impl_->context, mesh);
  return *impl_->renderer;
}

std::string GlDrawing::description() const {
  return describe(impl_->context->info());
}

std::shared_ptr<const DepthRayCaster> openRayCaster(const std::string& provider) {
  return std::make_shared<GlRayCaster>(openGlContext(provider, "--gl"));
}

#else

struct GlDrawing::Impl {};

GlDrawing::GlDrawing(const std::string& /*provider*/) {
  failWithoutOpenGl();
}

const SceneRenderer& GlDrawing::rendererOf(const Mesh& /*mesh*/) {
  failWithoutOpenGl();
}

std::string GlDrawing::description() const {
  return {};
}

std::shared_ptr<const DepthRayCaster> openRayCaster(const std::string& /*provider*/) {
  failWithoutOpenGl("--gl");
}

#endif

GlDrawing::~GlDrawing() = default;

}  // namespace ocelli
