#include "oc_core/scene/import/limited_files.h"

#include <assimp/DefaultIOSystem.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "oc_core/scene/import/percent_decoded.h"

namespace ocelli {
namespace {

class LimitedFiles : public Assimp::DefaultIOSystem {
 public:
  explicit LimitedFiles(ReadingBudget* budget) : budget_(budget) {}

  Assimp::IOStream* Open(const char* name, const char* mode) override {
    std::error_code error;
    std::string file = name;
    if (!folder_) {
      folder_ = file.substr(0, file.rfind('/') + 1);
    } else if (!std::filesystem::is_regular_file(file, error) && file.starts_with(*folder_)) {
      file = *folder_ + percentDecoded(file.substr(folder_->size()));
      file = file.substr(0, file.find('\0'));
    }
    const bool isRegular = std::filesystem::is_regular_file(file, error);
    if (!isRegular || std::string_view(mode).find_first_of("wa+") != std::string_view::npos) {
      return nullptr;
    }
    if (budget_ != nullptr) {
      const uintmax_t bytes = std::filesystem::file_size(file, error);
      budget_->addFile(error ? 0 : bytes);
    }
    return DefaultIOSystem::Open(file.c_str(), mode);
  }

 private:
  ReadingBudget* budget_;
  std::optional<std::string> folder_;  ///< of the scene; nothing before it is opened
};

}  // namespace

std::unique_ptr<Assimp::IOSystem> makeLimitedFiles(ReadingBudget* budget) {
  return std::make_unique<LimitedFiles>(budget);
}

}  // namespace ocelli
