// fuzz/scene_files_campaign SECONDS SEED FOLDER: damages small scene files of many formats and reads them as any
// program does, the process that Assimp runs in included. A finding is whatever is not a scene or an InputError that
// names the file and what to do; it ends the program with an error, and leaves the file in FOLDER.
#include <assimp/scene.h>
#include <fmt/format.h>
#include <sys/resource.h>

#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/image/png_file.h"
#include "oc_core/scene/scene_file.h"
#include "tests/scene/scene_file_samples.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;
using test::SceneFileSample;
using Random = std::mt19937_64;

constexpr const char* kSecondsOfReading = "4";
/// Of a CPU, for what the child may take and what this process adds.
constexpr double kMaxSeconds = 15;

/// That this process and its children have used.
double processorSeconds() {
  double seconds = 0;
  for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    getrusage(who, &usage);
    for (const timeval& part : {usage.ru_utime, usage.ru_stime}) {
      seconds += static_cast<double>(part.tv_sec) + 1e-6 * static_cast<double>(part.tv_usec);
    }
  }
  return seconds;
}

size_t below(Random& random, size_t bound) {
  return std::uniform_int_distribution<size_t>(0, bound - 1)(random);
}

/// A coloured and a textured triangle, written by each of Assimp's exporters.
std::vector<SceneFileSample> exportedFiles(const fs::path& folder) {
  writePng(folder / "t.png", Image<Rgb8>(2, 2, Rgb8(200, 100, 50)));
  writeFile(folder / "seed.mtl", "newmtl a\nKd 1 0 0\nKe 0 0 1\nnewmtl b\nmap_Kd t.png\n");
  writeFile(folder / "seed.obj",
            "mtllib seed.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\nusemtl a\n"
            "f 1/1/1 2/2/1 3/3/1\nusemtl b\nf 2/1/1 4/2/1 3/3/1\n");
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile((folder / "seed.obj").string(), 0);
  std::vector<SceneFileSample> samples{{"a.obj", readFile(folder / "seed.obj")}};
  Assimp::Exporter exporter;
  for (size_t i = 0; scene != nullptr && i < exporter.GetExportFormatCount(); ++i) {
    const aiExportFormatDesc& format = *exporter.GetExportFormatDescription(i);
    const fs::path path = folder / fmt::format("seed_{}.{}", format.id, format.fileExtension);
    if (exporter.Export(scene, format.id, path.string()) == aiReturn_SUCCESS && fs::is_regular_file(path)) {
      samples.push_back({path.filename().string(), readFile(path)});
    }
  }
  return samples;
}

/// Numbers that readers trip over, as text and as bytes.
const std::vector<std::string> kNumbers{
    "0",     "-1",   "1",          "4294967295", "2147483648",           "-2147483648",
    "65535", "1e39", "nan",        "inf",        "18446744073709551615", "1000000000",
    "255",   "3",    "1000000007", "-0"};
const std::vector<uint32_t> kWords{0,       1,    0xffffffff, 0x7fffffff, 0x80000000, 0xffff,
                                   0x10000, 0xff, 0x7f800000, 0x40000000, 3,          100'000'000};

void replaceNumber(std::string& bytes, Random& random) {
  constexpr std::string_view kDigits = "0123456789";
  const size_t from = bytes.find_first_of(kDigits, below(random, bytes.size()));
  if (from != std::string::npos) {
    const size_t end = std::min(bytes.find_first_not_of("0123456789.eE", from), bytes.size());
    bytes.replace(from, end - from, kNumbers[below(random, kNumbers.size())]);
  }
}

void replaceWord(std::string& bytes, Random& random) {
  const uint32_t word = kWords[below(random, kWords.size())];
  const size_t count = size_t{1} << below(random, 3);
  const size_t at = below(random, bytes.size());
  for (size_t i = 0; i < count && at + i < bytes.size(); ++i) {
    bytes[at + i] = static_cast<char>(word >> (8 * i));
  }
}

void mutate(std::string& bytes, const std::string& other, Random& random) {
  for (size_t left = 1 + below(random, 4); left > 0 && !bytes.empty(); --left) {
    const size_t at = below(random, bytes.size());
    const size_t length = 1 + below(random, std::min<size_t>(bytes.size() - at, 64));
    switch (below(random, 8)) {
      case 0:
        bytes[at] = static_cast<char>(random());
        break;
      case 1:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(random, 8)));
        break;
      case 2:
        bytes.resize(at);
        break;
      case 3:
        bytes.insert(at, bytes.substr(below(random, bytes.size()), length));
        break;
      case 4:
        bytes.erase(at, length);
        break;
      case 5:
        replaceWord(bytes, random);
        break;
      case 6:
        replaceNumber(bytes, random);
        break;
      default:
        bytes = bytes.substr(0, at) + other.substr(std::min(other.size(), at));
        break;
    }
  }
}

/// The kind of what was said, without names and numbers.
std::string kindOf(const std::string& message) {
  for (const char* kind :
       {"crashed", "took longer", "far more than its size", "lack of memory", "cannot read this scene", "is empty"}) {
    if (message.find(kind) != std::string::npos) {
      return kind;
    }
  }
  return "other messages";
}

class Campaign {
 public:
  Campaign(fs::path folder, uint64_t seed) : folder_(std::move(folder)), random_(seed) {
    fs::create_directories(folder_);
    seeds_ = test::smallSceneFiles();
    for (const auto& more : {test::hostileSceneFiles(), exportedFiles(folder_)}) {
      seeds_.insert(seeds_.end(), more.begin(), more.end());
    }
  }

  void step() {
    const SceneFileSample& seed = seeds_[below(random_, seeds_.size())];
    const SceneFileSample& other = seeds_[below(random_, seeds_.size())];
    std::string bytes = seed.bytes.substr(0, kMaxBytes);
    mutate(bytes, other.bytes, random_);
    const std::string extension = fs::path(seed.name).extension().string();
    const fs::path path = folder_ / ("now" + extension);
    writeFile(path, bytes);
    const double before = processorSeconds();
    const std::string said = read(path);
    if (const double taken = processorSeconds() - before; taken > kMaxSeconds) {
      finding(path, fmt::format("it took {:.0f} s", taken));
    }
    ++count_;
    ++kinds_[said];
    ++ofFormat_[extension + (said == "crashed" ? " crashed" : "")];
  }

  void print() const {
    std::string text = fmt::format("{} files of {} seeds:", count_, seeds_.size());
    for (const auto& [kind, count] : kinds_) {
      text += fmt::format(" {} {},", count, kind);
    }
    for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
      rusage usage{};
      getrusage(who, &usage);
      text += fmt::format(" {} {} s of a CPU, at most {} MiB;", who == RUSAGE_SELF ? "here" : "in children",
                          usage.ru_utime.tv_sec + usage.ru_stime.tv_sec, usage.ru_maxrss >> 10);
    }
    std::printf("%s\n", text.c_str());
    for (const auto& [format, count] : ofFormat_) {
      std::printf("  %s %zu\n", format.c_str(), count);
    }
    std::fflush(stdout);
  }

 private:
  static constexpr size_t kMaxBytes = 1 << 16;

  std::string read(const fs::path& path) {
    try {
      const Scene scene = readSceneFile(path, {.textures = true, .textureTriangles = 1000});
      validate(flatten(scene), path.string());
      return "scenes";
    } catch (const InputError& error) {
      const std::string message = error.what();
      if (message.find(path.string()) == std::string::npos || message.find("\n  try: ") == std::string::npos) {
        finding(path, message);
      }
      return kindOf(message);
    } catch (const std::exception& error) {
      const std::string message = error.what();
      if (message.find("AddressSanitizer: nested bug") == std::string::npos) {
        finding(path, message);
      }
      // The memory of Assimp's process was so broken that its sanitizer ended it without a signal.
      return "crashed";
    }
  }

  [[noreturn]] void finding(const fs::path& path, const std::string& what) const {
    std::printf("FINDING: %s\n  %s\n", path.c_str(), what.c_str());
    print();
    std::exit(1);
  }

  fs::path folder_;
  Random random_;
  std::vector<SceneFileSample> seeds_;
  size_t count_ = 0;
  std::map<std::string, size_t> kinds_;
  std::map<std::string, size_t> ofFormat_;
};

}  // namespace
}  // namespace ocelli

int main(int count, char** arguments) {
  using Clock = std::chrono::steady_clock;
  if (count != 4) {
    std::fputs("usage: scene_files_campaign SECONDS SEED FOLDER\n", stderr);
    return 2;
  }
  setenv("OCELLI_SCENE_SECONDS", ocelli::kSecondsOfReading, 0);
  ocelli::Campaign campaign(arguments[3], std::strtoull(arguments[2], nullptr, 10));
  const auto end = Clock::now() + std::chrono::seconds(std::atoi(arguments[1]));
  while (Clock::now() < end) {
    campaign.step();
  }
  campaign.print();
  return 0;
}
