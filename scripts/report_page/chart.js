"use strict";
// Panels over time. A panel has a plot with the time as its horizontal axis; pointers and keys move the time pointed at.

const MARGIN = {left: 58, right: 14, top: 10, bottom: 24};

class TimePanel {
  constructor(view, parent, title, note, height) {
    this.view = view;
    const figure = parent.appendChild(document.createElement("figure"));
    const caption = figure.appendChild(document.createElement("figcaption"));
    caption.appendChild(document.createElement("b")).textContent = title;
    this.note = caption.appendChild(document.createElement("span"));
    this.note.textContent = note;
    this.element = figure.appendChild(document.createElement("div"));
    this.element.className = "plot";
    this.element.style.height = `${height}px`;
    this.layers = new Layers(this.element);
    this.brush = null;  // where a drag began, and where it is
    this.listen();
    view.add(this);
  }

  get right() {
    return this.layers.width - MARGIN.right;
  }

  get bottom() {
    return this.layers.height - MARGIN.bottom;
  }

  x(time) {
    const [from, to] = this.view.window;
    return MARGIN.left + (time - from) / (to - from || 1) * (this.right - MARGIN.left);
  }

  time(x) {
    const [from, to] = this.view.window;
    const part = (x - MARGIN.left) / (this.right - MARGIN.left);
    return from + Math.min(1, Math.max(0, part)) * (to - from);
  }

  listen() {
    const plot = this.element;
    plot.addEventListener("pointermove", (event) => {
      if (this.brush) this.brush[1] = this.time(event.offsetX);
      this.view.point(this.time(event.offsetX));
    });
    plot.addEventListener("pointerdown", (event) => {
      if (event.pointerType === "mouse") plot.setPointerCapture(event.pointerId);
      this.brush = [this.time(event.offsetX), this.time(event.offsetX)];
    });
    plot.addEventListener("pointerup", () => this.endBrush());
    plot.addEventListener("pointercancel", () => { this.brush = null; });
    plot.addEventListener("pointerleave", () => { if (!this.brush) this.view.point(null); });
    plot.addEventListener("dblclick", () => this.view.zoomOut());
  }

  endBrush() {
    if (!this.brush) return;
    const [from, to] = this.brush;
    this.brush = null;
    const pixels = Math.abs(this.x(to) - this.x(from));
    if (pixels > 4) this.view.zoomTo(Math.min(from, to), Math.max(from, to)); else this.view.redraw(true);
  }

  /** Where fixes are biased, and the axis of time. */
  drawTime(context) {
    const {view, bottom, right} = this;
    const [from, to] = view.window;
    context.save();
    context.beginPath();
    context.rect(MARGIN.left, MARGIN.top, right - MARGIN.left, bottom - MARGIN.top);
    context.clip();
    context.fillStyle = view.colour("shade");
    for (const [begin, end] of view.stream.truth ? view.stream.truth.shadow : []) {
      context.fillRect(this.x(begin), MARGIN.top, this.x(end) - this.x(begin), bottom - MARGIN.top);
    }
    context.restore();
    context.fillStyle = view.colour("quiet");
    context.textAlign = "center";
    context.textBaseline = "top";
    for (const tick of timeTicks(from, to, Math.max(2, (right - MARGIN.left) / 90))) {
      context.fillRect(this.x(tick), bottom, 1, 4);
      if (this.x(tick) < right - 28) context.fillText(timeText(tick, to), this.x(tick), bottom + 7);
    }
    context.textAlign = "right";
    context.fillText(timeUnit(to), right + 10, bottom + 7);
  }

  drawCursor() {
    const context = this.layers.fresh(this.layers.upper);
    const {view, bottom} = this;
    if (this.brush) {
      const [a, b] = this.brush.map((time) => this.x(time));
      context.fillStyle = view.colour("shade");
      context.fillRect(Math.min(a, b), MARGIN.top, Math.abs(b - a), bottom - MARGIN.top);
    }
    const [from, to] = view.window;
    if (view.cursor === null || view.cursor < from || view.cursor > to) return;
    context.fillStyle = view.colour("accent");
    context.fillRect(Math.round(this.x(view.cursor)), MARGIN.top, 1, bottom - MARGIN.top);
    this.drawValues(context);
  }

  drawValues() {}
}

/** Lines, dots and a band. `layers()` gives a list of {kind, t, y, colour, top, ...}: `top` is the share of its values that
 * has to be in sight. `axis`: unit, from (the least value shown), logarithmic, symmetric, level (a line across). */
class LineChart extends TimePanel {
  constructor(view, parent, title, note, axis, layers) {
    super(view, parent, title, note, axis.height || 190);
    this.axis = axis;
    this.series = layers;
  }

  get logarithmic() {
    return this.axis.logarithmic || (this.axis.togglable && this.view.logarithmic);
  }

  inSight(layer) {
    const [a, b] = this.view.window.map((time) => firstFrom(layer.t, time));
    return layer.y.slice(a, b + 1).filter((value) => value !== null);
  }

  /** [lowest, highest] value shown of what lies in the stretch of time shown. */
  range(shown) {
    let [low, high] = [Infinity, -Infinity];
    for (const layer of shown) {
      const values = this.inSight(layer);
      if (values.length === 0 || layer.top === 0) continue;
      high = Math.max(high, quantile(values, layer.top));
      low = Math.min(low, quantile(values, this.logarithmic ? 0.02 : 1 - layer.top));
    }
    if (high === -Infinity) [low, high] = [0, 1];
    if (this.axis.level) high = Math.max(high, this.axis.level);
    if (this.logarithmic) return [Math.max(1e-3, Math.min(low, high / 10)) / 1.3, Math.max(high, 1e-2) * 1.4];
    if (this.axis.symmetric) high = Math.max(high, -low);
    const margin = 0.08 * Math.max(high, 1e-3);
    if (this.axis.symmetric) return [-high - margin, high + margin];
    return [Math.min(this.axis.from, low < 0 ? low - margin : this.axis.from), high + margin];
  }

  y(value) {
    const [low, high] = this.shown;
    const part = this.logarithmic
      ? Math.log(Math.max(value, 1e-9) / low) / Math.log(high / low)
      : (value - low) / (high - low);
    return this.bottom - part * (this.bottom - MARGIN.top);
  }

  draw() {
    const context = this.layers.fresh(this.layers.lower);
    const layers = this.series();
    this.shown = this.range(layers);
    this.drawGrid(context);
    this.drawTime(context);
    context.save();
    context.beginPath();
    context.rect(MARGIN.left, MARGIN.top, this.right - MARGIN.left, this.bottom - MARGIN.top);
    context.clip();
    for (const layer of layers) this[layer.kind](context, layer);
    if (this.axis.level) this.level(context);
    context.restore();
  }

  drawGrid(context) {
    const [low, high] = this.shown;
    const most = Math.max(5, (this.bottom - MARGIN.top) / 32);
    context.textAlign = "right";
    context.textBaseline = "middle";
    for (const tick of this.logarithmic ? logTicks(low, high) : linearTicks(low, high, most)) {
      context.fillStyle = this.view.colour("grid");
      context.fillRect(MARGIN.left, Math.round(this.y(tick)), this.right - MARGIN.left, 1);
      context.fillStyle = this.view.colour("quiet");
      context.fillText(tickText(tick), MARGIN.left - 7, this.y(tick));
    }
    context.save();
    context.translate(13, 0.5 * (MARGIN.top + this.bottom));
    context.rotate(-0.5 * Math.PI);
    context.textAlign = "center";
    context.fillText(this.axis.unit, 0, 0);
    context.restore();
  }

  /** Traces the line, broken at pauses and where there is no value. */
  trace(context, layer) {
    const pause = layer.pause || (layer.pause = longestPause(layer.t));
    let last = -Infinity;
    context.beginPath();
    for (let i = 0; i < layer.t.length; ++i) {
      if (layer.y[i] === null) { last = -Infinity; continue; }
      const [x, y] = [this.x(layer.t[i]), this.y(layer.y[i])];
      if (layer.t[i] - last > pause) context.moveTo(x, y); else context.lineTo(x, y);
      last = layer.t[i];
    }
  }

  line(context, layer) {
    context.strokeStyle = layer.colour;
    context.lineWidth = layer.width || 1.5;
    this.trace(context, layer);
    context.stroke();
  }

  dots(context, layer) {
    context.fillStyle = layer.colour;
    const [a, b] = this.view.window.map((time) => firstFrom(layer.t, time));
    for (let i = a; i < Math.min(b + 1, layer.t.length); ++i) {
      const used = !layer.used || layer.used[i];
      const [x, y] = [this.x(layer.t[i]), Math.max(this.y(layer.y[i]), MARGIN.top + 1)];
      if (used) context.fillRect(x - 1.25, y - 1.25, 2.5, 2.5); else this.cross(context, x, y, layer.colour);
    }
  }

  cross(context, x, y, colour) {
    context.strokeStyle = colour;
    context.lineWidth = 1.2;
    context.beginPath();
    context.moveTo(x - 3, y - 3);
    context.lineTo(x + 3, y + 3);
    context.moveTo(x - 3, y + 3);
    context.lineTo(x + 3, y - 3);
    context.stroke();
  }

  /** From the axis up to the values; bars as wide as their time, so that pauses stay empty. */
  band(context, layer) {
    context.save();
    context.globalAlpha = 0.2;
    context.fillStyle = layer.colour;
    const pause = layer.pause || (layer.pause = longestPause(layer.t));
    context.beginPath();
    for (let i = 0; i < layer.t.length; ++i) {
      const begins = i === 0 || layer.t[i] - layer.t[i - 1] > pause;
      const ends = i + 1 === layer.t.length || layer.t[i + 1] - layer.t[i] > pause;
      const [x, y] = [this.x(layer.t[i]), this.y(layer.y[i])];
      if (begins) context.moveTo(x, this.bottom);
      context.lineTo(x, y);
      if (ends) context.lineTo(x, this.bottom);
    }
    context.fill();
    context.restore();
    this.line(context, {...layer, width: 0.8});
  }

  level(context) {
    context.setLineDash([5, 4]);
    context.strokeStyle = this.view.colour("quiet");
    context.lineWidth = 1;
    context.beginPath();
    context.moveTo(MARGIN.left, this.y(this.axis.level));
    context.lineTo(this.right, this.y(this.axis.level));
    context.stroke();
    context.setLineDash([]);
  }

  drawValues(context) {
    for (const layer of this.series()) {
      if (layer.kind !== "line") continue;
      const i = nearest(layer.t, this.view.cursor, longestPause(layer.t));
      if (i < 0 || layer.y[i] === null) continue;
      const y = this.y(layer.y[i]);
      if (y < MARGIN.top || y > this.bottom) continue;
      context.fillStyle = layer.colour;
      context.beginPath();
      context.arc(this.x(layer.t[i]), y, 3.5, 0, 2 * Math.PI);
      context.fill();
    }
  }
}
