#include "oc_core/feeds_page/feeds_page_html.h"

#include <fmt/format.h>

#include "oc_core/page/html.h"

namespace ocelli {
namespace {

constexpr const char* kStyle = R"(
main { max-width: 80rem; margin: 0 auto; padding: 1rem; }
img { display: block; width: 100%; height: auto; background: var(--card); }
#feeds { display: flex; flex-wrap: wrap; gap: 0.5rem 2rem; padding: 0; list-style: none; }
#feeds .bad, #gone { color: var(--caution); font-weight: bold; }
)";

constexpr const char* kScript = R"(const list = document.getElementById("feeds");
const gone = document.getElementById("gone");
const image = document.getElementById("image");
let wasGone = false;
async function update() {
  try {
    const feeds = await (await fetch("/feeds.json", {cache: "no-store"})).json();
    while (list.children.length < feeds.length) list.append(document.createElement("li"));
    feeds.forEach(({text, good}, i) => {
      if (list.children[i].textContent !== text) list.children[i].textContent = text;
      list.children[i].className = good ? "" : "bad";
    });
    if (wasGone) image.src = "/image?" + Date.now();
    wasGone = false;
  } catch {
    wasGone = true;
  }
  gone.hidden = !wasGone;
}
update();
setInterval(update, 1000);
)";

}  // namespace

std::string feedsPageHtml(const std::string& title) {
  return pageBegin(title, {kStyle}) +
         fmt::format(R"(<main>
<h1>{}</h1>
<img id="image" src="{}" alt="One continuous image of all feeds, live">
<h2>Feeds</h2>
<ul id="feeds"></ul>
<p id="gone" role="status" hidden>The run has ended, or does not answer.</p>
<noscript><p>The image is live without scripts; the states of the feeds stand in it.</p></noscript>
<script src="{}"></script>
</main>
)",
                     htmlFromText(title), kFeedsImagePath, kFeedsScriptPath) +
         pageEnd();
}

std::string feedsPageScript() {
  return kScript;
}

}  // namespace ocelli
