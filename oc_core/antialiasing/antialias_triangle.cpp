#include "oc_core/antialiasing/antialias_triangle.h"

#include <bit>

namespace ocelli {
namespace {

constexpr int kSnapBits = 12;
constexpr int64_t kSnapped = int64_t{1} << kSnapBits;  ///< of a pixel

struct SnappedPoint {
  int64_t x;
  int64_t y;
};

/// To the nearest, ties to even, as std::llrint does, but inlined: the last bit of the sum stands for 1.
int64_t snapped(float pixels) {
  constexpr double kIntegerBits = 6755399441055744.0;  // 1.5 * 2^52
  return std::bit_cast<int64_t>(static_cast<double>(pixels) * kSnapped + kIntegerBits) -
         std::bit_cast<int64_t>(kIntegerBits);
}

float inPixels(int64_t snappedValue) {
  return static_cast<float>(snappedValue) / static_cast<float>(kSnapped);
}

}  // namespace

bool prepareTriangle(AntialiasTriangle& t, uint32_t triangle, const RasterVertex& a, const RasterVertex& b,
                     const RasterVertex& c, const glm::ivec2& base) {
  t.triangle = triangle;
  t.corners = {a, b, c};
  std::array<SnappedPoint, 3> p = {
      {{snapped(a.u), snapped(a.v)}, {snapped(b.u), snapped(b.v)}, {snapped(c.u), snapped(c.v)}}};
  int64_t area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
  if (area == 0) {
    return false;
  }
  if (area < 0) {  // both sides of a surface are drawn
    std::swap(p[1], p[2]);
    std::swap(t.corners[1], t.corners[2]);
    area = -area;
  }
  const SnappedPoint origin{base.x * kSnapped, base.y * kSnapped};
  t.perArea = static_cast<float>(1.0 / static_cast<double>(area));
  double za = 0;
  double zb = 0;
  double zc = 0;
  for (size_t i = 0; i < 3; ++i) {
    const SnappedPoint& from = p[(i + 1) % 3];
    const SnappedPoint& to = p[(i + 2) % 3];
    const int64_t dx = to.x - from.x;
    const int64_t dy = to.y - from.y;
    const int64_t atBase = dx * (origin.y - from.y) - dy * (origin.x - from.x);
    t.edges[i] = {static_cast<float>(-dy * kSnapped), static_cast<float>(dx * kSnapped), static_cast<float>(atBase)};
    t.inside[i] = dy < 0 || (dy == 0 && dx > 0) ? 0 : AntialiasTriangle::kAboveZero;
    const auto weight = static_cast<double>(t.corners[i].inverseZ) / static_cast<double>(area);
    za += static_cast<double>(-dy * kSnapped) * weight;
    zb += static_cast<double>(dx * kSnapped) * weight;
    zc += static_cast<double>(atBase) * weight;
  }
  t.inverseZ = {static_cast<float>(za), static_cast<float>(zb), static_cast<float>(zc)};
  t.box = {{inPixels(std::min({p[0].x, p[1].x, p[2].x}) - origin.x),
            inPixels(std::min({p[0].y, p[1].y, p[2].y}) - origin.y)},
           {inPixels(std::max({p[0].x, p[1].x, p[2].x}) - origin.x),
            inPixels(std::max({p[0].y, p[1].y, p[2].y}) - origin.y)}};
  return true;
}

std::optional<glm::vec3> AntialiasTriangle::onlyColor(const Mesh& mesh) const {
  if (mesh.colors.empty()) {
    return glm::vec3(1);
  }
  const glm::uvec3& t = mesh.triangles[triangle];
  const glm::vec3& first = mesh.colors[t.x];
  return first == mesh.colors[t.y] && first == mesh.colors[t.z] ? std::optional(first) : std::nullopt;
}

glm::vec3 AntialiasTriangle::colorAt(float x, float y, const Mesh& mesh) const {
  if (const std::optional<glm::vec3> only = onlyColor(mesh)) {
    return *only;
  }
  glm::vec3 weights;
  for (int i = 0; i < 3; ++i) {
    const auto corner = static_cast<size_t>(i);
    weights[i] = std::max(edges[corner].at(x, y) * perArea, 0.0f) * corners[corner].inverseZ;
  }
  weights /= weights.x + weights.y + weights.z;
  const float b1 = weights.x * corners[0].b1 + weights.y * corners[1].b1 + weights.z * corners[2].b1;
  const float b2 = weights.x * corners[0].b2 + weights.y * corners[1].b2 + weights.z * corners[2].b2;
  const glm::uvec3& t = mesh.triangles[triangle];
  return mesh.colors[t.x] * (1 - b1 - b2) + mesh.colors[t.y] * b1 + mesh.colors[t.z] * b2;
}

}  // namespace ocelli
