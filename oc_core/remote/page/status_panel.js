// What the page says besides its picture: the red frame and why, the state of the connection, the bar of what is loading,
// and the figures.

const byId = (id) => document.getElementById(id);

export function bytesText(bytes) {
  return bytes < 1e6 ? `${Math.round(bytes / 1e3)} kB` : `${(bytes / 1e6).toFixed(bytes < 1e7 ? 2 : 1)} MB`;
}

/// Why a picture is approximate, in words; nothing where it is not. `way` is what Picture.draw() returned.
export function approximateReason(way, load) {
  const reasons = [];
  if (way === 'depth') {
    reasons.push('the eye has moved since this image was made');
  } else if (way === 'directions') {
    reasons.push('the eye has moved, and the depth of this image is not here yet');
  }
  if (load.reach > 1) {
    reasons.push('it goes beyond this image');
  }
  if (load.detail > 1) {
    reasons.push('the image has less detail than this zoom');
  }
  return reasons.length > 0 ? `Approximate: ${reasons.join('; ')}` : '';
}

/// Texts change where they differ alone: readers of the screen say them anew otherwise.
function setText(element, text) {
  if (element.textContent !== text) {
    element.textContent = text;
  }
}

export class StatusPanel {
  constructor() {
    this.figures = new Map();
  }

  approximate(reason) {
    byId('approximate').hidden = reason === '';
    setText(byId('why'), reason);
  }

  /// `aside` leaves the picture free; `isPlain` is no trouble. Without a text it goes.
  state(text, {aside = false, isPlain = false} = {}) {
    const element = byId('state');
    element.hidden = text === '';
    element.classList.toggle('aside', aside);
    element.classList.toggle('plain', isPlain);
    setText(element, text);
  }

  /// `stage` in words; `progress` {received, size} where bytes are under way.
  loading(stage, progress) {
    const element = byId('loading');
    element.hidden = stage === '';
    const share = progress.size > 0 ? progress.received / progress.size : 0;
    byId('loaded').style.transform = `scaleX(${share})`;
    const bytes = progress.size > 0 ? `${bytesText(progress.received)} of ${bytesText(progress.size)}` : '';
    setText(byId('loading-text'), [stage, bytes].filter(Boolean).join(' '));
    element.setAttribute('aria-valuenow', Math.round(100 * share));
    element.setAttribute('aria-valuetext', `${stage} ${bytes}`);
  }

  /// Rows of a name and a text.
  show(rows) {
    const body = byId('figure-rows');
    for (const [name, text] of rows) {
      if (!this.figures.has(name)) {
        const row = body.insertRow();
        const head = row.appendChild(document.createElement('th'));
        head.scope = 'row';
        head.textContent = name;
        this.figures.set(name, row.insertCell());
      }
      setText(this.figures.get(name), text);
    }
  }

  get hasFigures() {
    return !byId('figures').hidden;
  }
}

/// Rows of [to do, mouse or touch, keys].
export function fillHelp(rows) {
  const body = byId('help-rows');
  for (const [what, mouse, keys] of rows) {
    const row = body.insertRow();
    const head = row.appendChild(document.createElement('th'));
    head.scope = 'row';
    head.textContent = what;
    row.insertCell().textContent = mouse;
    row.insertCell().textContent = keys;
  }
}
