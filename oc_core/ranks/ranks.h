// The processes that do one piece of work together, each a rank of an MPI job: what they tell each other.
//
// Every rank runs the same program, and calls the same functions of this interface in the same order. Messages are
// bytes; ranks run the same build on machines of one kind, so that what is copied into bytes there can be copied out
// here. Implementations: serialRanks() here, mpiRanks() of oc_core/mpi.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace ocelli {

using Bytes = std::vector<std::byte>;

/// Every function throws WorkError where a message cannot be passed on. A rank that has failed calls abort(): the
/// others wait for it otherwise.
class Ranks {
 public:
  virtual ~Ranks() = default;

  /// 0, 1, ..., size() - 1. Rank 0 alone writes files and prints.
  virtual int rank() const = 0;
  virtual int size() const = 0;
  bool isFirst() const { return rank() == 0; }

  /// Returns what rank 0 passed, in every rank; what others pass is not looked at.
  virtual Bytes broadcast(Bytes bytes) = 0;
  /// In rank 0 what each rank passed, in their order; nothing in the others.
  virtual std::vector<Bytes> gather(std::span<const std::byte> mine) = 0;
  /// The same in every rank.
  virtual std::vector<Bytes> gatherToAll(std::span<const std::byte> mine) = 0;
  /// `pieces` has one for each rank; returns what each of them has here for this one.
  virtual std::vector<Bytes> exchangeAll(const std::vector<Bytes>& pieces) = 0;
  /// With another rank, which calls this with the number of this one: returns what it passed.
  virtual Bytes exchange(int partner, std::span<const std::byte> bytes) = 0;
  /// The largest of what each rank passed, in every rank.
  virtual uint64_t largest(uint64_t mine) = 0;

  /// Ends all ranks, this one as well where there is more than one, with this exit code. What this one has printed
  /// stays.
  virtual void abort(int exitCode) = 0;

  /// What this rank has handed over for other ranks. Of gatherToAll(): once for each of them.
  uint64_t bytesSent() const { return bytesSent_; }

 protected:
  uint64_t bytesSent_ = 0;
};

/// The only rank of a program that was started by itself.
std::unique_ptr<Ranks> serialRanks();

/// Items [begin, end).
struct RankShare {
  size_t begin = 0;
  size_t end = 0;

  size_t size() const { return end - begin; }
};

/// Which of `count` items belong to a rank, neighbours together.
inline RankShare shareOfRank(size_t count, int rank, int size) {
  const auto part = static_cast<size_t>(rank);
  const auto parts = static_cast<size_t>(size);
  return {count * part / parts, count * (part + 1) / parts};
}

}  // namespace ocelli
