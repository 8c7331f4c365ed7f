#include "oc_core/worlds/dna_molecule.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <span>
#include <utility>

#include "oc_core/base/check.h"
#include "oc_core/base/conventions.h"
#include "oc_core/base/random.h"

namespace ocelli {
namespace {

using Part = DnaAtom::Part;

constexpr double kTwistDegrees = 36;
constexpr double kRisePerPair = 3.38;
/// No two atoms that are not bonded come as near, and no bond is as long.
constexpr float kMaxBondLength = 1.75f;

constexpr size_t kPhosphorus = 0;
constexpr size_t kO3 = 8;

/// P, OP1, OP2, O5', C5', C4', O4', C3', O3', C2' and C1' of the first strand, in the frame of its pair.
constexpr std::array<glm::vec3, 11> kBackbone{{{-0.102f, 9.286f, -2.116f},
                                               {-0.326f, 10.752f, -2.240f},
                                               {-1.072f, 8.356f, -2.748f},
                                               {0.025f, 8.941f, -0.571f},
                                               {-0.528f, 7.750f, 0.008f},
                                               {-2.004f, 7.638f, -0.285f},
                                               {-2.259f, 6.385f, -0.971f},
                                               {-2.891f, 7.551f, 0.957f},
                                               {-4.188f, 8.044f, 0.650f},
                                               {-2.858f, 6.070f, 1.284f},
                                               {-2.479f, 5.375f, 0.000f}}};

/// The atoms of a base in the plane of its pair, the one at the sugar first.
constexpr std::array<glm::vec2, 10> kAdenine{{{-1.291f, 4.498f},
                                              {0.024f, 4.897f},
                                              {0.877f, 3.902f},
                                              {0.071f, 2.771f},
                                              {0.369f, 1.398f},
                                              {1.611f, 0.909f},
                                              {-0.668f, 0.532f},
                                              {-1.912f, 1.023f},
                                              {-2.320f, 2.290f},
                                              {-1.267f, 3.124f}}};
constexpr std::array<glm::vec2, 11> kGuanine{{{-1.289f, 4.551f},
                                              {0.023f, 4.962f},
                                              {0.870f, 3.969f},
                                              {0.071f, 2.833f},
                                              {0.424f, 1.460f},
                                              {1.554f, 0.955f},
                                              {-0.700f, 0.641f},
                                              {-1.999f, 1.087f},
                                              {-2.949f, 0.139f},
                                              {-2.342f, 2.364f},
                                              {-1.265f, 3.177f}}};
constexpr std::array<glm::vec2, 8> kCytosine{{{-1.285f, 4.542f},
                                              {-1.472f, 3.158f},
                                              {-2.628f, 2.709f},
                                              {-0.391f, 2.344f},
                                              {0.837f, 2.868f},
                                              {1.875f, 2.027f},
                                              {1.056f, 4.275f},
                                              {-0.023f, 5.068f}}};
constexpr std::array<glm::vec2, 9> kThymine{{{-1.284f, 4.500f},
                                             {-1.462f, 3.135f},
                                             {-2.562f, 2.608f},
                                             {-0.298f, 2.407f},
                                             {0.994f, 2.897f},
                                             {1.944f, 2.119f},
                                             {1.106f, 4.338f},
                                             {2.466f, 4.961f},
                                             {-0.024f, 5.057f}}};

struct Base {
  Part part;
  std::span<const glm::vec2> atoms;
  size_t partner;  ///< in kBases
  /// Of its atoms, those with hydrogen bonds, in the order of the partner's; the last one is not there for two bonds.
  std::array<size_t, 3> bonded;
  size_t hydrogenBonds;
};

const std::array<Base, 4>& bases() {
  // N6 and N1 of adenine; N4, N3 and O2 of cytosine; O6, N1 and N2 of guanine; O4 and N3 of thymine.
  static const std::array<Base, 4> kBases{{{Part::kAdenine, kAdenine, 3, {5, 6, 0}, 2},
                                           {Part::kCytosine, kCytosine, 2, {5, 3, 2}, 3},
                                           {Part::kGuanine, kGuanine, 1, {5, 6, 8}, 3},
                                           {Part::kThymine, kThymine, 0, {5, 3, 0}, 2}}};
  return kBases;
}

Part partOfBackbone(size_t atom) {
  return atom == kPhosphorus ? Part::kPhosphorus : atom == 1 || atom == 2 ? Part::kPhosphateOxygen : Part::kSugar;
}

class DnaBuilder {
 public:
  explicit DnaBuilder(size_t pairs) : pairs_(pairs) {}

  /// Adds a base and its part of the backbone; returns its first atom.
  uint32_t addNucleotide(const Base& base, uint32_t strand, uint32_t pair) {
    const auto first = static_cast<uint32_t>(molecule_.atoms.size());
    for (size_t i = 0; i < kBackbone.size(); ++i) {
      molecule_.atoms.push_back({placed(kBackbone[i], strand, pair), partOfBackbone(i), strand, pair});
    }
    for (const glm::vec2& atom : base.atoms) {
      molecule_.atoms.push_back({placed({atom, 0}, strand, pair), base.part, strand, pair});
    }
    const auto end = static_cast<uint32_t>(molecule_.atoms.size());
    for (uint32_t i = first; i < end; ++i) {
      for (uint32_t j = i + 1; j < end; ++j) {
        if (glm::distance(molecule_.atoms[i].position, molecule_.atoms[j].position) < kMaxBondLength) {
          molecule_.bonds.push_back({i, j, false});
        }
      }
    }
    return first;
  }

  void join(uint32_t first, uint32_t second, bool isHydrogenBond) {
    molecule_.bonds.push_back({first, second, isHydrogenBond});
  }

  DnaMolecule take() { return std::move(molecule_); }

 private:
  /// From the frame of a pair. The second strand is the first one turned about the x axis.
  glm::vec3 placed(glm::vec3 position, uint32_t strand, uint32_t pair) const {
    if (strand == 1) {
      position = {position.x, -position.y, -position.z};
    }
    const double angle = radiansFromDegrees(kTwistDegrees) * pair;
    const glm::dvec2 turned(position.x * std::cos(angle) - position.y * std::sin(angle),
                            position.x * std::sin(angle) + position.y * std::cos(angle));
    return glm::vec3(turned, position.z + kRisePerPair * (pair - static_cast<double>(pairs_ - 1) / 2));
  }

  size_t pairs_;
  DnaMolecule molecule_;
};

}  // namespace

DnaMolecule makeDna(size_t pairs, uint64_t seed) {
  OC_CHECK(pairs > 0, "a molecule has base pairs");
  Random random(seed);
  DnaBuilder builder(pairs);
  std::array<uint32_t, 2> before{};
  for (uint32_t pair = 0; pair < pairs; ++pair) {
    const Base& base = bases()[random.below(bases().size())];
    const Base& partner = bases()[base.partner];
    const std::array<uint32_t, 2> first{builder.addNucleotide(base, 0, pair), builder.addNucleotide(partner, 1, pair)};
    for (size_t i = 0; i < base.hydrogenBonds; ++i) {
      const auto atomOf = [i](const Base& of) { return static_cast<uint32_t>(kBackbone.size() + of.bonded[i]); };
      builder.join(first[0] + atomOf(base), first[1] + atomOf(partner), true);
    }
    if (pair > 0) {
      // Each phosphate hangs on the sugar before it: below in the first strand, above in the second, which runs back.
      builder.join(before[0] + kO3, first[0] + kPhosphorus, false);
      builder.join(first[1] + kO3, before[1] + kPhosphorus, false);
    }
    before = first;
  }
  return builder.take();
}

}  // namespace ocelli
