// Paths: whether they are recognised equally well in both views, and better than by guessing.
#pragma once

#include "analysis/report/report_parts.h"

namespace ocelli {

void addPathSection(ReportWork& work);

/// How often a guess is right: by the maps of the protocol, or those of section 7.4.4 where none says.
double pathChance(const Dataset& data);

}  // namespace ocelli
