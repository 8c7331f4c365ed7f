#include "oc_core/worlds/teapot.h"

#include <array>
#include <glm/vec2.hpp>

#include "oc_core/base/check.h"
#include "oc_core/scene/share_vertices.h"

namespace ocelli {
namespace {

/// Control points of one patch, row after row. Newell's axes: z is up, and the patch is the one with y <= 0.
using Patch = std::array<glm::vec3, 16>;

/// Control points (radius, height) of the profile of a patch that is swept around the axis.
using Profile = std::array<glm::vec2, 4>;

// From the top: knob, lid, rim, upper body, lower body, bottom. Each is a quarter turn.
constexpr std::array<Profile, 6> kProfiles{{
    {{{0, 3.15f}, {0.8f, 3.15f}, {0, 2.85f}, {0.2f, 2.7f}}},
    {{{0.2f, 2.7f}, {0.4f, 2.55f}, {1.3f, 2.55f}, {1.3f, 2.4f}}},
    {{{1.4f, 2.4f}, {1.3375f, 2.53125f}, {1.4375f, 2.53125f}, {1.5f, 2.4f}}},
    {{{1.5f, 2.4f}, {1.75f, 1.875f}, {2, 1.35f}, {2, 0.9f}}},
    {{{2, 0.9f}, {2, 0.45f}, {1.5f, 0.225f}, {1.5f, 0.15f}}},
    {{{1.5f, 0.15f}, {1.5f, 0.075f}, {1.425f, 0}, {0, 0}}},
}};

// The nearer half of the handle, upper and lower, and of the spout, lower and upper.
// clang-format off
constexpr std::array<Patch, 4> kHalves{{
    {{{-1.6f, 0, 2.025f},   {-1.6f, -0.3f, 2.025f}, {-1.5f, -0.3f, 2.25f}, {-1.5f, 0, 2.25f},
      {-2.3f, 0, 2.025f},   {-2.3f, -0.3f, 2.025f}, {-2.5f, -0.3f, 2.25f}, {-2.5f, 0, 2.25f},
      {-2.7f, 0, 2.025f},   {-2.7f, -0.3f, 2.025f}, {-3.0f, -0.3f, 2.25f}, {-3.0f, 0, 2.25f},
      {-2.7f, 0, 1.8f},     {-2.7f, -0.3f, 1.8f},   {-3.0f, -0.3f, 1.8f},  {-3.0f, 0, 1.8f}}},
    {{{-2.7f, 0, 1.8f},     {-2.7f, -0.3f, 1.8f},   {-3.0f, -0.3f, 1.8f},      {-3.0f, 0, 1.8f},
      {-2.7f, 0, 1.575f},   {-2.7f, -0.3f, 1.575f}, {-3.0f, -0.3f, 1.35f},     {-3.0f, 0, 1.35f},
      {-2.5f, 0, 1.125f},   {-2.5f, -0.3f, 1.125f}, {-2.65f, -0.3f, 0.9375f},  {-2.65f, 0, 0.9375f},
      {-2.0f, 0, 0.9f},     {-2.0f, -0.3f, 0.9f},   {-1.9f, -0.3f, 0.6f},      {-1.9f, 0, 0.6f}}},
    {{{1.7f, 0, 1.425f},    {1.7f, -0.66f, 1.425f}, {1.7f, -0.66f, 0.6f},    {1.7f, 0, 0.6f},
      {2.6f, 0, 1.425f},    {2.6f, -0.66f, 1.425f}, {3.1f, -0.66f, 0.825f},  {3.1f, 0, 0.825f},
      {2.3f, 0, 2.1f},      {2.3f, -0.25f, 2.1f},   {2.4f, -0.25f, 2.025f},  {2.4f, 0, 2.025f},
      {2.7f, 0, 2.4f},      {2.7f, -0.25f, 2.4f},   {3.3f, -0.25f, 2.4f},    {3.3f, 0, 2.4f}}},
    {{{2.7f, 0, 2.4f},      {2.7f, -0.25f, 2.4f},   {3.3f, -0.25f, 2.4f},       {3.3f, 0, 2.4f},
      {2.8f, 0, 2.475f},    {2.8f, -0.25f, 2.475f}, {3.525f, -0.25f, 2.49375f}, {3.525f, 0, 2.49375f},
      {2.9f, 0, 2.475f},    {2.9f, -0.15f, 2.475f}, {3.45f, -0.15f, 2.5125f},   {3.45f, 0, 2.5125f},
      {2.8f, 0, 2.4f},      {2.8f, -0.15f, 2.4f},   {3.2f, -0.15f, 2.4f},       {3.2f, 0, 2.4f}}},
}};
// clang-format on

/// The quarter turn with x >= 0 and y <= 0. Bezier curves draw no circle; 0.56 is Newell's choice.
/// DEVIATION: the table of the knob says 0.45 where 0.56 * 0.8 is 0.448.
Patch sweptQuarter(const Profile& profile) {
  constexpr float kArc = 0.56f;
  Patch patch;
  for (size_t row = 0; row < 4; ++row) {
    const float r = profile[row].x;
    const float z = profile[row].y;
    patch[4 * row + 0] = {r, 0, z};
    patch[4 * row + 1] = {r, -kArc * r, z};
    patch[4 * row + 2] = {kArc * r, -r, z};
    patch[4 * row + 3] = {0, -r, z};
  }
  return patch;
}

std::array<double, 4> bernstein(double t) {
  const double s = 1 - t;
  return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

/// In double precision, so that control points that coincide give points that coincide once they are floats.
glm::vec3 evaluate(const Patch& patch, double u, double v) {
  const std::array<double, 4> rows = bernstein(u);
  const std::array<double, 4> columns = bernstein(v);
  glm::dvec3 point(0);
  for (size_t row = 0; row < 4; ++row) {
    for (size_t column = 0; column < 4; ++column) {
      point += rows[row] * columns[column] * glm::dvec3(patch[4 * row + column]);
    }
  }
  return glm::vec3(point);
}

/// Adds the patch with its x and y multiplied by 1 or -1, in our axes (y up). The table's patches face inwards.
/// Triangles without an area, which stand where a row of control points is one point, are left out.
void addPatch(Mesh& mesh, const Patch& patch, int segments, float signX, float signY) {
  const auto base = static_cast<uint32_t>(mesh.positions.size());
  const auto stride = static_cast<uint32_t>(segments + 1);
  for (int i = 0; i <= segments; ++i) {
    for (int j = 0; j <= segments; ++j) {
      const glm::vec3 p = evaluate(patch, static_cast<double>(i) / segments, static_cast<double>(j) / segments);
      // Adding zero turns -0 into 0, so that mirrored seams are equal bit by bit.
      mesh.positions.push_back(glm::vec3(signX * p.x, p.z, -signY * p.y) + 0.0f);
    }
  }
  const bool mirrored = signX * signY < 0;
  const auto addTriangle = [&](uint32_t a, uint32_t b, uint32_t c) {
    const glm::vec3& pa = mesh.positions[a];
    const glm::vec3& pb = mesh.positions[b];
    const glm::vec3& pc = mesh.positions[c];
    if (pa != pb && pb != pc && pc != pa) {
      mesh.triangles.push_back(mirrored ? glm::uvec3(a, b, c) : glm::uvec3(a, c, b));
    }
  };
  for (uint32_t i = 0; i < static_cast<uint32_t>(segments); ++i) {
    for (uint32_t j = 0; j < static_cast<uint32_t>(segments); ++j) {
      const uint32_t corner = base + i * stride + j;
      addTriangle(corner, corner + stride, corner + stride + 1);
      addTriangle(corner, corner + stride + 1, corner + 1);
    }
  }
}

}  // namespace

Mesh makeTeapot(int segments) {
  OC_CHECK(segments >= 1, "a patch has at least one segment a side");
  Mesh mesh;
  for (const Profile& profile : kProfiles) {
    const Patch patch = sweptQuarter(profile);
    for (const float signX : {1.0f, -1.0f}) {
      for (const float signY : {1.0f, -1.0f}) {
        addPatch(mesh, patch, segments, signX, signY);
      }
    }
  }
  for (const Patch& patch : kHalves) {
    for (const float signY : {1.0f, -1.0f}) {
      addPatch(mesh, patch, segments, 1, signY);
    }
  }
  shareVertices(mesh);
  return mesh;
}

}  // namespace ocelli
