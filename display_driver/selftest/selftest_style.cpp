#include "display_driver/selftest/selftest_style.h"

namespace ocelli {

const std::string_view kSelftestStyle = R"css(
body { max-width: 84rem; }
h2 { font-size: 1.5rem; margin: 3rem 0 .25rem; padding-top: 1rem; border-top: 3px solid var(--accent); scroll-margin-top: 1rem; }
h3 { font-size: 1.05rem; margin: 1.5rem 0 .25rem; }
p, li { max-width: 50rem; }
p { margin: .25rem 0 .75rem; }
.order { columns: 16rem; padding-left: 2rem; }
.facts { display: flex; flex-wrap: wrap; gap: .25rem 2rem; margin: 1rem 0; }
.facts div { white-space: nowrap; }
.facts dt { display: inline; color: var(--soft); }
.facts dd { display: inline; margin: 0 0 0 .4rem; }
.session { display: flex; flex-wrap: wrap; gap: .5rem 1.5rem; margin: 1rem 0; }
.session label { display: flex; gap: .5rem; align-items: center; }
.session input, .notes input { font: inherit; color: var(--text); background: var(--card); border: 1px solid var(--soft);
  border-radius: 4px; padding: .2rem .5rem; }
.session input { width: 13rem; }
.notes { display: flex; gap: .5rem; align-items: center; max-width: 50rem; margin: .75rem 0; }
.notes input { flex: 1; min-width: 0; }
.images { display: grid; grid-template-columns: repeat(5, minmax(0, 1fr)); gap: 1rem; margin: 1rem 0; }
@media (max-width: 60rem) { .images { grid-template-columns: repeat(3, minmax(0, 1fr)); } }
@media (max-width: 36rem) { .images { grid-template-columns: repeat(2, minmax(0, 1fr)); } }
figure img { display: block; width: 100%; height: auto; aspect-ratio: 1; object-fit: contain; border: 1px solid var(--line);
  border-radius: 6px; background: #000000; }
figcaption { font-size: .875rem; margin-top: .3rem; }
.checks { list-style: none; padding: 0; margin: .25rem 0; }
.checks label { display: flex; gap: .7rem; align-items: baseline; padding: .25rem 0; cursor: pointer; }
.checks input { flex: none; width: 1.15rem; height: 1.15rem; margin: 0; position: relative; top: .2rem; accent-color: var(--accent); }
table { border-collapse: collapse; margin: .5rem 0; background: var(--card); width: 100%; min-width: 40rem; }
th, td { padding: .4rem .7rem; border: 1px solid var(--line); text-align: left; vertical-align: top; font-weight: 400;
  white-space: normal; }
tbody th { width: 40%; }
tbody img { float: left; width: 8rem; height: 8rem; margin: 0 .8rem 0 0; border: 1px solid var(--line); border-radius: 4px; background: #000000; }
thead th { color: var(--soft); font-weight: 600; vertical-align: top; }
/* On narrow screens each row stands as a block, and says itself what its cells are. */
@media screen and (max-width: 40rem) {
  table { min-width: 0; }
  thead { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
  tr { display: flow-root; border: 1px solid var(--line); margin-bottom: .5rem; padding: .5rem .7rem; }
  tbody th, td { display: block; width: auto; border: 0; padding: .15rem 0; }
  tbody th { font-weight: 600; }
  td:nth-of-type(1)::before { content: "Means: "; color: var(--soft); }
  td:nth-of-type(2)::before { content: "Do: "; color: var(--soft); }
}
@media print {
  @page { size: A4; margin: 12mm; }
  body { padding: 0; font-size: 8.5pt; line-height: 1.35; }
  h2 { margin-top: 0; }
  section { break-before: page; }
  .images { grid-template-columns: repeat(5, 1fr); gap: .5rem; }
  figure img { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
  figcaption { font-size: 8pt; }
  tbody img { width: 4.5rem; height: 4.5rem; print-color-adjust: exact; -webkit-print-color-adjust: exact; }
  .scroll { overflow: visible; padding-right: 1px; }
  th, td { padding: .2rem .5rem; }
  h3 { margin-top: .6rem; }
  .checks label { padding: .1rem 0; }
  table { min-width: 0; }
  tr, figure, .checks li { break-inside: avoid; }
  h2, h3 { break-after: avoid; }
}
)css";

}  // namespace ocelli
