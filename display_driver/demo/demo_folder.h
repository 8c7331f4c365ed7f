// Where the images of one scene of the demo's page go.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>
#include <utility>

#include "display_driver/demo/demo_scene.h"
#include "oc_core/base/error.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

/// A folder below that of the page. Throws WorkError where it cannot be made.
class DemoFolder {
 public:
  DemoFolder(std::filesystem::path folder, std::string name) : folder_(std::move(folder)), name_(std::move(name)) {
    std::error_code error;
    std::filesystem::create_directories(folder_ / name_, error);
    if (error) {
      throw WorkError("cannot make this folder (" + error.message() + ")", (folder_ / name_).string(),
                      "choose another one with -o");
    }
  }

  DemoImage write(const std::string& file, const Image<glm::vec3>& image, const std::string& name,
                  const std::string& caption) const {
    return write(file, srgbFromLinear(image), name, caption);
  }

  DemoImage write(const std::string& file, const Image<Rgb8>& image, const std::string& name,
                  const std::string& caption) const {
    const std::string path = name_ + "/" + file + ".png";
    writePng(folder_ / path, image);
    return {path, name, caption, image.width(), image.height()};
  }

 private:
  std::filesystem::path folder_;
  std::string name_;
};

}  // namespace ocelli
