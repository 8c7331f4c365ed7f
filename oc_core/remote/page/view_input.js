// What mouse, touch and keys do with the view. `host` has `view` (null before the server has said one), `home` (the view
// to begin with), `pivot` (the middle of the scene), `speed` (a length of the scene) and `setView(view)`.
import {dragged, moved, orbited, turned, zoomed, radians} from './view_math.js';

const kWheelStep = 0.0015;
const kLinePixels = 16;  // of a wheel that counts lines
const kKeyTurn = 0.05;  // of the field of view
const kKeyZoom = 1.12;
const kKeyMove = 0.02;  // of the scene
const kKeyOrbit = radians(2);
const kOrbitPerHeight = radians(60);  // of a drag over the height of the screen

/// What a key does, and how the help calls it. Keys with a shift are written so.
const kViewKeys = {
  ArrowLeft: (host) => turned(host.view, -host.fov * kKeyTurn, 0),
  ArrowRight: (host) => turned(host.view, host.fov * kKeyTurn, 0),
  ArrowUp: (host) => turned(host.view, 0, host.fov * kKeyTurn),
  ArrowDown: (host) => turned(host.view, 0, -host.fov * kKeyTurn),
  'Shift+ArrowLeft': (host) => orbited(host.view, host.pivot, -kKeyOrbit, 0),
  'Shift+ArrowRight': (host) => orbited(host.view, host.pivot, kKeyOrbit, 0),
  'Shift+ArrowUp': (host) => orbited(host.view, host.pivot, 0, kKeyOrbit),
  'Shift+ArrowDown': (host) => orbited(host.view, host.pivot, 0, -kKeyOrbit),
  '+': (host) => zoomed(host.view, 2, 2, kKeyZoom, [1, 1]),
  '=': (host) => zoomed(host.view, 2, 2, kKeyZoom, [1, 1]),
  '-': (host) => zoomed(host.view, 2, 2, 1 / kKeyZoom, [1, 1]),
  w: (host) => moved(host.view, [0, 0, host.speed * kKeyMove]),
  s: (host) => moved(host.view, [0, 0, -host.speed * kKeyMove]),
  a: (host) => moved(host.view, [-host.speed * kKeyMove, 0, 0]),
  d: (host) => moved(host.view, [host.speed * kKeyMove, 0, 0]),
  e: (host) => moved(host.view, [0, host.speed * kKeyMove, 0]),
  q: (host) => moved(host.view, [0, -host.speed * kKeyMove, 0]),
  r: (host) => host.home,
};

/// The rows of the help: what, mouse or touch, keys.
export const viewHelp = [
  ['look around', 'drag', 'arrow keys'],
  ['zoom', 'wheel; pinch', '+  -'],
  ['go around the scene', 'drag with shift or the right button; two fingers', 'shift and arrow keys'],
  ['move the eye', '', 'W A S D, E up, Q down'],
  ['go back to the first view', '', 'R'],
];

export class ViewInput {
  constructor(canvas, host) {
    this.canvas = canvas;
    this.host = host;
    this.pointers = new Map();  // those that are down, where they are
    canvas.addEventListener('pointerdown', (event) => this.down(event));
    canvas.addEventListener('pointermove', (event) => this.move(event));
    canvas.addEventListener('pointerup', (event) => this.up(event));
    canvas.addEventListener('pointercancel', (event) => this.up(event));
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('wheel', (event) => this.wheel(event), {passive: false});
  }

  /// Pixels of the canvas.
  at(event) {
    const {left, top, width, height} = this.canvas.getBoundingClientRect();
    return [(event.clientX - left) * this.canvas.width / width, (event.clientY - top) * this.canvas.height / height];
  }

  down(event) {
    if (event.button === 1 || this.host.view === null) {
      return;
    }
    this.canvas.focus({focusVisible: false});
    this.canvas.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, this.at(event));
    this.goesAround = event.button === 2 || event.shiftKey;
    this.begin();
  }

  /// From where fingers and the view are now.
  begin() {
    this.start = {view: this.host.view, points: [...this.pointers.values()]};
  }

  move(event) {
    if (!this.pointers.has(event.pointerId)) {
      return;
    }
    this.pointers.set(event.pointerId, this.at(event));
    const [now, other] = [...this.pointers.values()];
    const {view, points: [from, otherFrom]} = this.start;
    const {width, height} = this.canvas;
    if (other) {
      const middle = (p, q) => [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2];
      const apart = (p, q) => Math.max(1, Math.hypot(p[0] - q[0], p[1] - q[1]));
      const factor = apart(now, other) / apart(from, otherFrom);
      const around = this.around(view, middle(from, otherFrom), middle(now, other));
      this.host.setView(zoomed(around, width, height, factor, middle(now, other)));
    } else {
      this.host.setView(this.goesAround ? this.around(view, from, now) : dragged(view, width, height, from, now));
    }
  }

  around(view, from, now) {
    const perPixel = kOrbitPerHeight / this.canvas.height;
    return orbited(view, this.host.pivot, (from[0] - now[0]) * perPixel, (now[1] - from[1]) * perPixel);
  }

  up(event) {
    if (this.pointers.delete(event.pointerId)) {
      this.begin();
    }
  }

  wheel(event) {
    event.preventDefault();
    if (this.host.view === null) {
      return;
    }
    const pixels = event.deltaY * (event.deltaMode === WheelEvent.DOM_DELTA_LINE ? kLinePixels : 1);
    const factor = Math.exp(-pixels * kWheelStep * (event.ctrlKey ? 5 : 1));
    const {width, height} = this.canvas;
    this.host.setView(zoomed(this.host.view, width, height, factor, this.at(event)));
    this.begin();
  }

  /// Whether the key was one of the view's.
  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) {
      return false;
    }
    const name = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const action = kViewKeys[event.shiftKey && name.startsWith('Arrow') ? `Shift+${name}` : name];
    if (action === undefined) {
      return false;
    }
    this.host.setView(action(this.host));
    return true;
  }
}
