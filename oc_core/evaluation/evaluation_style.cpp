#include "oc_core/evaluation/evaluation_style.h"

namespace ocelli {

// Series take the colours of Okabe and Ito without the yellow, and differ in marker and dash too.
const std::string_view kEvaluationStyle = R"css(
:root {
  --series-0: #1c2126; --series-1: #0072b2; --series-2: #d55e00; --series-3: #00785a; --series-4: #a8487f;
  --series-5: #a86f00; --series-6: #2b83b8; --grid: #e4e3dc; --best: #e7f1f8;
}
@media (prefers-color-scheme: dark) {
  :root {
    --series-0: #e8eaec; --series-1: #4aa3df; --series-2: #f0803a; --series-3: #2fbd94; --series-4: #df9dc0;
    --series-5: #e6a93c; --series-6: #8fcdf2; --grid: #2b3036; --best: #20394c;
  }
}
.scroll table { font-size: .875rem; }
.scroll th, .scroll td { padding: .35rem .5rem; }
th[scope=colgroup] { text-align: center; }
td.best { background: var(--best); font-weight: 700; }
td.best::before { content: "\2605\00a0"; color: var(--accent); }
.hidden { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
.warning { border-left: 4px solid var(--di); padding-left: .75rem; }
.plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(30rem, 100%), 1fr)); gap: 1.5rem; }
.plots svg { display: block; width: 100%; height: auto; background: var(--card); border: 1px solid var(--line);
  border-radius: 6px; }
svg text { fill: var(--text); font: 13px system-ui, "DejaVu Sans", sans-serif; }
svg .label { paint-order: stroke; stroke: var(--card); stroke-width: 3px; stroke-linejoin: round; }
svg .tick { fill: var(--soft); font-size: 12px; }
svg .axis { stroke: var(--soft); fill: none; }
svg .grid { stroke: var(--grid); fill: none; }
svg .front { stroke: var(--soft); fill: none; stroke-dasharray: 2 4; stroke-width: 1.5; }
svg .leader { stroke: var(--soft); stroke-opacity: .5; fill: none; }
.legend { padding: 0; margin: 0; list-style: none; }
.legend li { margin: .3rem 0; }
.swatch { display: inline-block; width: 1.1em; height: 1.1em; margin-right: .45em; vertical-align: -.2em;
  border: 1px solid var(--soft); border-radius: 3px; print-color-adjust: exact; -webkit-print-color-adjust: exact; }
.shown { margin-top: 1.5rem; display: grid; grid-template-columns: repeat(auto-fill, minmax(min(34rem, 100%), 1fr)); gap: 1.5rem; }
.shown h3 { margin: 0 0 .4rem; }
.pair { display: grid; grid-template-columns: 1fr 1fr; gap: .5rem; }
.key { display: grid; grid-template-columns: minmax(0, 18rem) 1fr; gap: 1.5rem; align-items: center; }
@media (max-width: 40rem) { .key { grid-template-columns: 1fr; } }
dt { font-weight: 600; margin-top: .75rem; }
dd { margin: .1rem 0 0; max-width: 52rem; }
@media print {
  @page { size: A4 landscape; margin: 12mm; }
  :root {
    color-scheme: light; --ground: #ffffff; --card: #ffffff; --text: #000000; --soft: #444444; --line: #bbbbbb;
    --grid: #dddddd; --best: #e4eef5; --accent: #00558c; --series-0: #000000; --series-1: #0072b2;
    --series-2: #d55e00; --series-3: #00785a; --series-4: #a8487f; --series-5: #a86f00; --series-6: #2b83b8;
  }
  body { padding: 0; max-width: none; font-size: 9pt; }
  h1 { font-size: 16pt; }
  h2 { font-size: 13pt; margin-top: 1.5rem; padding-top: .5rem; }
  .scroll table { font-size: 7.5pt; }
  .scroll th, .scroll td { padding: .15rem .3rem; }
  td.best { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
  .scroll { overflow: visible; }
  .plots, .shown { grid-template-columns: 1fr 1fr; }
  figure, .shown article, table, dt, dd { break-inside: avoid; }
  h2, h3, dt { break-after: avoid; }
}
)css";

}  // namespace ocelli
