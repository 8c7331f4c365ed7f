#include <algorithm>
#include <cctype>
#include <cstdio>
#include <string>
#include <system_error>
#include <vector>

#include "display_sim/frame_sink.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

bool isFrame(const fs::path& path) {
  const std::string name = path.filename().string();
  constexpr std::string_view kStart = "frame_";
  constexpr std::string_view kEnd = ".png";
  return name.size() > kStart.size() + kEnd.size() && name.starts_with(kStart) && name.ends_with(kEnd) &&
         std::all_of(name.begin() + kStart.size(), name.end() - kEnd.size(),
                     [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// The frames in a folder. Throws where that is a file, or holds anything else.
std::vector<fs::path> framesOf(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> frames;
  if (!fs::exists(folder, error)) {
    return frames;
  }
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (!isFrame(at->path())) {
      throw InputError("this folder holds \"" + at->path().filename().string() + "\", which is no frame of a series",
                       folder.string(), "give the path of a new folder");
    }
    frames.push_back(at->path());
  }
  if (error) {
    throw InputError("this is no folder that can be read (" + error.message() + ")", folder.string(),
                     "give the path of a new folder");
  }
  return frames;
}

class FrameFolder : public FrameSink {
 public:
  explicit FrameFolder(fs::path folder) : folder_(std::move(folder)) {
    if (!folder_.has_filename()) {
      folder_ = folder_.parent_path();  // "frames/"
    }
    partial_ = folder_;
    partial_ += ".partial";
    framesOf(folder_);
    remove(partial_);
    std::error_code error;
    fs::create_directories(partial_, error);
    if (error) {
      throw WorkError("cannot make this folder (" + error.message() + ")", partial_.string(),
                      "give the path of a folder, in a place that is writable");
    }
    isOpen_ = true;
  }
  ~FrameFolder() override {
    if (isOpen_) {
      std::error_code ignored;
      fs::remove_all(partial_, ignored);
    }
  }

  void add(const Image<Rgb8>& frame) override {
    char name[32];
    std::snprintf(name, sizeof name, "frame_%04d.png", count_++);
    writePng(partial_ / name, frame);
  }

  void finish() override {
    remove(folder_);
    std::error_code error;
    fs::rename(partial_, folder_, error);
    if (error) {
      throw WorkError("cannot make this folder (" + error.message() + ")", folder_.string(),
                      "check that nothing else is called so");
    }
    isOpen_ = false;
  }

 private:
  /// Its frames and itself, if it is there.
  static void remove(const fs::path& folder) {
    std::error_code ignored;
    for (const fs::path& frame : framesOf(folder)) {
      fs::remove(frame, ignored);
    }
    fs::remove(folder, ignored);
  }

  fs::path folder_;
  fs::path partial_;
  int count_ = 0;
  bool isOpen_ = false;
};

}  // namespace

std::unique_ptr<FrameSink> frameFolder(const std::filesystem::path& folder) {
  return std::make_unique<FrameFolder>(folder);
}

}  // namespace ocelli
