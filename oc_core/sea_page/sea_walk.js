// The page: where one is, what mouse and keys do, what is drawn. `ocelliSea.open(data)` begins it, from sea.js.
'use strict';

(() => {
  const kStepSeconds = 0.16;
  const kStart = {yaw: 0, pitch: 0, fov: 75};
  const kWays = new Map([['w', 0], ['arrowup', 0], ['d', 90], ['arrowright', 90], ['s', 180], ['arrowdown', 180], ['a', 270], ['arrowleft', 270]]);
  const kTurns = new Map([['q', [-5, 0]], ['e', [5, 0]], ['r', [0, 5]], ['f', [0, -5]]]);
  const element = (id) => document.getElementById(id);
  const sea = window.ocelliSea;

  class SeaWalk {
    constructor(data) {
      this.data = data;
      this.plan = new sea.PlacePlan(data.places);
      this.canvas = element('picture');
      const gl = this.canvas.getContext('webgl2', {antialias: false, preserveDrawingBuffer: true});
      if (gl === null) {
        this.say('This page needs WebGL2, which this browser does not have or has switched off.');
        return;
      }
      this.gl = gl;
      this.picture = new sea.SeaPicture(gl, data);
      this.images = new sea.SeaImages(gl, () => this.redraw(), (text) => this.say(text));
      this.map = new sea.SeaMap(element('map'), this.plan);
      this.view = {...kStart, eye: [0, 0, 0]};
      this.step = null; // {from, to, begin}
      this.goTo(this.placeOfAddress() ?? 0);
      this.listen();
      this.resize();
    }

    /// Place 17 of "index.html#place=17".
    placeOfAddress() {
      const found = /place=(\d+)/.exec(window.location.hash);
      const index = found === null ? null : Number(found[1]);
      return index !== null && index < this.data.places.length ? index : null;
    }

    say(text) {
      element('state').textContent = text;
      element('state').hidden = text === '';
    }

    goTo(index) {
      this.step = null;
      this.moveTo(this.plan.points[index]);
    }

    /// To a point of the plan, (x, z): heights are those of the places around it.
    moveTo(point) {
      const inside = this.plan.clamped(point);
      this.blend = sea.blendAt(this.plan, inside);
      const height = this.blend.reduce((sum, {index, weight}) => sum + weight * this.data.places[index].eye[1], 0);
      this.view.eye = [inside[0], height, inside[1]];
      this.redraw();
    }

    /// A step in a direction, degrees to the right of the view; many at once with `steps`.
    walk(way, steps) {
      const angle = (this.view.yaw + way) * Math.PI / 180;
      const direction = [Math.sin(angle), -Math.cos(angle)];
      let from = this.step === null ? [this.view.eye[0], this.view.eye[2]] : this.plan.points[this.step.to];
      let to = null;
      for (let k = 0; k < steps; ++k) {
        const next = sea.nextPlace(this.plan, from, direction);
        if (next === null) {
          break;
        }
        to = next;
        from = this.plan.points[next];
      }
      if (to === null) {
        return;
      }
      this.step = {from: [this.view.eye[0], this.view.eye[2]], to, begin: performance.now()};
      this.ahead = sea.nextPlace(this.plan, this.plan.points[to], direction);
      this.redraw();
    }

    turn(right, up) {
      this.view.yaw = (this.view.yaw + right + 360) % 360;
      this.view.pitch = Math.min(Math.max(this.view.pitch + up, -89), 89);
      this.redraw();
    }

    zoom(factor) {
      this.view.fov = Math.min(Math.max(this.view.fov * factor, 20), 110);
      this.redraw();
    }

    reset() {
      Object.assign(this.view, kStart);
      this.goTo(0);
    }

    redraw() {
      if (this.frame === undefined) {
        this.frame = requestAnimationFrame(() => {
          this.frame = undefined;
          this.animate();
          this.draw();
        });
      }
    }

    animate() {
      if (this.step === null) {
        return;
      }
      const {from, to, begin} = this.step;
      const t = Math.min((performance.now() - begin) / 1000 / kStepSeconds, 1);
      const end = this.plan.points[to];
      if (t >= 1) {
        this.step = null;
      }
      this.moveTo([from[0] + t * (end[0] - from[0]), from[1] + t * (end[1] - from[1])]);
    }

    draw() {
      const next = this.step === null ? [] : [this.step.to];
      const ahead = [this.ahead, ...this.plan.nearest([this.view.eye[0], this.view.eye[2]], 5)];
      this.images.want([...new Set([...this.blend.map(({index}) => index), ...next, ...ahead])].filter((index) => index != null));
      const parts = this.blend.map((part) => ({...part, texture: this.images.at(part.index)})).filter(({texture}) => texture !== null);
      const total = parts.reduce((sum, {weight}) => sum + weight, 0);
      // Until an image is here, the last one that was stays.
      if (parts.length > 0) {
        this.shown = parts.map((part) => ({...part, weight: part.weight / total}));
        this.picture.draw(this.view, this.shown);
      } else {
        const old = (this.shown ?? []).map((part) => ({...part, texture: this.images.at(part.index)})).filter(({texture}) => texture !== null);
        this.picture.draw(this.view, old);
      }
      this.isWhole = parts.length === this.blend.length;
      const half = Math.atan(Math.tan(this.view.fov * Math.PI / 360) * this.canvas.width / this.canvas.height);
      this.map.draw(this.view, half, this.blend);
      const shares = this.blend.map(({index, weight}) => `${index} (${Math.round(100 * weight)} %)`).join(', ');
      const status = `${this.blend.length > 1 ? 'Between places' : 'Place'} ${this.blend.length > 1 ? shares : this.blend[0].index} of ${this.data.places.length}`;
      if (element('status').textContent !== status) {
        element('status').textContent = status;
      }
    }

    resize() {
      const ratio = window.devicePixelRatio || 1;
      this.canvas.width = Math.max(1, Math.round(this.canvas.clientWidth * ratio));
      this.canvas.height = Math.max(1, Math.round(this.canvas.clientHeight * ratio));
      this.redraw();
    }

    showMap(isShown) {
      element('plan').hidden = !isShown;
      element('map-button').setAttribute('aria-pressed', String(isShown));
    }

    key(event) {
      if (event.ctrlKey || event.metaKey || event.altKey || element('help').open) {
        return;
      }
      const key = event.key.toLowerCase();
      const onButton = event.target instanceof HTMLButtonElement && (key === 'enter' || key === ' ');
      const {data, blend} = this;
      const actions = new Map([
        ['h', () => element('help').showModal()],
        ['m', () => this.showMap(element('plan').hidden)],
        ['0', () => this.reset()],
        ['n', () => this.goTo((blend[0].index + 1) % data.places.length)],
        ['p', () => this.goTo((blend[0].index + data.places.length - 1) % data.places.length)],
        ['+', () => this.zoom(1 / 1.1)], ['=', () => this.zoom(1 / 1.1)], ['-', () => this.zoom(1.1)]]);
      if (onButton) {
        return;
      }
      if (kWays.has(key)) {
        this.walk(kWays.get(key), event.shiftKey ? 10 : 1);
      } else if (kTurns.has(key)) {
        this.turn(...kTurns.get(key));
      } else if (actions.has(key)) {
        actions.get(key)();
      } else {
        return;
      }
      event.preventDefault();
    }

    listen() {
      const {canvas} = this;
      let last = null;
      canvas.addEventListener('pointerdown', (event) => {
        canvas.setPointerCapture(event.pointerId);
        last = [event.clientX, event.clientY];
      });
      canvas.addEventListener('pointermove', (event) => {
        if (last !== null) {
          // The picture follows the pointer.
          const degrees = this.view.fov / canvas.clientHeight;
          this.turn(-(event.clientX - last[0]) * degrees, (event.clientY - last[1]) * degrees);
          last = [event.clientX, event.clientY];
        }
      });
      for (const end of ['pointerup', 'pointercancel']) {
        canvas.addEventListener(end, () => { last = null; });
      }
      canvas.addEventListener('wheel', (event) => {
        this.zoom(1.001 ** event.deltaY);
        event.preventDefault();
      }, {passive: false});
      canvas.addEventListener('webglcontextlost', (event) => event.preventDefault());
      canvas.addEventListener('webglcontextrestored', () => {
        this.images.forget();
        this.picture.prepare();
        this.redraw();
      });
      const map = element('map');
      let isOnMap = false;
      const pointOf = (event) => this.map.pointOf([event.offsetX, event.offsetY]);
      map.addEventListener('pointerdown', (event) => {
        map.setPointerCapture(event.pointerId);
        isOnMap = true;
        this.goTo(this.plan.nearest(pointOf(event), 1)[0]);
      });
      map.addEventListener('pointermove', (event) => {
        if (isOnMap) {
          this.step = null;
          this.moveTo(pointOf(event));
        }
      });
      for (const end of ['pointerup', 'pointercancel']) {
        map.addEventListener(end, () => { isOnMap = false; });
      }
      window.addEventListener('keydown', (event) => this.key(event));
      window.addEventListener('resize', () => this.resize());
      element('help-button').addEventListener('click', () => element('help').showModal());
      element('help-close').addEventListener('click', () => element('help').close());
      element('map-button').addEventListener('click', () => this.showMap(element('plan').hidden));
      element('reset-button').addEventListener('click', () => this.reset());
      canvas.focus();
    }
  }

  sea.open = (data) => {
    document.title = data.title;
    element('sea-title').textContent = data.title;
    sea.page = new SeaWalk(data);
  };
})();
