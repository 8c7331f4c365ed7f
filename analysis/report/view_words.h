// Views in the words of the field. Sections name them as data and plans do, ppc and gc; readers get "pinhole" and
// "graph camera".
#pragma once

#include <string>

#include "analysis/report/report_document.h"

namespace ocelli {

/// Each ppc and gc that stands as a word of its own; not those within names such as "session-1/gc" or "easier_gc".
std::string withViewWords(const std::string& text);

/// In all that readers read: headings, text, tables but for records, captions, notes. Not in ids, sources, short names,
/// code, and the drawings of figures, whose labels are laid out before.
void spellOutViews(ReportDocument& document);

}  // namespace ocelli
