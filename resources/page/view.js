/*! Bundled with three.js. Copyright three.js authors. The MIT License: Permission is hereby granted, free
of charge, to any person obtaining a copy of this software and associated documentation files (the
"Software"), to deal in the Software without restriction, including without limitation the rights to use,
copy, modify, merge, publish, distribute, sublicense, and/or sell copies of the Software, and to permit
persons to whom the Software is furnished to do so, subject to the following conditions: The above copyright
notice and this permission notice shall be included in all copies or substantial portions of the Software.
THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED
TO THE WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL
THE AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF
CONTRACT, TORT OR OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER
DEALINGS IN THE SOFTWARE. */
// The 3D view of a page: the parts, a slider over the frames of the motion, and the shortest line of each row.
// It draws the JSON in #scene (cpp/src/page/scene.cpp). SPDX-License-Identifier: LGPL-2.1-or-later
import {
  AmbientLight,
  BufferAttribute,
  BufferGeometry,
  Color,
  DirectionalLight,
  DoubleSide,
  Group,
  Line,
  LineBasicMaterial,
  Mesh,
  MeshPhongMaterial,
  PerspectiveCamera,
  REVISION,
  Scene,
  SphereGeometry,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three-controls";

const COLOURS = {
  clear: 0x8aa88f, allowed: 0x8aa88f, below: 0xe0952f, contact: 0xa06cc4, clash: 0xd8434b,
  none: 0x9aa3ad, envelope: 0x5fa8e0,
};
const MOVING = [0x3f7fc1, 0x2b9c9c, 0x7a6bd0, 0x2f6690, 0x56b4e9, 0x5b8c5a];
const PAUSE = 45; // ms between two frames that are played
// Since this revision of three.js, light intensities have another unit.
const LIGHT = Number(REVISION) >= 155 ? Math.PI : 1;

function bytes(text) {
  return Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer;
}

function shapeOf(part) {
  const steps = new Uint16Array(bytes(part.points));
  const points = new Float32Array(steps.length);
  for (let i = 0; i < steps.length; ++i) points[i] = part.origin[i % 3] + part.step * steps[i];
  const shape = new BufferGeometry();
  shape.setAttribute("position", new BufferAttribute(points, 3));
  shape.setAttribute("normal", new BufferAttribute(new Int8Array(bytes(part.normals)), 3, true));
  const indices = bytes(part.indices);
  shape.setIndex(
    new BufferAttribute(part.wide ? new Uint32Array(indices) : new Uint16Array(indices), 1)
  );
  return shape;
}

class View {
  constructor(data) {
    this.data = data;
    this.canvas = document.getElementById("view-canvas");
    // The drawn picture is preserved, because prints and screenshots of the page need it.
    this.renderer = new WebGLRenderer({
      canvas: this.canvas, antialias: true, alpha: true, preserveDrawingBuffer: true,
    });
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(35, 1, 1, 1000);
    this.camera.up.set(0, 0, 1);
    this.scene.add(this.camera, new AmbientLight(0xffffff, 0.55 * LIGHT));
    const lamp = new DirectionalLight(0xffffff, 0.6 * LIGHT);
    lamp.position.set(-0.4, 0.7, 1);
    this.camera.add(lamp);
    this.moving = 0;
    this.parts = data.parts.map((part) => this.addPart(part));
    this.addLine();
    this.frame = 0;
    this.row = null;
    this.playing = 0;
    this.measure();
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.addEventListener("change", () => this.draw());
    this.connect();
    this.resize();
    this.home();
    if (data.rows.length) this.chooseRow(data.rows[0], false);
    else this.showFrame(0);
  }

  addPart(part) {
    const colour = part.kind === "moves" ? MOVING[this.moving++ % MOVING.length]
      : COLOURS[part.kind === "stands" ? part.verdict : part.kind];
    const material = new MeshPhongMaterial({
      color: colour, shininess: 12, specular: 0x222222, side: DoubleSide,
      transparent: part.kind === "envelope", opacity: part.kind === "envelope" ? 0.25 : 1,
      depthWrite: part.kind !== "envelope",
    });
    const mesh = new Mesh(shapeOf(part), material);
    if (part.poses) mesh.poses = new Float32Array(bytes(part.poses));
    this.scene.add(mesh);
    this.list(part, mesh, colour);
    return mesh;
  }

  list(part, mesh, colour) {
    const label = document.createElement("label");
    const box = document.createElement("input");
    const swatch = document.createElement("span");
    box.type = "checkbox";
    box.checked = true;
    swatch.className = "swatch";
    swatch.style.background = "#" + new Color(colour).getHexString();
    label.append(box, swatch, document.createTextNode(part.name));
    box.addEventListener("change", () => {
      mesh.visible = box.checked;
      this.draw();
    });
    document.getElementById("view-parts").append(label);
  }

  addLine() {
    this.mark = new Group();
    const always = { depthTest: false, transparent: true };
    this.line = new Line(new BufferGeometry(), new LineBasicMaterial({ color: 0xffd400, ...always }));
    this.line.renderOrder = 2;
    this.ends = [0, 1].map(() => {
      const end = new Mesh(new SphereGeometry(1, 16, 12), new MeshPhongMaterial({
        color: 0xffd400, emissive: 0x806a00, ...always,
      }));
      end.renderOrder = 3;
      return end;
    });
    this.mark.add(this.line, ...this.ends);
    this.scene.add(this.mark);
  }

  /** Sets the centre and the size (diagonal) of the box around all parts in all frames. */
  measure() {
    const low = new Vector3(Infinity, Infinity, Infinity), high = low.clone().negate();
    for (const mesh of this.parts) {
      mesh.geometry.computeBoundingSphere();
      const { center, radius } = mesh.geometry.boundingSphere;
      const frames = mesh.poses ? this.data.times.length : 1;
      for (let k = 0; k < frames; ++k) {
        this.place(mesh, k);
        const c = center.clone().applyQuaternion(mesh.quaternion).add(mesh.position);
        low.min(c.clone().addScalar(-radius));
        high.max(c.addScalar(radius));
      }
    }
    this.centre = low.clone().add(high).multiplyScalar(0.5);
    this.size = Math.max(1e-6, low.distanceTo(high));
    this.camera.near = this.size / 2000;
    this.camera.far = this.size * 20;
  }

  place(mesh, k) {
    if (!mesh.poses) return;
    const p = mesh.poses.subarray(7 * k, 7 * k + 7);
    mesh.position.set(p[0], p[1], p[2]);
    mesh.quaternion.set(p[3], p[4], p[5], p[6]);
  }

  home() {
    this.look(this.centre, this.size * 0.85);
  }

  look(target, distance) {
    this.controls.target.copy(target);
    this.camera.position.copy(target).add(
      new Vector3(0.62, -0.66, 0.43).normalize().multiplyScalar(distance)
    );
    this.controls.update();
    this.draw();
  }

  showFrame(k) {
    this.frame = k;
    for (const mesh of this.parts) this.place(mesh, k);
    const time = this.data.times[k];
    const shown = this.row && this.row.frame === k;
    this.mark.visible = Boolean(shown);
    document.getElementById("view-time").value = k;
    document.getElementById("view-now").value =
      time === undefined ? "" : time.toLocaleString(this.data.language, { maximumFractionDigits: 3 }) + " s";
    this.markGraph(time);
    this.draw();
  }

  markGraph(time) {
    const now = document.getElementById("graph-now");
    if (!now || time === undefined) return;
    const { from, to, left, right } = now.ownerSVGElement.dataset;
    const share = (time - from) / (to - from);
    const x = Number(left) + share * (right - left);
    now.setAttribute("visibility", share >= 0 && share <= 1 ? "visible" : "hidden");
    now.setAttribute("x1", x);
    now.setAttribute("x2", x);
  }

  chooseRow(row, near) {
    this.pause();
    this.row = row;
    const [a, b] = row.line.map((p) => new Vector3(...p));
    this.line.geometry.setFromPoints([a, b]);
    const middle = a.clone().add(b).multiplyScalar(0.5);
    const size = Math.max(this.size * 0.004, Math.min(a.distanceTo(b) * 0.08, this.size * 0.01));
    this.ends.forEach((end, i) => {
      end.position.copy(i ? b : a);
      end.scale.set(size, size, size);
    });
    this.data.parts.forEach((part, i) => {
      if (part.kind === "envelope") return;
      const bright = part.kind === "moves" || row.parts.includes(i);
      this.parts[i].material.transparent = !bright;
      this.parts[i].material.opacity = bright ? 1 : 0.45;
      this.parts[i].material.needsUpdate = true;
    });
    document.getElementById("view-row").value = row.row;
    document.querySelectorAll("tr[data-row]").forEach((line) => {
      line.classList.toggle("chosen", Number(line.dataset.row) === row.row);
    });
    document.querySelectorAll(".curve").forEach((curve) => {
      curve.classList.toggle("chosen", curve.dataset.row === row.name);
    });
    if (near) this.look(middle, Math.max(a.distanceTo(b) * 6, this.size * 0.3));
    this.showFrame(row.frame);
  }

  connect() {
    const slider = document.getElementById("view-time");
    slider.max = Math.max(0, this.data.times.length - 1);
    slider.addEventListener("input", () => {
      this.pause();
      this.showFrame(Number(slider.value));
    });
    this.button = document.getElementById("view-play");
    this.button.disabled = this.data.times.length < 2;
    this.button.addEventListener("click", () => (this.playing ? this.pause() : this.play()));
    document.getElementById("view-reset").addEventListener("click", () => this.home());
    const rowOf = (number) => this.data.rows.find((row) => row.row === Number(number));
    const select = document.getElementById("view-row");
    select.addEventListener("change", () => this.chooseRow(rowOf(select.value), true));
    document.querySelectorAll("tr[data-row]").forEach((line) => {
      line.classList.add("link");
      line.addEventListener("click", () => {
        this.chooseRow(rowOf(line.dataset.row), true);
        this.canvas.scrollIntoView({ behavior: "smooth", block: "nearest" });
      });
    });
    new ResizeObserver(() => this.resize()).observe(this.canvas);
  }

  play() {
    this.button.textContent = this.data.words.pause;
    if (this.frame >= this.data.times.length - 1) this.frame = -1;
    this.playing = setInterval(() => {
      if (this.frame >= this.data.times.length - 1) this.pause();
      else this.showFrame(this.frame + 1);
    }, PAUSE);
  }

  pause() {
    clearInterval(this.playing);
    this.playing = 0;
    this.button.textContent = this.data.words.play;
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (!width || !height) return;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  draw() {
    this.renderer.render(this.scene, this.camera);
  }
}

// The class "with-view" shows the element of the view first, because a hidden element has no size.
document.documentElement.classList.add("with-view");
try {
  window.sweptView = new View(JSON.parse(document.getElementById("scene").textContent));
} catch (error) {
  console.warn("no 3D view: " + error);
  document.documentElement.classList.remove("with-view");
}
