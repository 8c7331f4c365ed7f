#include "oc_core/pack/open_edges.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>

#include "oc_core/base/disjoint_sets.h"

namespace ocelli {
namespace {

bool isSharedEdge(const OpenEdge& edge, std::span<const uint8_t> isShared) {
  return isShared[edge.from] != 0 && isShared[edge.to] != 0;
}

/// Calls `visit(from, to)` for each side of each triangle, but for those without length.
template <class Visit>
void forEachPass(std::span<const uint32_t> indices, std::span<const uint32_t> places, const Visit& visit) {
  for (size_t i = 0; i + 2 < indices.size(); i += 3) {
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t a = places[indices[i + k]];
      const uint32_t b = places[indices[i + (k + 1) % 3]];
      if (a != b) {
        visit(a, b);
      }
    }
  }
}

}  // namespace

std::vector<OpenEdge> openEdges(std::span<const uint32_t> indices, std::span<const uint32_t> places) {
  // Passes by the lesser place of their edge: of each the other place, and in the last bit the direction.
  std::vector<uint32_t> ends(places.size() + 1, 0);
  forEachPass(indices, places, [&](uint32_t a, uint32_t b) { ++ends[std::min(a, b) + 1]; });
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<uint32_t> passes(ends.back());
  std::vector<uint32_t> next(ends.begin(), ends.end() - 1);
  forEachPass(indices, places, [&](uint32_t a, uint32_t b) {
    passes[next[std::min(a, b)]++] = std::max(a, b) << 1U | (a < b ? 0U : 1U);
  });
  std::vector<OpenEdge> open;
  for (uint32_t least = 0; least < places.size(); ++least) {
    std::sort(passes.begin() + ends[least], passes.begin() + ends[least + 1]);
    for (size_t begin = ends[least]; begin < ends[least + 1];) {
      size_t end = begin;
      size_t backward = 0;
      while (end < ends[least + 1] && passes[end] >> 1U == passes[begin] >> 1U) {
        backward += passes[end++] & 1U;
      }
      const size_t forward = end - begin - backward;
      const uint32_t most = passes[begin] >> 1U;
      if (forward > backward) {
        open.push_back({least, most, static_cast<uint32_t>(forward - backward)});
      } else if (backward > forward) {
        open.push_back({most, least, static_cast<uint32_t>(backward - forward)});
      }
      begin = end;
    }
  }
  std::sort(open.begin(), open.end());
  return open;
}

bool keepsBorders(std::span<const OpenEdge> fine, std::span<const OpenEdge> coarse, std::span<const uint8_t> isShared) {
  std::vector<OpenEdge> shared;
  std::vector<uint8_t> isRim(isShared.size(), 0);
  for (const OpenEdge& edge : fine) {
    if (isSharedEdge(edge, isShared)) {
      shared.push_back(edge);
    } else {
      isRim[edge.from] = 1;
      isRim[edge.to] = 1;
    }
  }
  std::vector<OpenEdge> others;
  std::set_difference(coarse.begin(), coarse.end(), shared.begin(), shared.end(), std::back_inserter(others));
  return coarse.size() - others.size() == shared.size() && std::ranges::all_of(others, [&](const OpenEdge& edge) {
           return isRim[edge.from] != 0 && isRim[edge.to] != 0;
         });
}

std::vector<uint32_t> connectedPieces(std::span<const uint32_t> indices, std::span<const uint32_t> places) {
  DisjointSets sets(places.size());
  for (size_t i = 0; i + 2 < indices.size(); i += 3) {
    sets.join(places[indices[i]], places[indices[i + 1]]);
    sets.join(places[indices[i]], places[indices[i + 2]]);
  }
  std::vector<uint32_t> pieces(places.size());
  for (uint32_t i = 0; i < pieces.size(); ++i) {
    pieces[i] = sets.least(i);
  }
  return pieces;
}

}  // namespace ocelli
