// The frames of the lenses on the page, and what mouse, touch and keys do with them. `changed()` is called after each
// change, `left()` when the focus is to go back to the picture.
import {outerHalf} from './gpc_map.js';

const kWheelStep = 0.0015;
const kKeyMove = 0.02;  // of the screen
const kKeyScale = 1.1;
const kKeyZoom = 1.15;

const inPercent = (share) => `${(100 * share).toFixed(3)}%`;

export class LensElements {
  constructor(container, set, {changed, left}) {
    this.container = container;
    this.set = set;
    this.changed = changed;
    this.left = left;
    this.elements = [];
  }

  /// A new lens near a point of the screen, which gets the focus. False where there is no room.
  add(at) {
    const index = this.set.add(at);
    if (index < 0) {
      return false;
    }
    this.changed();
    this.elements[index].focus();
    return true;
  }

  remove(index) {
    this.set.remove(index);
    this.changed();
    const next = this.elements[Math.min(index, this.elements.length - 1)];
    if (next) {
      next.focus();
    } else {
      this.left();
    }
  }

  update() {
    const {lenses} = this.set;
    while (this.elements.length > lenses.length) {
      this.elements.pop().remove();
    }
    while (this.elements.length < lenses.length) {
      this.elements.push(this.element());
    }
    lenses.forEach((lens, i) => this.place(this.elements[i], lens, i));
  }

  place(element, lens, index) {
    const {center, extent} = lens;
    Object.assign(element.style, {
      left: inPercent(center[0] - extent[0] / 2), top: inPercent(center[1] - extent[1] / 2),
      width: inPercent(extent[0]), height: inPercent(extent[1]),
    });
    const half = outerHalf(lens);
    const beyond = [0, 1].map((axis) => inPercent(-(half[axis] - extent[axis] / 2) / extent[axis]));
    const outer = element.querySelector('.outer');
    Object.assign(outer.style, {left: beyond[0], right: beyond[0], top: beyond[1], bottom: beyond[1]});
    const zoom = `${Number(lens.zoom.toPrecision(2))}\u00d7`;
    element.querySelector('.name').textContent = zoom;
    element.setAttribute('aria-label', `Lens ${index + 1}, ${zoom}. Arrow keys move it, shift and arrows resize it, ` +
      'plus and minus change its zoom, T its transition, Delete removes it.');
  }

  element() {
    const element = document.createElement('div');
    element.className = 'lens';
    element.tabIndex = 0;
    element.setAttribute('role', 'group');
    element.setAttribute('aria-roledescription', 'lens');
    const part = (name) => {
      const made = document.createElement('span');
      made.className = name;
      made.setAttribute('aria-hidden', 'true');
      return element.appendChild(made);
    };
    part('outer');
    part('name');
    for (const corner of [[-1, -1], [1, -1], [1, 1], [-1, 1]]) {
      const made = part('corner');
      [made.dataset.x, made.dataset.y] = corner;
      this.followDrag(made, element, (index, start, by) => {
        const at = start.center.map((c, axis) => c + corner[axis] * start.extent[axis] / 2 + by[axis]);
        return this.set.resize(index, corner, at);
      });
    }
    this.followDrag(element, element, (index, start, by) =>
      this.set.move(index, start.center.map((c, axis) => c + by[axis])));
    element.addEventListener('wheel', (event) => {
      event.preventDefault();
      this.change(element, (index) => this.set.zoom(index, Math.exp(-event.deltaY * kWheelStep)));
    }, {passive: false});
    element.addEventListener('contextmenu', (event) => event.preventDefault());
    element.addEventListener('keydown', (event) => this.takeKey(element, event));
    return this.container.appendChild(element);
  }

  change(element, body) {
    body(this.elements.indexOf(element));
    this.changed();
  }

  /// `body(index, lens as it was, by)` with shares of the screen.
  followDrag(handle, element, body) {
    handle.addEventListener('pointerdown', (event) => {
      if (event.button !== 0) {
        return;
      }
      event.preventDefault();
      event.stopPropagation();
      element.focus({focusVisible: false});
      const index = this.elements.indexOf(element);
      const start = structuredClone(this.set.lenses[index]);
      const {clientWidth, clientHeight} = this.container.parentElement;
      const follow = (move) => {
        if (move.pointerId === event.pointerId) {
          const by = [(move.clientX - event.clientX) / clientWidth, (move.clientY - event.clientY) / clientHeight];
          this.change(element, (now) => body(now, start, by));
        }
      };
      const end = (last) => {
        if (last.pointerId === event.pointerId) {
          handle.removeEventListener('pointermove', follow);
          handle.removeEventListener('pointerup', end);
          handle.removeEventListener('pointercancel', end);
        }
      };
      handle.setPointerCapture(event.pointerId);
      handle.addEventListener('pointermove', follow);
      handle.addEventListener('pointerup', end);
      handle.addEventListener('pointercancel', end);
    });
  }

  takeKey(element, event) {
    if (event.ctrlKey || event.metaKey || event.altKey) {
      return;
    }
    const index = this.elements.indexOf(element);
    const lens = this.set.lenses[index];
    const arrow = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}[event.key];
    const actions = {
      '+': () => this.set.zoom(index, kKeyZoom),
      '=': () => this.set.zoom(index, kKeyZoom),
      '-': () => this.set.zoom(index, 1 / kKeyZoom),
      't': () => this.set.widen(index, kKeyScale),
      'T': () => this.set.widen(index, 1 / kKeyScale),
    };
    if (arrow && event.shiftKey) {
      const corner = lens.center.map((c, axis) => c + lens.extent[axis] / 2 + arrow[axis] * kKeyMove);
      this.set.resize(index, [1, 1], corner);
    } else if (arrow) {
      this.set.move(index, lens.center.map((c, axis) => c + arrow[axis] * kKeyMove));
    } else if (event.key in actions) {
      actions[event.key]();
    } else if (event.key === 'Delete' || event.key === 'Backspace') {
      event.preventDefault();
      event.stopPropagation();
      this.remove(index);
      return;
    } else if (event.key === 'Escape') {
      event.stopPropagation();
      this.left();
      return;
    } else {
      return;
    }
    event.preventDefault();
    event.stopPropagation();
    this.changed();
  }
}
