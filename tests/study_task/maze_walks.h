// Random walks through random mazes.
#pragma once

#include <cstdint>

namespace ocelli::test {

/// Steps of any length in so many mazes: one never stands in a wall or nearer to it than the radius of the body, and
/// comes from cell to cell through passages alone.
void checkRandomWalks(uint64_t mazes, int steps);

/// Random poses where one can stand, in so many mazes: the portal-based constructor takes each of them. Returns how
/// many it refused.
int64_t refusedPoses(uint64_t mazes, int poses);

}  // namespace ocelli::test
