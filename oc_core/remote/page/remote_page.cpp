#include "oc_core/remote/page/remote_page.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "oc_core/base/check.h"
#include "oc_core/page/page_colors.h"
#include "oc_core/remote/page/embedded_page.h"

namespace ocelli {
namespace {

struct MediaType {
  std::string_view suffix;
  const char* name;
};
constexpr std::array<MediaType, 3> kMediaTypes{{{".html", "text/html; charset=utf-8"},
                                                {".css", "text/css; charset=utf-8"},
                                                {".js", "text/javascript; charset=utf-8"}}};

RemotePageFile pageFile(const EmbeddedFile& file) {
  const auto* const type =
      std::ranges::find_if(kMediaTypes, [&](const MediaType& each) { return file.name.ends_with(each.suffix); });
  OC_CHECK(type != kMediaTypes.end(), "a file of the page has a known media type");
  const bool isPage = type->suffix == ".html";
  // Its colours are those of all pages.
  const std::string colors = type->suffix == ".css" ? pageColorsStyle(PageScheme::kDark) : std::string();
  return {.path = isPage ? "/" : "/" + std::string(file.name),
          .mediaType = type->name,
          .bytes = colors + std::string(file.bytes)};
}

}  // namespace

std::span<const RemotePageFile> remotePageFiles() {
  static const std::vector<RemotePageFile> kFiles = [] {
    std::vector<RemotePageFile> files;
    std::ranges::transform(embeddedPage(), std::back_inserter(files), pageFile);
    return files;
  }();
  return kFiles;
}

}  // namespace ocelli
