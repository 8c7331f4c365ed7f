#include "oc_core/shade/specular_ways.h"

#include <algorithm>

#include "oc_core/base/error.h"
#include "oc_core/shade/scene_proxies.h"

namespace ocelli {
namespace {

constexpr const char* kWalk = "how rays walk";
constexpr const char* kExit = "where rays leave glass";

const WayWord* findWord(const std::string& word) {
  const auto found =
      std::find_if(wayWords().begin(), wayWords().end(), [&](const WayWord& each) { return word == each.word; });
  return found != wayWords().end() ? &*found : nullptr;
}

}  // namespace

const std::vector<WayWord>& wayWords() {
  static const std::vector<WayWord> words{
      {"stepped", kWalk, "rays walk along their projections, in fine steps of a pixel, as the text has it",
       [](SpecularWayName& way) { way.finePixels = 1; }},
      {"stepped-1/2", kWalk, "the same in steps of half a pixel", [](SpecularWayName& way) { way.finePixels = 0.5; }},
      {"stepped-1/4", kWalk, "the same in steps of a quarter", [](SpecularWayName& way) { way.finePixels = 0.25; }},
      {"by-frusta", kWalk,
       "rays walk frustum by frustum through the image of a graph camera (the name of its constructor, or its file)",
       [](SpecularWayName& way) { way.byFrusta = true; }},
      {"expected-exit", kExit,
       "rays leave glass where the text expects them to, with the normal of an image of its back faces",
       [](SpecularWayName& way) { way.exit = BackFaceExit::kExpected; }},
      {"searched-exit", kExit, "rays leave glass where the depth in that image says",
       [](SpecularWayName& way) { way.exit = BackFaceExit::kSearched; }},
  };
  return words;
}

SpecularWayName specularWay(const std::string& text) {
  SpecularWayName way{.full = text, .target = text};
  std::vector<const WayWord*> words;
  for (size_t colon = way.target.rfind(':'); colon != std::string::npos; colon = way.target.rfind(':')) {
    const WayWord* word = findWord(way.target.substr(colon + 1));
    if (word == nullptr) {
      break;
    }
    words.push_back(word);
    way.target.resize(colon);
  }
  for (size_t i = 0; i < words.size(); ++i) {
    for (size_t k = 0; k < i; ++k) {
      if (std::string(words[i]->kind) == words[k]->kind) {
        throw InputError("\"" + text + "\" says twice " + words[i]->kind, "--by", "say it once");
      }
    }
    words[i]->apply(way);
  }
  const bool hasImages = way.target != kTraced && way.target != kEnvironment;
  if (!hasImages && (way.isStepped() || way.byFrusta)) {
    throw InputError("\"" + way.target + "\" has no image for rays to walk in", "--by " + text,
                     "name a camera before the colon, such as di");
  }
  return way;
}

std::string wayWordsHelp() {
  std::string text;
  for (const WayWord& word : wayWords()) {
    text += (text.empty() ? "\":" : "; \":") + std::string(word.word) + "\": " + word.meaning;
  }
  return text;
}

}  // namespace ocelli
