// SPDX-License-Identifier: GPL-3.0-or-later
// Turns the snapshots on the page: particles as shaded spheres (point sprites), walls as triangles. WebGL 2, no library.
"use strict";
const SPHERES = [`#version 300 es
layout(location = 0) in vec4 sphere;
layout(location = 1) in float colour;
uniform mat3 turn; uniform vec3 middle; uniform vec2 scale; uniform float pixels, depth;
uniform vec3 palette[13];
out vec3 tint; out float size;
void main() {
  vec3 p = turn * (sphere.xyz - middle);
  gl_Position = vec4(p.xy * scale, -p.z / depth, 1.0);
  gl_PointSize = max(1.0, 2.0 * sphere.w * pixels);
  size = sphere.w / depth;
  tint = palette[int(colour)];
}`, `#version 300 es
precision highp float;
in vec3 tint; in float size;
out vec4 colour;
void main() {
  vec2 at = 2.0 * gl_PointCoord - 1.0;
  float r2 = dot(at, at);
  if (r2 > 1.0) discard;
  vec3 n = vec3(at.x, -at.y, sqrt(1.0 - r2));
  float light = 0.35 + 0.65 * max(0.0, dot(n, normalize(vec3(-0.4, 0.6, 0.8))));
  colour = vec4(tint * light * (1.0 - 0.35 * smoothstep(0.75, 1.0, r2)), 1.0);
  gl_FragDepth = gl_FragCoord.z - 0.5 * size * n.z;
}`];
const WALLS = [`#version 300 es
layout(location = 0) in vec3 corner;
layout(location = 1) in float cut;
uniform mat3 turn; uniform vec3 middle; uniform vec2 scale; uniform float depth;
out vec3 seen, place; out float open;
void main() {
  place = corner;
  seen = turn * (corner - middle);
  open = cut;
  gl_Position = vec4(seen.xy * scale, -seen.z / depth, 1.0);
}`, `#version 300 es
precision highp float;
in vec3 seen, place; in float open;
uniform vec2 toward; uniform vec3 steel; uniform float opaque;
out vec4 colour;
void main() {
  if ((open > 0.5) == (opaque > 0.5)) discard;
  if (open > 0.5 && dot(place.xy, toward) > 0.0) discard;
  vec3 n = normalize(cross(dFdx(seen), dFdy(seen)));
  colour = vec4(steel * (0.35 + 0.65 * abs(dot(n, normalize(vec3(-0.4, 0.6, 0.8))))), open > 0.5 ? 0.45 : 1.0);
}`];

function program(gl, [vertex, fragment]) {
  const made = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(made, shader);
  }
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(made));
  const at = {};
  for (let k = 0; k < gl.getProgramParameter(made, gl.ACTIVE_UNIFORMS); ++k) {
    const name = gl.getActiveUniform(made, k).name;
    at[name.replace("[0]", "")] = gl.getUniformLocation(made, name);
  }
  return {made, at};
}

// The arrays of a frame, in the order in which encode.hpp writes them.
function decode(element) {
  const {time, spheres, particles, corners, triangles} = element.dataset, n = +spheres, m = +corners, t = +triangles;
  const bytes = Uint8Array.from(atob(element.textContent), (c) => c.charCodeAt(0)).buffer;
  const walls = 16 * n, faces = walls + 12 * m, colours = faces + 12 * t;
  return {time: +time, n, t, particles: +particles, spheres: new Float32Array(bytes, 0, 4 * n),
          corners: new Float32Array(bytes, walls, 3 * m), faces: new Uint32Array(bytes, faces, 3 * t),
          colours: new Uint8Array(bytes, colours, n), cut: new Uint8Array(bytes, colours + n, m)};
}

function attribute(gl, place, values, size, type) {
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
  gl.enableVertexAttribArray(place);
  gl.vertexAttribPointer(place, size, type, false, 0, 0);
}

function upload(gl, frame) {
  frame.rock = gl.createVertexArray();
  gl.bindVertexArray(frame.rock);
  attribute(gl, 0, frame.spheres, 4, gl.FLOAT);
  attribute(gl, 1, frame.colours, 1, gl.UNSIGNED_BYTE);
  frame.steel = gl.createVertexArray();
  gl.bindVertexArray(frame.steel);
  attribute(gl, 0, frame.corners, 3, gl.FLOAT);
  attribute(gl, 1, frame.cut, 1, gl.UNSIGNED_BYTE);
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, frame.faces, gl.STATIC_DRAW);
}

// Middle and half of the diagonal of what the frames show: the walls, else the rock.
function extent(frames) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (const f of frames) {
    const [points, step] = f.corners.length > 0 ? [f.corners, 3] : [f.spheres, 4];
    for (let k = 0; k < points.length; k += step)
      for (let c = 0; c < 3; ++c) {
        low[c] = Math.min(low[c], points[k + c]);
        high[c] = Math.max(high[c], points[k + c]);
      }
  }
  const half = Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]) / 2 || 1;
  return {middle: low.map((v, c) => (v + high[c]) / 2), half};
}

function cssColour(style, name) {
  const hex = style.getPropertyValue(name).trim();
  return [1, 3, 5].map((k) => parseInt(hex.slice(k, k + 2), 16) / 255);
}

function start(view) {
  const canvas = view.querySelector("canvas"), gl = canvas.getContext("webgl2", {alpha: false, preserveDrawingBuffer: true});
  if (!gl) return;
  const rock = program(gl, SPHERES), steel = program(gl, WALLS);
  const frames = [...view.querySelectorAll("script.frame")].map(decode);
  frames.forEach((frame) => upload(gl, frame));
  const {middle, half} = extent(frames);
  const slider = view.querySelector("input"), output = view.querySelector("output");
  let azimuth = -1.2, elevation = 0.35, zoom = 1, walls = true;

  function draw() {
    const frame = frames[+slider.value], style = getComputedStyle(view), ratio = window.devicePixelRatio || 1;
    const width = canvas.clientWidth * ratio, height = canvas.clientHeight * ratio;
    if (!(width > 0)) return;
    [canvas.width, canvas.height] = [width, height];
    gl.viewport(0, 0, width, height);
    gl.clearColor(...cssColour(style, "--canvas"), 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    const [ca, sa, ce, se] = [Math.cos(azimuth), Math.sin(azimuth), Math.cos(elevation), Math.sin(elevation)];
    const turn = [-sa, -se * ca, ce * ca, ca, -se * sa, ce * sa, 0, ce, se];  // columns: x, y, z of right, up, toward us
    const pixels = zoom * Math.min(width, height) / (1.7 * half), scale = [2 * pixels / width, 2 * pixels / height];
    const set = ({made, at}) => {
      gl.useProgram(made);
      gl.uniformMatrix3fv(at.turn, false, turn);
      gl.uniform3fv(at.middle, middle);
      gl.uniform2fv(at.scale, scale);
      gl.uniform1f(at.depth, 3 * half);
    };
    set(rock);
    gl.uniform1f(rock.at.pixels, pixels);
    gl.uniform3fv(rock.at.palette, [...Array(13).keys()].flatMap((k) => cssColour(style, "--p" + k)));
    gl.bindVertexArray(frame.rock);
    gl.drawArrays(gl.POINTS, 0, frame.n);
    if (walls) drawWalls(frame, set, style, [ca, sa]);
    output.textContent = (frame.time < 0.1 ? (1000 * frame.time).toPrecision(3) + " ms" : frame.time.toPrecision(3) + " s") +
      ", " + frame.particles + " particles";
  }

  function drawWalls(frame, set, style, toward) {
    set(steel);
    gl.uniform2fv(steel.at.toward, toward);
    gl.uniform3fv(steel.at.steel, cssColour(style, "--steel"));
    gl.bindVertexArray(frame.steel);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    for (const opaque of [1, 0]) {
      gl.depthMask(opaque === 1);
      gl.uniform1f(steel.at.opaque, opaque);
      gl.drawElements(gl.TRIANGLES, 3 * frame.t, gl.UNSIGNED_INT, 0);
    }
    gl.depthMask(true);
    gl.disable(gl.BLEND);
  }

  function rotate(dx, dy) {
    azimuth -= dx;
    elevation = Math.max(-1.5, Math.min(1.5, elevation + dy));
    draw();
  }
  view.querySelector(".live").hidden = false;
  view.classList.add("running");
  canvas.addEventListener("pointerdown", (e) => canvas.setPointerCapture(e.pointerId));
  canvas.addEventListener("pointermove", (e) => e.buttons && rotate(0.01 * e.movementX, 0.01 * e.movementY));
  canvas.addEventListener("keydown", (e) => {
    const step = {ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1]}[e.key];
    if (step) rotate(...step), e.preventDefault();
  });
  slider.addEventListener("input", draw);
  const buttons = {".in": () => zoom *= 1.25, ".out": () => zoom /= 1.25, ".walls": () => walls = !walls};
  for (const [name, act] of Object.entries(buttons))
    view.querySelector(name).addEventListener("click", () => { act(); draw(); });
  new ResizeObserver(draw).observe(canvas);
  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
  draw();
}

// A view behind a closed name starts when it is opened: browsers allow few of them at a time.
for (const view of document.querySelectorAll(".view3d")) {
  const once = () => { if (!view.dataset.started) { view.dataset.started = "yes"; start(view); } };
  const folded = view.closest("details");
  if (folded && !folded.open) folded.addEventListener("toggle", once);
  else once();
}
