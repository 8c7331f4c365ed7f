#include "display_sim/gl/gl_slicer.h"

#include <algorithm>

#include "display_sim/frames/sweep_geometry.h"
#include "display_sim/gl/shaders.h"
#include "oc_core/base/error.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_program.h"

namespace ocelli {
namespace {

constexpr size_t kGroupSize = 64;           // local_size_x of the shaders
constexpr size_t kMaxSlicerGroups = 65535;  // in a direction, on any GPU
constexpr GLuint kQueueBinding = 5;
constexpr size_t kFirstCapacity = size_t{1} << 14;
constexpr size_t kQueueHead = 2 * sizeof(uint32_t);  // the count, and what aligns the items
constexpr size_t kQueueItem = 2 * sizeof(uint32_t);

GlObject makeSlicer(GlContext& context, const std::string& name, std::string_view main, GlPrecision precision) {
  const GlScope scope(context);
  return makeProgram(context, name, {{GL_COMPUTE_SHADER, {shaders::kSlicer, main}}},
                     precision == GlPrecision::kSingle ? "#define SINGLE\n" : "");
}

/// In the precision of the shaders.
GlObject makeDirections(GlContext& context, const SweepGeometry& sweep, GlPrecision precision) {
  std::vector<glm::dvec2> directions;
  directions.reserve(static_cast<size_t>(sweep.sectors()));
  for (int sector = 0; sector < sweep.sectors(); ++sector) {
    directions.push_back(sweep.sectorDirection(sector));
  }
  return precision == GlPrecision::kDouble
             ? makeBuffer(context, directions)
             : makeBuffer(context, std::vector<glm::vec2>(directions.begin(), directions.end()));
}

void setUniforms(const GladGLContext& gl, GLuint program, const SweepGeometry& sweep, GlPrecision precision,
                 bool ownSecondHalf, bool dithered, size_t triangles) {
  gl.ProgramUniform1i(program, 0, sweep.slicesPerHalfTurn());
  gl.ProgramUniform1i(program, 1, sweep.width());
  gl.ProgramUniform1i(program, 2, sweep.height());
  if (precision == GlPrecision::kDouble) {
    gl.ProgramUniform1d(program, 3, sweep.halfHeight());
    gl.ProgramUniform1d(program, 4, sweep.tanHalfStep());
  } else {
    gl.ProgramUniform1f(program, 3, static_cast<float>(sweep.halfHeight()));
    gl.ProgramUniform1f(program, 4, static_cast<float>(sweep.tanHalfStep()));
  }
  gl.ProgramUniform1i(program, 5, ownSecondHalf ? 1 : 0);
  gl.ProgramUniform1i(program, 6, dithered ? 1 : 0);
  gl.ProgramUniform1ui(program, 7, static_cast<GLuint>(triangles));
}

}  // namespace

GlSlicer::GlSlicer(GlContext& context, GlPrecision precision)
    : context_(&context),
      precision_(precision),
      small_(makeSlicer(context, "slice_small", shaders::kSliceSmall, precision)),
      large_(makeSlicer(context, "slice_large", shaders::kSliceLarge, precision)) {}

void GlSlicer::makeRoom(size_t items) {
  const size_t most = (static_cast<size_t>(context_->info().maxStorageBytes) - kQueueHead) / kQueueItem;
  if (items > most) {
    throw GlError("the scene's large triangles have more parts than this GPU's shaders address", "slicer",
                  "use a smaller scene or a profile with fewer slices, or slice without OpenGL");
  }
  queueRoom_ = std::min(std::max(items + items / 4, kFirstCapacity), most);
  queue_ = makeBuffer(*context_, kQueueHead + queueRoom_ * kQueueItem);
}

size_t GlSlicer::sliceSmall(size_t triangles) {
  const GladGLContext& gl = context_->gl();
  gl.ClearNamedBufferSubData(queue_.id(), GL_R32UI, 0, sizeof(uint32_t), GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
  gl.ProgramUniform1ui(small_.id(), 8, static_cast<GLuint>(queueRoom_));
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, kQueueBinding, queue_.id());
  const size_t groups = (triangles + kGroupSize - 1) / kGroupSize;
  const size_t across = std::min(groups, kMaxSlicerGroups);
  gl.UseProgram(small_.id());
  gl.DispatchCompute(static_cast<GLuint>(across), static_cast<GLuint>((groups + across - 1) / across), 1);
  uint32_t queued = 0;
  readBuffer(*context_, queue_, sizeof(queued), &queued);
  return queued;
}

void GlSlicer::sliceLarge(size_t queued) {
  const GladGLContext& gl = context_->gl();
  gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  gl.UseProgram(large_.id());
  for (size_t first = 0; first < queued; first += kMaxSlicerGroups) {
    gl.ProgramUniform1ui(large_.id(), 9, static_cast<GLuint>(first));
    gl.DispatchCompute(static_cast<GLuint>(std::min(queued - first, kMaxSlicerGroups)), 1, 1);
  }
}

void GlSlicer::slice(const GlMesh& mesh, GlVolume& volume, const SliceOptions& options) {
  const GlScope scope(*context_);
  const GladGLContext& gl = context_->gl();
  const DisplayProfile& profile = volume.profile();
  if (needsCpu(options)) {
    throw InputError("OpenGL slices with ordered dithering or without any, and nothing else", "slicer",
                     "slice without OpenGL");
  }
  volume.clear();
  if (mesh.triangleCount() == 0) {
    return;
  }
  if (slices_ != profile.slicesPerHalfTurn) {
    directions_ = makeDirections(*context_, SweepGeometry(profile), precision_);
    slices_ = profile.slicesPerHalfTurn;
  }
  if (!queue_) {
    makeRoom(0);
  }
  const SweepGeometry sweep(profile);
  for (const GlObject* program : {&small_, &large_}) {
    setUniforms(gl, program->id(), sweep, precision_, profile.secondHalfTurn == SecondHalfTurn::kOwn,
                options.colors == ColorReduction::kDither, mesh.triangleCount());
  }
  GLuint binding = 0;
  for (const GLuint buffer :
       {mesh.positions().id(), mesh.colors().id(), mesh.triangles().id(), directions_.id(), volume.words().id()}) {
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, binding++, buffer);
  }
  size_t queued = sliceSmall(mesh.triangleCount());
  if (queued > queueRoom_) {
    makeRoom(queued);
    queued = sliceSmall(mesh.triangleCount());  // what is lit already stays lit
  }
  sliceLarge(queued);
  gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
  context_->check("slicing " + std::to_string(mesh.triangleCount()) + " triangles");
}

}  // namespace ocelli
