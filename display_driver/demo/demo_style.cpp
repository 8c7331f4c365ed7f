#include "display_driver/demo/demo_style.h"

namespace ocelli {

const std::string_view kDemoStyle = R"css(
nav ul { display: flex; flex-wrap: wrap; gap: .25rem 1.5rem; padding: 0; margin: 1rem 0; list-style: none; }
.row { display: grid; grid-template-columns: repeat(var(--columns), minmax(0, 1fr)); gap: 1rem; }
@media (max-width: 50rem) { .row { grid-template-columns: minmax(0, 1fr); } }
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
.bar { display: block; height: .45rem; min-width: 1px; margin: .2rem 0 .1rem; border-radius: 2px; }
.di { background: var(--vermilion); }
.ddoc { background: repeating-linear-gradient(45deg, var(--blue) 0 4px, color-mix(in srgb, var(--blue) 55%, var(--card)) 4px 7px); }
)css";

}  // namespace ocelli
