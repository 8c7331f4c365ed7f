#include "oc_core/page/page_style.h"

namespace ocelli {

// Colours of text keep a contrast of at least 4.5 : 1 to their ground in both schemes.
const std::string_view kPageStyle = R"css(
:root {
  color-scheme: light dark;
  --ground: #fbfaf7; --card: #ffffff; --text: #1c2126; --soft: #56606b; --line: #d9d9d2;
  --accent: #00558c; --di: #b34e00; --ddoc: #0072b2;
}
@media (prefers-color-scheme: dark) {
  :root {
    --ground: #14171a; --card: #1d2125; --text: #e8eaec; --soft: #a7b0b9; --line: #363c43;
    --accent: #7cc4f5; --di: #ef8c3b; --ddoc: #56b4e9;
  }
}
* { box-sizing: border-box; }
body {
  margin: 0 auto; padding: 2rem clamp(1rem, 4vw, 4rem) 4rem; max-width: 96rem;
  background: var(--ground); color: var(--text); font: 1rem/1.55 system-ui, "DejaVu Sans", sans-serif;
}
h1 { font-size: 2rem; line-height: 1.2; margin: 0 0 .5rem; }
h2 { font-size: 1.5rem; margin: 3.5rem 0 .25rem; padding-top: 1rem; border-top: 3px solid var(--accent); }
h3 { font-size: 1.1rem; margin: 2rem 0 .25rem; }
p { max-width: 46rem; margin: .25rem 0 .75rem; }
a { color: var(--accent); }
a:focus-visible, input:focus-visible, input:focus-visible + label, summary:focus-visible, .scroll:focus-visible {
  outline: 3px solid var(--accent); outline-offset: 2px; }
code { font-family: ui-monospace, "DejaVu Sans Mono", monospace; font-size: .9em; overflow-wrap: anywhere; }
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

}  // namespace ocelli
