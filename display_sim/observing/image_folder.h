// A folder of numbered files, PNG unless said otherwise, that appears only when all of them are there.
#pragma once

#include <filesystem>
#include <string>

#include "oc_core/base/unfinished_output.h"

namespace ocelli {

/// `STEM_0000ENDING` and so on are written to `FOLDER.partial`, which finish() renames; without that nothing is left,
/// also where a signal ends the program (unfinished_output.h). In a folder that is there, such files of an earlier run
/// are replaced; other files stay, and the images are moved to them. Throws WorkError, and InputError where the
/// folder is a file.
class ImageFolder {
 public:
  /// `ending` as ".png".
  ImageFolder(std::filesystem::path folder, std::string stem, std::string ending = ".png");
  ~ImageFolder();
  ImageFolder(const ImageFolder&) = delete;
  ImageFolder& operator=(const ImageFolder&) = delete;

  /// Where the file of this number is to be written.
  std::filesystem::path path(int number) const;
  void finish();

 private:
  std::filesystem::path folder_;
  std::filesystem::path partial_;
  std::string stem_;
  std::string ending_;
  UnfinishedOutput unfinished_;
  bool isOpen_ = false;
};

}  // namespace ocelli
