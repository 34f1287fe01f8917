"use strict";
// The map of the tracks: north up, metres; dragged and zoomed, and pointed at to tell the time of the nearest estimate.

class TrackMap {
  constructor(view, element) {
    this.view = view;
    this.element = element;
    this.layers = new Layers(element);
    this.scale = null;  // pixels a metre
    this.middle = [0, 0];
    this.grip = null;
    this.listen();
    view.add(this);
  }

  /** Shows all tracks, but not what few estimates before alignment are far off. */
  fit() {
    const {stream: {truth, fixes}, data: {runs}} = this.view;
    const tracks = truth ? [truth, ...runs] : [...runs, fixes];
    const ends = (key) => {
      const bounds = tracks.filter((track) => track.t.length > 0).map((track) => [
        quantile(track[key], track === truth ? 0 : 0.005), quantile(track[key], track === truth ? 1 : 0.995)]);
      return [Math.min(...bounds.map((bound) => bound[0])), Math.max(...bounds.map((bound) => bound[1]))];
    };
    const [[west, east], [south, north]] = [ends("x"), ends("y")];
    this.middle = [0.5 * (west + east), 0.5 * (south + north)];
    this.scale = Math.min((this.layers.width - 90) / Math.max(east - west, 4),
                          (this.layers.height - 90) / Math.max(north - south, 4));
  }

  toPixel(x, y) {
    return [0.5 * this.layers.width + (x - this.middle[0]) * this.scale,
            0.5 * this.layers.height - (y - this.middle[1]) * this.scale];
  }

  toPlace(px, py) {
    return [this.middle[0] + (px - 0.5 * this.layers.width) / this.scale,
            this.middle[1] - (py - 0.5 * this.layers.height) / this.scale];
  }

  /** Zooms and keeps the place at that pixel where it is. */
  zoom(factor, px = 0.5 * this.layers.width, py = 0.5 * this.layers.height) {
    const before = this.toPlace(px, py);
    this.scale = Math.min(2000, Math.max(1e-4, this.scale * factor));
    const after = this.toPlace(px, py);
    this.middle = this.middle.map((value, i) => value + before[i] - after[i]);
    this.view.redraw();
  }

  refit() {
    this.scale = null;
    this.view.redraw();
  }

  listen() {
    const element = this.element;
    element.addEventListener("wheel", (event) => {
      event.preventDefault();
      const box = element.getBoundingClientRect();
      this.zoom(Math.exp(-0.0015 * event.deltaY), event.clientX - box.left, event.clientY - box.top);
    }, {passive: false});
    element.addEventListener("pointerdown", (event) => {
      if (event.target.closest("button")) return;
      element.setPointerCapture(event.pointerId);
      this.grip = [event.clientX, event.clientY];
    });
    element.addEventListener("pointermove", (event) => this.move(event));
    element.addEventListener("pointerup", () => { this.grip = null; });
    element.addEventListener("pointerleave", () => { if (!this.grip) this.view.point(null); });
    element.addEventListener("click", (event) => {
      const button = event.target.closest("button");
      if (!button) return;
      if (button.dataset.zoom === "fit") this.refit(); else this.zoom(Number(button.dataset.zoom));
    });
    element.addEventListener("keydown", (event) => {
      if (event.key === "+") this.zoom(1.5);
      if (event.key === "-") this.zoom(1 / 1.5);
      if (event.key === "0") this.refit();
    });
  }

  move(event) {
    if (this.grip) {
      this.middle[0] -= (event.clientX - this.grip[0]) / this.scale;
      this.middle[1] += (event.clientY - this.grip[1]) / this.scale;
      this.grip = [event.clientX, event.clientY];
      this.view.redraw();
      return;
    }
    const box = this.element.getBoundingClientRect();
    this.view.point(this.timeAt(event.clientX - box.left, event.clientY - box.top));
  }

  /** When the estimate in focus was nearest to a pixel, null where it never was near. */
  timeAt(px, py) {
    const run = this.view.data.runs[this.view.focus];
    const [x, y] = this.toPlace(px, py);
    let [best, time] = [(30 / this.scale) ** 2, null];
    for (let i = 0; i < run.t.length; ++i) {
      const off = (run.x[i] - x) ** 2 + (run.y[i] - y) ** 2;
      if (off < best) [best, time] = [off, run.t[i]];
    }
    return time;
  }

  draw() {
    if (this.scale === null) this.fit();
    const context = this.layers.fresh(this.layers.lower);
    const {view} = this;
    const {stream: {truth, fixes}, data: {runs}} = view;
    this.drawGrid(context);
    if (truth && view.shows("truth")) this.drawShadow(context, truth);
    if (view.shows("fixes")) this.drawFixes(context, fixes);
    if (truth && view.shows("truth")) this.drawTrack(context, truth, view.colour("truth"), 3);
    for (let i = runs.length - 1; i >= 0; --i) {
      if (view.shows(i)) this.drawTrack(context, runs[i], view.runColour(i), 1.8);
    }
    this.drawEnds(context, truth || runs[0]);
    this.drawScaleBar(context);
    this.drawNorth(context);
  }

  drawGrid(context) {
    const step = roundStep(90 / this.scale);
    const [west, north] = this.toPlace(0, 0);
    const [east, south] = this.toPlace(this.layers.width, this.layers.height);
    const {width, height} = this.layers;
    context.fillStyle = this.view.colour("grid");
    for (const x of multiples(west, east, step)) context.fillRect(Math.round(this.toPixel(x, 0)[0]), 0, 1, height);
    for (const y of multiples(south, north, step)) context.fillRect(0, Math.round(this.toPixel(0, y)[1]), width, 1);
  }

  /** The line of a track from one time to another, broken at pauses. */
  trace(context, track, from, to) {
    const pause = track.pause || (track.pause = longestPause(track.t));
    const end = Math.min(track.t.length, firstFrom(track.t, to) + 1);
    context.beginPath();
    for (let i = firstFrom(track.t, from), first = i; i < end; ++i) {
      const [x, y] = this.toPixel(track.x[i], track.y[i]);
      if (i === first || track.t[i] - track.t[i - 1] > pause) context.moveTo(x, y); else context.lineTo(x, y);
    }
    context.stroke();
  }

  /** A track faintly, and what of it lies in the stretch of time shown. */
  drawTrack(context, track, colour, width) {
    const {window: [from, to], data: {span}} = this.view;
    context.strokeStyle = colour;
    context.lineWidth = width;
    if (from > span[0] || to < span[1]) {
      context.globalAlpha = 0.2;
      this.trace(context, track, -Infinity, Infinity);
      context.globalAlpha = 1;
    }
    this.trace(context, track, from, to);
  }

  drawShadow(context, truth) {
    context.save();
    context.strokeStyle = this.view.colour("shade");
    context.lineWidth = 18;
    context.lineCap = "butt";
    for (const [begin, end] of truth.shadow) this.trace(context, truth, begin, end);
    context.restore();
  }

  drawFixes(context, fixes) {
    const [a, b] = this.view.window.map((time) => firstFrom(fixes.t, time));
    context.fillStyle = this.view.colour("fix");
    for (let i = a; i < Math.min(b + 1, fixes.t.length); ++i) {
      const [x, y] = this.toPixel(fixes.x[i], fixes.y[i]);
      context.fillRect(x - 1.25, y - 1.25, 2.5, 2.5);
    }
  }

  drawEnds(context, track) {
    const last = track.t.length - 1;
    for (const [i, text, below] of [[0, "start", -9], [last, "end", 11]]) {
      const [x, y] = this.toPixel(track.x[i], track.y[i]);
      context.beginPath();
      context.arc(x, y, 5, 0, 2 * Math.PI);
      context.fillStyle = this.view.colour(i === 0 ? "panel" : "ink");
      context.strokeStyle = this.view.colour("ink");
      context.lineWidth = 2;
      context.fill();
      context.stroke();
      this.text(context, text, x + 9, y + below, "left");
    }
  }

  /** Text that stays legible over tracks. */
  text(context, text, x, y, align) {
    context.textAlign = align;
    context.textBaseline = "middle";
    context.strokeStyle = this.view.colour("panel");
    context.lineWidth = 4;
    context.strokeText(text, x, y);
    context.fillStyle = this.view.colour("ink");
    context.fillText(text, x, y);
  }

  drawScaleBar(context) {
    const metres = roundStep(70 / this.scale);
    const [width, y] = [metres * this.scale, this.layers.height - 18];
    context.fillStyle = this.view.colour("ink");
    context.fillRect(16, y, width, 3);
    context.fillRect(16, y - 5, 1.5, 8);
    context.fillRect(16 + width - 1.5, y - 5, 1.5, 8);
    this.text(context, lengthText(metres), 16 + 0.5 * width, y - 12, "center");
  }

  drawNorth(context) {
    const [x, y] = [26, 34];
    context.fillStyle = this.view.colour("ink");
    context.beginPath();
    context.moveTo(x, y - 14);
    context.lineTo(x + 7, y + 8);
    context.lineTo(x, y + 3);
    context.lineTo(x - 7, y + 8);
    context.fill();
    this.text(context, "N", x, y + 19, "center");
  }

  drawCursor() {
    const context = this.layers.fresh(this.layers.upper);
    const {view} = this;
    if (view.cursor === null) return;
    const {stream: {truth}, data: {runs}} = view;
    if (truth && view.shows("truth")) this.drawSpot(context, truth, view.colour("truth"));
    runs.forEach((run, i) => {
      if (!view.shows(i)) return;
      const at = this.drawSpot(context, run, view.runColour(i));
      if (at >= 0 && i === view.focus) this.drawPose(context, run, at, view.runColour(i));
    });
  }

  /** A dot where a track was; its index. */
  drawSpot(context, track, colour) {
    const i = nearest(track.t, this.view.cursor, longestPause(track.t));
    if (i < 0) return i;
    context.fillStyle = colour;
    context.strokeStyle = this.view.colour("panel");
    context.lineWidth = 2;
    context.beginPath();
    context.arc(...this.toPixel(track.x[i], track.y[i]), 5.5, 0, 2 * Math.PI);
    context.fill();
    context.stroke();
    return i;
  }

  /** The 3 sigma ellipse and the heading. */
  drawPose(context, run, i, colour) {
    const [x, y] = this.toPixel(run.x[i], run.y[i]);
    const [middle, apart] = [0.5 * (run.xx[i] + run.yy[i]), Math.hypot(0.5 * (run.xx[i] - run.yy[i]), run.xy[i])];
    const axes = [middle + apart, middle - apart].map((variance) => 3 * this.scale * Math.sqrt(Math.max(variance, 0)));
    const turn = 0.5 * Math.atan2(2 * run.xy[i], run.xx[i] - run.yy[i]);
    context.strokeStyle = colour;
    context.lineWidth = 1.5;
    context.beginPath();
    context.ellipse(x, y, axes[0], axes[1], -turn, 0, 2 * Math.PI);
    context.moveTo(x, y);
    context.lineTo(x + 22 * Math.cos(run.yaw[i]), y - 22 * Math.sin(run.yaw[i]));
    context.stroke();
  }
}
