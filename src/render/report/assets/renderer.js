// Draws the bodies by WebGL 2: skins in the colours of a field, cut faces, edges.

const VERTEX = `#version 300 es
in vec3 place;
in vec3 moved;
in vec3 fields;
uniform mat4 matrix;
uniform vec3 mirror;
uniform float exaggeration;
uniform vec3 field;
uniform float nearer;
out vec3 still;
out vec3 now;
out float share;
void main() {
  still = mirror * place;
  now = mirror * (place + exaggeration * moved);
  share = dot(field, fields);
  gl_Position = matrix * vec4(now, 1.0);
  gl_Position.z -= nearer;
}`;

const FRAGMENT = `#version 300 es
precision highp float;
in vec3 still;
in vec3 now;
in float share;
uniform sampler2D colours;
uniform float stretch;
uniform float threshold;
uniform vec4 plane;
uniform vec3 eye;
uniform vec3 lamp;
uniform vec4 ink;
uniform float body;
out vec4 colour;
void main() {
  if (dot(plane.xyz, still) > plane.w) discard;
  if (body >= 0.0) {
    colour = vec4(still, body + clamp(share, 0.0, 0.999));
    return;
  }
  if (ink.a > 0.0) {
    colour = ink;
    return;
  }
  vec3 normal = normalize(cross(dFdx(now), dFdy(now)));
  if (dot(normal, eye) < 0.0) normal = -normal;
  float light = 0.80 + 0.20 * max(dot(normal, lamp), 0.0);
  float value = clamp(share * stretch, 0.0, 1.0);
  vec3 paint = texture(colours, vec2((value * 255.0 + 0.5) / 256.0, 0.5)).rgb;
  if (share < threshold) paint = vec3(0.80, 0.81, 0.82);
  colour = vec4(paint * light, 1.0);
}`;

class Renderer {
  constructor(canvas, model, colours) {
    const gl = canvas.getContext("webgl2", { antialias: true });
    if (!gl) throw new Error("WebGL 2 is not available in this browser");
    this.canvas = canvas;
    this.gl = gl;
    this.model = model;
    this.program = makeProgram(gl);
    this.uniforms = new Proxy({}, { get: (_, name) => gl.getUniformLocation(this.program, name) });
    this.skin = this.upload(model);
    const { low, high } = model.header;
    // Whatever is in the picture is nearer than this to its middle.
    this.reach = 4 * Math.hypot(...high.map((h, k) => Math.max(Math.abs(h), Math.abs(low[k]))));
    this.cuts = new Map();
    this.probe = this.makeProbe();
    gl.useProgram(this.program);
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGB, 256, 1, 0, gl.RGB, gl.UNSIGNED_BYTE,
      Uint8Array.from(colours.flat()));
    for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) {
      gl.texParameteri(gl.TEXTURE_2D, name, gl.LINEAR);
    }
    gl.enable(gl.DEPTH_TEST);
  }

  // Points and, for each body, its lists of corners, in one vertex array.
  upload({ data, bodies }) {
    const gl = this.gl;
    const array = gl.createVertexArray();
    const buffers = [gl.createBuffer(), gl.createBuffer()];
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffers[0]);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
    ["place", "moved", "fields"].forEach((name, k) => {
      const at = gl.getAttribLocation(this.program, name);
      gl.enableVertexAttribArray(at);
      gl.vertexAttribPointer(at, 3, gl.FLOAT, false, 4 * STRIDE, 12 * k);
    });
    const lists = bodies.map((b) => [b.triangles, b.mesh, b.edges]);
    const corners = new Uint32Array(lists.flat().reduce((sum, list) => sum + list.length, 0));
    let next = 0;
    const ranges = lists.map((of) => of.map((list) => {
      corners.set(list, next);
      next += list.length;
      return [next - list.length, list.length];
    }));
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffers[1]);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, corners, gl.STATIC_DRAW);
    gl.bindVertexArray(null);
    return { array, buffers, ranges };
  }

  forget({ array, buffers }) {
    this.gl.deleteVertexArray(array);
    buffers.forEach((buffer) => this.gl.deleteBuffer(buffer));
  }

  // The cut faces for a plane, kept until the plane moves.
  cutAt(axis, at) {
    const key = `${axis} ${at}`;
    if (!this.cuts.has(key)) this.cuts.set(key, this.upload(cutModel(this.model, axis, at)));
    return this.cuts.get(key);
  }

  forgetCuts() {
    this.cuts.forEach((cut) => this.forget(cut));
    this.cuts.clear();
  }

  // Signs of the coordinates of each copy of the modelled part.
  copies(whole) {
    let copies = [[1, 1, 1]];
    if (!whole) return copies;
    for (const axis of this.model.header.mirrors) {
      const images = copies.map((signs) => signs.map((s, k) => (k === axis ? -s : s)));
      copies = copies.concat(images);
    }
    return copies;
  }

  draw(camera, state) {
    const { gl, canvas } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(1, 1, 1, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    this.prepare(camera, state);
    gl.uniform1f(this.uniforms.body, -1);
    this.each(state, (ranges, [triangles, mesh, edges]) => {
      gl.uniform4f(this.uniforms.ink, 0, 0, 0, 0);
      gl.uniform1f(this.uniforms.nearer, 0);
      this.elements(gl.TRIANGLES, triangles);
      // Lines lie in the faces: a little before them they are seen.
      gl.uniform1f(this.uniforms.nearer, (0.0012 * camera.height) / this.reach);
      if (state.mesh) {
        gl.uniform4f(this.uniforms.ink, 0.35, 0.37, 0.4, 1);
        this.elements(gl.LINES, mesh);
      }
      gl.uniform4f(this.uniforms.ink, 0.1, 0.11, 0.13, 1);
      this.elements(gl.LINES, edges);
    });
  }

  prepare(camera, state) {
    const { gl, canvas, uniforms } = this;
    gl.useProgram(this.program);
    gl.uniformMatrix4fv(uniforms.matrix, false, camera.matrix(canvas.width / canvas.height, this.reach));
    gl.uniform1f(uniforms.exaggeration, state.exaggeration);
    gl.uniform3fv(uniforms.field, [0, 1, 2].map((k) => (k === state.field ? 1 : 0)));
    gl.uniform1f(uniforms.stretch, state.stretch);
    gl.uniform1f(uniforms.threshold, state.threshold);
    const [right, up, eye] = camera.frame();
    gl.uniform3fv(uniforms.eye, eye);
    const lamp = eye.map((e, k) => 0.8 * e + 0.35 * up[k] - 0.3 * right[k]);
    const length = Math.hypot(...lamp);
    gl.uniform3fv(uniforms.lamp, lamp.map((x) => x / length));
  }

  // Calls `work` for each visible body of each copy, its skin clipped, then its cut faces.
  each(state, work) {
    const { gl, uniforms } = this;
    for (const signs of this.copies(state.whole)) {
      gl.uniform3fv(uniforms.mirror, signs);
      const passes = [{ part: this.skin, clipped: true }];
      if (state.cut) {
        const { axis, at } = state.cut;
        passes.push({ part: this.cutAt(axis, signs[axis] * at), clipped: false });
      }
      for (const { part, clipped } of passes) {
        gl.uniform4fv(uniforms.plane, clipped && state.cut ? planeOf(state.cut) : [0, 0, 0, 1]);
        gl.bindVertexArray(part.array);
        this.model.bodies.forEach((body, k) => {
          if (body.visible) work(k, part.ranges[k]);
        });
      }
    }
    gl.bindVertexArray(null);
  }

  elements(mode, [first, count]) {
    if (count > 0) this.gl.drawElements(mode, count, this.gl.UNSIGNED_INT, 4 * first);
  }

  makeProbe() {
    const gl = this.gl;
    if (!gl.getExtension("EXT_color_buffer_float")) return null;
    return { frame: gl.createFramebuffer(), colour: gl.createRenderbuffer(), depth: gl.createRenderbuffer() };
  }

  // What is seen at a pixel: body, place, and share of the range of the field; null where nothing is.
  probeAt(camera, state, x, y) {
    const { gl, canvas, probe } = this;
    if (!probe) return null;
    gl.bindFramebuffer(gl.FRAMEBUFFER, probe.frame);
    const parts = [
      [probe.colour, gl.RGBA32F, gl.COLOR_ATTACHMENT0],
      [probe.depth, gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT],
    ];
    for (const [buffer, format, attachment] of parts) {
      gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
      gl.renderbufferStorage(gl.RENDERBUFFER, format, canvas.width, canvas.height);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, attachment, gl.RENDERBUFFER, buffer);
    }
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(x, y, 1, 1);
    gl.clearColor(0, 0, 0, -1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    this.prepare(camera, state);
    this.each(state, (body, [triangles]) => {
      gl.uniform1f(this.uniforms.body, body);
      gl.uniform1f(this.uniforms.nearer, 0);
      this.elements(gl.TRIANGLES, triangles);
    });
    const pixel = new Float32Array(4);
    gl.readPixels(x, y, 1, 1, gl.RGBA, gl.FLOAT, pixel);
    gl.disable(gl.SCISSOR_TEST);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    const [px, py, pz, code] = pixel;
    if (code < 0) return null;
    return { body: Math.floor(code), share: (code % 1) / 0.999, place: [px, py, pz] };
  }
}

// Kept is what lies below the plane, or above it where the cut is turned.
function planeOf({ axis, at, turned, slack }) {
  const sign = turned ? -1 : 1;
  const plane = [0, 0, 0, sign * at + slack];
  plane[axis] = sign;
  return plane;
}

function makeProgram(gl) {
  const program = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, FRAGMENT]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
    throw new Error(gl.getProgramInfoLog(program));
  }
  return program;
}
