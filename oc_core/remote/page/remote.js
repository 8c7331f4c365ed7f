// The page of remote visualisation (section 5.2.1): it draws pictures at the screen's rate from the images that it has
// received, and asks the server for others before these end. Parts of it: connection.js and image_receiver.js receive,
// look_planner.js asks, picture.js draws, view_input.js and lens_elements.js take what the user does.
import {Connection, socketAddress} from './connection.js';
import {FrameClock} from './frame_clock.js';
import {GpcMap} from './gpc_map.js';
import {ImageCover} from './image_cover.js';
import {ImageReceiver, unreadableReason} from './image_receiver.js';
import {LensElements} from './lens_elements.js';
import {LensSet} from './lens_set.js';
import {LookPlanner, chosenImage} from './look_planner.js';
import {Picture} from './picture.js';
import {StatusPanel, approximateReason, bytesText, fillHelp} from './status_panel.js';
import {ViewInput, viewHelp} from './view_input.js';
import {add, completeView, length, radians, subtract, times} from './view_math.js';

const kMaxHeld = 4;
const kMaxTriangles = 400000;
/// An image that is wider than the screen by this has two samples and more on a pixel where it is dense: one of two is
/// enough to join surfaces at their rims.
const kDenseSamples = 1.7;
const kTick = 50;  // milliseconds between looks at what there is to ask
const kFigureTick = 250;
const kFineAfter = 150;  // milliseconds without a change, where pictures in motion are quick ones
const kScreenLimits = [16, 4096];
/// Images of wide views are larger than those of narrow ones: so much of a texture is for the latter.
const kTextureShare = 0.95;
const kMaxScreenPixels = 2.5e6;  // of dense screens fewer, as an image has more than twice as many
const kVersion = 1;

const seconds = () => performance.now() / 1000;
const byId = (id) => document.getElementById(id);

class RemotePage {
  constructor() {
    this.canvas = byId('picture');
    this.panel = new StatusPanel();
    this.clock = new FrameClock();
    this.planner = new LookPlanner();
    this.lenses = new LensSet();
    this.held = [];
    this.view = null;
    this.home = null;
    this.pivot = [0, 0, 0];
    this.speed = 1;
    this.settings = {};
    this.stage = '';
    this.way = 'nothing';
    this.bytes = 0;
    this.problem = '';
    this.connectionText = '';
    this.isAsking = false;
    this.maxScreen = kScreenLimits[1];
    this.picture = new Picture(this.canvas);
    this.receiver = new ImageReceiver({
      colored: (image) => this.takeColors(image),
      deepened: (image) => this.takeDepths(image),
      failed: (text, sequence) => this.stopAsking(text, sequence),
    }, kMaxTriangles);
    this.lensElements = new LensElements(byId('lenses'), this.lenses, {
      changed: () => this.lensesChanged(),
      left: () => this.canvas.focus(),
    });
    this.input = new ViewInput(this.canvas, this);
    this.listen();
    this.connection = new Connection(socketAddress(location), {
      message: (message) => this.takeMessage(message),
      piece: (buffer) => this.takePiece(buffer),
      state: (name, pause, reason) => this.takeState(name, pause, reason),
      failed: (text) => this.failMessage(text),
    });
    setInterval(() => this.ask(), kTick);
    setInterval(() => this.showFigures(), kFigureTick);
  }

  /// Vertical, radians.
  get fov() {
    return radians(this.view.fov_vertical_degrees);
  }

  get screen() {
    return [this.canvas.width, this.canvas.height];
  }

  get lensLayout() {
    return this.lenses.layout(this.settings.sampling ?? 'cubic');
  }

  listen() {
    new ResizeObserver(() => this.fitScreen()).observe(this.canvas);
    this.fitScreen();
    this.canvas.addEventListener('webglcontextlost', (event) => event.preventDefault());
    this.canvas.addEventListener('webglcontextrestored', () => this.restorePicture());
    this.canvas.addEventListener('pointermove', (event) => {
      const {width, height} = this.canvas;
      this.pointer = this.input.at(event).map((x, axis) => x / [width, height][axis]);
    });
    const buttons = {
      'help-button': () => byId('help').showModal(),
      'help-close': () => byId('help').close(),
      'lens-button': () => this.addLens([0.5, 0.5]),
      'reset-button': () => this.reset(),
      'figures-button': () => this.toggleFigures(),
    };
    for (const [id, action] of Object.entries(buttons)) {
      byId(id).addEventListener('click', action);
    }
    fillHelp([
      ...viewHelp,
      ['add a lens', 'the button', 'L'],
      ['move, resize a lens', 'drag it; drag a corner', 'arrow keys; shift and arrow keys'],
      ['change its zoom, its transition', 'wheel over it', '+ and -; T and shift T'],
      ['choose, remove a lens', 'click', 'Tab; Delete'],
      ['see figures, this help', 'the buttons', 'F, H'],
    ]);
    document.addEventListener('keydown', (event) => this.takeKey(event));
    for (const name of ['pointerdown', 'keydown', 'wheel']) {
      document.addEventListener(name, () => this.connection.wake(), {capture: true, passive: true});
    }
    document.addEventListener('visibilitychange', () => {
      if (!document.hidden) {
        this.connection.tryNow();
      }
    });
    this.canvas.focus({focusVisible: false});
  }

  takeKey(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || byId('help').open) {
      return;
    }
    const isButton = event.target instanceof HTMLButtonElement;
    const actions = {
      h: () => byId('help').showModal(),
      '?': () => byId('help').showModal(),
      l: () => this.addLens(this.pointer ?? [0.5, 0.5]),
      f: () => this.toggleFigures(),
    };
    const action = actions[event.key.toLowerCase()];
    if (action !== undefined) {
      event.preventDefault();
      action();
    } else if (!isButton && this.view !== null && this.input.key(event)) {
      event.preventDefault();
    }
  }

  addLens(at) {
    if (!this.lensElements.add(at)) {
      this.panel.state('There is no room for another lens.', {aside: true, isPlain: true});
      setTimeout(() => this.showState(), 2000);
    }
  }

  reset() {
    if (this.home !== null) {
      this.setView(this.home);
    }
    this.canvas.focus();
  }

  toggleFigures() {
    const figures = byId('figures');
    figures.hidden = !figures.hidden;
    byId('figures-button').setAttribute('aria-pressed', String(!figures.hidden));
    this.showFigures();
  }

  fitScreen() {
    const {clientWidth, clientHeight} = this.canvas;
    const density = Math.min(devicePixelRatio, Math.sqrt(kMaxScreenPixels / Math.max(1, clientWidth * clientHeight)),
      this.maxScreen / Math.max(1, clientWidth, clientHeight));
    const pixels = (size) => Math.min(this.maxScreen, Math.max(kScreenLimits[0], Math.round(size * density)));
    const [width, height] = [pixels(clientWidth), pixels(clientHeight)];
    if (width !== this.canvas.width || height !== this.canvas.height) {
      this.canvas.width = width;
      this.canvas.height = height;
      this.lensMap = null;
      this.redraw();
    }
  }

  restorePicture() {
    this.picture.restore();
    for (const image of this.held) {
      this.picture.addColors(image);
      if (image.mesh !== null) {
        this.picture.addDepths(image);
      }
    }
    this.redraw();
  }

  setView(view) {
    this.view = view;
    this.inMotion();
  }

  lensesChanged() {
    this.lensMap = null;
    this.lensElements.update();
    this.inMotion();
  }

  /// Where pictures take long, those in motion are drawn the quick way, and a fine one when it ends.
  inMotion() {
    this.isMoving = true;
    clearTimeout(this.rest);
    this.rest = setTimeout(() => {
      this.isMoving = false;
      if (this.isQuick) {
        this.redraw();
      }
    }, kFineAfter);
    this.redraw();
  }

  // What comes from the server.

  takeState(name, pause, reason) {
    this.connectionText = {
      connecting: this.held.length > 0 ? '' : 'Connecting to the server ...',
      open: '',
      closed: `The connection to the server is lost${reason ? ` (${reason})` : ''}. ` +
        `Trying again in ${Math.max(1, Math.round(pause))} s.`,
      refused: `The server has closed the connection (${reason}). Click, or press a key, to connect again.`,
    }[name];
    this.isConnected = name === 'open';
    if (name !== 'open') {
      this.planner.forget();
      this.receiver.forget();
      this.stage = '';
    }
    this.problem = '';
    this.showState();
    this.showLoading();
  }

  showState() {
    const text = this.problem || this.connectionText;
    this.panel.state(text, {aside: this.held.length > 0, isPlain: text === 'Connecting to the server ...'});
  }

  takeMessage(message) {
    const takers = {
      hello: () => this.begin(message),
      queued: () => this.setStage(message.before > 0 ? `Waiting for ${message.before} others` : 'Waiting'),
      drawing: () => this.setStage('Drawing'),
      image: () => this.beginImage(message),
      error: () => {
        this.planner.failed(message.sequence, seconds());
        this.fail(`The server says: ${message.message}`);
      },
    };
    takers[message.type]?.();
  }

  begin({version, scene, view, box, settings, max_screen: maxScreen}) {
    this.isAsking = false;
    if (version !== kVersion) {
      this.fail(`The server speaks version ${version} of the protocol, and this page version ${kVersion}: load it again.`);
      return;
    }
    this.settings = settings;
    this.lensMap = null;
    // No larger than what the server draws for, and, but for images of wide views, than what the graphics processor takes.
    this.maxScreen = Math.min(maxScreen ?? kScreenLimits[1],
      Math.floor(kTextureShare * this.picture.maxSide / (settings.size ?? 1)));
    this.fitScreen();
    this.pivot = times(add(box[0], box[1]), 0.5);
    this.speed = length(subtract(box[1], box[0])) || 1;
    this.home = completeView(view);
    // A view that the user has already chosen stays, where the scene is the same.
    if (this.view === null || scene !== this.scene) {
      [...this.held].forEach((image) => this.drop(image));
      this.view = this.home;
    }
    this.scene = scene;
    document.title = `${scene} - Ocelli`;
    byId('scene-name').textContent = scene;
    const unreadable = unreadableReason(settings);
    if (unreadable !== '') {
      this.stopAsking(unreadable);
    } else {
      this.isAsking = true;
      this.ask();
    }
    this.redraw();
  }

  beginImage(header) {
    const {maxSide} = this.picture;
    if (Math.max(...header.size ?? []) > maxSide) {
      this.planner.failed(header.sequence, seconds());
      this.fail(`This computer draws images of at most ${maxSide} pixels a side, and that of this view has ` +
        `${header.size.join(' \u00d7 ')}. Zoom in, or make the window smaller.`);
      return;
    }
    const screen = this.planner.asked.find(({look}) => look.sequence === header.sequence)?.look.screen ?? this.screen;
    const image = this.receiver.begin(header, seconds(), {
      isBent: this.lenses.lenses.length > 0,
      least: header.size?.[0] >= kDenseSamples * screen[0] ? 2 : 1,
    });
    image.screen = screen;
    this.setStage('Receiving');
  }

  takePiece(buffer) {
    this.bytes += buffer.byteLength;
    this.receiver.piece(buffer);
    this.showLoading();
  }

  takeColors(image) {
    image.cover = new ImageCover(image.view, image.width, image.height, image.layout);
    this.picture.addColors(image);
    image.drawnAt = seconds();
    image.arrived = seconds();
    if (this.held.length >= kMaxHeld) {
      this.drop(this.held.reduce((a, b) => (b.drawnAt < a.drawnAt ? b : a)));
    }
    this.held.push(image);
    if (image.mesh !== null) {
      this.takeDepths(image);  // it came first
    } else if (image.depth === null) {
      this.finish(image);
    }
    this.problem = '';
    this.showState();
    this.redraw();
  }

  drop(image) {
    this.held.splice(this.held.indexOf(image), 1);
    this.picture.remove(image);
    image.bitmap.close();
  }

  takeDepths(image) {
    if (!this.held.includes(image)) {
      return;  // its colours are to come, or it was dropped
    }
    image.cover = image.cover.withDepths(image.depths);
    this.picture.addDepths(image);
    this.finish(image);
    this.redraw();
  }

  finish(image) {
    this.planner.answered(image.sequence, seconds());
    this.setStage(this.planner.isWaiting ? 'Waiting' : '');
  }

  fail(text) {
    this.problem = text;
    this.setStage('');
    this.showState();
  }

  /// Images that this page cannot show would come again and again: none is asked for until the next hello.
  stopAsking(text, sequence) {
    this.isAsking = false;
    this.planner.failed(sequence, seconds());
    this.fail(text);
  }

  /// What the server sent was no message, so that what was under way may lack a part of it.
  failMessage(text) {
    this.receiver.forget();
    this.planner.failed(undefined, seconds());
    this.fail(text);
  }

  // What goes to the server, and onto the screen.

  ask() {
    if (!this.isConnected || !this.isAsking || this.home === null || document.hidden) {
      return;
    }
    const look = this.planner.look({view: this.view, screen: this.screen, lenses: structuredClone(this.lenses.lenses),
      images: this.held, settings: this.settings, seconds: seconds()});
    if (look !== null) {
      this.connection.send({type: 'look', ...look});
      if (this.stage === '') {
        this.setStage('Asking');
      }
    }
  }

  setStage(stage) {
    this.stage = stage;
    this.showLoading();
  }

  showLoading() {
    // The next look may already wait while an image comes.
    const progress = this.receiver.progress();
    this.panel.loading(progress.size > 0 ? 'Receiving' : this.stage, progress);
  }

  redraw() {
    if (this.frame === undefined && this.view !== null) {
      this.frame = requestAnimationFrame(() => {
        this.frame = undefined;
        this.draw();
        this.ask();
      });
    }
  }

  draw() {
    this.lensMap ??= new GpcMap(this.lensLayout, ...this.screen);
    const best = chosenImage(this.held, this.view, this.screen, this.lenses.lenses);
    const isWhole = best !== null && best.load.reach <= 1 && best.load.shift === 0;
    const behind = best === null || isWhole ? [] : this.held.filter((image) => image !== best.image).reverse().slice(0, 1);
    if (best !== null) {
      best.image.drawnAt = seconds();
    }
    this.isQuick = this.isMoving && this.clock.isSlow(seconds());
    this.way = this.picture.draw(this.view, this.lensMap, best === null ? [] : [best.image, ...behind],
      {isQuick: this.isQuick, isCovered: isWhole});
    this.drawn = best;
    this.clock.tick(seconds(), this.isQuick);
    this.panel.approximate(best === null ? '' : approximateReason(this.way, best.load));
  }

  showFigures() {
    if (!this.panel.hasFigures) {
      return;
    }
    const image = this.drawn?.image;
    const inSeconds = (time) => `${time.toFixed(time < 10 ? 1 : 0)} s`;
    this.panel.show([
      ['pictures', this.clock.rate > 0 ? `${this.clock.rate.toFixed(0)} a second` : '-'],
      ['screen', this.screen.join(' \u00d7 ')],
      ['image', image ? `${image.width} \u00d7 ${image.height}` : '-'],
      ['its bytes', image ? bytesText(image.color.size + (image.depth?.size ?? 0)) : '-'],
      ['its age', image ? inSeconds(seconds() - image.arrived) : '-'],
      ['received', bytesText(this.bytes)],
      ['delay of an image', inSeconds(this.planner.trip)],
    ]);
  }
}

try {
  // For tests, and for those who look into the page with their browser's tools.
  window.ocelliRemote = new RemotePage();
} catch (error) {
  new StatusPanel().state(error.message);
  throw error;
}
