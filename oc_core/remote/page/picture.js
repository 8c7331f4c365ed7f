// Draws pictures of a view from the images that are held, with WebGL2: by rays from an image's own eye, by its depths from
// elsewhere (oc_core/ocri/resample.h). Where the image that is drawn from ends, the others show behind it.
import {GlProgram} from './gl_program.js';
import {GpcMap} from './gpc_map.js';
import {gpcUniforms, setGpcUniforms} from './gpc_shader.js';
import {pictureShaders} from './picture_shaders.js';
import {Pinhole, cameraFromPixel, length, subtract} from './view_math.js';

/// Depths in clip coordinates: surfaces of what is drawn from, its gaps, what it sees at infinity, and other images.
const kInfinity = 0.7;
const kSurfaces = [-1, 0.5, kInfinity];
const kGaps = [0.5, 0.6, 0.6];
const kRaysDepth = 0;
const kOthersDepth = 0.8;
const kNothingDepth = 0.99;
/// Side of the squares of the quick way, pixels of the screen.
const kGridSide = 16;
/// An eye that is this near to an image's, by its distance to near things, is the image's.
const kSameEye = 1e-6;

export class Picture {
  constructor(canvas) {
    this.canvas = canvas;
    this.gl = canvas.getContext('webgl2',
      {alpha: false, antialias: false, powerPreference: 'high-performance', preserveDrawingBuffer: false});
    if (this.gl === null) {
      throw new Error('This browser has no WebGL2, which draws the pictures. Turn on hardware acceleration, or try another browser.');
    }
    this.restore();
  }

  /// After the context was lost, too; images must be added again.
  restore() {
    const {gl} = this;
    this.maxSide = gl.getParameter(gl.MAX_TEXTURE_SIZE);  // of images, pixels
    this.programs = Object.fromEntries(Object.entries(pictureShaders).map(
      ([name, [vertex, fragment]]) => [name, new GlProgram(gl, vertex, fragment)]));
    this.empty = gl.createVertexArray();
    this.grid = {array: gl.createVertexArray(), buffer: gl.createBuffer(), key: ''};
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LESS);
  }

  /// Takes over image.bitmap; adds image.gpu.
  addColors(image) {
    const {gl} = this;
    const map = new GpcMap(image.layout, image.width, image.height);
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.SRGB8_ALPHA8, gl.RGBA, gl.UNSIGNED_BYTE, image.bitmap);
    gl.generateMipmap(gl.TEXTURE_2D);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
    image.gpu = {texture, zones: gpcUniforms(map), surface: null, gap: null};
  }

  /// Takes over image.mesh.
  addDepths(image) {
    const {gl} = this;
    const {vertices, triangles, gaps} = image.mesh;
    const buffer = (target, data) => {
      const made = gl.createBuffer();
      gl.bindBuffer(target, made);
      gl.bufferData(target, data, gl.STATIC_DRAW);
      return made;
    };
    const surface = gl.createVertexArray();
    gl.bindVertexArray(surface);
    const buffers = [buffer(gl.ARRAY_BUFFER, vertices)];
    const describeVertices = () => {
      const stride = 5 * Float32Array.BYTES_PER_ELEMENT;
      gl.enableVertexAttribArray(0);
      gl.vertexAttribPointer(0, 3, gl.FLOAT, false, stride, 0);
      gl.enableVertexAttribArray(1);
      gl.vertexAttribPointer(1, 2, gl.FLOAT, false, stride, 3 * Float32Array.BYTES_PER_ELEMENT);
    };
    describeVertices();
    buffers.push(buffer(gl.ELEMENT_ARRAY_BUFFER, triangles));
    const gap = gl.createVertexArray();
    gl.bindVertexArray(gap);
    buffers.push(buffer(gl.ARRAY_BUFFER, gaps));
    describeVertices();
    gl.bindVertexArray(null);
    Object.assign(image.gpu, {surface, gap, buffers, surfaceSize: triangles.length, gapSize: gaps.length / 5});
  }

  remove(image) {
    const {gl} = this;
    const {texture, surface, gap, buffers} = image.gpu;
    gl.deleteTexture(texture);
    gl.deleteVertexArray(surface);
    gl.deleteVertexArray(gap);
    (buffers ?? []).forEach((each) => gl.deleteBuffer(each));
    image.gpu = null;
  }

  /// `images`: the one to draw from first, then those behind it. `isQuick`: samples on a pixel are averaged roughly, and
  /// rays looked up at each kGridSide pixels, interpolated between. `isCovered`: the first one shows on all of the screen,
  /// so that nothing is left to be striped. Returns what it drew by: 'rays', 'depth',
  /// 'directions' (as if all were far away: there is no depth yet), or 'nothing'.
  draw(view, lensMap, images, {isQuick = false, isCovered = false} = {}) {
    const {gl, canvas} = this;
    this.isQuick = isQuick;
    const screen = {pinhole: new Pinhole(view, canvas.width, canvas.height), zones: gpcUniforms(lensMap)};
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    let way = 'nothing';
    images.forEach((image, order) => {
      const drawn = this.drawImage(screen, image, order);
      way = order === 0 ? drawn : way;
    });
    if (!isCovered) {
      const {nothing} = this.programs;
      nothing.use();
      this.drawWholeScreen(nothing, kNothingDepth);
    }
    return way;
  }

  drawImage(screen, image, order) {
    const reference = image.cover.reference;
    const offset = length(subtract(screen.pinhole.eye, reference.eye));
    const near = image.nearZ > 0 ? image.nearZ : 1;
    const isSame = offset <= kSameEye * near;
    if (order === 0 && !isSame && image.gpu.surface !== null) {
      this.drawDepths(screen, image, reference);
      return 'depth';
    }
    this.drawRays(screen, image, reference, order === 0 ? kRaysDepth : kOthersDepth + 0.01 * order);
    return isSame ? 'rays' : 'directions';
  }

  useImage(program, screen, image) {
    const {gl, canvas} = this;
    program.use();
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, image.gpu.texture);
    gl.uniform1i(program.at('uColor'), 0);
    gl.uniform2f(program.at('uImageSize'), image.width, image.height);
    gl.uniform1f(program.at('uScreenHeight'), canvas.height);
    gl.uniform2f(program.at('uScreenSize'), canvas.width, canvas.height);
    setGpcUniforms(gl, program, 'screen', screen.zones);
    setGpcUniforms(gl, program, 'image', image.gpu.zones);
  }

  drawRays(screen, image, reference, depth) {
    const {gl} = this;
    const program = this.isQuick ? this.programs.grid : this.programs.rays;
    this.useImage(program, screen, image);
    gl.uniformMatrix3fv(program.at('uCameraFromPixel'), false, cameraFromPixel(screen.pinhole, reference));
    gl.uniform3f(program.at('uCenterFocal'), ...reference.center, reference.focal);
    if (this.isQuick) {
      this.drawGrid(program, depth);
    } else {
      this.drawWholeScreen(program, depth);
    }
  }

  drawWholeScreen(program, depth) {
    const {gl} = this;
    gl.uniform1f(program.at('uDepth'), depth);
    gl.bindVertexArray(this.empty);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  drawGrid(program, depth) {
    const {gl, canvas, grid} = this;
    const [columns, rows] = [Math.ceil(canvas.width / kGridSide), Math.ceil(canvas.height / kGridSide)];
    gl.bindVertexArray(grid.array);
    if (grid.key !== `${columns}x${rows}`) {
      const indices = new Uint32Array(6 * columns * rows);
      for (let i = 0; i < columns * rows; ++i) {
        const first = i + Math.floor(i / columns);
        const below = first + columns + 1;
        indices.set([first, below, first + 1, first + 1, below, below + 1], 6 * i);
      }
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, grid.buffer);
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.STATIC_DRAW);
      Object.assign(grid, {key: `${columns}x${rows}`, size: indices.length});
    }
    gl.uniform1f(program.at('uDepth'), depth);
    gl.uniform2f(program.at('uGrid'), columns, kGridSide);
    gl.drawElements(gl.TRIANGLES, grid.size, gl.UNSIGNED_INT, 0);
  }

  drawDepths(screen, image, reference) {
    const {gl} = this;
    const {gap} = this.programs;
    const surface = this.isQuick ? this.programs.quickSurface : this.programs.surface;
    const {pinhole} = screen;
    const place = cameraFromPixel(reference, pinhole);
    const move = pinhole.axes(subtract(reference.eye, pinhole.eye));
    const nearest = 1e-3 * (image.nearZ > 0 ? image.nearZ : 1);
    const parts = [
      {program: surface, array: image.gpu.surface, range: kSurfaces},
      {program: gap, array: image.gpu.gap, range: kGaps},
    ];
    for (const {program, array, range} of parts) {
      this.useImage(program, screen, image);
      gl.uniformMatrix3fv(program.at('uCameraFromPlace'), false, place);
      gl.uniform3f(program.at('uMove'), ...move);
      gl.uniform4f(program.at('uScreenCenterFocal'), ...pinhole.center, pinhole.focal, nearest);
      gl.uniform3f(program.at('uDepthRange'), ...range);
      gl.bindVertexArray(array);
      if (program === surface) {
        gl.drawElements(gl.TRIANGLES, image.gpu.surfaceSize, gl.UNSIGNED_INT, 0);
      } else {
        gl.drawArrays(gl.TRIANGLES, 0, image.gpu.gapSize);
      }
    }
    gl.bindVertexArray(null);
  }
}
