#include "study/store/word_search.h"

#include <algorithm>
#include <fstream>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr size_t kChunk = size_t{1} << 20;

bool isPartOfWord(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

}  // namespace

bool holdsWord(std::string_view text, std::string_view word) {
  for (size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    const size_t end = at + word.size();
    if ((at == 0 || !isPartOfWord(text[at - 1])) && (end == text.size() || !isPartOfWord(text[end]))) {
      return true;
    }
  }
  return false;
}

bool fileHoldsWord(const std::filesystem::path& path, std::string_view word) {
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw InputError("cannot read this file", path.string(), "check that it exists and is readable");
  }
  // Pieces overlap by the word and the characters around it. At the ends of a piece a word may seem to stand alone that
  // does not: such a piece errs towards finding it.
  std::string piece;
  std::string bytes(kChunk, '\0');
  while (file.read(bytes.data(), static_cast<std::streamsize>(bytes.size())) || file.gcount() > 0) {
    piece.append(bytes, 0, static_cast<size_t>(file.gcount()));
    if (holdsWord(piece, word)) {
      return true;
    }
    piece.erase(0, piece.size() - std::min(piece.size(), word.size() + 1));
  }
  return false;
}

}  // namespace ocelli
