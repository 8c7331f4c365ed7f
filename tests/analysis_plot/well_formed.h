// Whether text is well-formed XML, as far as writers of this project go: no document types, no processing but the head.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ocelli {

struct MarkupReading {
  std::string problem;                  ///< empty where there is none
  std::vector<std::string> tags;        ///< of elements, as they start
  std::vector<std::string> attributes;  ///< "name=value", as written
  std::string text;                     ///< between tags
};

/// `voidTags`: those that HTML never closes.
MarkupReading readMarkup(std::string_view markup, const std::vector<std::string>& voidTags = {});

}  // namespace ocelli
