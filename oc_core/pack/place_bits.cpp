#include "oc_core/pack/place_bits.h"

#include <numeric>
#include <tuple>

namespace ocelli {

std::vector<uint32_t> placeNumbers(std::span<const glm::vec3> positions) {
  std::vector<uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
    return std::tuple(placeBits(positions[a]), a) < std::tuple(placeBits(positions[b]), b);
  });
  std::vector<uint32_t> numbers(positions.size());
  uint32_t first = 0;
  for (const uint32_t vertex : order) {
    if (vertex == order[0] || placeBits(positions[vertex]) != placeBits(positions[first])) {
      first = vertex;
    }
    numbers[vertex] = first;
  }
  return numbers;
}

}  // namespace ocelli
