// Draws what one sees from a point in a direction: up to three images in all directions, each looked up where the ray
// meets the proxy, or far away where there is none.
'use strict';

(() => {
  const kVertex = `#version 300 es
    out vec2 vScreen;
    void main() {
      vScreen = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
      gl_Position = vec4(vScreen, 0.0, 1.0);
    }`;
  const kFragment = `#version 300 es
    precision highp float;
    in vec2 vScreen;
    out vec4 color;
    uniform vec2 uTangent;
    uniform mat3 uWorldFromEye;  // columns: right, up, forward
    uniform vec3 uEye;
    uniform int uCount;
    uniform sampler2D uImage0, uImage1, uImage2;
    uniform vec3 uImageEye[3];
    uniform mat3 uWorldFromImage[3];
    uniform float uWeight[3];
    uniform bool uHasProxy;
    uniform mat3 uWorldFromProxy;
    uniform vec3 uLower, uUpper;
    const float kPi = 3.14159265358979;

    vec2 placeIn(vec3 direction, mat3 worldFromImage) {
      vec3 d = normalize(direction * worldFromImage);  // by the transpose
      return vec2(atan(d.x, d.z) / (2.0 * kPi) + 0.5, 0.5 - asin(clamp(d.y, -1.0, 1.0)) / kPi);
    }

    void main() {
      vec3 ray = normalize(uWorldFromEye * vec3(vScreen * uTangent, 1.0));
      vec3 hit = uEye + ray;
      if (uHasProxy) {
        vec3 from = clamp(uEye * uWorldFromProxy, uLower, uUpper);
        vec3 along = ray * uWorldFromProxy;
        vec3 t = mix((uLower - from) / along, (uUpper - from) / along, greaterThan(along, vec3(0.0)));
        t = mix(t, vec3(1e9), equal(along, vec3(0.0)));
        hit = uEye + ray * max(min(t.x, min(t.y, t.z)), 1e-4);
      }
      vec3 sum = vec3(0.0);
      for (int k = 0; k < uCount; ++k) {
        vec3 direction = uHasProxy ? hit - uImageEye[k] : ray;
        vec2 at = placeIn(direction, uWorldFromImage[k]);
        vec3 seen = k == 0 ? textureLod(uImage0, at, 0.0).rgb : k == 1 ? textureLod(uImage1, at, 0.0).rgb
                                                                       : textureLod(uImage2, at, 0.0).rgb;
        sum += uWeight[k] * seen;
      }
      color = vec4(sum, 1.0);
    }`;

  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

  /// Columns right, up and forward of a view: degrees to the right of -z, and up.
  function axesOf(yaw, pitch) {
    const [y, p] = [yaw * Math.PI / 180, pitch * Math.PI / 180];
    const forward = [Math.sin(y) * Math.cos(p), Math.sin(p), -Math.cos(y) * Math.cos(p)];
    const right = [Math.cos(y), 0, Math.sin(y)];
    return [...right, ...cross(right, forward), ...forward];
  }

  class SeaPicture {
    constructor(gl, data) {
      Object.assign(this, {gl, data});
      this.prepare();
    }

    prepare() {
      const {gl} = this;
      this.program = gl.createProgram();
      for (const [type, source] of [[gl.VERTEX_SHADER, kVertex], [gl.FRAGMENT_SHADER, kFragment]]) {
        const shader = gl.createShader(type);
        gl.shaderSource(shader, source);
        gl.compileShader(shader);
        if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost()) {
          throw new Error(`a shader does not compile: ${gl.getShaderInfoLog(shader)}`);
        }
        gl.attachShader(this.program, shader);
      }
      gl.linkProgram(this.program);
      this.at = new Map();
    }

    place(name) {
      if (!this.at.has(name)) {
        this.at.set(name, this.gl.getUniformLocation(this.program, name));
      }
      return this.at.get(name);
    }

    /// `parts` are [{index, weight, texture}], three at most, whose weights add up to 1; none draws the ground alone.
    draw({eye, yaw, pitch, fov}, parts) {
      const {gl, data} = this;
      const {width, height} = gl.canvas;
      gl.viewport(0, 0, width, height);
      gl.clearColor(0.08, 0.09, 0.1, 1);
      gl.clear(gl.COLOR_BUFFER_BIT);
      if (parts.length === 0) {
        return;
      }
      gl.useProgram(this.program);
      const tangent = Math.tan(fov * Math.PI / 360);
      gl.uniform2f(this.place('uTangent'), tangent * width / height, tangent);
      gl.uniformMatrix3fv(this.place('uWorldFromEye'), false, axesOf(yaw, pitch));
      gl.uniform3fv(this.place('uEye'), eye);
      gl.uniform1i(this.place('uCount'), parts.length);
      gl.uniform1i(this.place('uHasProxy'), data.proxy === null ? 0 : 1);
      if (data.proxy !== null) {
        gl.uniformMatrix3fv(this.place('uWorldFromProxy'), false, data.proxy.axes.flat());
        gl.uniform3fv(this.place('uLower'), data.proxy.lower);
        gl.uniform3fv(this.place('uUpper'), data.proxy.upper);
      }
      parts.forEach(({index, weight, texture}, k) => {
        const {eye: imageEye, forward, up} = data.places[index];
        gl.uniform3fv(this.place(`uImageEye[${k}]`), imageEye);
        gl.uniformMatrix3fv(this.place(`uWorldFromImage[${k}]`), false, [...cross(forward, up), ...up, ...forward]);
        gl.uniform1f(this.place(`uWeight[${k}]`), weight);
        gl.uniform1i(this.place(`uImage${k}`), k);
        gl.activeTexture(gl.TEXTURE0 + k);
        gl.bindTexture(gl.TEXTURE_2D, texture);
      });
      gl.activeTexture(gl.TEXTURE0);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
    }
  }

  Object.assign(window.ocelliSea, {SeaPicture, axesOf});
})();
