// The style sheet of the pages that the program makes: colours and fonts (page_colors.h), text, links, tables.
#pragma once

#include <string>

namespace ocelli {

std::string pageStyle();

}  // namespace ocelli
