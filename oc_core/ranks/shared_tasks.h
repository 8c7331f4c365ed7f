// Independent tasks that are handed out to ranks: rank 0 has the results, in the order of the tasks.
#pragma once

#include <cstddef>
#include <vector>

#include "oc_core/ranks/ranks.h"

namespace ocelli {

/// Which of `count` tasks belong to this rank, in rising order: every size()-th one, since tasks that stand together
/// often take about as long.
std::vector<size_t> tasksOfRank(const Ranks& ranks, size_t count);

/// `mine` has a result for each of tasksOfRank(). In rank 0 one for each task; nothing in the others.
std::vector<Bytes> gatherTasks(Ranks& ranks, size_t count, const std::vector<Bytes>& mine);
/// The same in every rank.
std::vector<Bytes> gatherTasksToAll(Ranks& ranks, size_t count, const std::vector<Bytes>& mine);

}  // namespace ocelli
