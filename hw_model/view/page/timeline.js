// SPDX-License-Identifier: Apache-2.0
// The machine's time: a row for each unit and FIFO, from the whole frame to single cycles.
'use strict';

const LEAST_CYCLES = 8;  // that can be shown
const UNIT_HEIGHT = 22, FIFO_HEIGHT = 18, HEADER_HEIGHT = 50, OVERVIEW_HEIGHT = 24;

class Timeline {
  constructor(app, header, labels, canvas) {
    Object.assign(this, {app, header, labels, canvas});
    this.rows = new Rows(app.models);
    this.end = Math.max(...app.models.map(model => model.cycles));
    canvas.addEventListener('wheel', event => this.wheel(event), {passive: false});
    this.followPointers();
    header.addEventListener('pointerdown', event => this.jump(event));
    header.addEventListener('pointermove', event => event.buttons && this.jump(event));
    new ResizeObserver(() => this.draw()).observe(canvas.parentElement);
    this.showLabels();
  }

  get width() {
    return this.header.clientWidth;
  }
  xOf(date) {
    return ((date - this.app.from) / (this.app.to - this.app.from)) * this.width;
  }
  dateOf(x) {
    return this.app.from + (x / this.width) * (this.app.to - this.app.from);
  }

  /** Shows these cycles, as far as there are any. */
  show(from, to) {
    const cycles = Math.min(Math.max(to - from, LEAST_CYCLES), this.end);
    const begin = Math.max(0, Math.min((from + to - cycles) / 2, this.end - cycles));
    this.app.from = begin;
    this.app.to = begin + cycles;
    this.app.changed();
  }
  zoom(factor, date = (this.app.from + this.app.to) / 2) {
    const {from, to} = this.app, cycles = Math.min(Math.max((to - from) * factor, LEAST_CYCLES), this.end);
    const begin = date - ((date - from) * cycles) / (to - from);
    this.show(begin, begin + cycles);
  }
  pan(share) {
    const {from, to} = this.app, by = share * (to - from);
    this.show(from + by, to + by);
  }
  /** Brings [from, to) into view with some room around it, closer than `most` cycles. */
  reveal(from, to, most = 400) {
    const room = Math.max((to - from) * 0.25, 6), wide = this.app.to - this.app.from;
    if (wide <= most && from >= this.app.from && to <= this.app.to) return this.app.changed();
    const cycles = Math.max(to - from + 2 * room, Math.min(wide, most));
    this.show((from + to - cycles) / 2, (from + to + cycles) / 2);
  }

  wheel(event) {
    event.preventDefault();
    if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) return this.pan((event.deltaX || event.deltaY) / 1000);
    this.zoom(Math.exp(event.deltaY / 300), this.dateOf(event.clientX - this.canvas.getBoundingClientRect().left));
  }
  jump(event) {
    const bounds = this.header.getBoundingClientRect();
    if (event.type === 'pointerdown') {
      this.header.setPointerCapture(event.pointerId);
      this.held = event.clientY - bounds.top < OVERVIEW_HEIGHT;
    }
    if (!this.held) return;
    const date = ((event.clientX - bounds.left) / bounds.width) * this.end, half = (this.app.to - this.app.from) / 2;
    this.show(date - half, date + half);
  }

  /** One pointer pans, or selects where it does not move; two zoom. */
  followPointers() {
    const {canvas} = this, pointers = new Map();
    let moved = false;
    canvas.addEventListener('pointerdown', event => {
      canvas.setPointerCapture(event.pointerId);
      pointers.set(event.pointerId, event);
      moved = pointers.size > 1;
    });
    canvas.addEventListener('pointermove', event => {
      const before = pointers.get(event.pointerId);
      if (!before) return this.hover(event);
      const other = [...pointers.values()].find(pointer => pointer.pointerId !== event.pointerId);
      if (other) {
        const distance = pointer => Math.max(Math.abs(pointer.clientX - other.clientX), 10);
        this.zoom(distance(before) / distance(event), this.dateOf(other.clientX - canvas.getBoundingClientRect().left));
      } else if (moved || Math.abs(event.clientX - before.clientX) > 3) {
        moved = true;
        this.pan((before.clientX - event.clientX) / this.width);
      } else {
        return;
      }
      pointers.set(event.pointerId, event);
    });
    const release = event => {
      if (pointers.delete(event.pointerId) && !moved && event.type === 'pointerup') this.click(event);
    };
    canvas.addEventListener('pointerup', release);
    canvas.addEventListener('pointercancel', release);
    canvas.addEventListener('pointerleave', () => this.app.say(''));
  }

  heightOf(row) {
    const bands = this.app.models.length;
    return row.kind === 'unit' ? (bands > 1 ? 46 : UNIT_HEIGHT) : bands > 1 ? 30 : FIFO_HEIGHT;
  }
  /** {row, model, number} under the pointer; number is undefined in a group. */
  hit(event) {
    const bounds = this.canvas.getBoundingClientRect();
    let y = event.clientY - bounds.top;
    for (const row of this.rows.list()) {
      const height = this.heightOf(row);
      if (y >= height) {
        y -= height;
        continue;
      }
      const band = this.app.models.length > 1 ? Math.min(Math.floor(y / this.bandHeight(row)), 1) : 0;
      const members = row.members[band];
      return {row, model: this.app.models[band], number: row.count ? undefined : members[0],
              date: Math.floor(this.dateOf(event.clientX - bounds.left))};
    }
    return undefined;
  }
  hover(event) {
    const hit = this.hit(event);
    this.app.say(hit ? this.app.hitText(hit) : '');
  }
  click(event) {
    this.canvas.parentElement.focus({preventScroll: true});
    const hit = this.hit(event);
    if (!hit || hit.date >= hit.model.cycles) return;
    if (hit.number === undefined) return hit.row.count && this.toggle(hit.row.key);
    if (hit.row.kind === 'unit') {
      this.app.selectSpan(hit.model, hit.number, hit.model.times[hit.number].spanAt(hit.date));
    } else {
      this.app.selectFifo(hit.model, hit.number, hit.date);
    }
  }
  toggle(key) {
    this.rows.toggle(key);
    this.showLabels();
    this.app.changed();
  }

  showLabels() {
    const {app} = this;
    this.labels.replaceChildren(...this.rows.list().map(row => {
      const short = row.kind === 'unit' && row.group ? row.name.replace(/.*_/, 'unit ') : shortName(row.name);
      const name = row.kind === 'fifo' ? short : row.name.replace(/_/g, ' ');
      const mark = row.count ? (this.rows.closed.has(row.key) ? '▸ ' : '▾ ') : row.group ? '  ' : '';
      const label = element('button', {
        type: 'button', class: `label ${row.kind}`, style: `height:${this.heightOf(row)}px`, title: row.name,
        'aria-expanded': row.count ? String(!this.rows.closed.has(row.key)) : undefined,
        onclick: () => (row.count ? this.toggle(row.key) : app.selectRow(row)),
      }, ...[['wide', name], ['narrow', short]].map(([width, text]) => element('span', {class: width}, `${mark}${text}${row.count ? ` (${row.count})` : ''}`)),
        element('output', {}));
      label.row = row;
      return label;
    }));
  }
  /** Beside each name: what its part did in the cycles that are shown. */
  showShares() {
    const {app} = this;
    for (const label of this.labels.children) {
      const {row} = label;
      label.classList.toggle('selected', row.kind === 'unit' && !row.count && row.members[app.active].includes(app.unit));
      label.lastChild.textContent = app.models.map((model, r) => {
        const members = row.members[r], to = Math.min(app.to, model.cycles);
        if (!members.length || app.from >= to) return '–';
        if (row.kind === 'unit') return Math.round((100 * this.shares(model, members, app.from, to)[BUSY]) / (to - app.from));
        return grouped(Math.max(...members.map(k => model.fills[k].max(app.from, to))));
      }).join(' | ') + (row.kind === 'unit' ? ' %' : '');
    }
  }

  /** Cycles in each state, the mean over the members. */
  shares(model, members, from, to) {
    const sums = [0, 0, 0, 0];
    for (const k of members) model.times[k].between(from, to, sums);
    return sums.map(sum => sum / members.length);
  }
  bandHeight(row) {
    return row.kind === 'unit' ? 16 : 14;
  }
  bands(row) {
    const {models} = this.app;
    if (models.length === 1) return [{model: models[0], members: row.members[0], y: 1, height: this.heightOf(row) - 3}];
    return models.map((model, r) => ({model, members: row.members[r], y: 1 + r * this.bandHeight(row), height: this.bandHeight(row) - 1}));
  }

  draw() {
    if (this.width === 0) return;
    const rows = this.rows.list(), height = rows.reduce((sum, row) => sum + this.heightOf(row), 0);
    drawHeader(this, prepared(this.header, this.width, HEADER_HEIGHT));
    const context = prepared(this.canvas, this.width, height);
    drawGrid(this, context, 0, height);
    let y = 0;
    for (const row of rows) {
      context.save();
      context.translate(0, y);
      for (const band of this.bands(row)) {
        if (!band.members.length) continue;
        context.save();
        context.beginPath();
        context.rect(0, band.y, Math.max(0, this.xOf(band.model.cycles)), band.height);
        context.clip();
        if (row.kind === 'unit') drawUnits(this, context, band);
        else drawFifos(this, context, band);
        drawMarks(this, context, band, row.kind);
        context.restore();
        if (this.app.models.length > 1) drawName(context, 'AB'[this.app.models.indexOf(band.model)], band);
      }
      if (row.kind === 'unit' && this.app.models.length > 1) drawDifference(this, context, row);
      context.restore();
      y += this.heightOf(row);
    }
    this.showShares();
  }
}
