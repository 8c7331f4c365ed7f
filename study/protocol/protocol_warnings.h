// What a protocol may do but a study had better not.
#pragma once

#include <string>
#include <vector>

#include "study/protocol/schedule.h"

namespace ocelli {

/// One sentence each.
std::vector<std::string> warningsOf(const Protocol& protocol, uint64_t seed);

}  // namespace ocelli
