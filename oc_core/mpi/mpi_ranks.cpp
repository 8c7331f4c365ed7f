#include "oc_core/mpi/mpi_ranks.h"

#define OMPI_SKIP_MPICXX  // the C functions alone
#include <mpi.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <string>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

/// MPI counts what it passes on in an int: messages are padded to units of so many bytes.
constexpr size_t kUnit = 16;

void check(int code, const char* what) {
  if (code == MPI_SUCCESS) {
    return;
  }
  std::array<char, MPI_MAX_ERROR_STRING> text{};
  int length = 0;
  MPI_Error_string(code, text.data(), &length);
  throw WorkError(std::string(what) + " failed: " + std::string(text.data(), static_cast<size_t>(length)), "MPI",
                  "look for a rank or a machine that has failed, and run the job again");
}

int unitsOf(size_t bytes) {
  const size_t units = (bytes + kUnit - 1) / kUnit;
  if (units > static_cast<size_t>(std::numeric_limits<int>::max())) {
    throw WorkError("a message of " + std::to_string(bytes) + " bytes is too long for MPI", "MPI",
                    "use more ranks, or a smaller image");
  }
  return static_cast<int>(units);
}

/// How long each message is, and where it stands among all of them, in units.
struct Places {
  explicit Places(const std::vector<uint64_t>& sizes) : bytes(sizes) {
    int64_t next = 0;
    for (const uint64_t size : sizes) {
      const int units = unitsOf(static_cast<size_t>(size));
      counts.push_back(units);
      offsets.push_back(unitsOf(static_cast<size_t>(next) * kUnit));
      next += units;
    }
    total = static_cast<size_t>(unitsOf(static_cast<size_t>(next) * kUnit)) * kUnit;
  }

  std::vector<Bytes> split(const Bytes& all) const {
    std::vector<Bytes> pieces;
    for (size_t i = 0; i < bytes.size(); ++i) {
      const auto first = all.begin() + static_cast<std::ptrdiff_t>(static_cast<size_t>(offsets[i]) * kUnit);
      pieces.emplace_back(first, first + static_cast<std::ptrdiff_t>(bytes[i]));
    }
    return pieces;
  }

  std::vector<uint64_t> bytes;
  std::vector<int> counts;
  std::vector<int> offsets;
  size_t total = 0;
};

Bytes padded(std::span<const std::byte> bytes) {
  Bytes copy((bytes.size() + kUnit - 1) / kUnit * kUnit);
  std::copy(bytes.begin(), bytes.end(), copy.begin());
  return copy;
}

class MpiRanks final : public Ranks {
 public:
  MpiRanks() {
    int provided = MPI_THREAD_SINGLE;
    check(MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided), "MPI_Init_thread");
    MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
    check(MPI_Comm_rank(MPI_COMM_WORLD, &rank_), "MPI_Comm_rank");
    check(MPI_Comm_size(MPI_COMM_WORLD, &size_), "MPI_Comm_size");
    check(MPI_Type_contiguous(kUnit, MPI_BYTE, &unit_), "MPI_Type_contiguous");
    check(MPI_Type_commit(&unit_), "MPI_Type_commit");
  }
  ~MpiRanks() override {
    MPI_Type_free(&unit_);
    MPI_Finalize();
  }
  MpiRanks(const MpiRanks&) = delete;
  MpiRanks& operator=(const MpiRanks&) = delete;

  int rank() const override { return rank_; }
  int size() const override { return size_; }

  Bytes broadcast(Bytes bytes) override {
    uint64_t size = bytes.size();
    check(MPI_Bcast(&size, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD), "MPI_Bcast");
    const int units = unitsOf(static_cast<size_t>(size));
    bytes.resize(static_cast<size_t>(units) * kUnit);
    check(MPI_Bcast(bytes.data(), units, unit_, 0, MPI_COMM_WORLD), "MPI_Bcast");
    bytes.resize(static_cast<size_t>(size));
    bytesSent_ += isFirst() ? size * others() : 0;
    return bytes;
  }

  std::vector<Bytes> gather(std::span<const std::byte> mine) override {
    const uint64_t size = mine.size();
    std::vector<uint64_t> sizes(isFirst() ? ranks() : 0);
    check(MPI_Gather(&size, 1, MPI_UINT64_T, sizes.data(), 1, MPI_UINT64_T, 0, MPI_COMM_WORLD), "MPI_Gather");
    const Places places(sizes);
    const Bytes sent = padded(mine);
    Bytes all(places.total);
    check(MPI_Gatherv(sent.data(), unitsOf(mine.size()), unit_, all.data(), places.counts.data(), places.offsets.data(),
                      unit_, 0, MPI_COMM_WORLD),
          "MPI_Gatherv");
    bytesSent_ += isFirst() ? 0 : size;
    return places.split(all);
  }

  std::vector<Bytes> gatherToAll(std::span<const std::byte> mine) override {
    const uint64_t size = mine.size();
    std::vector<uint64_t> sizes(ranks());
    check(MPI_Allgather(&size, 1, MPI_UINT64_T, sizes.data(), 1, MPI_UINT64_T, MPI_COMM_WORLD), "MPI_Allgather");
    const Places places(sizes);
    const Bytes sent = padded(mine);
    Bytes all(places.total);
    check(MPI_Allgatherv(sent.data(), unitsOf(mine.size()), unit_, all.data(), places.counts.data(),
                         places.offsets.data(), unit_, MPI_COMM_WORLD),
          "MPI_Allgatherv");
    bytesSent_ += size * others();
    return places.split(all);
  }

  std::vector<Bytes> exchangeAll(const std::vector<Bytes>& pieces) override {
    std::vector<uint64_t> sizes;
    for (const Bytes& piece : pieces) {
      sizes.push_back(piece.size());
    }
    const Places going(sizes);
    std::vector<uint64_t> arrivingSizes(ranks());
    check(MPI_Alltoall(sizes.data(), 1, MPI_UINT64_T, arrivingSizes.data(), 1, MPI_UINT64_T, MPI_COMM_WORLD),
          "MPI_Alltoall");
    const Places coming(arrivingSizes);
    Bytes sent(going.total);
    for (size_t i = 0; i < pieces.size(); ++i) {
      std::copy(pieces[i].begin(), pieces[i].end(),
                sent.begin() + static_cast<std::ptrdiff_t>(static_cast<size_t>(going.offsets[i]) * kUnit));
      bytesSent_ += static_cast<int>(i) == rank_ ? 0 : pieces[i].size();
    }
    Bytes received(coming.total);
    check(MPI_Alltoallv(sent.data(), going.counts.data(), going.offsets.data(), unit_, received.data(),
                        coming.counts.data(), coming.offsets.data(), unit_, MPI_COMM_WORLD),
          "MPI_Alltoallv");
    return coming.split(received);
  }

  Bytes exchange(int partner, std::span<const std::byte> bytes) override {
    constexpr int kTag = 0;
    const uint64_t size = bytes.size();
    uint64_t other = 0;
    check(MPI_Sendrecv(&size, 1, MPI_UINT64_T, partner, kTag, &other, 1, MPI_UINT64_T, partner, kTag, MPI_COMM_WORLD,
                       MPI_STATUS_IGNORE),
          "MPI_Sendrecv");
    const Bytes sent = padded(bytes);
    const int units = unitsOf(static_cast<size_t>(other));
    Bytes received(static_cast<size_t>(units) * kUnit);
    check(MPI_Sendrecv(sent.data(), unitsOf(bytes.size()), unit_, partner, kTag, received.data(), units, unit_, partner,
                       kTag, MPI_COMM_WORLD, MPI_STATUS_IGNORE),
          "MPI_Sendrecv");
    received.resize(static_cast<size_t>(other));
    bytesSent_ += size;
    return received;
  }

  uint64_t largest(uint64_t mine) override {
    uint64_t found = 0;
    check(MPI_Allreduce(&mine, &found, 1, MPI_UINT64_T, MPI_MAX, MPI_COMM_WORLD), "MPI_Allreduce");
    bytesSent_ += sizeof(mine);
    return found;
  }

  void abort(int exitCode) override { MPI_Abort(MPI_COMM_WORLD, exitCode); }

 private:
  size_t ranks() const { return static_cast<size_t>(size_); }
  uint64_t others() const { return static_cast<uint64_t>(size_ - 1); }

  int rank_ = 0;
  int size_ = 1;
  MPI_Datatype unit_ = MPI_DATATYPE_NULL;
};

}  // namespace

std::unique_ptr<Ranks> mpiRanks() {
  return std::make_unique<MpiRanks>();
}

}  // namespace ocelli
