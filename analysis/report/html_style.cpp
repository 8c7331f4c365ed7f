#include "analysis/report/html_style.h"

namespace ocelli {

const std::string_view kReportStyle = R"css(:root { --rule: #8a9098; }
html { scroll-padding-top: 1rem; -webkit-text-size-adjust: 100%; text-size-adjust: 100%; }
body { margin: 0; background: var(--ground); color: var(--text); font: 1.0625rem/1.6 var(--serif); }
.page { margin: 0 auto; padding: 2.5rem clamp(1rem, 4vw, 3.5rem) 5rem; max-width: 58rem; background: var(--card); }
header { border-bottom: 1px solid var(--rule); padding-bottom: 1.25rem; margin-bottom: 1.5rem; }
h1, h2, h3, h4, nav, table, figcaption, caption, .note b, dt, button, summary, .marking, .sources, footer {
  font-family: var(--sans); }
h1 { font-size: clamp(1.6rem, 5vw, 2.2rem); line-height: 1.2; margin: 0 0 .4rem; letter-spacing: -.01em;
  text-wrap: balance; }
.subtitle { margin: 0; color: var(--soft); font-style: italic; }
.marking { display: inline-block; margin: 0 0 .9rem; padding: .1rem .6rem; border: 1px solid var(--caution);
  color: var(--caution); font-size: .8125rem; font-weight: 600; letter-spacing: .04em; }
h2 { font-size: 1.4rem; line-height: 1.3; margin: 3.25rem 0 .75rem; padding-top: .9rem; border-top: 1px solid var(--rule); }
h3 { font-size: 1.1rem; margin: 2.25rem 0 .4rem; }
h4 { font-size: 1rem; margin: 1.75rem 0 .3rem; color: var(--soft); }
p, .text { max-width: 42rem; margin: 0 0 .9rem; overflow-wrap: anywhere; }
li { max-width: 42rem; margin: .2rem 0; overflow-wrap: anywhere; }
a { color: var(--accent); text-underline-offset: .15em; }
:focus-visible { outline: 3px solid var(--accent); outline-offset: 2px; }
:target { scroll-margin-top: 2rem; }
td:target, th:target { background: #fff3c4; outline: 2px solid var(--caution); }
.skip { position: absolute; left: -100rem; }
.skip:focus { left: 1rem; top: .5rem; background: var(--card); padding: .3rem .6rem; }
nav { font-size: .9rem; margin: 0 0 2rem; }
nav h2 { font-size: .8125rem; letter-spacing: .06em; text-transform: uppercase; color: var(--soft); border: 0; margin: 0 0 .35rem;
  padding: 0; }
nav ol { list-style: none; margin: 0; padding: 0; }
nav ol ol { padding-left: 1.1rem; }
nav li { margin: 0; }
nav a { display: inline-block; padding: .12rem 0; text-decoration: none; }
nav a:hover { text-decoration: underline; }
dl.facts { display: grid; grid-template-columns: minmax(8rem, max-content) minmax(0, 1fr); gap: .2rem 1.25rem; margin: 0 0 1rem; }
dl.facts dt { color: var(--soft); font-size: .875rem; padding-top: .15rem; }
dl.facts dd { margin: 0; overflow-wrap: anywhere; }
code { font-size: .85em; }
.note { max-width: 42rem; margin: 0 0 1rem; padding: .6rem .9rem; border-left: 4px solid var(--accent); background: var(--tint);
  overflow-wrap: anywhere; }
.note b { display: block; font-size: .875rem; color: var(--accent); }
.note.caution { border-left-color: var(--caution); background: #fbf3ec; border-left-style: double; border-left-width: 6px; }
.note.caution b { color: var(--caution); }
.note.missing { border-left: 4px dashed var(--rule); background: #f5f5f2; }
.note.missing b { color: var(--soft); }
.excerpt { max-width: 46rem; margin: 1rem 0; border: 1px solid var(--rule); }
.excerpt .bar { display: flex; justify-content: space-between; align-items: center; gap: 1rem; padding: .35rem .9rem;
  border-bottom: 1px solid var(--line); background: var(--tint); }
.excerpt h3, .excerpt h4 { margin: 0; font-size: .9rem; color: var(--text); }
.excerpt .text { padding: .75rem .9rem; margin: 0; white-space: pre-wrap; max-width: none; user-select: text; }
button { font-size: .875rem; padding: .2rem .8rem; min-height: 2rem; border: 1px solid var(--accent); background: var(--card);
  color: var(--accent); cursor: pointer; }
button:hover { background: var(--tint); }
.scroll { overflow-x: auto; max-width: 100%; background:
  linear-gradient(90deg, var(--card) 40%, #fff0) 0 0 / 3rem 100% local no-repeat,
  linear-gradient(270deg, var(--card) 40%, #fff0) 100% 0 / 3rem 100% local no-repeat,
  linear-gradient(90deg, #0003, #0000) 0 0 / .8rem 100% scroll no-repeat,
  linear-gradient(270deg, #0003, #0000) 100% 0 / .8rem 100% scroll no-repeat; }
.table { margin: 1.5rem 0 1.75rem; }
table { border-collapse: collapse; font-size: .875rem; line-height: 1.35; font-variant-numeric: tabular-nums;
  border-top: 2px solid var(--text); border-bottom: 2px solid var(--text); }
.title { font-family: var(--sans); font-size: .9rem; line-height: 1.45; margin: 0 0 .5rem; max-width: 46rem; overflow-wrap: anywhere; }
th, td { padding: .32rem .75rem; text-align: right; vertical-align: top; white-space: nowrap; }
th:first-child, td:first-child, .words { text-align: left; }
.words { white-space: normal; min-width: 4rem; max-width: 26rem; overflow-wrap: break-word; }
tbody th { font-weight: 400; white-space: normal; min-width: 5.5rem; max-width: 20rem; }
thead th { font-weight: 600; vertical-align: bottom; white-space: normal; }
thead tr:last-child th { border-bottom: 1px solid var(--text); }
th[scope=colgroup] { text-align: center; border-bottom: 1px solid var(--rule); }
tbody tr + tr > * { border-top: 1px solid var(--grid); }
tbody tr:hover > * { background: var(--tint); }
td[title] { cursor: help; }
td .source { text-decoration: underline dotted var(--rule); text-underline-offset: .25em; }
td.strong { font-weight: 700; }
th small, td small { display: block; font-size: .8em; color: var(--soft); }
.exploratory { display: inline-block; padding: 0 .4rem; border: 1px solid var(--soft); color: var(--soft); font-size: .75rem; }
sup { font-size: .75em; line-height: 0; }
td sup { position: absolute; margin-left: .1em; transform: translateY(.6em); }
.footnotes { font: .8125rem/1.45 var(--sans); color: var(--soft); margin: .4rem 0 0; padding: 0; list-style: none; }
.footnotes li { margin: .1rem 0; }
.sources { font-size: .8125rem; line-height: 1.45; margin-top: .4rem; }
.sources h3 { font-size: .875rem; margin: 1.25rem 0 .2rem; }
.sources ul { margin: .3rem 0 0; padding-left: 1.1rem; color: var(--soft); }
.sources li { max-width: 52rem; }
figure { margin: 1.75rem 0 2rem; }
figure svg { display: block; width: 100%; height: auto; max-width: calc(1.3 * var(--width)); min-width: var(--least); }
figcaption { font-size: .9rem; line-height: 1.45; margin-top: .6rem; max-width: 46rem; overflow-wrap: anywhere; }
#shown { position: fixed; left: 0; right: 0; bottom: 0; margin: 0; padding: .7rem 1rem; background: var(--text); color: #fff;
  font: .875rem/1.4 var(--sans); overflow-wrap: anywhere; }
#shown:empty { display: none; }
footer { margin-top: 4rem; padding-top: .75rem; border-top: 1px solid var(--rule); color: var(--soft); font-size: .8125rem; }
@media (min-width: 64rem) {
  .page { display: grid; grid-template-columns: 13rem minmax(0, 1fr); column-gap: 2.5rem; max-width: 80rem; }
  .page > header, .page > footer { grid-column: 1 / -1; }
  .page > nav { position: sticky; top: 1.5rem; align-self: start; max-height: calc(100vh - 3rem); overflow-y: auto; }
  main > :first-child { margin-top: 0; border-top: 0; padding-top: 0; }
}
@media (max-width: 30rem) {
  body { font-size: 1rem; }
  .page { padding-top: 1.25rem; }
  dl.facts { grid-template-columns: 1fr; gap: 0; }
  dl.facts dd { margin-bottom: .5rem; }
  th, td { padding: .32rem .5rem; }
}
@media print {
  @page { size: A4; margin: 20mm; }
  body { background: none; font-size: 10pt; }
  .page { display: block; padding: 0; max-width: none; }
  nav, button, #shown, .skip { display: none; }
  h2, h3, h4, .title { break-after: avoid; }
  figure, .note, tr, dt, dd { break-inside: avoid; }
  thead { display: table-header-group; }
  table { font-size: 8pt; }
  .scroll { overflow: visible; background: none; }
  figure svg { max-width: var(--width); min-width: 0; }
}
)css";

const std::string_view kReportScript = R"js(
"use strict";
for (const box of document.querySelectorAll(".excerpt")) {
  const button = document.createElement("button");
  const text = box.querySelector(".text");
  button.type = "button";
  button.textContent = "Copy";
  button.addEventListener("click", async () => {
    try {
      await navigator.clipboard.writeText(text.textContent);
      button.textContent = "Copied";
    } catch {
      getSelection().selectAllChildren(text);
      button.textContent = "Selected";
    }
    setTimeout(() => { button.textContent = "Copy"; }, 2000);
  });
  box.querySelector(".bar").append(button);
}
const shown = document.getElementById("shown");
document.addEventListener("click", (event) => {
  const cell = event.target.closest("td[title]");
  shown.textContent = cell ? cell.title : "";
});
document.addEventListener("keydown", (event) => {
  if (event.key === "Escape") {
    shown.textContent = "";
  }
});
)js";

}  // namespace ocelli
