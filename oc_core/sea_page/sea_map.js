// The map: all places from above, where one is and looks, and whose images are blended. Shapes say it, colours only help.
'use strict';

(() => {
  const kMargin = 10; // pixels
  const kMost = [260, 200];

  class SeaMap {
    constructor(canvas, plan) {
      Object.assign(this, {canvas, plan});
      const size = [plan.upper[0] - plan.lower[0], plan.upper[1] - plan.lower[1]];
      const room = kMost.map((most) => most - 2 * kMargin);
      this.scale = Math.min(...size.map((extent, k) => (extent > 0 ? room[k] / extent : Infinity)));
      this.scale = Number.isFinite(this.scale) ? this.scale : 1;
      this.size = size.map((extent) => Math.max(60, Math.round(extent * this.scale) + 2 * kMargin));
      const ratio = window.devicePixelRatio || 1;
      canvas.width = this.size[0] * ratio;
      canvas.height = this.size[1] * ratio;
      canvas.style.width = `${this.size[0]}px`;
      canvas.style.height = `${this.size[1]}px`;
      this.ratio = ratio;
      this.ground = this.drawnPlaces();
    }

    color(name) {
      return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
    }

    pixelOf([x, z]) {
      const slack = [0, 1].map((k) => (this.size[k] - (this.plan.upper[k] - this.plan.lower[k]) * this.scale) / 2);
      return [slack[0] + (x - this.plan.lower[0]) * this.scale, slack[1] + (z - this.plan.lower[1]) * this.scale];
    }

    pointOf([px, py]) {
      const [ox, oy] = this.pixelOf([0, 0]);
      return [(px - ox) / this.scale, (py - oy) / this.scale];
    }

    drawnPlaces() {
      const layer = document.createElement('canvas');
      layer.width = this.canvas.width;
      layer.height = this.canvas.height;
      const context = layer.getContext('2d');
      context.scale(this.ratio, this.ratio);
      context.fillStyle = this.color('soft');
      // Smaller where they are many, so that they stay apart.
      const side = this.plan.points.length > 1500 ? 1 : this.plan.points.length > 200 ? 2 : 4;
      for (const point of this.plan.points) {
        const [x, y] = this.pixelOf(point);
        context.fillRect(x - side / 2, y - side / 2, side, side);
      }
      return layer;
    }

    /// `half`: of what is seen from left to right, radians.
    draw({eye, yaw}, half, blend) {
      const context = this.canvas.getContext('2d');
      context.setTransform(1, 0, 0, 1, 0, 0);
      context.clearRect(0, 0, this.canvas.width, this.canvas.height);
      context.drawImage(this.ground, 0, 0);
      context.scale(this.ratio, this.ratio);
      context.lineWidth = 2;
      context.strokeStyle = this.color('ochre');
      for (const {index} of blend) {
        const [x, y] = this.pixelOf(this.plan.points[index]);
        context.strokeRect(x - 4, y - 4, 8, 8);
      }
      const [x, y] = this.pixelOf([eye[0], eye[2]]);
      context.strokeStyle = context.fillStyle = this.color('accent');
      const middle = (yaw - 90) * Math.PI / 180;
      context.globalAlpha = 0.45;
      context.beginPath();
      context.moveTo(x, y);
      context.arc(x, y, 22, middle - half, middle + half);
      context.fill();
      context.globalAlpha = 1;
      context.beginPath();
      context.arc(x, y, 6, 0, 2 * Math.PI);
      context.stroke();
    }
  }

  Object.assign(window.ocelliSea, {SeaMap});
})();
