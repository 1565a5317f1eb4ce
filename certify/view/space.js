// SPDX-License-Identifier: Apache-2.0
/*! Drawn with three.js, which comes with this notice:

The MIT License

Copyright © 2010-2019 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy of this software and associated
documentation files (the "Software"), to deal in the Software without restriction, including without limitation the
rights to use, copy, modify, merge, publish, distribute, sublicense, and/or sell copies of the Software, and to permit
persons to whom the Software is furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all copies or substantial portions of the
Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE
WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR
COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR
OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.
*/
// A run drawn in space with three.js, and labels over it. All views of a page share one WebGL context (browsers allow
// few); each copies its image to a canvas of its own.
import {
  AmbientLight,
  Color,
  DirectionalLight,
  DoubleSide,
  Group,
  LatheBufferGeometry,
  Mesh,
  MeshLambertMaterial,
  OrthographicCamera,
  Quaternion,
  Scene,
  Vector2,
  Vector3,
  WebGLRenderer,
} from 'three/build/three.module.js';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js';
import { length, minus } from './run.js';

const WIDTH = { programmed: 4, axes: 2, point: 2, other: 2 };
const MOST_LABELS = 60; // where there are no more steps; of more the fewer
const SPREAD_LABELS = 24;

let shared;
function renderer() {
  if (shared !== undefined) return shared;
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('webgl', { alpha: true, antialias: true });
  shared = context ? new WebGLRenderer({ canvas, context, alpha: true, antialias: true }) : null;
  if (shared) canvas.addEventListener('webglcontextlost', () => document.dispatchEvent(new Event('view-lost')));
  return shared;
}

export const canDraw = () => renderer() !== null;

function dispose(group) {
  group.traverse((object) => {
    if (object.geometry) object.geometry.dispose();
    if (object.material) object.material.dispose();
  });
}

// The largest of 1, 2, 5 · 10^n that is not above x.
function roundDown(x) {
  const power = 10 ** Math.floor(Math.log10(x));
  const mantissa = x / power;
  return power * (mantissa >= 5 ? 5 : mantissa >= 2 ? 2 : 1);
}

export class Space {
  constructor(canvas, run) {
    this.canvas = canvas;
    this.run = run;
    this.labelled = this.chooseLabels();
    const [low, high] = run.box();
    this.box = [low, high];
    this.center = low.map((x, i) => (x + high[i]) / 2);
    this.size = length(minus(high, low)) || 1;
    this.camera = new OrthographicCamera(-1, 1, 1, -1, -20 * this.size, 20 * this.size);
    const tilted = run.steps.some((step) => step.tool_axis && Math.abs(step.tool_axis[2]) < 1);
    this.flat = high[2] === low[2] && !tilted;
    this.lookFrom(this.flat ? 'top' : 'corner');
  }

  // The directions in degrees: around Z from -Y, and above the plane.
  lookFrom(name) {
    [this.around, this.above] = { top: [0, 90], front: [0, 0], corner: [30, 30] }[name];
    this.zoom = 1;
    this.shift = [0, 0];
    this.fit();
  }

  // How far everything reaches to the side and up, as it is seen now. Of a tool larger than its path some is cut off.
  fit() {
    const [right, up] = this.paper();
    const tool = Math.min(Math.max(0, ...this.run.tools.map((shape) => shape.radius)), this.size / 2);
    const half = minus(this.box[1], this.box[0]).map((x) => x / 2);
    this.reach = [right, up].map((axis) => {
      const far = axis.reduce((sum, x, i) => sum + Math.abs(x) * half[i], 0);
      return (far + tool) * 1.25 || this.size;
    });
  }

  // What is to the right on the paper, and what is up.
  paper() {
    const rad = Math.PI / 180;
    const [sa, ca] = [Math.sin(this.around * rad), Math.cos(this.around * rad)];
    const [sb, cb] = [Math.sin(this.above * rad), Math.cos(this.above * rad)];
    return [[ca, sa, 0], [-sa * sb, ca * sb, cb]];
  }

  orbit(around, above) {
    this.around += around;
    this.above = Math.max(-90, Math.min(90, this.above + above));
  }

  enlarge(factor) {
    this.zoom = Math.max(0.2, Math.min(1e6, this.zoom * factor));
  }

  // Everything, with the steps `selected` drawn stronger and the tool behind step `index`. `hidden`: names of courses
  // that are not drawn.
  draw({ index, selected, factor, hidden }) {
    const ratio = window.devicePixelRatio || 1;
    const width = this.canvas.clientWidth;
    const height = this.canvas.clientHeight;
    if (!width || !height) return;
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    this.resolution = new Vector2(width, height);
    this.style = getComputedStyle(this.canvas);
    this.aim(width, height);
    const courses = this.run.shown.filter((course) => !hidden.has(course));
    const paper = this.canvas.getContext('2d');
    paper.scale(ratio, ratio);
    this.layer((group) => this.addTool(group, index), (image) => paper.drawImage(image, 0, 0, width, height));
    paper.drawImage(this.still(courses, factor, ratio), 0, 0, width, height);
    this.layer(
      (group) => this.addSelected(group, courses, index, selected, factor, hidden),
      (image) => paper.drawImage(image, 0, 0, width, height),
    );
    this.label(paper, width, height, index);
  }

  // Draws what `add` puts into a group, and hands the image on.
  layer(add, use) {
    const group = new Group();
    add(group);
    if (group.children.length) this.render(group, use);
    dispose(group);
  }

  render(group, use) {
    const gl = renderer();
    const scene = new Scene();
    scene.add(...this.lights, group);
    gl.setPixelRatio(window.devicePixelRatio || 1);
    gl.setSize(this.resolution.x, this.resolution.y, false);
    gl.setClearColor(0, 0);
    gl.render(scene, this.camera);
    use(gl.domElement);
  }

  // What is the same for every step, as an image: lines are made anew only where they change, the image where they are
  // seen otherwise.
  still(courses, factor, ratio) {
    const colours = [...courses, 'recorded', 'off'].map((name) => this.style.getPropertyValue(`--view-${name}`));
    const lines = JSON.stringify([courses, factor, colours]);
    if (this.stillLines !== lines) {
      if (this.stillGroup) dispose(this.stillGroup);
      this.stillGroup = new Group();
      this.addCourses(this.stillGroup, courses, factor);
      this.addRecording(this.stillGroup, factor);
      this.stillLines = lines;
    }
    const { around, above, zoom, shift, resolution } = this;
    const seen = JSON.stringify([lines, around, above, zoom, shift, resolution.x, resolution.y, ratio]);
    if (this.stillSeen === seen) return this.stillImage;
    this.stillSeen = seen;
    this.stillImage = document.createElement('canvas');
    this.stillImage.width = this.canvas.width;
    this.stillImage.height = this.canvas.height;
    this.stillGroup.traverse((object) => {
      if (object.material) object.material.resolution = resolution;
    });
    this.render(this.stillGroup, (image) => this.stillImage.getContext('2d').drawImage(image, 0, 0));
    return this.stillImage;
  }

  aim(width, height) {
    const [right, up] = this.paper().map((axis) => new Vector3(...axis));
    const eye = right.clone().cross(up);
    this.camera.up.copy(up);
    this.camera.position.copy(eye);
    this.camera.lookAt(0, 0, 0);
    this.camera.updateMatrixWorld();
    this.perPixel = Math.max((2 * this.reach[0]) / width, (2 * this.reach[1]) / height) / this.zoom;
    const [x, y] = [(width * this.perPixel) / 2, (height * this.perPixel) / 2];
    const [dx, dy] = this.shift.map((s) => s * this.perPixel);
    Object.assign(this.camera, { left: -x - dx, right: x - dx, top: y + dy, bottom: -y + dy });
    this.camera.updateProjectionMatrix();
    const light = new DirectionalLight(0xffffff, 0.5);
    light.position.copy(eye).add(new Vector3(0.3, 0.2, 0.6));
    this.lights = [new AmbientLight(0xffffff, 0.65), light];
  }

  colour(name) {
    return new Color(this.style.getPropertyValue(`--view-${name}`).trim());
  }

  // From the middle of the drawing, before anything is rounded to single precision.
  local(p) {
    return minus(p, this.center);
  }

  // Lines lie over each other in the order they are added.
  addLines(group, polylines, colour, width, dashed = false) {
    const ends = [];
    for (const points of polylines)
      for (let i = 1; i < points.length; ++i) ends.push(...this.local(points[i - 1]), ...this.local(points[i]));
    if (ends.length === 0) return;
    const geometry = new LineSegmentsGeometry();
    geometry.setPositions(ends);
    const dash = this.size / 60;
    const material = new LineMaterial({ color: this.colour(colour), linewidth: width, dashSize: dash, gapSize: dash / 2 });
    material.dashed = dashed;
    if (dashed) material.defines.USE_DASH = '';
    material.resolution = this.resolution;
    material.depthTest = false;
    material.transparent = true; // drawn in the order given
    const lines = new LineSegments2(geometry, material);
    if (dashed) lines.computeLineDistances();
    lines.frustumCulled = false;
    lines.renderOrder = group.children.length;
    group.add(lines);
  }

  addCourses(group, courses, factor) {
    const { run } = this;
    for (const course of courses)
      for (const rapid of [true, false]) {
        const lines = run.steps.map((step, i) => (Boolean(step.rapid) === rapid ? run.line(course, i, factor) : null));
        this.addLines(group, lines.filter(Boolean), course, WIDTH[course], rapid);
      }
  }

  addSelected(group, courses, index, selected, factor, hidden) {
    const { run } = this;
    for (const course of courses)
      this.addLines(group, selected.map((i) => run.line(course, i, factor)).filter(Boolean), course, WIDTH[course] + 3);
    for (const i of selected)
      if (run.steps[i].programmed && run.steps[i].point)
        this.addLines(group, [[run.place('programmed', i), run.tip(i)]], 'vector', 3);
    const step = run.steps[index];
    if (step && step.other && step[run.compared] && !hidden.has('other'))
      this.addLines(group, [[run.place(run.compared, index), run.drawn('other', index, factor).slice(-1)[0]]], 'off', 3);
  }

  addRecording(group, factor) {
    const { run } = this;
    const followed = [];
    const off = [];
    for (let i = 1; i < run.recorded.length; ++i)
      (run.recorded[i][2] || run.recorded[i - 1][2] ? off : followed).push([
        run.sample(i - 1, factor),
        run.sample(i, factor),
      ]);
    this.addLines(group, followed, 'recorded', 1.5);
    this.addLines(group, off, 'off', 2.5);
  }

  // The tool at the end of the step: turned about its axis, its tip at the tool point.
  addTool(group, index) {
    if (!this.run.steps.length) return;
    const shape = this.run.tools[this.run.steps[Math.max(index, 0)].tool];
    const profile = shape ? this.profileOf(shape) : [[0, 0], [0.012, 0.05], [0.012, 0.2], [0, 0.2]].map(
      ([x, y]) => [x * this.size, y * this.size]);
    const geometry = new LatheBufferGeometry(profile.map(([x, y]) => new Vector2(x, y)), 48);
    const material = new MeshLambertMaterial({
      color: this.colour('tool'),
      transparent: true,
      opacity: 0.45,
      side: DoubleSide,
      depthWrite: false,
    });
    const tool = new Mesh(geometry, material);
    tool.position.set(...this.local(this.run.tip(index)));
    tool.quaternion.copy(new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), new Vector3(...this.axis(index))));
    group.add(tool);
  }

  // The tool axis in force: that of the step, or the last one before it.
  axis(index) {
    for (let i = index; i >= 0; --i) if (this.run.steps[i].tool_axis) return this.run.steps[i].tool_axis;
    return [0, 0, 1];
  }

  // Half of a section through the tool, as far as there is room: bottom, corner, shank.
  profileOf(shape) {
    const corner = Math.min(shape.corner, shape.radius);
    const wanted = shape.length || Math.max(4 * shape.radius, 0.15 * this.size);
    const top = Math.max(Math.min(wanted, 0.6 * this.size), 2 * shape.radius, corner);
    const points = [[0, 0]];
    for (let angle = 0; angle <= 90; angle += 10) {
      const rad = (angle * Math.PI) / 180;
      points.push([shape.radius - corner + corner * Math.sin(rad), corner - corner * Math.cos(rad)]);
    }
    points.push([shape.radius, top], [0, top]);
    return points;
  }

  // On the canvas, pixels.
  project(p, width, height) {
    const v = new Vector3(...this.local(p)).project(this.camera);
    return [((v.x + 1) / 2) * width, ((1 - v.y) / 2) * height];
  }

  // Blocks, alarms, axes and a scale; no label covers another.
  label(paper, width, height, index) {
    const soft = this.style.getPropertyValue('--soft');
    const taken = [];
    const write = (text, x, y, colour, weight = '') => {
      paper.font = `${weight} 12px system-ui, sans-serif`;
      const box = [x - 2, y - 11, x + paper.measureText(text).width + 2, y + 4];
      const hits = ([a, b, c, d]) => box[0] < c && a < box[2] && box[1] < d && b < box[3];
      if (box[0] < 0 || box[1] < 0 || box[2] > width || box[3] > height || taken.some(hits)) return false;
      taken.push(box);
      paper.fillStyle = colour;
      paper.fillText(text, x, y);
      return true;
    };
    this.drawAxes(paper, height, write, soft);
    this.drawScale(paper, width, height, write, soft);
    const { run } = this;
    const written = new Set();
    const mark = (i, weight) => {
      const [x, y] = this.project(run.tip(i), width, height);
      const step = run.steps[i];
      // Several moves of a block may end in one place.
      const place = `${step.line} ${Math.round(x)} ${Math.round(y)}`;
      if (written.has(place)) return;
      written.add(place);
      const colour = step.alarm ? this.style.getPropertyValue('--bad') : soft;
      paper.fillStyle = colour;
      paper.beginPath();
      paper.arc(x, y, weight ? 3.5 : 2, 0, 7);
      paper.fill();
      const text = (step.n === undefined ? `${step.line}` : `N${step.n}`) + (step.alarm ? ` ${step.alarm}` : '');
      const left = -10 - 7 * text.length;
      [[6, -6], [6, 14], [left, -6], [left, 14]].some(([dx, dy]) => write(text, x + dx, y + dy, colour, weight));
    };
    if (run.steps[index]) mark(index, 'bold');
    for (const i of this.labelled) if (i !== index) mark(i, '');
  }

  // Alarms, and of the other steps so many, spread over all of them.
  chooseLabels() {
    const { steps } = this.run;
    const stride = steps.length <= MOST_LABELS ? 1 : Math.ceil(steps.length / SPREAD_LABELS);
    const all = steps.map((_, i) => i);
    return [...all.filter((i) => steps[i].alarm), ...all.filter((i) => !steps[i].alarm && i % stride === 0)];
  }

  drawAxes(paper, height, write, soft) {
    const [x, y] = [40, height - 44];
    const turn = new Quaternion().copy(this.camera.quaternion).inverse();
    ['X', 'Y', 'Z'].forEach((name, i) => {
      const axis = new Vector3().setComponent(i, 26).applyQuaternion(turn);
      if (Math.hypot(axis.x, axis.y) < 2) return;
      paper.strokeStyle = soft;
      paper.beginPath();
      paper.moveTo(x, y);
      paper.lineTo(x + axis.x, y - axis.y);
      paper.stroke();
      write(name, x + axis.x * 1.4 - 4, y - axis.y * 1.4 + 4, soft);
    });
  }

  drawScale(paper, width, height, write, soft) {
    const long = roundDown((width / 4) * this.perPixel);
    const pixels = long / this.perPixel;
    const [x, y] = [width - 12 - pixels, height - 12];
    paper.strokeStyle = soft;
    paper.beginPath();
    paper.moveTo(x, y - 4);
    paper.lineTo(x, y);
    paper.lineTo(x + pixels, y);
    paper.lineTo(x + pixels, y - 4);
    paper.stroke();
    write(`${Number(long.toPrecision(3))} ${this.run.unit}`, x + 4, y - 6, soft);
  }
}
