#include "oc_core/page/page_style.h"

#include <fmt/format.h>

#include <string_view>

#include "oc_core/page/page_colors.h"

namespace ocelli {

namespace {

constexpr std::string_view kRules = R"css(body {
  margin: 0 auto; padding: 2rem clamp(1rem, 4vw, 4rem) 4rem; max-width: 96rem;
  background: var(--ground); color: var(--text); font: 1rem/1.55 var(--sans);
}
h1 { font-size: 2rem; line-height: 1.2; margin: 0 0 .5rem; }
h2 { font-size: 1.5rem; margin: 3.5rem 0 .25rem; padding-top: 1rem; border-top: 3px solid var(--accent); }
h3 { font-size: 1.1rem; margin: 2rem 0 .25rem; }
p { max-width: 46rem; margin: .25rem 0 .75rem; }
a { color: var(--accent); }
a:focus-visible, input:focus-visible, input:focus-visible + label, summary:focus-visible, .scroll:focus-visible {
  outline: 3px solid var(--accent); outline-offset: 2px; }
code { font-size: .9em; }
.soft, figcaption { color: var(--soft); }
figure { margin: 0; }
/* A fitted scene fills the middle square. */
figure img, .stack img { display: block; width: 100%; height: auto; aspect-ratio: 1; object-fit: cover; border-radius: 6px;
  background: #05060a; }
figcaption { font-size: .875rem; margin-top: .4rem; }
figcaption b { color: var(--text); }
.scroll { overflow-x: auto; position: relative; }
table { border-collapse: collapse; margin: .75rem 0; font-variant-numeric: tabular-nums; background: var(--card); }
caption { text-align: left; color: var(--soft); padding-bottom: .4rem; max-width: 60rem; }
th, td { padding: .35rem .8rem; border: 1px solid var(--line); text-align: right; white-space: nowrap; }
th[scope=row], thead tr:first-child th:first-child { text-align: left; }
thead th { color: var(--soft); font-weight: 600; vertical-align: bottom; }
)css";

}  // namespace

std::string pageStyle() {
  return fmt::format("{}{}", pageColorsStyle(PageScheme::kFollowsScreen), kRules);
}

}  // namespace ocelli
