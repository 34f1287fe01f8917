"use strict";
// The state of each estimator as a coloured bar, with a red mark where its error was beyond its own 3 sigma.

const ROW = 30;

class StateChart extends TimePanel {
  constructor(view, parent) {
    const note = view.hasTruth ? "red below: error beyond its own 3 sigma" : "";
    super(view, parent, "State", note, MARGIN.top + MARGIN.bottom + ROW * view.data.runs.length);
    this.spans = view.data.runs.map((run) => spansOf(run));
    this.explain();
  }

  /** A key of the states there are. */
  explain() {
    const {states, runs} = this.view.data;
    const there = states.map((_, state) => runs.some((run) => run.state.includes(state)));
    for (const [state, name] of states.entries()) {
      if (!there[state]) continue;
      const item = document.createElement("span");
      item.appendChild(document.createElement("i")).style.background = `var(--state-${state})`;
      item.append(name.replace("_", " "));
      this.note.before(item);
    }
  }

  draw() {
    const context = this.layers.fresh(this.layers.lower);
    this.drawTime(context);
    context.save();
    context.beginPath();
    context.rect(0, 0, this.right, this.layers.height);
    context.clip();
    this.view.data.runs.forEach((run, i) => this.drawRun(context, run, i));
    context.restore();
  }

  drawRun(context, run, i) {
    const top = MARGIN.top + ROW * i + 3;
    for (const {state, begin, end} of this.spans[i]) {
      if (state === null) continue;
      const [from, to] = [Math.max(this.x(begin), MARGIN.left), this.x(end)];
      if (to <= from) continue;
      context.fillStyle = this.view.colour(`state-${state}`);
      context.fillRect(from, top, Math.max(to - from, 1), ROW - 10);
      this.label(context, state, from, Math.min(to, this.right), top);
    }
    context.fillStyle = this.view.colour("alarm");
    for (const [begin, end] of run.beyond) {
      const from = Math.max(this.x(begin), MARGIN.left);
      if (this.x(end) >= from) context.fillRect(from, top + ROW - 9, Math.max(this.x(end) - from, 2), 4);
    }
    context.fillStyle = this.view.runColour(i);
    context.fillRect(MARGIN.left - 14, top, 6, ROW - 10);
  }

  label(context, state, from, to, top) {
    const name = this.view.data.states[state].replace("_", " ");
    if (to - from < context.measureText(name).width + 10) return;
    context.fillStyle = [0, 1, 3].includes(state) ? "#1d222b" : "#ffffff";
    context.textAlign = "left";
    context.textBaseline = "middle";
    context.fillText(name, from + 5, top + 0.5 * (ROW - 10));
  }
}

/** Stretches of one state: {state, begin, end}; none over pauses. */
function spansOf(run) {
  const [pause, found] = [longestPause(run.t), []];
  for (let i = 0; i < run.t.length; ++i) {
    const last = found[found.length - 1];
    const goesOn = last && run.t[i] - last.end <= pause;
    if (goesOn) last.end = run.t[i];
    if (!goesOn || last.state !== run.state[i]) found.push({state: run.state[i], begin: run.t[i], end: run.t[i]});
  }
  return found;
}
