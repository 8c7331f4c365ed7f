// Recordings of the reference display: whether a recorder and a player keep up with it, and how small the files are.
// Scenes that turn by 2 degrees from frame to frame, that stand still, and of which a part moves. Counters: volumes a
// second, and how many times smaller than its bit planes the file is. The file bunny.obj is taken from the folder that
// OCELLI_DATA_DIR names; without it, there are built-in scenes only. Files go to the folder for temporary files.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "display_sim/frames/svol_player.h"
#include "display_sim/frames/svol_writer.h"
#include "display_sim/slicing/slicer.h"
#include "oc_core/base/conventions.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

constexpr int kFrames = 24;
constexpr uint64_t kFrameMicroseconds = 41667;

enum class Motion { kTurns, kStands, kMovesInPart };

struct Film {
  std::string name;
  std::vector<Volume> volumes;
};

glm::vec3 turned(const glm::vec3& p, double radians) {
  const auto c = static_cast<float>(std::cos(radians));
  const auto s = static_cast<float>(std::sin(radians));
  return {c * p.x + s * p.z, p.y, c * p.z - s * p.x};
}

Film makeFilm(const std::string& scene, int bits, Motion motion) {
  const char* motions[] = {"turns", "stands", "moves_in_part"};
  DisplayProfile profile = loadProfile("perspecta");
  profile.colorBitsPerChannel = bits;
  const Mesh mesh = loadScene(scene);
  Film film{scene + "/bits:" + std::to_string(bits) + "/" + motions[static_cast<size_t>(motion)], {}};
  for (int k = 0; k < kFrames; ++k) {
    Mesh moved = mesh;
    for (glm::vec3& p : moved.positions) {
      if (motion == Motion::kTurns) {
        p = turned(p, k * kPi / 90);
      } else if (motion == Motion::kMovesInPart && p.x > 0.3f) {
        p.y += 0.002f * static_cast<float>(k);
      }
    }
    film.volumes.push_back(slice(moved, profile));
  }
  return film;
}

std::filesystem::path fileOf(const Film& film) {
  std::string name = "svol_bench_" + film.name + ".svol";
  std::replace(name.begin(), name.end(), '/', '_');
  return std::filesystem::temp_directory_path() / name;
}

uint64_t record(const Film& film) {
  SvolWriter writer(fileOf(film), film.volumes.front().profile(), {.growing = true});
  for (size_t k = 0; k < film.volumes.size(); ++k) {
    writer.append(film.volumes[k], k * kFrameMicroseconds);
  }
  writer.finish();
  return writer.bytes();
}

void count(benchmark::State& state, const Film& film, uint64_t fileBytes) {
  const size_t raw = film.volumes.size() * film.volumes.front().profile().volumeBytes();
  state.counters["volumes/s"] = benchmark::Counter(
      static_cast<double>(state.iterations()) * static_cast<double>(film.volumes.size()), benchmark::Counter::kIsRate);
  state.counters["smaller"] = static_cast<double>(raw) / static_cast<double>(fileBytes);
}

void registerFilm(const std::string& scene, int bits, Motion motion) {
  const auto film = std::make_shared<Film>(makeFilm(scene, bits, motion));
  benchmark::RegisterBenchmark(("write/" + film->name).c_str(),
                               [film](benchmark::State& state) {
                                 uint64_t bytes = 0;
                                 for (auto _ : state) {
                                   bytes = record(*film);
                                 }
                                 count(state, *film, bytes);
                                 std::filesystem::remove(fileOf(*film));
                               })
      ->Unit(benchmark::kMillisecond)
      ->MeasureProcessCPUTime()
      ->UseRealTime();
  benchmark::RegisterBenchmark(("read/" + film->name).c_str(),
                               [film](benchmark::State& state) {
                                 const uint64_t bytes = record(*film);
                                 for (auto _ : state) {
                                   SvolReader reader(fileOf(*film));
                                   SvolPlayer player(reader);
                                   for (size_t k = 0; k < reader.frames().size(); ++k) {
                                     player.seek(k);
                                     benchmark::DoNotOptimize(player.changed());
                                   }
                                 }
                                 count(state, *film, bytes);
                                 std::filesystem::remove(fileOf(*film));
                               })
      ->Unit(benchmark::kMillisecond)
      ->MeasureProcessCPUTime()
      ->UseRealTime();
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  benchmark::Initialize(&argumentCount, arguments);
  if (benchmark::ReportUnrecognizedArguments(argumentCount, arguments)) {
    return 1;
  }
  using ocelli::Motion;
  ocelli::registerFilm("builtin:statues", 1, Motion::kTurns);
  ocelli::registerFilm("builtin:statues", 1, Motion::kStands);
  ocelli::registerFilm("builtin:statues", 1, Motion::kMovesInPart);
  ocelli::registerFilm("builtin:statues", 3, Motion::kTurns);
  if (std::getenv("OCELLI_DATA_DIR") != nullptr) {
    ocelli::registerFilm("builtin:statues,mesh=bunny.obj", 1, Motion::kTurns);
  }
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
