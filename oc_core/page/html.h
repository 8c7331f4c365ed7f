// What pages in HTML share: plain HTML and CSS, no script, nothing from the network.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace ocelli {

/// The text with everything escaped that HTML would read as markup.
std::string htmlFromText(const std::string& text);

/// "189 082", with narrow spaces.
std::string groupedDigits(size_t number);

/// Up to the opened body. `styles` follow the style that all pages share (page_style.h).
std::string pageBegin(const std::string& title, std::initializer_list<std::string_view> styles);
std::string pageEnd();

}  // namespace ocelli
