// Put into the page by page_test.py: what the tests ask of it. Each answer is data.
const kEqual = 999; // dB, as JSON has no infinity
window.probe = {
  page: () => window.ocelliRemote,

  /// Pixels of the picture that `draw` draws; RGBA from the top left.
  pixels(draw) {
    const {canvas, picture: {gl}} = this.page();
    draw();
    const flipped = new Uint8Array(4 * canvas.width * canvas.height);
    gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, flipped);
    const pixels = new Uint8Array(flipped.length);
    const row = 4 * canvas.width;
    for (let y = 0; y < canvas.height; ++y) {
      pixels.set(flipped.subarray(row * (canvas.height - 1 - y), row * (canvas.height - y)), row * y);
    }
    return {data: pixels, width: canvas.width, height: canvas.height};
  },

  /// The picture of now, fine or quick, under a name; and the image that it is drawn from, for image(): that which the
  /// page draws from, or another that it had.
  keep(name, isQuick, image = undefined) {
    const page = this.page();
    page.draw();
    this.kept = image ?? page.drawn.image;
    this[name] = this.pixels(() => page.picture.draw(page.view, page.lensMap, [this.kept], {isQuick}));
  },

  /// From now on the page doesn't let go of the image that it draws from now: `held`.
  hold() {
    const {picture, drawn} = this.page();
    this.held = drawn.image;
    const remove = picture.remove.bind(picture);
    picture.remove = (image) => image === this.held || remove(image);
  },

  async decoded(base64) {
    const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([bytes], {type: 'image/png'}), {colorSpaceConversion: 'none'});
    const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
    context.drawImage(bitmap, 0, 0);
    return context.getImageData(0, 0, bitmap.width, bitmap.height);
  },

  /// Between two images over a rectangle of the first: {psnr, share}, the share of pixels that differ by more than `most`
  /// grey levels.
  compared(a, b, {left = 0, top = 0, most = 8} = {}) {
    let squares = 0;
    let differing = 0;
    for (let y = 0; y < b.height; ++y) {
      for (let x = 0; x < b.width; ++x) {
        const p = 4 * ((y + top) * a.width + x + left);
        const q = 4 * (y * b.width + x);
        let worst = 0;
        for (let c = 0; c < 3; ++c) {
          const d = a.data[p + c] - b.data[q + c];
          squares += d * d;
          worst = Math.max(worst, Math.abs(d));
        }
        differing += worst > most ? 1 : 0;
      }
    }
    const count = b.width * b.height;
    return {psnr: squares > 0 ? 10 * Math.log10(255 * 255 * 3 * count / squares) : kEqual, share: differing / count};
  },

  async comparedWith(name, base64, options) {
    return this.compared(this[name], await this.decoded(base64), options);
  },

  /// Of what the picture kept last was drawn from: its header and the bytes of its planes, base64.
  image() {
    const image = this.kept;
    const text = (bytes) => {
      let binary = '';
      for (let i = 0; i < bytes.length; i += 0x8000) {
        binary += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
      }
      return btoa(binary);
    };
    return {header: JSON.stringify(image.header), color: text(image.color.bytes), depth: text(image.depth.bytes)};
  },

  /// From now on: the shares that the bar shows, and how many pictures were drawn from colours alone.
  watchLoading() {
    const page = this.page();
    const bar = document.getElementById('loading');
    this.loading = {shares: [], flatPictures: 0};
    new MutationObserver(() => this.loading.shares.push(Number(bar.getAttribute('aria-valuenow'))))
      .observe(bar, {attributes: true, attributeFilter: ['aria-valuenow']});
    const draw = page.draw.bind(page);
    page.draw = () => {
      draw();
      this.loading.flatPictures += page.drawn?.image.mesh === null && page.way === 'rays' ? 1 : 0;
    };
  },

  /// At rest: the picture is exact, and nothing is on its way.
  isSettled() {
    const page = this.page();
    return page?.drawn != null && page.drawn.image.mesh !== null && page.way === 'rays' && !page.planner.isWaiting &&
      document.getElementById('approximate').hidden && page.drawn.image.screen.join() === page.screen.join();
  },

  /// The greatest distance between the shader's map of an image and gpc_map.js, pixels, over a grid of the screen.
  async shaderError(layout, width, height) {
    const {GlProgram} = await import('/gl_program.js');
    const {GpcMap} = await import('/gpc_map.js');
    const {gpcGlsl, gpcUniforms, setGpcUniforms} = await import('/gpc_shader.js');
    const {gl} = this.page().picture;
    if (gl.getExtension('EXT_color_buffer_float') === null) {
      return null;
    }
    const size = 512;
    const program = new GlProgram(gl, `uniform float uDepth;
      void main() {
        gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
      }`, `out vec4 both;
      uniform vec2 uSize;
      ${gpcGlsl('image')}
      void main() {
        vec2 p = gl_FragCoord.xy / ${size}.0 * uSize;
        both = vec4(imageImageFromPinhole(p), imagePinholeFromImage(p));
      }`);
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, size, size);
    const target = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, target);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    gl.viewport(0, 0, size, size);
    program.use();
    const map = new GpcMap(layout, width, height);
    setGpcUniforms(gl, program, 'image', gpcUniforms(map));
    gl.uniform2f(program.at('uSize'), width, height);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    const values = new Float32Array(4 * size * size);
    gl.readPixels(0, 0, size, size, gl.RGBA, gl.FLOAT, values);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    const worst = {image: 0, pinhole: 0};
    for (let y = 0, i = 0; y < size; ++y) {
      for (let x = 0; x < size; ++x, i += 4) {
        const p = [(x + 0.5) / size * width, (y + 0.5) / size * height];
        const [image, pinhole] = [map.imageFromPinhole(p), map.pinholeFromImage(p)];
        worst.image = Math.max(worst.image, Math.hypot(values[i] - image[0], values[i + 1] - image[1]));
        worst.pinhole = Math.max(worst.pinhole, Math.hypot(values[i + 2] - pinhole[0], values[i + 3] - pinhole[1]));
      }
    }
    this.page().redraw();
    return worst;
  },

  /// Milliseconds of the fastest of some pictures, each waited for: {rays, grid, depth, quickDepth}.
  async times(repeats) {
    const page = this.page();
    const {gl} = page.picture;
    const pixel = new Uint8Array(4);
    const aside = {...page.view, eye: page.view.eye.map((x, i) => x + (i === 0 ? 0.05 * page.speed : 0))};
    const ways = {rays: [page.view, false], grid: [page.view, true], depth: [aside, false], quickDepth: [aside, true]};
    const best = {};
    for (let i = 0; i < repeats; ++i) {
      for (const [name, [view, isQuick]] of Object.entries(ways)) {
        const start = performance.now();
        page.picture.draw(view, page.lensMap, [page.drawn.image], {isQuick, isCovered: view === page.view});
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
        best[name] = Math.min(best[name] ?? Infinity, performance.now() - start);
        await new Promise((resolve) => setTimeout(resolve, 0));
      }
    }
    page.redraw();
    return best;
  },
};
true;
