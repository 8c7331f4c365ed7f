// fault_run COUNT [FIRST_SEED]: so many random scripts of faults over an emulated USB; prints what became of them. Exit
// code 1 where something did not hold, 77 where no USB can be emulated here.
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <thread>

#include "display_driver/emulator/usb_emulator.h"
#include "tests/display_driver_usb/fault_runner.h"

namespace ocelli {
namespace {

constexpr int kSkipped = 77;
constexpr size_t kKeptByUmockdev = 2;         // descriptors, as of version 0.17.16
constexpr std::chrono::minutes kPatience{3};  // with a script, before it counts as stuck

/// Ends the process where nothing moves on.
class Watchdog {
 public:
  Watchdog() : thread_([this] { watch(); }) {}
  ~Watchdog() {
    seed_ = kDone;
    thread_.join();
  }
  void begin(uint64_t seed) {
    seed_ = static_cast<int64_t>(seed);
    begin_ = std::chrono::steady_clock::now();
  }

 private:
  static constexpr int64_t kDone = -1;

  void watch() {
    while (seed_ != kDone) {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      if (std::chrono::steady_clock::now() - begin_.load() > kPatience) {
        fmt::print(stderr, "fault_run: seed {} hangs\n", seed_.load());
        std::abort();
      }
    }
  }

  std::atomic<int64_t> seed_ = 0;
  std::atomic<std::chrono::steady_clock::time_point> begin_ = std::chrono::steady_clock::now();
  std::thread thread_;
};

/// What is freed on threads of others may take a moment.
Holdings settledHoldings(const Holdings& expected) {
  Holdings now = holdingsOfThisProcess();
  for (int i = 0; i < 1000 && now.exceed(expected); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    now = holdingsOfThisProcess();
  }
  return now;
}

int run(size_t count, uint64_t firstSeed) {
  Watchdog watchdog;
  size_t bad = 0;
  FaultRunResult sum;
  std::optional<Holdings> before;
  for (uint64_t seed = firstSeed; seed < firstSeed + count; ++seed) {
    watchdog.begin(seed);
    FaultRunResult result = runRandomFaults(seed);
    // The first script leaves what libraries keep for good, and each what umockdev keeps of a test bed.
    if (before) {
      before->descriptors += kKeptByUmockdev;
    }
    const Holdings after = before ? settledHoldings(*before) : holdingsOfThisProcess();
    if (before && after.exceed(*before)) {
      result.problems.push_back(fmt::format("left behind: {} threads, {} descriptors, {} transfers; before {}, {}, {}",
                                            after.threads, after.descriptors, after.transfers, before->threads,
                                            before->descriptors, before->transfers));
      before = after;
    }
    before = before.value_or(after);
    for (const std::string& problem : result.problems) {
      fmt::print("seed {}: {}\n", seed, problem);
      std::fflush(stdout);
    }
    bad += result.problems.empty() ? 0 : 1;
    sum.faults += result.faults;
    sum.framesSubmitted += result.framesSubmitted;
    sum.framesAcknowledged += result.framesAcknowledged;
    sum.reconnections += result.reconnections;
    sum.rotationsToReturn.insert(sum.rotationsToReturn.end(), result.rotationsToReturn.begin(),
                                 result.rotationsToReturn.end());
    if ((seed - firstSeed + 1) % 100 == 0) {
      fmt::print(stderr, "{} scripts, {} bad\n", seed - firstSeed + 1, bad);
    }
  }
  std::vector<double>& rotations = sum.rotationsToReturn;
  std::ranges::sort(rotations);
  fmt::print("{} scripts, {} faults, {} frames submitted, {} acknowledged, {} reconnections; {} scripts failed\n",
             count, sum.faults, sum.framesSubmitted, sum.framesAcknowledged, sum.reconnections, bad);
  if (!rotations.empty()) {
    const auto within = std::ranges::upper_bound(rotations, 2.0) - rotations.begin();
    const auto at = [&](double share) {
      return rotations[static_cast<size_t>(share * static_cast<double>(rotations.size() - 1))];
    };
    fmt::print(
        "back after a fault: {} of {} within two rotations; median {:.2f}, 99 % {:.2f}, longest {:.2f} rotations\n",
        within, rotations.size(), at(0.5), at(0.99), rotations.back());
  }
  return bad == 0 ? 0 : 1;
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  ocelli::UsbEmulator::restartPreloaded();
  if (!ocelli::UsbEmulator::preloaded()) {
    const auto error = ocelli::UsbEmulator::preloadError();
    fmt::print("no USB can be emulated: {}\n", error ? error->what() : "this program was not started anew");
    return ocelli::kSkipped;
  }
  rlimit descriptors{};
  getrlimit(RLIMIT_NOFILE, &descriptors);
  descriptors.rlim_cur = descriptors.rlim_max;
  setrlimit(RLIMIT_NOFILE, &descriptors);
  const size_t count = argumentCount > 1 ? std::strtoul(arguments[1], nullptr, 10) : 25;
  const uint64_t seed = argumentCount > 2 ? std::strtoul(arguments[2], nullptr, 10) : 1;
  return ocelli::run(count, seed);
}
