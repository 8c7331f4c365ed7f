// `builtin:dna`: a double helix as balls and sticks (the molecule of dissertation Figure 5.2, of another origin).
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "oc_core/base/conventions.h"
#include "oc_core/worlds/builtin_list.h"
#include "oc_core/worlds/dna_molecule.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/solids.h"

namespace ocelli {
namespace {

/// Angstroms.
constexpr float kAtomRadius = 0.6f;
constexpr float kPhosphorusRadius = 0.85f;
constexpr float kStickRadius = 0.26f;
constexpr float kHydrogenBondRadius = 0.14f;
/// The axis leans to the right, so that the helix reaches across the image.
constexpr double kLeanDegrees = 50;
constexpr int kMinBallSegments = 4;

/// How finely balls and sticks are made.
struct BallsAndSticks {
  int ballSegments = kMinBallSegments;
  int stickSides = 3;
};

size_t trianglesOfBall(int segments) {
  return static_cast<size_t>(2 * segments * (std::max(segments / 2, 2) - 1));
}

size_t trianglesOfStick(int sides) {
  return static_cast<size_t>(4 * sides - 4);
}

/// Those that come nearest to `triangles` altogether, and not above what a scene may have, where sticks have half to
/// all of the segments of balls.
BallsAndSticks chooseDetail(const DnaMolecule& molecule, size_t triangles) {
  BallsAndSticks best;
  size_t bestError = triangles + 1;
  for (int ball = kMinBallSegments; molecule.atoms.size() * trianglesOfBall(ball) <= triangles; ++ball) {
    for (int sides = std::max(ball / 2, 3); sides <= ball; ++sides) {
      const size_t made =
          molecule.atoms.size() * trianglesOfBall(ball) + molecule.bonds.size() * trianglesOfStick(sides);
      const size_t error = made > triangles ? made - triangles : triangles - made;
      if (error < bestError && made <= kMaxSceneTriangles) {
        bestError = error;
        best = {ball, sides};
      }
    }
  }
  return best;
}

/// A closed prism of radius 1 around the z axis from 0 to 1.
Mesh makeStick(int sides) {
  std::vector<glm::vec2> outline;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * kPi * i / sides;
    outline.push_back(glm::vec2(std::cos(angle), std::sin(angle)));
  }
  Mesh stick = makePrism(outline, 0.5f);
  transform(stick, glm::translate(glm::mat4(1), glm::vec3(0, 0, 0.5f)));
  return stick;
}

/// The unit stick between two places.
glm::mat4 stickBetween(const glm::vec3& from, const glm::vec3& to, float radius) {
  const glm::vec3 along = to - from;
  const glm::vec3 beside = std::abs(along.z) < 0.7f * glm::length(along) ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0);
  const glm::vec3 x = glm::normalize(glm::cross(beside, along));
  const glm::vec3 y = glm::normalize(glm::cross(along, x));
  return {glm::vec4(x * radius, 0), glm::vec4(y * radius, 0), glm::vec4(along, 0), glm::vec4(from, 1)};
}

glm::vec3 colorOfAtom(const DnaAtom& atom) {
  switch (atom.part) {
    case DnaAtom::Part::kAdenine:
      return palette::green();
    case DnaAtom::Part::kCytosine:
      return palette::blue();
    case DnaAtom::Part::kGuanine:
      return palette::yellow();
    case DnaAtom::Part::kThymine:
      return palette::vermilion();
    case DnaAtom::Part::kSugar:
      return atom.strand == 0 ? palette::ivory() : palette::skyBlue();
    case DnaAtom::Part::kPhosphorus:
      return palette::orange();
    case DnaAtom::Part::kPhosphateOxygen:
      return palette::purple();
  }
  return {};
}

Scene buildDna(const BuiltinValues& values) {
  const DnaMolecule molecule = makeDna(values.count("pairs"), values.count("seed"));
  const BallsAndSticks detail = chooseDetail(molecule, values.count("triangles"));
  Scene scene;
  scene.meshes = {makeSphere(detail.ballSegments), makeStick(detail.stickSides)};
  glm::mat4 worldFromMolecule =
      glm::rotate(glm::mat4(1), static_cast<float>(radiansFromDegrees(-kLeanDegrees)), glm::vec3(0, 0, 1));
  worldFromMolecule = glm::rotate(worldFromMolecule, static_cast<float>(radiansFromDegrees(-90.0)), glm::vec3(1, 0, 0));
  for (const DnaAtom& atom : molecule.atoms) {
    const float radius = atom.part == DnaAtom::Part::kPhosphorus ? kPhosphorusRadius : kAtomRadius;
    scene.instances.push_back(
        {0, worldFromMolecule * glm::scale(glm::translate(glm::mat4(1), atom.position), glm::vec3(radius)),
         colorOfAtom(atom), atom.pair + 1});
  }
  for (const DnaBond& bond : molecule.bonds) {
    const DnaAtom& first = molecule.atoms[bond.first];
    const DnaAtom& second = molecule.atoms[bond.second];
    scene.instances.push_back(
        {1,
         worldFromMolecule *
             stickBetween(first.position, second.position, bond.isHydrogenBond ? kHydrogenBondRadius : kStickRadius),
         bond.isHydrogenBond ? palette::ivory() : colorOfAtom(first), first.pair + 1});
  }
  return scene;
}

}  // namespace

BuiltinScene dnaScene() {
  using Kind = BuiltinParameter::Kind;
  return {.name = "dna",
          .summary = "a double helix of base pairs, its atoms as balls and sticks, coloured by base",
          .parameters = {{"pairs", "of bases", Kind::kInteger, "20", 1, 500},
                         {"triangles", "about so many in all, but 8 or more for each ball and stick", Kind::kInteger,
                          "1300000", 1, static_cast<double>(kMaxSceneTriangles)},
                         {"seed", "of the sequence", Kind::kInteger, "1", 0, 4294967295.0}},
          .build = buildDna};
}

}  // namespace ocelli
