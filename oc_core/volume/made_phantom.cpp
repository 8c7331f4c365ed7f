// The head phantom of Shepp and Logan in three dimensions: ten ellipsoids whose densities add up.
//
//   A. Kak and M. Slaney, "Principles of computerized tomographic imaging", 1988, table 3.2: where they are
//
// DEVIATION: the densities there are those of X-rays in tissue, 1 to 2 % apart inside of the skull, which no transfer
// function shows. They are raised, as P. Toft did for the phantom of the plane ("The Radon transform", 1996).
#include <array>
#include <cmath>

#include "oc_core/base/conventions.h"
#include "oc_core/volume/builtin_volume_list.h"
#include "oc_core/volume/made_volume.h"

namespace ocelli {
namespace {

struct PhantomEllipsoid {
  glm::dvec3 center;
  glm::dvec3 radii;
  double degrees;  ///< that it is turned by around z
  double density;
};

// x to the right of the head, y to its front, z to its top; the head fits -1 to 1.
constexpr std::array<PhantomEllipsoid, 10> kEllipsoids{{{{0, 0, 0}, {0.69, 0.92, 0.9}, 0, 1},
                                                        {{0, 0, 0}, {0.6624, 0.874, 0.88}, 0, -0.8},
                                                        {{-0.22, 0, -0.25}, {0.41, 0.16, 0.21}, 108, -0.2},
                                                        {{0.22, 0, -0.25}, {0.31, 0.11, 0.22}, 72, -0.2},
                                                        {{0, 0.35, -0.25}, {0.21, 0.25, 0.5}, 0, 0.1},
                                                        {{0, 0.1, -0.25}, {0.046, 0.046, 0.046}, 0, 0.1},
                                                        {{-0.08, -0.65, -0.25}, {0.046, 0.023, 0.02}, 0, 0.1},
                                                        {{0.06, -0.65, -0.25}, {0.046, 0.023, 0.02}, 90, 0.1},
                                                        {{0.06, -0.105, 0.625}, {0.056, 0.04, 0.1}, 90, 0.1},
                                                        {{0, 0.1, 0.625}, {0.056, 0.056, 0.1}, 0, -0.1}}};

/// Adds the density to those centres of a row, `x` of which is `first` + i * `step`, that are in the ellipsoid.
void addToRow(const PhantomEllipsoid& ellipsoid, double first, double step, double y, double z, std::span<float> row) {
  // In the frame of the ellipsoid, its radii taken out, a point of the row is a + x b, and in it where its length is
  // at most 1: between the roots of a quadratic equation.
  const double radians = radiansFromDegrees(ellipsoid.degrees);
  const double cosine = std::cos(radians);
  const double sine = std::sin(radians);
  const auto scaled = [&](double px, double py, double pz) {
    return glm::dvec3(cosine * px + sine * py, cosine * py - sine * px, pz) / ellipsoid.radii;
  };
  const glm::dvec3 a = scaled(-ellipsoid.center.x, y - ellipsoid.center.y, z - ellipsoid.center.z);
  const glm::dvec3 b = scaled(1, 0, 0);
  const double half = glm::dot(a, b) / glm::dot(b, b);
  const double rest = half * half - (glm::dot(a, a) - 1) / glm::dot(b, b);
  if (rest < 0) {
    return;
  }
  const double count = static_cast<double>(row.size());
  const double begin = std::clamp(std::ceil((-half - std::sqrt(rest) - first) / step), 0.0, count);
  const double end = std::clamp(std::floor((-half + std::sqrt(rest) - first) / step) + 1, begin, count);
  for (auto i = static_cast<size_t>(begin); i < static_cast<size_t>(end); ++i) {
    row[i] += static_cast<float>(ellipsoid.density);
  }
}

BuiltinVolume makePhantom(const BuiltinValues& values) {
  const auto count = static_cast<int>(values.count("size"));
  const double step = 2.0 / count;
  VolumeGrid grid = gridAroundOrigin(glm::ivec3(count), step);
  const double first = grid.worldFromIndex[3].x;
  // Its front and its top are those of a patient, whose x is to the left and whose y is to the back.
  grid.isAnatomical = true;
  grid.worldFromIndex =
      glm::dmat4(glm::dvec4(-1, 0, 0, 0), glm::dvec4(0, -1, 0, 0), glm::dvec4(0, 0, 1, 0), glm::dvec4(0, 0, 0, 1)) *
      grid.worldFromIndex;
  ScalarVolume volume = madeVolume<float>(grid, [&](int j, int k, std::span<float> row) {
    for (const PhantomEllipsoid& ellipsoid : kEllipsoids) {
      addToRow(ellipsoid, first, step, first + step * j, first + step * k, row);
    }
  });
  return {std::move(volume),
          {TransferFunction({transferPoint(0.05, 0x2b5b84, 0), transferPoint(0.15, 0x2b83b8, 0.05),
                             transferPoint(0.2, 0x56606b, 0.008), transferPoint(0.25, 0xe69f00, 0.08),
                             transferPoint(0.4, 0xf0c060, 0.3), transferPoint(0.6, 0xd0c8bc, 0.01),
                             transferPoint(1, 0xf5efe6, 0.03)},
                            2.0 / 128),
           {.isOn = true}}};
}

}  // namespace

BuiltinVolumeKind phantomVolume() {
  return {"phantom",
          "the head phantom of Shepp and Logan in three dimensions: ten ellipsoids",
          {sizeParameter(128)},
          makePhantom};
}

}  // namespace ocelli
