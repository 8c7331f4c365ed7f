// How many pictures a second there are while the picture moves.

const kWindow = 1;  // seconds
const kPause = 0.3;  // no picture for so long: it does not move

export class FrameClock {
  constructor() {
    this.times = [];
  }

  /// A picture is drawn.
  tick(seconds) {
    if (this.times.length > 0 && seconds - this.times[this.times.length - 1] > kPause) {
      this.times = [];
    }
    this.times.push(seconds);
    while (seconds - this.times[0] > kWindow) {
      this.times.shift();
    }
  }

  /// Of the last motion; 0 where there was none.
  get rate() {
    const {times} = this;
    return times.length > 1 ? (times.length - 1) / (times[times.length - 1] - times[0]) : 0;
  }
}
