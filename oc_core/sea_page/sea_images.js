// The images of a sea as textures: each is a script that hands over a data address, asked for when it is needed first.
'use strict';

(() => {
  const kHeld = 24;     // textures at once: of 1024 x 1024 pixels 100 MB
  const kUnderWay = 6;  // scripts at once

  class SeaImages {
    /// `changed()` is called where an image has come, or could not; `trouble(text)` says why not.
    constructor(gl, changed, trouble) {
      Object.assign(this, {gl, changed, trouble});
      this.held = new Map();  // index -> {texture, usedAt}
      this.wanted = [];
      this.underWay = new Map();
      this.missing = new Set();
      this.clock = 0;
      window.ocelliSea.take = (index, address) => this.take(index, address);
    }

    /// The texture of an image, or null; `indices` are what is needed now, in the order of their weight, then what may be
    /// needed next.
    want(indices) {
      this.wanted = indices.filter((index) => !this.held.has(index) && !this.underWay.has(index) && !this.missing.has(index));
      this.begin();
    }

    at(index) {
      const image = this.held.get(index);
      if (image === undefined) {
        return null;
      }
      image.usedAt = ++this.clock;
      return image.texture;
    }

    begin() {
      while (this.wanted.length > 0 && this.underWay.size < kUnderWay) {
        const index = this.wanted.shift();
        const script = document.createElement('script');
        const file = `images/${String(index).padStart(5, '0')}.js`;
        script.src = file;
        script.onerror = () => this.fail(index, `The image of place ${index} is missing: ${file}`);
        // A script that ran and handed nothing over.
        script.onload = () => {
          if (this.underWay.get(index) === script) {
            this.fail(index, `${file} holds no image`);
          }
        };
        this.underWay.set(index, script);
        document.head.append(script);
      }
    }

    take(index, address) {
      const script = this.underWay.get(index);
      if (script === undefined) {
        return;
      }
      this.underWay.set(index, null); // it has come, and is being decoded
      script.remove();
      const image = new Image();
      image.onload = () => this.hold(index, image);
      image.onerror = () => this.fail(index, `The image of place ${index} is damaged`);
      image.src = address;
    }

    hold(index, image) {
      const {gl} = this;
      this.underWay.delete(index);
      while (this.held.size >= kHeld) {
        const [oldest] = [...this.held].reduce((a, b) => (b[1].usedAt < a[1].usedAt ? b : a));
        gl.deleteTexture(this.held.get(oldest).texture);
        this.held.delete(oldest);
      }
      const texture = gl.createTexture();
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGB8, gl.RGB, gl.UNSIGNED_BYTE, image);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.REPEAT);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
      this.held.set(index, {texture, usedAt: ++this.clock});
      this.begin();
      this.changed();
    }

    fail(index, text) {
      this.underWay.get(index)?.remove();
      this.underWay.delete(index);
      this.missing.add(index);
      this.trouble(text);
      this.begin();
      this.changed();
    }

    /// After the context was lost: all textures are gone.
    forget() {
      this.held.clear();
    }
  }

  Object.assign(window.ocelliSea, {SeaImages});
})();
