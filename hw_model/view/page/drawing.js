// SPDX-License-Identifier: Apache-2.0
// How rows of the timeline are drawn.
'use strict';

/** The context of a canvas of that size in CSS pixels, empty. */
function prepared(canvas, width, height) {
  const ratio = devicePixelRatio;
  canvas.style.height = `${height}px`;
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  const context = canvas.getContext('2d');
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.font = '11px system-ui, sans-serif';
  context.textBaseline = 'middle';
  return context;
}

/** 1, 2 or 5 times a power of ten, at least `least`. */
function roundStep(least) {
  const power = 10 ** Math.floor(Math.log10(Math.max(least, 1)));
  return [1, 2, 5, 10].map(k => k * power).find(step => step >= least);
}

function ticks({app, width}) {
  const step = roundStep(((app.to - app.from) * 90) / width), list = [];
  for (let date = Math.ceil(app.from / step) * step; date <= app.to; date += step) list.push(date);
  return list;
}

function drawGrid(timeline, context, top, height) {
  context.strokeStyle = theme.line;
  context.lineWidth = 1;
  context.beginPath();
  const every = date => {
    const x = Math.round(timeline.xOf(date)) + 0.5;
    context.moveTo(x, top);
    context.lineTo(x, top + height);
  };
  const {app, width} = timeline;
  if (width / (app.to - app.from) >= 6) {
    for (let date = Math.ceil(app.from); date <= app.to; ++date) every(date);
  } else {
    ticks(timeline).forEach(every);
  }
  context.stroke();
}

/** Of a run, at the beginning of its band. */
function drawName(context, name, {y, height}) {
  context.globalAlpha = 0.8;
  context.fillStyle = theme.panel;
  context.fillRect(0, y, 11, height);
  context.globalAlpha = 1;
  context.fillStyle = theme.ink;
  context.fillText(name, 1.5, y + height / 2 + 0.5);
}

/** The whole frame, the busiest units, with the part that is shown; below it the axis. */
function drawHeader(timeline, context) {
  const {app, width, end} = timeline, {model} = app;
  const members = model.run.units.flatMap((unit, k) => (unit.box === 'intersection_units' ? [k] : []));
  drawShares(context, model, members, {y: 0, height: OVERVIEW_HEIGHT - 4, width, from: 0, to: end});
  const left = (app.from / end) * width, right = Math.max((app.to / end) * width, left + 3);
  context.fillStyle = theme.panel;
  context.globalAlpha = 0.65;
  context.fillRect(0, 0, left, OVERVIEW_HEIGHT - 4);
  context.fillRect(right, 0, width - right, OVERVIEW_HEIGHT - 4);
  context.globalAlpha = 1;
  context.strokeStyle = theme.ink;
  context.lineWidth = 1.5;
  context.strokeRect(left + 0.75, 0.75, right - left - 1.5, OVERVIEW_HEIGHT - 5.5);
  context.fillStyle = theme.dim;
  context.strokeStyle = theme.line;
  context.beginPath();
  for (const date of ticks(timeline)) {
    const x = Math.round(timeline.xOf(date)) + 0.5;
    context.moveTo(x, HEADER_HEIGHT - 8);
    context.lineTo(x, HEADER_HEIGHT);
    const text = grouped(date), wide = context.measureText(text).width;
    context.fillText(text, Math.max(0, Math.min(x - wide / 2, width - wide)), HEADER_HEIGHT - 16);
  }
  context.stroke();
}

/** A column for each pixel of the screen: the shares of states, busy at the bottom. */
function drawShares(context, model, members, {y, height, width, from, to}) {
  const end = Math.min(to, model.cycles), per = (to - from) / width, columns = Math.ceil((end - from) / per);
  let before = [0, 0, 0, 0];
  for (const k of members) model.times[k].addUpTo(from, 1, before);
  for (let x = 0; x < columns; ++x) {
    const sums = [0, 0, 0, 0], date = Math.min(from + (x + 1) * per, end);
    for (const k of members) model.times[k].addUpTo(date, 1, sums);
    const all = (date - Math.min(from + x * per, end)) * members.length;
    let bottom = y + height;
    for (const state of [BUSY, STARVED, BLOCKED, IDLE]) {
      const part = all > 0 ? ((sums[state] - before[state]) / all) * height : 0;
      if (part > 0.01) {
        context.fillStyle = theme.states[state];
        context.fillRect(x, bottom - part, 1, part);
      }
      bottom -= part;
    }
    before = sums;
  }
}

/** Firing by firing, where there is room for them; else shares. */
function drawUnits(timeline, context, {model, members, y, height}) {
  const {app, width} = timeline, times = model.times[members[0]], {at, until, firings, subject} = times.unit;
  const first = countBelow(until, app.from), last = countBelow(at, app.to);
  if (members.length > 1 || (last - first) * 3 > width) {
    return drawShares(context, model, members, {y, height, width, from: app.from, to: app.to});
  }
  const rect = (state, from, to) => {
    if (!(to > from)) return 0;
    const x = Math.max(timeline.xOf(from), -2), right = Math.min(timeline.xOf(to), width + 2);
    context.fillStyle = theme.states[state];
    context.fillRect(x, y, Math.max(right - x - (right - x > 4 ? 1 : 0), 0.5), height);
    return right - Math.max(x, 0);
  };
  for (let n = first; n <= Math.min(last, firings); ++n) {
    const ready = n ? until[n - 1] : 0, state = times.stateBefore(n), waited = n < firings ? at[n] : model.cycles;
    const room = rect(state, ready, waited);
    if (room > 60 && state !== IDLE) label(timeline, context, STATES[state], Math.max(ready, app.from), room, y + height / 2, state === BLOCKED ? '#fff' : '#000');
    if (n === firings) break;
    const wide = rect(BUSY, at[n], until[n]);
    if (wide > 22) label(timeline, context, subjectText(times.unit, subject[n]), Math.max(at[n], app.from), wide, y + height / 2, '#000');
  }
}
const subjectText = (unit, subject) => (unit.about === 'nodes' ? `node ${subject}` : `ray ${subject}`);

function label(timeline, context, text, date, room, y, color) {
  const short = text.split(' ').at(-1), x = timeline.xOf(date) + 3;
  const fits = [text, short].find(one => context.measureText(one).width < room - 6);
  if (!fits) return;
  context.fillStyle = color;
  context.fillText(fits, x, y + 0.5);
}

/** An area of the mean, and a line of the most; of several FIFOs, those of all of them together. */
function drawFifos(timeline, context, {model, members, y, height}) {
  const {app, width} = timeline, per = (app.to - app.from) / width;
  const depth = model.run.fifos[members[0]].depth, end = Math.min(app.to, model.cycles);
  for (let x = 0; x < width; ++x) {
    const from = app.from + x * per, to = Math.min(from + per, end);
    if (from >= to) break;
    let mean = 0, most = 0;
    for (const k of members) {
      const fill = model.fills[k];
      mean += fill.mean(from, to) / members.length;
      most = Math.max(most, fill.max(Math.floor(from), to));
    }
    if (most === 0) continue;
    const top = level => Math.max((level / depth) * (height - 2), 0);
    context.fillStyle = theme.fill;
    context.fillRect(x, y + height - top(mean), 1, top(mean));
    context.fillStyle = theme.dim;
    context.fillRect(x, y + height - top(most) - 1, 1, 1.5);
  }
  context.fillStyle = theme.line;
  context.fillRect(0, y + height - 0.5, width, 0.5);
}

/** What the selected pixel took there, and the span that is selected. */
function drawMarks(timeline, context, {model, members, y, height}, kind) {
  const {app, width} = timeline;
  const mark = (from, to, strong) => {
    const x = timeline.xOf(from), right = Math.max(timeline.xOf(Math.min(to, model.cycles)), x + 2);
    if (right < 0 || x > width) return;
    if (kind === 'fifo') {
      context.fillStyle = theme.mark;
      context.fillRect(x, y + height - (strong ? 5 : 3), right - x, strong ? 5 : 3);
      return;
    }
    context.fillStyle = theme.mark;
    context.fillRect(x, y, right - x - (right - x > 4 ? 1 : 0), strong ? height : 4);
    if (strong) return;
    context.fillRect(x, y + height - 4, right - x - (right - x > 4 ? 1 : 0), 4);
  };
  for (const step of app.highlights(model)) {
    if (!members.includes(kind === 'unit' ? step.unit : step.fifo)) continue;
    mark(step.from, step.to, step.strong);
    if (!step.strong || kind === 'fifo') continue;
    const room = Math.min(timeline.xOf(step.to), width) - Math.max(timeline.xOf(step.from), 0);
    if (room > 22) label(timeline, context, step.text, Math.max(step.from, app.from), room, y + height / 2, '#000');
  }
  const {span} = app;
  if (!span || span.model !== model || kind !== 'unit' || !members.includes(span.unit) || members.length > 1) return;
  const x = timeline.xOf(span.from), right = Math.max(timeline.xOf(span.to), x + 3);
  context.strokeStyle = theme.ink;
  context.lineWidth = 2;
  context.strokeRect(x + 1, y + 1, right - x - 2, height - 2);
}

/** How much busier B is than A, above the line in one colour, or below it in the other. */
function drawDifference(timeline, context, row) {
  const [a, b] = timeline.app.models, {app, width} = timeline, per = (app.to - app.from) / width;
  const top = 34, height = 10, middle = top + height / 2;
  context.fillStyle = theme.line;
  context.fillRect(0, middle - 0.25, width, 0.5);
  const share = (model, members, from, to) => {
    const end = Math.min(to, model.cycles);
    return members.length && from < end ? timeline.shares(model, members, from, end)[BUSY] / (to - from) : 0;
  };
  for (let x = 0; x < width; x += 2) {
    const from = app.from + x * per, to = from + 2 * per;
    const more = share(b, row.members[1], from, to) - share(a, row.members[0], from, to);
    if (Math.abs(more) < 0.005) continue;
    context.fillStyle = more > 0 ? theme.more : theme.less;
    const size = Math.max(Math.abs(more) * (height / 2), 0.75);
    context.fillRect(x, more > 0 ? middle - size : middle, 2, size);
  }
}
