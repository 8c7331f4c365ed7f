#include "oc_core/scene/import/texture_search.h"

#include <algorithm>
#include <cctype>
#include <system_error>

#include "oc_core/scene/import/percent_decoded.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

/// A folder with more entries than this is not searched for names in another case.
constexpr size_t kMaxEntries = 100'000;

bool isFile(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

std::string lowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// The entry of a folder with this name, else with the same name in another case.
std::optional<fs::path> entryInAnyCase(const fs::path& folder, const std::string& name) {
  std::error_code error;
  if (name == "." || name == ".." || fs::exists(folder / name, error)) {
    return folder / name;
  }
  const std::string wanted = lowerCase(name);
  std::optional<fs::path> best;
  size_t count = 0;
  for (fs::directory_iterator entry(folder.empty() ? "." : folder, error), end;
       !error && entry != end && count < kMaxEntries; entry.increment(error), ++count) {
    const std::string found = entry->path().filename().string();
    if (lowerCase(found) == wanted && (!best || found < best->filename().string())) {
      best = folder / found;
    }
  }
  return best;
}

std::optional<fs::path> fileInAnyCase(const fs::path& folder, const fs::path& name) {
  fs::path path = folder;
  for (const fs::path& part : name.relative_path()) {
    const std::optional<fs::path> next = entryInAnyCase(path, part.string());
    if (!next) {
      return std::nullopt;
    }
    path = *next;
  }
  return isFile(path) ? std::optional(path) : std::nullopt;
}

}  // namespace

std::optional<fs::path> findTextureFile(const fs::path& sceneFile, const std::string& name) {
  const fs::path folder = sceneFile.parent_path();
  // A name with a zero byte would be cut there by the system.
  if (name.empty() || name.find('\0') != std::string::npos) {
    return std::nullopt;
  }
  if (isFile(folder / name)) {
    return folder / name;
  }
  std::string plain = percentDecoded(name);
  plain = plain.substr(0, plain.find('\0'));
  std::replace(plain.begin(), plain.end(), '\\', '/');
  if (plain.starts_with("//")) {
    plain.erase(0, 2);
  }
  if (isFile(folder / plain)) {
    return folder / plain;
  }
  if (fs::path(plain).is_relative()) {
    if (auto found = fileInAnyCase(folder, plain)) {
      return found;
    }
  }
  const fs::path bare = fs::path(plain).filename();
  if (bare.empty() || bare == "." || bare == "..") {
    return std::nullopt;
  }
  for (const fs::path& beside : {fs::path(), fs::path("textures"), fs::path("..") / "textures"}) {
    if (auto found = fileInAnyCase(folder, beside / bare)) {
      return found;
    }
  }
  return std::nullopt;
}

}  // namespace ocelli
