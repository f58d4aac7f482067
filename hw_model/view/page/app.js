// SPDX-License-Identifier: Apache-2.0
// What is shown and selected, and what follows from it.
'use strict';

/** A run with what is worked out of it. */
class Model {
  constructor(run) {
    this.run = run;
    this.cycles = run.header.cycles;
    this.times = run.units.map((_, k) => new UnitTime(run, k));
    this.fills = run.fifos.map((_, k) => new FifoFill(run, k));
    this.pixels = new Pixels(run);
    let sum = 0, count = 0, max = 0;
    for (let pixel = 0; pixel < this.pixels.count; ++pixel) {
      const latency = this.pixels.latency(pixel);
      if (Number.isNaN(latency)) continue;
      sum += latency;
      count += 1;
      max = Math.max(max, latency);
    }
    this.latencies = {mean: sum / count, max};
  }
}

class App {
  constructor(models) {
    this.models = models;
    this.active = 0;
    this.from = 0;
    this.to = Math.max(...models.map(model => model.cycles));
    this.pixel = -1;
    this.unit = models[0].run.units.findIndex(unit => unit.box === 'intersection_units');
    this.map = 'picture';
    // Whether pixels of one number are one pixel.
    this.comparable = models.every(({pixels: {window}}) => ['x', 'y', 'columns', 'rows'].every(key => window[key] === models[0].pixels.window[key]));
    this.finds = findsOf(this);
    const place = id => document.getElementById(id);
    this.picture = new PictureView(this, place('picture'), place('legend'));
    this.timeline = new Timeline(this, place('header'), place('labels'), place('rows'));
    this.pixelPanel = new PixelPanel(this, place('pixel'));
    this.showMaps(place('maps'));
    this.showTabs();
    this.selected();
  }
  get model() {
    return this.models[this.active];
  }

  say(text) {
    document.getElementById('readout').textContent = text || this.shownText();
  }
  shownText() {
    const [from, to] = [Math.floor(this.from), Math.ceil(this.to)];
    return `Shown: ${spanText(from, to)}, ${cyclesText(to - from)}`;
  }

  /** Draws with the next frame of the screen. */
  changed() {
    if (this.drawing) return;
    this.drawing = requestAnimationFrame(() => {
      this.drawing = undefined;
      this.timeline.draw();
      this.say('');
    });
  }
  /** After what is selected has changed. */
  selected() {
    this.marks = new Map();
    this.pixelPanel.show();
    selectionPanel(this, document.getElementById('selection'));
    summary(this, document.getElementById('summary'));
    this.picture.draw();
    this.changed();
  }

  activate(run) {
    this.active = run;
    this.subject = this.span = this.fifo = undefined;
    this.unit = this.model.run.units.findIndex(unit => unit.box === 'intersection_units');
    if (!this.comparable) this.pixel = -1;
    this.finds = findsOf(this);
    this.showTabs();
    this.selected();
  }

  selectPixel(pixel, reveals = false) {
    this.pixel = pixel;
    this.subject = this.span = this.fifo = undefined;
    const {admitted, finished} = this.model.pixels, end = Number.isNaN(finished[pixel]) ? this.model.cycles : finished[pixel];
    this.selected();
    if (!Number.isNaN(admitted[pixel]) && (reveals || this.to < admitted[pixel] || this.from > end)) {
      this.timeline.reveal(admitted[pixel], end, 0);
    }
  }
  /** -1: none. */
  pixelOf({ray, node}) {
    return ray === undefined ? this.model.pixels.ofNode(node) : this.model.pixels.ofRay(ray);
  }
  /** Steps of a ray or node. */
  wayOf({ray, node}) {
    return ray === undefined ? this.model.pixels.wayOfNode(node) : this.model.pixels.wayOfRay(ray);
  }
  /** Brings the selected ray or node into view, closer than `most` cycles. */
  revealSubject(most) {
    const steps = this.wayOf(this.subject);
    if (steps.length) this.timeline.reveal(steps[0].from, Math.min(steps.at(-1).to, this.model.cycles), most);
  }
  selectSubject(subject) {
    this.subject = subject;
    this.span = undefined;
    this.pixel = this.pixelOf(subject);
    this.selected();
    this.revealSubject(Infinity);
    this.pixelPanel.reveal();
  }
  selectSpan(model, unit, span, reveals = false) {
    if (model !== this.model) this.activate(this.models.indexOf(model));
    this.unit = unit;
    const its = model.run.units[unit];
    this.span = {...span, model, unit, cause: span.firing < its.firings ? its.cause[span.firing] - 1 : -1};
    this.fifo = undefined;
    this.subject = undefined;
    if (span.firing < its.firings && span.state !== IDLE && its.subject[span.firing] >= 0) {
      this.subject = {[its.about === 'nodes' ? 'node' : 'ray']: its.subject[span.firing]};
      this.pixel = this.pixelOf(this.subject);
    }
    this.selected();
    if (reveals) this.timeline.reveal(span.from, span.to);
    this.pixelPanel.reveal();
  }
  selectFifo(model, number, date) {
    if (model !== this.model) this.activate(this.models.indexOf(model));
    this.fifo = {number, date};
    this.span = this.subject = undefined;
    this.selected();
  }
  selectRow(row) {
    if (row.kind !== 'unit') return;
    const run = row.members.findIndex(members => members.length > 0);
    if (!row.members[this.active].length) this.activate(run);
    this.unit = row.members[this.active][0];
    this.changed();
  }
  clear() {
    this.pixel = -1;
    this.subject = this.span = this.fifo = undefined;
    this.selected();
  }

  /** Steps of the selected pixel in units and FIFOs; those of the selected ray or node are strong. */
  highlights(model) {
    if (model !== this.model && (this.pixel < 0 || !this.comparable)) return [];
    if (this.pixel < 0 && this.subject?.ray === undefined) return [];
    if (!this.marks.has(model)) this.marks.set(model, this.stepsOfPixel(model));
    return this.marks.get(model);
  }
  stepsOfPixel(model) {
    const {pixels} = model, {subject} = this, steps = [];
    const add = (way, text, strong) => {
      for (const {unit, fifo, from, to, waits} of way) {
        if (waits) continue;
        const until = unit === undefined ? to : model.run.units[unit].until[countBelow(model.run.units[unit].at, from)];
        steps.push({unit, fifo, from, to: until ?? to, text, strong});
      }
    };
    const same = (kind, number) => subject !== undefined && model === this.model && subject[kind] === number;
    const rays = this.pixel < 0 ? [subject.ray] : pixels.raysOf(this.pixel);
    for (const ray of rays) add(pixels.wayOfRay(ray), `ray ${ray}`, same('ray', ray));
    for (const node of this.pixel < 0 ? [] : pixels.nodesOf(this.pixel)) add(pixels.wayOfNode(node), `node ${node}`, same('node', node));
    return steps.sort((a, b) => a.strong - b.strong);
  }

  pixelText(pixel) {
    const {pixels, run} = this.model, [row, column] = pixels.placeOf(pixel), nodes = pixels.nodesOf(pixel);
    const latency = pixels.latency(pixel), top = nodes.length ? CASES[run.nodes.which[pixels.topOf(pixel)]] : 'not classified';
    return `Row ${row}, column ${column}: ${top}, ${grouped(pixels.rays[pixel])} own ray${pixels.rays[pixel] === 1 ? '' : 's'}, ` +
           `${Number.isNaN(latency) ? 'not finished' : cyclesText(latency)}`;
  }
  hitText({row, model, number, date}) {
    if (date >= model.cycles) return '';
    if (number === undefined) return row.count ? `${row.name}: click to open or close` : '';
    const run = this.models.length > 1 ? `${'AB'[this.models.indexOf(model)]} ` : '';
    if (row.kind === 'fifo') {
      return `${run}${row.name}, cycle ${grouped(date)}: ${model.fills[number].at(date)} of ${model.run.fifos[number].depth} tokens`;
    }
    const span = model.times[number].spanAt(date), unit = model.run.units[number];
    const about = span.state === BUSY ? ` with ${subjectText(unit, unit.subject[span.firing])}` :
        span.state === IDLE ? '' : `, waits for ${shortName(model.run.fifos[unit.cause[span.firing] - 1].name)}`;
    return `${run}${row.name}: ${STATES[span.state]}${about}, ${spanText(span.from, span.to)} (${cyclesText(span.to - span.from)})`;
  }

  showMaps(place) {
    for (const [map, {name}] of Object.entries(MAPS)) {
      if (map === 'difference' && !(this.models.length > 1 && this.comparable)) continue;
      place.append(element('label', {}, element('input', {type: 'radio', name: 'map', value: map, checked: map === this.map, onchange: () => {
        this.map = map;
        this.picture.draw();
      }}), name));
    }
  }
  showTabs() {
    document.getElementById('tab-find').replaceChildren(findPanel(this));
    document.getElementById('tab-units').replaceChildren(unitTable(this));
    document.getElementById('tab-fifos').replaceChildren(fifoTable(this));
  }
}
