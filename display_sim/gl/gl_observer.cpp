#include "display_sim/gl/gl_observer.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "display_sim/frames/sweep_geometry.h"
#include "display_sim/gl/shaders.h"
#include "display_sim/observing/eye_perspective.h"
#include "oc_core/base/error.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_program.h"

namespace ocelli {
namespace {

/// Enough to fill a large GPU; their invocations share what there is to do.
constexpr GLuint kGroups = 512;
constexpr double kShaderLightUnit = 1 << 20;  // kLightUnit of observe.glsl
constexpr size_t kSumsPerPixel = 4;           // likewise
constexpr size_t kVoxelsPerGroup = 1024;      // 4 of 256 invocations
constexpr size_t kMaxObserverGroups = 65535;  // in a direction, on any GPU
constexpr uint32_t kMaxRowGroups = 64;        // as many as a voxel right before the eye may need
constexpr size_t kFirstScreenCapacity = 1 << 20;

GlObject makeCompute(GlContext& context, const std::string& name, const std::vector<std::string_view>& pieces) {
  const GlScope scope(context);
  return makeProgram(context, name, {{GL_COMPUTE_SHADER, pieces}});
}

void clear(const GladGLContext& gl, const GlObject& buffer) {
  gl.ClearNamedBufferData(buffer.id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
}

std::array<float, 3> floats(const glm::dvec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// Arc of observe.glsl.
struct GlArc {
  float cosine;
  float sine;
  float radians;
  float swing;
  float ahead;
  float behind;
  uint32_t channels;
  uint32_t unused;
};

void refuseWhatTheGpuLacks(const ObserverOptions& view) {
  if (view.lens.apertureRadii > 0 || view.ambient > 0) {
    throw InputError("a lens and the light of the room are not for the GPU", "observer",
                     "leave out --method gl: observe without OpenGL");
  }
}

void setUniforms(const GladGLContext& gl, GLuint program, const GlObserverOptions& options,
                 const SweepGeometry& sweep) {
  const EyePerspective eye(options.view);
  gl.ProgramUniform2i(program, 0, options.view.width, options.view.height);
  gl.ProgramUniform2i(program, 1, sweep.width(), sweep.height());
  gl.ProgramUniform1f(program, 2, static_cast<float>(sweep.halfHeight()));
  gl.ProgramUniform3fv(program, 3, 1, floats(eye.point({0, 0, 0})).data());
  std::array<float, 9> eyeFromWorld{};
  for (size_t axis = 0; axis < 3; ++axis) {
    glm::dvec3 unit(0);
    unit[static_cast<int>(axis)] = 1;
    std::ranges::copy(floats(eye.direction(unit)), eyeFromWorld.begin() + static_cast<std::ptrdiff_t>(3 * axis));
  }
  gl.ProgramUniformMatrix3fv(program, 4, 1, GL_FALSE, eyeFromWorld.data());
  gl.ProgramUniform1f(program, 5, static_cast<float>(eye.pixelsPerTangent));
  gl.ProgramUniform1i(program, 6, options.splat == GlSplat::kPoints ? 1 : 0);
  const ObserverOptions& view = options.view;
  gl.ProgramUniform1i(program, 8, view.emission.model == EmissionModel::kScreen ? 1 : 0);
  gl.ProgramUniform3fv(program, 9, 1, floats(eye.direction(view.wobble.displacement(0))).data());
  gl.ProgramUniform1f(program, 10, static_cast<float>(view.wobble.frequency));
  gl.ProgramUniform1f(program, 11, static_cast<float>(view.deadZoneRadii));
}

}  // namespace

GlObserver::GlObserver(GlContext& context)
    : context_(&context),
      list_(makeCompute(context, "list_lit", {shaders::kListLit})),
      small_(makeCompute(context, "observe_small", {shaders::kObserve, shaders::kObserveSmall})),
      large_(makeCompute(context, "observe_large", {shaders::kObserve, shaders::kObserveLarge})),
      resolve_(makeCompute(context, "resolve_light", {shaders::kResolveLight})) {}

void GlObserver::look(const GlVolume& volume) {
  const GlScope scope(*context_);
  const GladGLContext& gl = context_->gl();
  volume_ = nullptr;
  litVoxels_ = 0;
  gl.UseProgram(list_.id());
  gl.ProgramUniform1ui(list_.id(), 0, static_cast<GLuint>(volume.wordCount()));
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, volume.words().id());
  for (size_t room = std::max(litRoom_, kFirstScreenCapacity);; room = litVoxels_ + litVoxels_ / 4) {
    if (room > litRoom_) {
      const size_t most = static_cast<size_t>(context_->info().maxStorageBytes) / sizeof(uint32_t) - 2;
      if (litVoxels_ > most) {
        throw GlError(std::to_string(litVoxels_) +
                          " voxels are lit, and this GPU's shaders address a list of at most " + std::to_string(most),
                      "observer", "observe without OpenGL");
      }
      litRoom_ = std::min(room, most);
      lit_ = makeBuffer(*context_, (1 + litRoom_) * sizeof(uint32_t));
      queue_ = makeBuffer(*context_, (2 + litRoom_) * sizeof(uint32_t));
    }
    gl.ProgramUniform1ui(list_.id(), 1, static_cast<GLuint>(litRoom_));
    gl.ClearNamedBufferSubData(lit_.id(), GL_R32UI, 0, sizeof(uint32_t), GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, lit_.id());
    gl.DispatchCompute(kGroups, 1, 1);
    uint32_t count = 0;
    readBuffer(*context_, lit_, sizeof(count), &count);
    litVoxels_ = count;
    if (litVoxels_ <= litRoom_) {
      break;
    }
  }
  gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  context_->check("listing lit voxels");
  volume_ = &volume;
}

void GlObserver::resize(int width, int height) {
  if (width == width_ && height == height_) {
    return;
  }
  width_ = height_ = 0;
  const GladGLContext& gl = context_->gl();
  const size_t bytes = static_cast<size_t>(width) * static_cast<size_t>(height) * kSumsPerPixel * sizeof(uint32_t);
  low_ = makeBuffer(*context_, bytes);
  high_ = makeBuffer(*context_, bytes);
  clear(gl, low_);
  clear(gl, high_);
  light_ = makeTexture(*context_, GL_RGBA32F, width, height);
  width_ = width;
  height_ = height;
}

/// Returns by how much their light is scaled down, so that that of a voxel does not grow with the exposure.
double GlObserver::bindArcs(const std::vector<ExposedArc>& arcs, const ObserverOptions& view) {
  const DisplayProfile& profile = volume_->profile();
  const double step = SweepGeometry(profile).stepRadians();
  double most = 0;
  for (const ExposedArc& arc : arcs) {
    most = std::max(most, arc.passes);
  }
  std::vector<uint32_t> first(static_cast<size_t>(profile.storedSlices()) + 1);
  std::vector<GlArc> items;
  for (const ExposedArc& arc : arcs) {
    const double middle = (arc.fromRadians + arc.toRadians) / 2;
    const double swing = std::remainder(arc.swingRadians + view.wobble.frequency * middle, 2 * kPi);
    const ArcLight light = arcLight(arc, view.emission, step);
    items.push_back({static_cast<float>(std::cos(middle)), static_cast<float>(std::sin(middle)),
                     static_cast<float>(arc.toRadians - arc.fromRadians), static_cast<float>(swing),
                     static_cast<float>(light.ahead / most), static_cast<float>(light.behind / most), arc.channels, 0});
    first[static_cast<size_t>(arc.slice) + 1] = static_cast<uint32_t>(items.size());
  }
  for (size_t i = 1; i < first.size(); ++i) {
    first[i] = std::max(first[i], first[i - 1]);
  }
  arcs_ = makeBuffer(*context_, items);
  arcsOfSlices_ = makeBuffer(*context_, first);
  const GladGLContext& gl = context_->gl();
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, arcs_.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 3, arcsOfSlices_.id());
  return most;
}

void GlObserver::drawLarge() {
  std::array<uint32_t, 2> head{};
  readBuffer(*context_, queue_, sizeof(head), head.data());
  const auto [queued, rowGroups] = head;
  const GladGLContext& gl = context_->gl();
  gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  gl.UseProgram(large_.id());
  for (size_t first = 0; first < queued; first += kMaxObserverGroups) {
    gl.ProgramUniform1ui(large_.id(), 7, static_cast<GLuint>(first));
    gl.DispatchCompute(static_cast<GLuint>(std::min(queued - first, kMaxObserverGroups)),
                       std::min(rowGroups, kMaxRowGroups), 1);
  }
}

void GlObserver::draw(const GlObserverOptions& options) {
  OC_CHECK(volume_ != nullptr, "the observer has no volume to look at");
  const DisplayProfile& profile = volume_->profile();
  const ObserverOptions& view = options.view;
  checkObserverOptions(view, profile);
  refuseWhatTheGpuLacks(view);
  const std::vector<ExposedArc> arcs = options.window ? windowArcs(profile, *options.window, view.wobble)
                                                      : exposedArcs(profile, exposedSweep(view, profile), view.wobble);
  const GlScope scope(*context_);
  const GladGLContext& gl = context_->gl();
  resize(view.width, view.height);
  const double scale = bindArcs(arcs, view);
  GLuint binding = 0;
  for (const GLuint buffer : {volume_->words().id(), lit_.id()}) {
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, binding++, buffer);
  }
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 4, low_.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 5, high_.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 6, queue_.id());
  for (const GlObject* program : {&small_, &large_}) {
    setUniforms(gl, program->id(), options, SweepGeometry(profile));
  }
  gl.ClearNamedBufferSubData(queue_.id(), GL_R32UI, 0, 2 * sizeof(uint32_t), GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
  gl.UseProgram(small_.id());
  gl.DispatchCompute(static_cast<GLuint>(std::min(litVoxels_ / kVoxelsPerGroup + 1, kMaxObserverGroups)), 1, 1);
  drawLarge();
  gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  gl.ProgramUniform2i(resolve_.id(), 0, view.width, view.height);
  gl.ProgramUniform1f(resolve_.id(), 1, static_cast<float>(scale / kShaderLightUnit));
  gl.BindImageTexture(0, light_.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
  gl.UseProgram(resolve_.id());
  gl.DispatchCompute(kGroups, 1, 1);
  gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
  context_->check("observing " + std::to_string(litVoxels_) + " voxels");
}

Image<glm::vec3> GlObserver::readLight() const {
  const GlScope scope(*context_);
  return readTexture<glm::vec3>(*context_, light_, width_, height_, GL_RGB, GL_FLOAT);
}

}  // namespace ocelli
