#include "oc_core/worlds/dna_molecule.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <set>
#include <utility>
#include <vector>

#include "oc_core/worlds/builtin_scenes.h"
#include "tests/scene/mesh_checks.h"

namespace ocelli {
namespace {

using Part = DnaAtom::Part;

float lengthOf(const DnaMolecule& molecule, const DnaBond& bond) {
  return glm::distance(molecule.atoms[bond.first].position, molecule.atoms[bond.second].position);
}

TEST(DnaMolecule, HasTheBondLengthsOfNucleotides) {
  const DnaMolecule molecule = makeDna(24, 5);
  size_t toPhosphorus = 0;
  for (const DnaBond& bond : molecule.bonds) {
    const float length = lengthOf(molecule, bond);
    if (bond.isHydrogenBond) {
      EXPECT_GT(length, 2.7f);  // Olson et al. 2001: 2.8 to 3.0 in both kinds of pairs
      EXPECT_LT(length, 3.05f);
      continue;
    }
    const bool phosphorus =
        molecule.atoms[bond.first].part == Part::kPhosphorus || molecule.atoms[bond.second].part == Part::kPhosphorus;
    toPhosphorus += phosphorus ? 1 : 0;
    // From a C=O to a C-C bond, and from P=O to P-O, each with the 0.06 of the fit.
    EXPECT_GT(length, (phosphorus ? 1.485f : 1.21f) - 0.06f);
    EXPECT_LT(length, (phosphorus ? 1.607f : 1.525f) + 0.06f);
  }
  // Four oxygens each; the first one of each strand has no sugar before it.
  EXPECT_EQ(toPhosphorus, 2u * (24 * 4 - 1));
}

TEST(DnaMolecule, KeepsAtomsThatAreNotBondedApart) {
  const DnaMolecule molecule = makeDna(6, 2);
  std::set<std::pair<uint32_t, uint32_t>> bonded;
  std::vector<size_t> bonds(molecule.atoms.size());
  for (const DnaBond& bond : molecule.bonds) {
    bonded.insert(std::minmax(bond.first, bond.second));
    ++bonds[bond.first];
    ++bonds[bond.second];
  }
  for (uint32_t i = 0; i < molecule.atoms.size(); ++i) {
    EXPECT_GE(bonds[i], 1u);
    for (uint32_t j = i + 1; j < molecule.atoms.size(); ++j) {
      if (!bonded.contains({i, j})) {
        // Two atoms at one carbon of a five-ring are 2.2 apart, others farther.
        EXPECT_GT(glm::distance(molecule.atoms[i].position, molecule.atoms[j].position), 2.1f) << i << " " << j;
      }
    }
  }
}

TEST(DnaMolecule, PairsBasesAndTurnsRight) {
  const size_t pairs = 40;
  const DnaMolecule molecule = makeDna(pairs, 3);
  std::vector<std::set<Part>> kinds(pairs);
  std::vector<glm::vec3> phosphorus;
  for (const DnaAtom& atom : molecule.atoms) {
    if (atom.part == Part::kPhosphorus && atom.strand == 0) {
      phosphorus.push_back(atom.position);
    }
    if (atom.part < Part::kSugar) {
      kinds[atom.pair].insert(atom.part);
    }
  }
  std::set<std::set<Part>> all(kinds.begin(), kinds.end());
  EXPECT_EQ(all, (std::set<std::set<Part>>{{Part::kAdenine, Part::kThymine}, {Part::kCytosine, Part::kGuanine}}));
  ASSERT_EQ(phosphorus.size(), pairs);
  for (size_t i = 1; i < pairs; ++i) {
    const glm::vec3& a = phosphorus[i - 1];
    const glm::vec3& b = phosphorus[i];
    EXPECT_NEAR(b.z - a.z, 3.38f, 1e-4f);  // of coordinates up to 70
    EXPECT_NEAR(std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y), 0.62832f, 1e-5f) << "36 degrees";
  }
}

TEST(BuiltinDna, HasAboutAsManyTrianglesAsAsked) {
  for (const size_t triangles : {50'000u, 300'000u, 1'300'000u}) {
    const Scene scene = makeBuiltinScene("builtin:dna,triangles=" + std::to_string(triangles));
    EXPECT_NEAR(static_cast<double>(triangleCount(scene)), static_cast<double>(triangles),
                0.02 * static_cast<double>(triangles));
    for (const Mesh& mesh : scene.meshes) {
      EXPECT_TRUE(isClosed(mesh));
      EXPECT_GT(signedVolume(mesh), 0);
    }
  }
  for (const int pairs : {1, 2, 3, 5, 8, 13}) {
    const Scene finest = makeBuiltinScene("builtin:dna,pairs=" + std::to_string(pairs) +
                                          ",triangles=" + std::to_string(kMaxSceneTriangles));
    EXPECT_NEAR(static_cast<double>(triangleCount(finest)), 0.99 * kMaxSceneTriangles, 0.01 * kMaxSceneTriangles)
        << pairs << " pairs: about as many, but not more than a scene may have";
  }
  const Scene coarsest = makeBuiltinScene("builtin:dna,pairs=3,triangles=1");
  EXPECT_EQ(triangleCount(coarsest), 8 * coarsest.instances.size());
  const std::vector<uint32_t> objects = objectOfTriangles(coarsest);
  EXPECT_EQ(std::set<uint32_t>(objects.begin(), objects.end()), (std::set<uint32_t>{1, 2, 3})) << "the pairs";
}

TEST(BuiltinDna, FollowsTheSeed) {
  const auto colors = [](const char* source) { return flatten(makeBuiltinScene(source)).colors; };
  EXPECT_EQ(colors("builtin:dna,triangles=1,seed=4"), colors("builtin:dna,triangles=1,seed=4"));
  EXPECT_NE(colors("builtin:dna,triangles=1,seed=4"), colors("builtin:dna,triangles=1,seed=5"));
}

}  // namespace
}  // namespace ocelli
