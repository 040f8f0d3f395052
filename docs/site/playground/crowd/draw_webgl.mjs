// SPDX-License-Identifier: Apache-2.0
// All shapes in one call of WebGL 2: a quad each, of which the fragments outside the shape are dropped.
import { box, perInstance } from './motion.mjs';

const vertexShader = `#version 300 es
layout(location = 0) in vec2 corner;
layout(location = 1) in vec2 centre;
layout(location = 2) in vec2 axis;
layout(location = 3) in float across;
layout(location = 4) in vec3 kind; // round, touched, radius of corners
uniform vec2 world;
uniform float least; // half a line's width
out vec2 at;
flat out vec2 half_size;
flat out vec3 sort;
void main() {
  float length_along = length(axis);
  vec2 u = length_along > 0.0 ? axis / length_along : vec2(1.0, 0.0);
  half_size = max(vec2(length_along, across), vec2(least));
  at = corner * half_size;
  sort = kind;
  gl_Position = vec4((centre + at.x * u + at.y * vec2(-u.y, u.x)) / (0.5 * world), 0.0, 1.0);
}`;

const fragmentShader = `#version 300 es
precision highp float;
in vec2 at;
flat in vec2 half_size;
flat in vec3 sort;
uniform vec3 calm;
uniform vec3 hit;
out vec4 colour;
void main() {
  vec2 q = at / half_size;
  if (sort.x > 1.5) { // a dart
    if (abs(q.y) > 0.5 - 0.5 * q.x || abs(q.y) < -0.5 - 1.5 * q.x) discard;
  } else if (sort.x > 0.5 && dot(q, q) > 1.0) discard;
  vec2 beyond = max(abs(at) - half_size + sort.z, 0.0);
  if (sort.z > 0.0 && dot(beyond, beyond) > sort.z * sort.z) discard;
  colour = vec4(sort.y > 0.5 ? hit : calm, sort.y > 0.5 ? 0.85 : 0.5);
}`;

function program(gl) {
  const made = gl.createProgram();
  for (const [type, source] of [
    [gl.VERTEX_SHADER, vertexShader],
    [gl.FRAGMENT_SHADER, fragmentShader],
  ]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(made, shader);
  }
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(made) ?? 'no WebGL');
  return made;
}

/** draw(instances, count, colours), or null where there is no WebGL 2. Colours are three numbers from 0 to 1 each. */
export function webgl(canvas) {
  const gl = canvas.getContext('webgl2', { alpha: false, antialias: false });
  if (gl === null) return null;
  const shaders = program(gl),
    instances = gl.createBuffer(),
    place = (name) => gl.getUniformLocation(shaders, name);
  gl.useProgram(shaders);
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ARRAY_BUFFER, new Float32Array([-1, -1, 1, -1, -1, 1, 1, 1]), gl.STATIC_DRAW);
  gl.enableVertexAttribArray(0);
  gl.vertexAttribPointer(0, 2, gl.FLOAT, false, 0, 0);
  gl.bindBuffer(gl.ARRAY_BUFFER, instances);
  [
    [1, 2, 0],
    [2, 2, 2],
    [3, 1, 4],
    [4, 3, 5],
  ].forEach(([location, size, offset]) => {
    gl.enableVertexAttribArray(location);
    gl.vertexAttribPointer(location, size, gl.FLOAT, false, 4 * perInstance, 4 * offset);
    gl.vertexAttribDivisor(location, 1);
  });
  gl.enable(gl.BLEND);
  gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
  gl.uniform2f(place('world'), box.width, box.height);
  return (data, count, { paper, calm, hit }) => {
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(...paper, 1);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.uniform3f(place('calm'), ...calm);
    gl.uniform3f(place('hit'), ...hit);
    gl.uniform1f(place('least'), (0.75 * box.width) / canvas.width);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.DYNAMIC_DRAW);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, count);
  };
}
