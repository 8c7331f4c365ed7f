// Sections write the view conditions as marks (study/trial/view_condition.h), as they do not know what the study
// calls them. Readers get labels; ids, sources, short names and code get the names that data and plans have.
#pragma once

#include <functional>
#include <string>

#include "analysis/report/report_document.h"

namespace ocelli {

/// The conditions of ReportOrigins: labels in all that readers read, which are headings, text, tables but for records,
/// captions and notes; names in all else. The drawings of figures have their labels before: they are laid out.
void spellOutViews(ReportDocument& document);

/// The same with any words: `shown` changes what readers read, `kept` the rest.
using TextChange = std::function<std::string(const std::string& text)>;
void replaceViewMarks(ReportDocument& document, const TextChange& shown, const TextChange& kept);

}  // namespace ocelli
