"use strict";
// What the map and the charts share: the data, the stretch of time shown, the time pointed at, and what is hidden.

class View {
  constructor(data) {
    this.data = data;
    this.window = [...data.span];
    this.cursor = null;
    this.focus = 0;  // whose 3 sigma, truth and fixes are drawn
    this.hidden = new Set();  // "truth", "fixes", numbers of runs
    this.logarithmic = false;
    this.panels = [];
    this.pending = null;
  }

  add(panel) {
    this.panels.push(panel);
    new ResizeObserver(() => this.redraw()).observe(panel.element);
  }

  /** What the run in focus went over: truth, fixes and odometry. */
  get stream() {
    return this.data.streams[this.data.runs[this.focus].stream];
  }

  get hasTruth() {
    return this.data.streams[0].truth !== null;
  }

  /** Draws all at the next frame; with `cursorAlone` what follows the pointer. */
  redraw(cursorAlone = false) {
    const known = this.pending;
    this.pending = known === "all" || !cursorAlone ? "all" : "cursor";
    if (known === null) requestAnimationFrame(() => this.draw());
  }

  draw() {
    const all = this.pending === "all";
    this.pending = null;
    this.style = getComputedStyle(document.documentElement);
    for (const panel of this.panels) {
      if (all) panel.draw();
      panel.drawCursor();
    }
  }

  colour(name) {
    return this.style.getPropertyValue(`--${name}`).trim();
  }

  runColour(i) {
    return this.colour(`run-${i % 8}`);
  }

  shows(what) {
    return !this.hidden.has(what);
  }

  point(time) {
    this.cursor = time;
    this.redraw(true);
  }

  zoomTo(from, to) {
    const [first, last] = this.data.span;
    const least = Math.min(0.5, last - first);
    if (to - from < least) return;
    this.window = [Math.max(first, from), Math.min(last, to)];
    this.redraw();
  }

  zoomOut() {
    this.window = [...this.data.span];
    this.redraw();
  }
}

/** Two canvases over one another in an element, the upper one for what follows the pointer. */
class Layers {
  constructor(element) {
    this.element = element;
    this.lower = element.appendChild(document.createElement("canvas"));
    this.upper = element.appendChild(document.createElement("canvas"));
  }

  get width() {
    return this.element.clientWidth;
  }

  get height() {
    return this.element.clientHeight;
  }

  /** A context to draw with in CSS pixels, emptied. */
  fresh(canvas) {
    const ratio = window.devicePixelRatio || 1;
    const [width, height] = [Math.round(this.width * ratio), Math.round(this.height * ratio)];
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, {width, height});
    const context = canvas.getContext("2d");
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, this.width, this.height);
    context.font = "12px system-ui, 'DejaVu Sans', sans-serif";
    context.lineJoin = "round";
    return context;
  }
}
