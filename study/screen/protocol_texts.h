// What a protocol puts on the screens of its subjects, and whether they can show it. Needs no OpenGL.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "study/protocol/protocol.h"

namespace ocelli {

struct ScreenText {
  std::string where;  ///< the field: "consent", "paragraphs" 2
  std::string text;
};

/// All that subjects read.
std::vector<ScreenText> textsOf(const Protocol& protocol);
/// Their characters, without line breaks and tabs: for the fonts of the screens.
std::set<char32_t> glyphsOf(const Protocol& protocol);

/// Throws InputError naming fields and characters that the screens of this computer would show wrongly, or not at all.
void requireDrawable(const Protocol& protocol);

}  // namespace ocelli
