#include "oc_core/ranks/shared_tasks.h"

#include "oc_core/base/check.h"
#include "oc_core/ranks/packed_bytes.h"

namespace ocelli {
namespace {

Bytes packedTogether(const std::vector<Bytes>& results) {
  BytePacker packer;
  for (const Bytes& result : results) {
    packer.add(result);
  }
  return packer.take();
}

std::vector<Bytes> inOrder(size_t count, const std::vector<Bytes>& ofRanks) {
  std::vector<Bytes> results(ofRanks.empty() ? 0 : count);
  for (size_t rank = 0; rank < ofRanks.size(); ++rank) {
    ByteUnpacker unpacker(ofRanks[rank]);
    for (size_t task = rank; task < count; task += ofRanks.size()) {
      results[task] = unpacker.values<std::byte>();
    }
    OC_CHECK(unpacker.atEnd(), "each rank sends the results of its own tasks");
  }
  return results;
}

}  // namespace

std::vector<size_t> tasksOfRank(const Ranks& ranks, size_t count) {
  std::vector<size_t> tasks;
  for (auto task = static_cast<size_t>(ranks.rank()); task < count; task += static_cast<size_t>(ranks.size())) {
    tasks.push_back(task);
  }
  return tasks;
}

std::vector<Bytes> gatherTasks(Ranks& ranks, size_t count, const std::vector<Bytes>& mine) {
  return inOrder(count, ranks.gather(packedTogether(mine)));
}

std::vector<Bytes> gatherTasksToAll(Ranks& ranks, size_t count, const std::vector<Bytes>& mine) {
  return inOrder(count, ranks.gatherToAll(packedTogether(mine)));
}

}  // namespace ocelli
