#include "oc_core/volume_gl/gl_volume_renderer.h"

#include <algorithm>
#include <array>
#include <glm/matrix.hpp>
#include <span>
#include <utility>

#include "oc_core/base/check.h"
#include "oc_core/gl/displacement_uniforms.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/pinhole_uniforms.h"
#include "oc_core/volume/gradient_light.h"
#include "oc_core/volume/volume_bricks.h"
#include "oc_core/volume_gl/gl_volume_march.h"
#include "oc_core/volume_gl/gl_voxel_texture.h"
#include "oc_core/volume_gl/listed_volume_rays.h"
#include "oc_core/volume_render/optical_table.h"
#include "oc_core/volume_render/volume_occupancy.h"

namespace ocelli {
namespace {

constexpr const char* kStage = "rendering the volume";
/// Rows of a pinhole's image between two calls of `progress`.
constexpr int kRowsOfBand = 128;
/// Of listed rays that are uploaded together.
constexpr size_t kBytesOfList = size_t{32} << 20;
constexpr int kMinListedRows = 8;
constexpr int kMaxListedRows = 256;

/// In the layout std140, as shaders/volume_light.glsl has it.
struct LightBlock {
  glm::mat4 sceneFromIndexGradient{1};
  glm::vec3 toLight{0};
  float litByGradient = 0;
  float ambient = 0;
  float diffuse = 0;
  float specular = 0;
  float shininess = 0;
};

/// The same, as shaders/pinhole_rays.glsl has it.
struct ExtentBlock {
  glm::mat4 indexFromWorld{1};
  glm::vec3 eyeIndex{0};
  float unitsByWorldLength = 1;
  std::array<glm::vec4, kMaxShaderClips> clips{};
  int32_t clipCount = 0;
  std::array<int32_t, 3> unused{};
};

/// A row for each of the numbers of an entry.
GlObject uploadTable(GlContext& context, const OpticalTable& table) {
  constexpr int kRows = 4;
  const std::vector<OpticalTable::Entry>& entries = table.entries();
  Image<OpticalTable::Four> texels(static_cast<int>(entries.size()), kRows);
  for (int i = 0; i < texels.width(); ++i) {
    const OpticalTable::Entry& entry = entries[static_cast<size_t>(i)];
    texels(i, 0) = entry.integral;
    texels(i, 1) = entry.rest;
    texels(i, 2) = entry.at;
    texels(i, 3) = entry.halfChange;
  }
  GlObject texture = makeTexture(context, GL_RGBA32F, texels.width(), kRows);
  context.gl().TextureSubImage2D(texture.id(), 0, 0, 0, texels.width(), kRows, GL_RGBA, GL_FLOAT, texels.data());
  context.check("uploading a transfer function");
  return texture;
}

GlObject uploadBricks(GlContext& context, const glm::ivec3& size, const uint8_t* distances) {
  const GladGLContext& gl = context.gl();
  uint32_t id = 0;
  gl.CreateTextures(GL_TEXTURE_3D, 1, &id);
  GlObject texture(context, GlObjectKind::kTexture, id);
  gl.TextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.TextureStorage3D(id, 1, GL_R8UI, size.x, size.y, size.z);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TextureSubImage3D(id, 0, 0, 0, 0, size.x, size.y, size.z, GL_RED_INTEGER, GL_UNSIGNED_BYTE, distances);
  context.check("uploading which bricks of a volume are empty");
  return texture;
}

}  // namespace

struct GlVolumeRenderer::Impl {
  GlContext& context;
  VolumeScene scene;
  VolumeRenderOptions options;
  GlVolumeFilter filter;
  VolumeBricks bricks;
  ValueRange range;
  VolumeRayLister lister;
  GlVoxelTexture voxels;
  mutable GlVolumeMarch march;
  double diagonal;  ///< of the volume, in its unit: no straight ray is longer within
  // Of the appearance and the options:
  GlObject table;
  GlObject occupancy;
  GlObject light;
  VolumeMarchNumbers numbers;

  Impl(GlContext& itsContext, VolumeScene itsScene, const VolumeRenderOptions& itsOptions, GlVolumeFilter itsFilter,
       const Progress& progress)
      : context(itsContext),
        scene(std::move(itsScene)),
        options(itsOptions),
        filter(itsFilter),
        bricks(*scene.volume),
        range(rangeOf(bricks)),
        lister(scene),
        voxels(context, *scene.volume, progress),
        march(context),
        diagonal(diagonalOf(scene.volume->grid())) {
    prepare();
  }

  static double diagonalOf(const VolumeGrid& grid) {
    const glm::dvec3 sides = grid.spacing() * glm::dvec3(grid.size);
    return sides.x + sides.y + sides.z;  // no less than any diagonal, also of boxes that are not rectangular
  }

  void prepare() {
    OC_CHECK(options.step > 0 && options.depthOpacity > 0 && options.depthOpacity < 1,
             "steps are positive, and the opacity of the depth lies in (0, 1)");
    const OpticalTable optics(scene.appearance.transfer, range);
    table = uploadTable(context, optics);
    if (options.skipEmpty) {
      const VolumeOccupancy full(bricks, optics);
      occupancy = uploadBricks(context, full.size(), full.distances().data());
    } else {
      const uint8_t isSeen = 0;
      occupancy = uploadBricks(context, glm::ivec3(1), &isSeen);
    }
    const GradientLight<float> rule =
        singleLight(gradientLight(scene.worldFromIndex, scene.appearance.shading, range), voxels.scale());
    const LightBlock block{glm::mat4(rule.worldFromIndexGradient),
                           rule.toLight,
                           rule.litByGradient,
                           rule.ambient,
                           rule.diffuse,
                           rule.specular,
                           rule.shininess};
    light = makeBuffer(context, sizeof(block), &block);
    numbers = {static_cast<float>(options.step * scene.volume->grid().meanSpacing()),
               static_cast<float>(options.endTransmittance), static_cast<float>(1 - options.depthOpacity),
               static_cast<float>(voxels.scale() * optics.entriesByValue()),
               static_cast<float>((voxels.offset() - optics.firstValue()) * optics.entriesByValue())};
  }

  VolumeMarchKind kind(VolumeRaysFrom rays) const {
    return {rays, scene.appearance.shading.isOn, rays == VolumeRaysFrom::kList && lister.hasSurfaces(),
            filter == GlVolumeFilter::kHardware};
  }

  /// Whether the shader can make and cut the rays of a pinhole.
  bool cutsPinholes() const { return !lister.hasSurfaces() && scene.clips.size() <= size_t{kMaxShaderClips}; }

  GlObject extentOf(const PinholeCamera& camera) const {
    const glm::dmat4 indexFromWorld = glm::inverse(scene.worldFromIndex);
    const glm::dvec3 eye(camera.eye());
    ExtentBlock block{glm::mat4(indexFromWorld), glm::vec3(indexFromWorld * glm::dvec4(eye, 1)),
                      static_cast<float>(1 / scene.sceneLengthOfUnit())};
    for (const ClipPlane& clip : scene.clips) {
      block.clips[static_cast<size_t>(block.clipCount++)] =
          glm::vec4(glm::dvec4(clip.normal, glm::dot(clip.normal, eye) - clip.distance));
    }
    return makeBuffer(context, sizeof(block), &block);
  }

  Picture begin(int width, int height) const {
    return {makeTexture(context, GL_RGBA32F, width, height), makeTexture(context, GL_RGBA32F, width, height)};
  }

  /// Binds what every variant of the shader reads and writes.
  void bind(const Picture& picture) const {
    const GladGLContext& gl = context.gl();
    gl.BindTextureUnit(0, voxels.texture().id());
    gl.BindTextureUnit(1, occupancy.id());
    gl.BindTextureUnit(2, table.id());
    gl.BindBufferBase(GL_UNIFORM_BUFFER, 2, light.id());
    gl.BindImageTexture(0, picture.colors.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
    gl.BindImageTexture(1, picture.depths.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
  }

  /// The shader makes the rays: of `camera`, or of a general pinhole around it, whose zones are bound.
  Picture drawPinhole(const PinholeCamera& camera, VolumeRaysFrom rays, const Progress& progress) const {
    const GladGLContext& gl = context.gl();
    Picture picture = begin(camera.width(), camera.height());
    const GlObject pinhole = pinholeUniforms(context, camera);
    const GlObject extent = extentOf(camera);
    bind(picture);
    gl.BindBufferBase(GL_UNIFORM_BUFFER, 0, pinhole.id());
    gl.BindBufferBase(GL_UNIFORM_BUFFER, 1, extent.id());
    const int band = progress ? kRowsOfBand : std::max(camera.height(), 1);
    for (int first = 0; first < camera.height(); first += band) {
      report(progress, kStage, static_cast<double>(first) / camera.height());
      march.run(kind(rays), numbers, camera.width(), first, std::min(first + band, camera.height()), diagonal);
      if (progress) {
        gl.Finish();
      }
    }
    report(progress, kStage, 1);
    return picture;
  }

  /// Marches along listed rows, as many together as their pieces allow.
  void marchRows(std::span<const ListedRow> rows, int width, int firstRow) const {
    for (size_t begin = 0; begin < rows.size();) {
      size_t end = begin;
      size_t bytes = 0;
      double longest = 0;
      do {
        bytes += rows[end].pieces.size() * sizeof(ListedPiece);
        longest = std::max(longest, rows[end].longest);
        ++end;
      } while (end < rows.size() && bytes + rows[end].pieces.size() * sizeof(ListedPiece) <= kBytesOfList);
      const GlListedRows onGpu = uploadRows(context, rows.data() + begin, end - begin);
      const GladGLContext& gl = context.gl();
      gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, onGpu.pieces.id());
      gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 3, onGpu.firstPieces.id());
      gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 4, onGpu.surfaces.id());
      march.run(kind(VolumeRaysFrom::kList), numbers, width, firstRow + static_cast<int>(begin),
                firstRow + static_cast<int>(end), longest);
      begin = end;
    }
  }

  VolumeImage read(const Picture& picture, int width, int height) const {
    const auto colors = readTexture<glm::vec4>(context, picture.colors, width, height, GL_RGBA, GL_FLOAT);
    const auto depths = readTexture<glm::vec4>(context, picture.depths, width, height, GL_RGBA, GL_FLOAT);
    constexpr float kSomewhere = 1e38f;  // the shader's nowhere is beyond
    const auto tOf = [](float t) { return t < kSomewhere ? t : VolumePixel::kNowhere; };
    VolumeImage image(width, height);
    for (size_t i = 0; i < image.size(); ++i) {
      image[i] = {colors[i], tOf(depths[i].x), tOf(depths[i].y), static_cast<uint32_t>(depths[i].z)};
    }
    return image;
  }
};

GlVolumeRenderer::GlVolumeRenderer(GlContext& context, VolumeScene scene, const VolumeRenderOptions& options,
                                   GlVolumeFilter filter, const Progress& progress) {
  const GlScope scope(context);
  impl_ = std::make_unique<Impl>(context, std::move(scene), options, filter, progress);
}

GlVolumeRenderer::~GlVolumeRenderer() = default;

GlContext& GlVolumeRenderer::context() const {
  return impl_->context;
}
const VolumeScene& GlVolumeRenderer::scene() const {
  return impl_->scene;
}
const VolumeRenderOptions& GlVolumeRenderer::options() const {
  return impl_->options;
}

void GlVolumeRenderer::setAppearance(const VolumeAppearance& appearance) {
  const GlScope scope(impl_->context);
  impl_->scene.appearance = appearance;
  impl_->prepare();
}
void GlVolumeRenderer::setClips(std::vector<ClipPlane> clips) {
  impl_->scene.clips = std::move(clips);
}
void GlVolumeRenderer::setOptions(const VolumeRenderOptions& options) {
  const GlScope scope(impl_->context);
  impl_->options = options;
  impl_->prepare();
}

GlVolumeRenderer::Picture GlVolumeRenderer::drawOnGpu(const PinholeCamera& camera, const Progress& progress) const {
  if (!impl_->cutsPinholes()) {
    return drawOnGpu(
        camera.width(), camera.height(), [&](const glm::vec2& pixel) { return camera.rayPath(pixel); }, progress);
  }
  return impl_->drawPinhole(camera, VolumeRaysFrom::kPinhole, progress);
}

GlVolumeRenderer::Picture GlVolumeRenderer::drawOnGpu(const GpcCamera& camera, const Progress& progress) const {
  if (!impl_->cutsPinholes()) {
    return drawOnGpu(
        camera.width(), camera.height(), [&](const glm::vec2& pixel) { return camera.rayPath(pixel); }, progress);
  }
  const GlObject zones = zoneTexture(impl_->context, camera);
  impl_->context.gl().BindTextureUnit(3, zones.id());
  return impl_->drawPinhole(camera.reference(), VolumeRaysFrom::kLenses, progress);
}

GlVolumeRenderer::Picture GlVolumeRenderer::drawOnGpu(int width, int height,
                                                      const std::function<RayPath(const glm::vec2& pixel)>& rayPath,
                                                      const Progress& progress) const {
  Picture picture = impl_->begin(width, height);
  impl_->bind(picture);
  int count = kMinListedRows;
  for (int first = 0; first < height;) {
    report(progress, kStage, static_cast<double>(first) / height);
    const int end = std::min(first + count, height);
    const std::vector<ListedRow> rows = impl_->lister.rows(width, first, end, rayPath);
    impl_->marchRows(rows, width, first);
    // As many next time as would fill the list.
    size_t bytes = 1;
    for (const ListedRow& row : rows) {
      bytes += row.pieces.size() * sizeof(ListedPiece);
    }
    const double fit = static_cast<double>(kBytesOfList) * (end - first) / static_cast<double>(bytes);
    count = static_cast<int>(std::clamp(fit, double{kMinListedRows}, std::min(2.0 * count, double{kMaxListedRows})));
    first = end;
  }
  report(progress, kStage, 1);
  return picture;
}

VolumeImage GlVolumeRenderer::render(const PinholeCamera& camera, const Progress& progress) const {
  const GlScope scope(impl_->context);
  return impl_->read(drawOnGpu(camera, progress), camera.width(), camera.height());
}

VolumeImage GlVolumeRenderer::render(const GpcCamera& camera, const Progress& progress) const {
  const GlScope scope(impl_->context);
  return impl_->read(drawOnGpu(camera, progress), camera.width(), camera.height());
}

VolumeImage GlVolumeRenderer::render(int width, int height,
                                     const std::function<RayPath(const glm::vec2& pixel)>& rayPath,
                                     const Progress& progress) const {
  const GlScope scope(impl_->context);
  return impl_->read(drawOnGpu(width, height, rayPath, progress), width, height);
}

}  // namespace ocelli
