// A piece of DNA in its B form: where its atoms are and which of them are bonded. For `builtin:dna`.
//
// Bases have the coordinates of the standard reference frame (Olson et al. 2001, "A standard reference frame for the
// description of nucleic acid base-pair geometry", J. Mol. Biol. 313). Pairs follow each other at 36 degrees and 3.38
// angstroms. The backbone repeats exactly: sugars and phosphates stand where the bond lengths and angles of nucleotides
// (Gelbin et al. 1996, Parkinson et al. 1996) put them, which a least-squares fit has met to 0.06 angstrom; that is an
// idealisation, not a structure that was measured. There are no hydrogen atoms.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace ocelli {

struct DnaAtom {
  enum class Part { kAdenine, kCytosine, kGuanine, kThymine, kSugar, kPhosphorus, kPhosphateOxygen };

  glm::vec3 position;  ///< angstroms
  Part part;
  uint32_t strand;  ///< 0 or 1
  uint32_t pair;    ///< its base pair, from 0 on
};

struct DnaBond {
  uint32_t first;  ///< atoms
  uint32_t second;
  bool isHydrogenBond;  ///< between the two bases of a pair; otherwise between atoms of one strand
};

struct DnaMolecule {
  std::vector<DnaAtom> atoms;
  std::vector<DnaBond> bonds;
};

/// `pairs` (1 or more) base pairs along the z axis, their middle at the origin, the first strand running towards +z; a
/// seeded random sequence.
DnaMolecule makeDna(size_t pairs, uint64_t seed);

}  // namespace ocelli
