"use strict";
// Puts the page together.

const NIS_95 = 5.991;  // of 2 degrees of freedom

/** Charts as lists of layers of what is not hidden; runs from the last to the first, which lies on top. */
class ChartLayers {
  constructor(view) {
    this.view = view;
  }

  ofRuns(make) {
    const {view} = this;
    const found = [];
    for (let i = view.data.runs.length - 1; i >= 0; --i) {
      const layer = view.shows(i) ? make(view.data.runs[i]) : null;
      if (layer && layer.t.length > 0) found.push({...layer, colour: view.runColour(i)});
    }
    return found;
  }

  band() {
    const {view} = this;
    const run = view.data.runs[view.focus];
    if (!view.shows(view.focus)) return [];
    return [{kind: "band", t: run.t, y: run.sigma3, top: 0.97, colour: view.runColour(view.focus)}];
  }

  errors() {
    const {view} = this;
    const {t, error} = view.stream.fix_errors;
    const fixes = {kind: "dots", t, y: error, top: 0.9, colour: view.colour("fix")};
    return [...this.band(), ...(view.shows("fixes") ? [fixes] : []), ...this.ofRuns((run) => ({kind: "line", t: run.t, y: run.error, top: 0.998}))];
  }

  distances() {
    return [...this.band(), ...this.ofRuns(
      (run) => ({kind: "dots", t: run.distances.t, y: run.distances.error, top: 0.99}))];
  }

  nis() {
    return this.ofRuns((run) => ({kind: "dots", t: run.nis.t, y: run.nis.nis, used: run.nis.used, top: 1}));
  }

  headings() {
    return this.ofRuns((run) => ({kind: "line", t: run.headings.t, y: run.headings.error, top: 0.98}));
  }

  speeds() {
    const {view} = this;
    const {odometry, truth} = view.stream;
    const found = [];
    if (odometry.t.length > 0) {
      found.push({kind: "line", t: odometry.t, y: odometry.speed, top: 0.999, colour: view.colour("fix"), width: 1});
    }
    found.push(...this.ofRuns((run) => ({kind: "line", t: run.speeds.t, y: run.speeds.speed, top: 0.98, width: 1.2})));
    if (truth && view.shows("truth") && truth.speeds.t.length > 0) {
      const {t, speed} = truth.speeds;
      found.push({kind: "line", t, y: speed, top: 0.999, colour: view.colour("truth"), width: 1.4});
    }
    return found;
  }
}

function addCharts(view, parent) {
  const layers = new ChartLayers(view);
  const {runs} = view.data;
  const shadow = view.data.streams.some(({truth}) => truth !== null && truth.shadow.length > 0);
  const shaded = shadow ? "; grey: where they are biased" : "";
  const error = {unit: "m", from: 0, togglable: true, height: 260};
  if (view.hasTruth) {
    const note = `distance from the truth; band: the 3 sigma it claims; dots: fixes${shaded}`;
    new LineChart(view, parent, "Position error", note, error, () => layers.errors());
  } else {
    new LineChart(view, parent, "Distance to the fixes", "from the estimate; band: the 3 sigma it claims",
                  error, () => layers.distances());
  }
  if (runs.some((run) => run.state.some((state) => state !== null))) new StateChart(view, parent);
  if (runs.some((run) => run.nis.t.length > 0)) {
    const note = "innovation squared over its variance; 95 % should lie below the line; cross: not used";
    new LineChart(view, parent, "NIS", note,
                  {unit: "", from: 0, logarithmic: true, level: NIS_95, height: 170}, () => layers.nis());
  }
  if (runs.some((run) => run.headings.t.length > 0)) {
    new LineChart(view, parent, "Heading error", "", {unit: "deg", from: 0, symmetric: true, height: 150},
                  () => layers.headings());
  }
  const note = `of ${view.hasTruth ? "truth and " : ""}estimate over ground within a second; grey: odometry`;
  new LineChart(view, parent, "Speed", note, {unit: "m/s", from: 0, height: 160}, () => layers.speeds());
}

/** A button for each track, which hides it or shows it. */
function addLegend(view, parent) {
  const add = (what, name, colour, dot, title) => {
    const button = parent.appendChild(document.createElement("button"));
    button.type = "button";
    button.title = title;
    button.setAttribute("aria-pressed", "true");
    const mark = button.appendChild(document.createElement("i"));
    mark.style.background = `var(--${colour})`;
    if (dot) mark.className = "dot";
    button.append(name);
    button.addEventListener("click", () => {
      if (view.shows(what)) view.hidden.add(what); else view.hidden.delete(what);
      button.setAttribute("aria-pressed", String(view.shows(what)));
      view.redraw();
    });
  };
  if (view.hasTruth) add("truth", "truth", "truth", false, "Hide or show the truth");
  if (view.stream.fixes.t.length > 0) add("fixes", "fixes", "fix", true, "Hide or show the fixes");
  view.data.runs.forEach((run, i) => {
    add(i, run.name, `run-${i % 8}`, false, "Hide or show it");
  });
  if (view.data.runs.length > 1) addChoice(view, parent);
}

/** Whose 3 sigma are drawn and, where each run had a way of its own, whose truth and fixes. */
function addChoice(view, parent) {
  const label = parent.appendChild(document.createElement("label"));
  label.append(view.data.streams.length > 1 ? "3 sigma, truth, fixes of " : "3 sigma of ");
  const choice = label.appendChild(document.createElement("select"));
  view.data.runs.forEach((run, i) => choice.add(new Option(run.name, i)));
  choice.addEventListener("change", () => {
    view.focus = Number(choice.value);
    view.redraw();
  });
}

/** The values of each estimator at the time pointed at. */
class Readout {
  constructor(view, element) {
    this.view = view;
    this.element = element;
    view.add(this);
  }

  draw() {}

  drawCursor() {
    const {view, element} = this;
    if (view.cursor === null) {
      element.textContent = "Point at a chart or at the track to read values. Drag in a chart to look closer, double-click " +
        "to see all again; on the map drag and turn the wheel.";
      return;
    }
    const table = document.createElement("table");
    const caption = table.createCaption();
    caption.textContent = `${valueText(view.cursor, 1)} s${this.ofTruth()}`;
    const head = ["", "state", view.hasTruth ? "error m" : "to fix m", "3 sigma m", "NIS", "m/s", "x, y m"];
    this.row(table.createTHead(), head, "th");
    const body = table.createTBody();
    view.data.runs.forEach((run, i) => { if (view.shows(i)) this.row(body, this.valuesOf(run), "td", `run-${i % 8}`); });
    element.replaceChildren(table);
  }

  ofTruth() {
    const {truth, odometry} = this.view.stream;
    const odometrySpeed = this.at(odometry, "speed", 1);
    const trueSpeed = truth ? this.at(truth.speeds, "speed", 2) : null;
    return (trueSpeed === null ? "" : `, truth ${valueText(trueSpeed)} m/s`) +
      (odometrySpeed === null ? "" : `, odometry ${valueText(odometrySpeed)} m/s`);
  }

  /** A value near the time pointed at, null where there is none. */
  at(columns, key, longest) {
    const i = nearest(columns.t, this.view.cursor, longest);
    return i < 0 ? null : columns[key][i];
  }

  valuesOf(run) {
    const near = longestPause(run.t);
    const state = this.at(run, "state", near);
    const off = this.view.hasTruth ? this.at(run, "error", near) : this.at(run.distances, "error", 2);
    const place = [this.at(run, "x", near), this.at(run, "y", near)].map((value) => valueText(value, 1));
    return [run.name, state === null ? "–" : this.view.data.states[state].replace("_", " "), valueText(off),
            valueText(this.at(run, "sigma3", near)), valueText(this.at(run.nis, "nis", 2), 1),
            valueText(this.at(run.speeds, "speed", 2)), place.join(", ")];
  }

  row(parent, cells, kind, colour) {
    const row = parent.insertRow();
    cells.forEach((text, i) => {
      const cell = row.appendChild(document.createElement(i === 0 ? "th" : kind));
      if (i === 0 && colour) cell.appendChild(document.createElement("i")).style.background = `var(--${colour})`;
      cell.append(text);
    });
  }
}

function addTools(view) {
  const root = document.documentElement;
  const dark = window.matchMedia("(prefers-color-scheme: dark)");
  const wear = (theme) => { root.dataset.theme = theme; view.redraw(); };
  dark.addEventListener("change", () => wear(dark.matches ? "dark" : "light"));
  wear(dark.matches ? "dark" : "light");
  const button = (id, action) => document.getElementById(id).addEventListener("click", action);
  button("theme", () => wear(root.dataset.theme === "dark" ? "light" : "dark"));
  button("whole", () => view.zoomOut());
  const scale = (logarithmic) => {
    view.logarithmic = logarithmic;
    document.getElementById("scale").setAttribute("aria-pressed", String(logarithmic));
    view.redraw();
  };
  button("scale", () => scale(!view.logarithmic));
  scale(farApart(view.data.runs));
}

/** Whether one estimator is that much farther off than another that only a logarithmic scale shows both. */
function farApart(runs) {
  const sizes = runs.map((run) => run.error.filter((error) => error !== null)).filter((errors) => errors.length > 0)
    .map((errors) => quantile(errors, 0.9));
  return Math.max(...sizes) > 15 * Math.min(...sizes);
}

/** Arrow keys move the time pointed at, by a hundredth of the stretch shown. */
function addKeys(view, element) {
  element.addEventListener("keydown", (event) => {
    const [from, to] = view.window;
    const step = {ArrowLeft: -0.01, ArrowRight: 0.01}[event.key];
    if (event.key === "Escape") view.zoomOut();
    if (step === undefined) return;
    event.preventDefault();
    const start = view.cursor === null ? from : view.cursor;
    view.point(Math.min(to, Math.max(from, start + step * (to - from))));
  });
}

const view = new View(JSON.parse(document.getElementById("run").textContent));
addLegend(view, document.getElementById("legend"));
new TrackMap(view, document.getElementById("map"));
addCharts(view, document.getElementById("charts"));
new Readout(view, document.getElementById("readout"));
addKeys(view, document.getElementById("charts"));
addTools(view);
