// How much rays turn in the openings of a corridor by how far ahead they are, as a figure.
#pragma once

#include <string>
#include <vector>

#include "oc_core/constructor/portal_constructor.h"
#include "oc_core/drawing/figure.h"

namespace ocelli {

struct NamedPortalCurve {
  std::string name;
  PortalOptions options;
};

/// The share by which rays have turned, for who stands in the middle of a corridor of 3 m cells, `cells` before the
/// middle of an opening in its wall: 2.7 m wide and 2.4 m high.
double shareAhead(const PortalOptions& options, double cells);

Figure portalCurveFigure(const std::vector<NamedPortalCurve>& curves);

}  // namespace ocelli
