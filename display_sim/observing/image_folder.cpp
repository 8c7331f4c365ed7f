#include "display_sim/observing/image_folder.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <string_view>
#include <system_error>
#include <vector>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

bool isImage(const fs::path& path, const std::string& stem, const std::string& ending) {
  constexpr std::string_view kUnfinished = ".partial";  // of a run that was killed
  std::string name = path.filename().string();
  if (name.ends_with(kUnfinished)) {
    name.resize(name.size() - kUnfinished.size());
  }
  const std::string start = stem + "_";
  return name.size() > start.size() + ending.size() && name.starts_with(start) && name.ends_with(ending) &&
         std::all_of(name.begin() + static_cast<std::ptrdiff_t>(start.size()),
                     name.end() - static_cast<std::ptrdiff_t>(ending.size()),
                     [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// The images in a folder. Throws where that is a file.
std::vector<fs::path> imagesOf(const fs::path& folder, const std::string& stem, const std::string& ending) {
  std::error_code error;
  std::vector<fs::path> images;
  if (!fs::exists(folder, error)) {
    return images;
  }
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (isImage(at->path(), stem, ending)) {
      images.push_back(at->path());
    }
  }
  if (error) {
    throw InputError("this is no folder that can be read (" + error.message() + ")", folder.string(),
                     "give the path of a new folder");
  }
  return images;
}

/// Its images and itself, if it is there.
void remove(const fs::path& folder, const std::string& stem, const std::string& ending) {
  std::error_code ignored;
  for (const fs::path& image : imagesOf(folder, stem, ending)) {
    fs::remove(image, ignored);
  }
  fs::remove(folder, ignored);
}

}  // namespace

ImageFolder::ImageFolder(std::filesystem::path folder, std::string stem, std::string ending)
    : folder_(std::move(folder)), stem_(std::move(stem)), ending_(std::move(ending)) {
  folder_ = fs::absolute(folder_).lexically_normal();
  if (!folder_.has_filename()) {
    folder_ = folder_.parent_path();  // "frames/"
  }
  partial_ = folder_;
  partial_ += ".partial";
  imagesOf(folder_, stem_, ending_);
  remove(partial_, stem_, ending_);
  std::error_code error;
  unfinished_ = UnfinishedOutput(partial_, [&] { fs::create_directories(partial_, error); });
  if (error) {
    throw WorkError("cannot make this folder (" + error.message() + ")", partial_.string(),
                    "give the path of a folder, in a place that is writable");
  }
  isOpen_ = true;
}

ImageFolder::~ImageFolder() {
  if (isOpen_) {
    unfinished_.finish([this] {
      std::error_code ignored;
      fs::remove_all(partial_, ignored);
    });
  }
}

std::filesystem::path ImageFolder::path(int number) const {
  char end[32];
  std::snprintf(end, sizeof end, "_%04d", number);
  return partial_ / (stem_ + end + ending_);
}

void ImageFolder::finish() {
  std::error_code error;
  unfinished_.finish([&] {
    remove(folder_, stem_, ending_);
    if (fs::exists(folder_, error)) {  // with other files
      for (const fs::path& image : imagesOf(partial_, stem_, ending_)) {
        if (!error) {
          fs::rename(image, folder_ / image.filename(), error);
        }
      }
      fs::remove_all(partial_);
    } else {
      fs::rename(partial_, folder_, error);
    }
  });
  if (error) {
    throw WorkError("cannot make this folder (" + error.message() + ")", folder_.string(),
                    "check that nothing else is called so");
  }
  isOpen_ = false;
}

}  // namespace ocelli
