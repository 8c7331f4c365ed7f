#include "oc_core/gl/epipolar_uniforms.h"

#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/pinhole_uniforms.h"

namespace ocelli {
namespace {

/// In the layout std140.
struct LinesBlock {
  glm::dvec2 epipole;
  double disparity;
  double advanceSign;
  int32_t rowCount;
  int32_t longest;
  int32_t isParallel;
  int32_t isForward;
  int32_t isRing;
  float firstAngle;
  float angleStep;
  float clipMargin;
};
static_assert(sizeof(LinesBlock) == 64);

/// In the layout std430.
struct RowItem {
  glm::dvec2 direction;
  int32_t start;
  int32_t length;
  int32_t firstDisocclusion;
  int32_t disocclusionCount;
};
static_assert(sizeof(RowItem) == 32);

/// In the layout std430.
struct DisocclusionItem {
  int32_t position;
  int32_t added;
  int32_t shift;
  int32_t unused;
  double xRight;
  double yFar;
};
static_assert(sizeof(DisocclusionItem) == 32);

GlObject linesBlock(GlContext& context, const EpipolarLines& lines) {
  const LinesBlock block{lines.epipole(),
                         lines.disparity(),
                         lines.advance() > 0 ? 1.0 : -1.0,
                         lines.rowCount(),
                         lines.longest(),
                         lines.isParallel(),
                         lines.isForward(),
                         lines.isRing(),
                         static_cast<float>(lines.firstAngle()),
                         static_cast<float>(lines.angleStep()),
                         EpipolarUniforms::kClipMargin};
  return makeBuffer(context, sizeof(block), &block);
}

RowItem rowItem(const EpipolarLines& lines, int row) {
  return {lines.isParallel() ? glm::dvec2(1, 0) : lines.direction(row + 0.5), lines.start(row), lines.length(row), 0,
          0};
}

}  // namespace

EpipolarUniforms::EpipolarUniforms(GlContext& context, const PinholeCamera& base, const EpipolarLines& lines)
    : pinhole_(pinholeUniforms(context, base)), lines_(linesBlock(context, lines)) {
  std::vector<RowItem> rows;
  for (int row = 0; row < lines.rowCount(); ++row) {
    rows.push_back(rowItem(lines, row));
  }
  rows_ = makeBuffer(context, rows);
  disocclusions_ = makeBuffer(context, 0);
  over_ = makeBuffer(context, 0);
}

EpipolarUniforms::EpipolarUniforms(GlContext& context, const EpipolarCamera& camera)
    : pinhole_(pinholeUniforms(context, camera.base())), lines_(linesBlock(context, camera.lines())) {
  const EpipolarLines& lines = camera.lines();
  std::vector<RowItem> rows;
  std::vector<DisocclusionItem> disocclusions;
  const size_t stride = static_cast<size_t>(lines.longest()) + 1;
  const size_t cells = static_cast<size_t>(lines.rowCount()) * stride;
  std::vector<uint32_t> over(cells + 1);  // where each list begins; the lists follow
  for (int row = 0; row < lines.rowCount(); ++row) {
    rows.push_back(rowItem(lines, row));
    rows.back().firstDisocclusion = static_cast<int32_t>(disocclusions.size());
    for (const EpipolarCamera::Disocclusion& disocclusion : camera.disocclusions(row)) {
      disocclusions.push_back(
          {disocclusion.position, disocclusion.added, disocclusion.shift, 0, disocclusion.xRight, disocclusion.yFar});
    }
    rows.back().disocclusionCount = static_cast<int32_t>(disocclusions.size()) - rows.back().firstDisocclusion;
    for (size_t cell = 0; cell < stride; ++cell) {
      over[static_cast<size_t>(row) * stride + cell] = static_cast<uint32_t>(over.size());
      const auto list = camera.disocclusionsOver(row, static_cast<int>(cell));
      over.insert(over.end(), list.begin(), list.end());
    }
  }
  over[cells] = static_cast<uint32_t>(over.size());
  rows_ = makeBuffer(context, rows);
  disocclusions_ = makeBuffer(context, disocclusions);
  over_ = makeBuffer(context, over);
}

void EpipolarUniforms::bind(GlContext& context) const {
  const GladGLContext& gl = context.gl();
  gl.BindBufferBase(GL_UNIFORM_BUFFER, 0, pinhole_.id());
  gl.BindBufferBase(GL_UNIFORM_BUFFER, 1, lines_.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 4, rows_.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 5, disocclusions_.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 6, over_.id());
}

}  // namespace ocelli
