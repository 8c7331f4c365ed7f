// Which image a picture is drawn from, and when to ask for another: the rule of oc_core/remote/client/remote_client.h,
// which has it in words. It is told the time, so that tests can tell it theirs.
import {coverLimits, coverLoad, plannedCover} from './image_cover.js';
import {isResting, motionBetween, viewAhead} from './view_motion.js';

export const lookRule = {
  askAt: 0.95,  // of the load that ends what is covered
  firstTripSeconds: 0.5,
  aheadSeconds: 0.25,
  maxAheadSeconds: 4,
  restSeconds: 0.3,
  motionSeconds: 0.1,
  pauseSeconds: 0.25,
  maxAsked: 8,  // requests that are remembered while they wait for an answer
  maxPauseSeconds: 30,  // after requests that failed: twice as long after each
};

const sameText = (a, b) => JSON.stringify(a) === JSON.stringify(b);

/// Of the held images one that covers the view from its own eye, as there pictures are exact; else, or of several, the one
/// with the least load; of equals the newest, which comes last.
export function chosenImage(images, view, screen, lenses) {
  let best = null;
  for (const image of images) {
    const load = coverLoad(image.cover, view, screen, lenses);
    const isExact = load.shift === 0 && load.whole <= 1;
    if (best === null || (isExact === best.isExact ? load.whole <= best.load.whole : isExact)) {
      best = {image, load, isExact};
    }
  }
  return best;
}

export class LookPlanner {
  constructor() {
    this.sequence = 0;
    this.trip = lookRule.firstTripSeconds;
    this.forget();
  }

  /// Nothing is under way any more: the server is another, or was away.
  forget() {
    this.asked = [];
    this.past = [];
    this.lastWish = null;
    this.lastAsked = -Infinity;
    this.restingSince = -Infinity;
    this.failures = 0;  // one after the other
    this.pausedUntil = -Infinity;
  }

  /// The look to send now, {sequence, view, screen, lenses}, or null. `settings` are those of the server.
  look({view, screen, lenses, images, settings, seconds}) {
    const state = {view, screen, lenses};
    const {past} = this;
    while (past.length > 1 && past[1].seconds <= seconds - lookRule.motionSeconds) {
      past.shift();
    }
    if (past.length === 0 || !sameText(past[past.length - 1].state, state)) {
      this.restingSince = seconds;
    }
    const wish = this.wish(state, images, settings, seconds);
    past.push({seconds, state});
    if (wish === null || seconds < this.pausedUntil || seconds - this.lastAsked < lookRule.pauseSeconds) {
      return null;
    }
    this.lastAsked = seconds;
    this.lastWish = wish;
    const look = {sequence: ++this.sequence, ...wish};
    this.asked.push({look, seconds, cover: plannedCover(wish.view, screen, settings)});
    if (this.asked.length > lookRule.maxAsked) {
      this.asked.shift();
    }
    return look;
  }

  wish(state, images, settings, seconds) {
    const {view, screen, lenses} = state;
    const best = chosenImage(images, view, screen, lenses);
    if (best === null) {
      return this.asked.length === 0 ? state : null;
    }
    const first = this.past[0];
    const motion = first ? motionBetween(first.state.view, view, seconds - first.seconds) : null;
    if (motion === null || isResting(motion)) {
      // `detail` is 1 where there are leastDetail samples a pixel, and leastDetail where there is one a pixel.
      const isExact = best.load.shift === 0 && best.load.reach <= 1 &&
        best.load.detail <= coverLimits.leastDetail * 1.001 && sameText(best.image.screen, screen);
      const isRested = seconds - this.restingSince >= lookRule.restSeconds;
      return !isExact && isRested && !sameText(this.lastWish, state) ? state : null;
    }
    const time = Math.min(this.trip + lookRule.aheadSeconds, lookRule.maxAheadSeconds);
    const ahead = viewAhead(view, motion, time);
    const load = Math.min(...images.map((image) => coverLoad(image.cover, ahead, screen, lenses).whole));
    return load <= lookRule.askAt || this.isAskedFor(ahead, screen, best.image.cover.depths) ? null :
      {view: ahead, screen, lenses};
  }

  isAskedFor(view, screen, depths) {
    return this.asked.some(({cover}) => coverLoad(cover.withDepths(depths), view, screen).whole <= 1);
  }

  /// The whole answer to a request is here.
  answered(sequence, seconds) {
    const own = this.asked.find(({look}) => look.sequence === sequence);
    if (own) {
      this.trip = seconds - own.seconds;
    }
    this.failures = 0;
    this.pausedUntil = -Infinity;
    this.asked = this.asked.filter(({look}) => look.sequence > sequence);
  }

  /// A request failed, or, without `sequence`, one that is not known: none is awaited then. It may be made again, after a
  /// pause that grows.
  failed(sequence, seconds) {
    const pause = Math.min(lookRule.pauseSeconds * 2 ** ++this.failures, lookRule.maxPauseSeconds);
    this.pausedUntil = seconds + pause;
    this.lastWish = null;
    this.asked = this.asked.filter(({look}) => look.sequence > (sequence ?? Infinity));
  }

  /// Whether an answer is awaited.
  get isWaiting() {
    return this.asked.length > 0;
  }
}
