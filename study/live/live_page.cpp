#include "study/live/live_page.h"

#include <string_view>

#include "oc_core/page/html.h"

namespace ocelli {
namespace {

constexpr std::string_view kStyle = R"css(
body { max-width: 72rem; padding-top: 1.25rem; }
header { display: flex; flex-wrap: wrap; gap: .5rem 1.5rem; align-items: baseline; justify-content: space-between; }
h1 { font-size: 1.1rem; color: var(--soft); font-weight: 600; margin: 0; }
#state { font-size: 1.75rem; line-height: 1.25; font-weight: 700; margin: .5rem 0 .25rem; max-width: none; }
#step { margin: 0 0 1rem; max-width: none; }
#state[data-state="calls you"], #state[data-state="paused"], #state[data-state="no connection"] {
  color: var(--caution); }
button { font: inherit; color: var(--accent); background: var(--card); border: 1px solid var(--line);
  border-radius: 6px; padding: .3rem .9rem; cursor: pointer; }
button:focus-visible { outline: 3px solid var(--accent); outline-offset: 2px; }
.bar { height: 1.1rem; border-radius: 6px; background: var(--card); border: 1px solid var(--line);
  overflow: hidden; }
.bar div { height: 100%; width: 0; background: var(--accent); }
.cards { display: grid; gap: 1rem; grid-template-columns: repeat(auto-fit, minmax(min(19rem, 100%), 1fr));
  margin-top: 1rem; }
.card { background: var(--card); border: 1px solid var(--line); border-radius: 8px; padding: .9rem 1.1rem;
  min-width: 0; overflow-wrap: anywhere; }
.card h2 { font-size: 1rem; margin: 0 0 .4rem; padding: 0; border: 0; color: var(--soft); font-weight: 600; }
.big { font-size: 1.6rem; font-weight: 700; line-height: 1.2; margin: 0; font-variant-numeric: tabular-nums; }
.card p { margin: .15rem 0; }
.card table { width: 100%; margin: .2rem 0 0; }
th, td { border: 0; border-top: 1px solid var(--line); padding: .3rem .5rem; }
thead th { border-top: 0; }
td:first-child, th:first-child { text-align: left; padding-left: 0; white-space: normal; overflow-wrap: anywhere; }
td:last-child, th:last-child { padding-right: 0; }
ul { list-style: none; margin: .2rem 0 0; padding: 0; }
li { border-top: 1px solid var(--line); padding: .3rem 0; }
li:first-child { border-top: 0; }
.trouble { color: var(--caution); font-weight: 600; }
)css";

constexpr std::string_view kBody = R"html(<header>
<h1>Session under way</h1>
<button type="button" id="hold" aria-pressed="false">Hold the display</button>
</header>
<main>
<p id="state" role="status" aria-live="polite">Waiting for the program</p>
<p id="step" class="soft"></p>
<div class="bar" role="progressbar" aria-label="Trials done" aria-valuemin="0" aria-valuemax="100" id="bar">
<div></div></div>
<div class="cards">
<section class="card"><h2>Progress</h2><p class="big" id="done">–</p><p class="soft" id="block"></p></section>
<section class="card"><h2>Time left</h2><p class="big" id="left">–</p><p class="soft" id="elapsed"></p></section>
<section class="card"><h2>Timing of frames</h2><p class="big" id="dropped">–</p><p class="soft" id="median"></p>
<p id="verdicts"></p></section>
<section class="card"><h2>Last answers</h2><table>
<thead><tr><th scope="col">trial</th><th scope="col">answer</th><th scope="col">time</th></tr></thead>
<tbody id="answers"></tbody></table><p class="soft" id="hides"></p></section>
<section class="card"><h2>Devices</h2><ul id="devices"></ul></section>
<section class="card"><h2>Warnings</h2><ul id="warnings"></ul><p class="soft" id="more"></p></section>
</div>
</main>
<noscript><p>This page needs JavaScript to follow the session. The terminal tells the same.</p></noscript>
<script src="live.js"></script>
)html";

constexpr std::string_view kScript = R"js("use strict";
const at = id => document.getElementById(id);
const signs = {"right": "\u2713 right", "wrong": "\u2717 wrong", "time over": "\u25cb time over",
  "broken off": "\u2013 broken off"};
const states = {"running": "Running", "paused": "Paused", "calls you": "The session calls you",
  "ended": "The session has ended",
  "not begun": "The checks before the session run",
  "no connection": "No connection: the session has ended, or the program has stopped"};
const verdicts = {"good": "good", "dropped_frames": "frames dropped", "early_frames": "frames too early",
  "unstable_refresh": "screen not steady", "simulated_clock": "simulated clock"};
const ms = value => value.toFixed(1) + "\u00a0ms";
function duration(seconds) {
  const minutes = Math.round(seconds / 60);
  if (seconds < 60) return Math.round(seconds) + "\u00a0s";
  return minutes < 60 ? minutes + "\u00a0min" : Math.floor(minutes / 60) + "\u00a0h " + minutes % 60 + "\u00a0min";
}
function say(id, text) {
  if (at(id).textContent !== text) at(id).textContent = text;
}
function element(tag, text, style) {
  const made = document.createElement(tag);
  made.textContent = text;
  made.className = style ?? "";
  return made;
}
function fill(parent, rows, row, cell, none) {
  const lines = rows.length ? rows : [[{text: none, style: "soft"}]];
  parent.replaceChildren(...lines.map(cells => {
    const made = element(row, "");
    made.append(...cells.map(each => element(cell, each.text ?? each, each.style)));
    return made;
  }));
}
function showState(state) {
  at("state").dataset.state = state;
  say("state", states[state] ?? state);
}
function show(s) {
  const old = s.age_s > 3 && s.state !== "ended";
  showState(s.state);
  if (s.state === "not begun") return;
  say("step", s.step + (s.condition ? ", condition " + s.condition : "") +
    (old ? "; nothing new for " + duration(s.age_s) : ""));
  const share = s.trials ? Math.round(100 * s.trials_done / s.trials) : 0;
  at("bar").setAttribute("aria-valuenow", share);
  at("bar").firstElementChild.style.width = share + "%";
  document.title = share + " % " + (states[s.state] ?? s.state);
  say("done", s.trials_done + " of " + s.trials + " trials");
  say("block", share + " % done; block " + s.block + " of " + s.blocks);
  say("left", s.trials_done === s.trials ? "all trials are done" : "about " + duration(s.left_s));
  say("elapsed", (s.left_by === "pace" ? "at the pace of the trials so far" : "by the protocol") +
    "; without forms at the end. " + duration(s.elapsed_s) + " since the start");
  const t = s.timing;
  say("dropped", t.frames ? t.dropped + " of " + t.frames + " frames late" : "no trial yet");
  say("median", t.frames ? "last trial: " + t.last_dropped + " late, median " + ms(t.last_median_ms) + ", longest " +
    ms(t.last_longest_ms) : "");
  say("verdicts", Object.entries(t.verdicts).map(([name, n]) =>
    n + "\u00a0\u00d7\u00a0" + (verdicts[name] ?? name)).join(", "));
  fill(at("answers"), s.last_trials.map(row => [row.trial + (row.condition ? " (" + row.condition + ")" : ""),
    signs[row.outcome] ?? row.outcome, row.response_s === null ? "" : row.response_s.toFixed(2) + "\u00a0s"]),
    "tr", "td", "none yet");
  say("hides", s.hides_condition ? "Conditions are hidden: who does not know them cannot give them away." : "");
  fill(at("devices"), s.devices.map(d => [
    {text: (d.trouble ? "\u26a0 " : "") + d.name, style: d.trouble ? "trouble" : ""},
    {text: d.state, style: d.trouble ? "trouble" : "soft"}]), "li", "div", "none");
  fill(at("warnings"), s.warnings.map(w => ["\u26a0 " + w.text,
    {text: duration(w.at_s) + " after the start", style: "soft"}]), "li", "div", "none");
  say("more", s.warning_count > s.warnings.length ? "and " + (s.warning_count - s.warnings.length) + " before" : "");
}
let held = false;
at("hold").addEventListener("click", () => {
  held = !held;
  at("hold").setAttribute("aria-pressed", held);
  say("hold", held ? "Go on" : "Hold the display");
});
async function look() {
  if (!held) {
    try {
      const answer = await fetch("status.json", {cache: "no-store"});
      if (!answer.ok) throw new Error(answer.status);
      show(await answer.json());
    } catch (error) {
      showState("no connection");
    }
  }
  setTimeout(look, 1000);
}
look();
)js";

}  // namespace

std::string livePage() {
  return pageBegin("Ocelli session", {kStyle}) + std::string(kBody) + pageEnd();
}

std::string liveScript() {
  return std::string(kScript);
}

}  // namespace ocelli
