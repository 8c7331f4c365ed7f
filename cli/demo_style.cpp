#include "cli/demo_style.h"

namespace ocelli {

// Colours of text keep a contrast of at least 4.5 : 1 to their ground in both schemes.
const std::string_view kDemoStyle = R"css(
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
a:focus-visible, input:focus-visible + label, summary:focus-visible { outline: 3px solid var(--accent); outline-offset: 2px; }
nav ul { display: flex; flex-wrap: wrap; gap: .25rem 1.5rem; padding: 0; margin: 1rem 0; list-style: none; }
code { font-family: ui-monospace, "DejaVu Sans Mono", monospace; font-size: .9em; overflow-wrap: anywhere; }
.soft, figcaption { color: var(--soft); }
.row { display: grid; grid-template-columns: repeat(var(--columns), minmax(0, 1fr)); gap: 1rem; }
@media (max-width: 50rem) { .row { grid-template-columns: minmax(0, 1fr); } }
figure { margin: 0; }
/* A fitted scene fills the middle square. */
figure img, .stack img { display: block; width: 100%; height: auto; aspect-ratio: 1; object-fit: cover; border-radius: 6px;
  background: #05060a; }
figcaption { font-size: .875rem; margin-top: .4rem; }
figcaption b { color: var(--text); }
details { margin: .75rem 0; }
summary { cursor: pointer; color: var(--accent); width: fit-content; }
fieldset { border: 1px solid var(--line); border-radius: 6px; margin: .5rem 0; padding: .75rem; max-width: 56rem; }
.flip input { position: absolute; opacity: 0; }
.flip label { display: inline-block; padding: .2rem .8rem; margin: 0 .25rem .5rem 0; border: 1px solid var(--line);
  border-radius: 999px; cursor: pointer; }
.flip input:checked + label { background: var(--accent); border-color: var(--accent); color: var(--ground); }
.stack { display: grid; }
.stack img { grid-area: 1 / 1; visibility: hidden; }
.flip input:nth-of-type(1):checked ~ .stack img:nth-child(1),
.flip input:nth-of-type(2):checked ~ .stack img:nth-child(2),
.flip input:nth-of-type(3):checked ~ .stack img:nth-child(3),
.flip input:nth-of-type(4):checked ~ .stack img:nth-child(4) { visibility: visible; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; margin: .75rem 0; font-variant-numeric: tabular-nums; background: var(--card); }
caption { text-align: left; color: var(--soft); padding-bottom: .4rem; max-width: 60rem; }
th, td { padding: .35rem .8rem; border: 1px solid var(--line); text-align: right; white-space: nowrap; }
th[scope=row], thead th:first-child { text-align: left; }
thead th { color: var(--soft); font-weight: 600; vertical-align: bottom; }
.bar { display: block; height: .45rem; min-width: 1px; margin: .2rem 0 .1rem; border-radius: 2px; }
.di { background: var(--di); }
.ddoc { background: repeating-linear-gradient(45deg, var(--ddoc) 0 4px, color-mix(in srgb, var(--ddoc) 55%, var(--card)) 4px 7px); }
)css";

}  // namespace ocelli
