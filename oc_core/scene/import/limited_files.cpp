#include "oc_core/scene/import/limited_files.h"

#include <assimp/DefaultIOSystem.h>

#include <filesystem>
#include <string_view>
#include <system_error>

namespace ocelli {
namespace {

class LimitedFiles : public Assimp::DefaultIOSystem {
 public:
  explicit LimitedFiles(ReadingBudget* budget) : budget_(budget) {}

  Assimp::IOStream* Open(const char* file, const char* mode) override {
    std::error_code error;
    const bool isRegular = std::filesystem::is_regular_file(file, error);
    if (!isRegular || std::string_view(mode).find_first_of("wa+") != std::string_view::npos) {
      return nullptr;
    }
    if (budget_ != nullptr) {
      const uintmax_t bytes = std::filesystem::file_size(file, error);
      budget_->addFile(error ? 0 : bytes);
    }
    return DefaultIOSystem::Open(file, mode);
  }

 private:
  ReadingBudget* budget_;
};

}  // namespace

std::unique_ptr<Assimp::IOSystem> makeLimitedFiles(ReadingBudget* budget) {
  return std::make_unique<LimitedFiles>(budget);
}

}  // namespace ocelli
