// Parts of a protocol file that only a study reads, or more strictly than an analysis: pages, forms and rules of
// exclusion. All throw InputError naming the field.
#pragma once

#include <string>
#include <vector>

#include "study/protocol/protocol.h"

namespace ocelli {

class JsonFields;

/// Trials that the pages of a block may show.
struct PageTrials {
  const ViewConditions& conditions;
  std::shared_ptr<const TaskBlock> examples;  ///< null where the block has no example cases
  TrialPlan plan;                             ///< but for case and view
};

/// In the field `name`.
ProtocolPage readPage(JsonFields& fields, const std::string& name, const std::string& language);
/// Nothing where the field is missing. Without `trials` pages cannot show any.
std::vector<ProtocolPage> readPages(JsonFields& fields, const std::string& name, const std::string& language,
                                    const PageTrials* trials = nullptr);
ProtocolForm readForm(JsonFields& fields, const std::string& name, const FormSetting& setting);

/// Defaults where fields are missing.
ScreenGeometry screenGeometry(const StatedScreen& stated);
/// The field "exclusions".
std::vector<ExclusionRule> readExclusions(JsonFields& fields, const Protocol& protocol);

}  // namespace ocelli
