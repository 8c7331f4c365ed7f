#include "oc_core/evaluation/evaluation_style.h"

namespace ocelli {

const std::string_view kEvaluationStyle = R"css(.scroll table { font-size: .875rem; }
.scroll th, .scroll td { padding: .35rem .5rem; }
th[scope=colgroup] { text-align: center; }
td.best { background: var(--tint); font-weight: 700; }
td.best::before { content: "\2605\00a0"; color: var(--accent); }
.hidden { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
.warning { border-left: 4px solid var(--caution); padding-left: .75rem; }
.plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(30rem, 100%), 1fr)); gap: 1.5rem; }
.plots svg { display: block; width: 100%; height: auto; background: var(--card); border: 1px solid var(--line);
  border-radius: 6px; }
svg text { fill: var(--text); font: 13px var(--sans); }
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
