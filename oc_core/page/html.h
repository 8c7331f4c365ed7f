// What pages in HTML share: plain HTML and CSS, no script, nothing from the network.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace ocelli {

/// The clean text (utf8.h) with everything escaped that HTML and XML would read as markup, in text and in quoted
/// attributes.
std::string htmlFromText(std::string_view text);

/// "189 082", with narrow spaces.
std::string groupedDigits(size_t number);

struct PageHead {
  std::string title;
  std::string tags;  ///< of the head, before the title and the style
  std::string style;
};
/// Up to the opened body.
std::string pageBegin(const PageHead& head);
/// The same with the style of the program's pages (page_style.h), then `styles`.
std::string pageBegin(const std::string& title, std::initializer_list<std::string_view> styles);
std::string pageEnd();

}  // namespace ocelli
