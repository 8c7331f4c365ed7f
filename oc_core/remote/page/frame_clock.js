// How many pictures a second there are while the picture moves, and whether these are too few for fine ones.

const kWindow = 1;  // seconds
const kPause = 0.3;  // no picture for so long: it does not move
const kSlowPictures = 4;  // so many fine ones in a row that took longer than
const kSlow = 1 / 36;  // seconds each
const kSlowFor = 60;  // seconds until fine pictures are tried again

export class FrameClock {
  constructor() {
    this.times = [];
    this.fineTimes = [];
    this.slowUntil = -Infinity;
  }

  /// A picture is drawn.
  tick(seconds, isQuick = false) {
    const last = this.times[this.times.length - 1];
    if (last !== undefined && seconds - last > kPause) {
      this.times = [];
      this.fineTimes = [];
    }
    this.times.push(seconds);
    while (seconds - this.times[0] > kWindow) {
      this.times.shift();
    }
    this.fineTimes = isQuick ? [] : [...this.fineTimes, seconds].slice(-kSlowPictures - 1);
    if (this.fineTimes.length > kSlowPictures && seconds - this.fineTimes[0] > kSlowPictures * kSlow) {
      this.slowUntil = seconds + kSlowFor;
    }
  }

  isSlow(seconds) {
    return seconds < this.slowUntil;
  }

  /// Pictures a second in the last motion; 0 where there was none.
  get rate() {
    const {times} = this;
    return times.length > 1 ? (times.length - 1) / (times[times.length - 1] - times[0]) : 0;
  }
}
