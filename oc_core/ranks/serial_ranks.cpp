#include "oc_core/base/check.h"
#include "oc_core/ranks/ranks.h"

namespace ocelli {
namespace {

class SerialRanks final : public Ranks {
 public:
  int rank() const override { return 0; }
  int size() const override { return 1; }
  Bytes broadcast(Bytes bytes) override { return bytes; }
  std::vector<Bytes> gather(std::span<const std::byte> mine) override { return {Bytes(mine.begin(), mine.end())}; }
  std::vector<Bytes> gatherToAll(std::span<const std::byte> mine) override { return gather(mine); }
  std::vector<Bytes> exchangeAll(const std::vector<Bytes>& pieces) override { return pieces; }
  Bytes exchange(int /*partner*/, std::span<const std::byte> /*bytes*/) override {
    OC_CHECK(false, "the only rank has no partner");
  }
  uint64_t largest(uint64_t mine) override { return mine; }
  void abort(int /*exitCode*/) override {}
};

}  // namespace

std::unique_ptr<Ranks> serialRanks() {
  return std::make_unique<SerialRanks>();
}

}  // namespace ocelli
