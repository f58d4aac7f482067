// SPDX-License-Identifier: Apache-2.0
// Pixels, their trace trees, and the ways of rays and nodes through the machine.
'use strict';

const CASES = ['split', 'empty', 'covered', 'edge', 'hidden'];
const POINTS = ['top', 'left', 'centre', 'right', 'bottom'];
const CORNERS = ['upper left', 'upper right', 'lower left', 'lower right'];

/** The place of each number in `subjects`; -1: it is not there. */
function placesOf(subjects, count) {
  const places = new Int32Array(count).fill(-1);
  for (let k = 0; k < subjects.length; ++k) places[subjects[k]] = k;
  return places;
}

class Pixels {
  constructor(run) {
    this.run = run;
    const {header, units, fifos, rays, nodes} = run;
    const box = name => units.findIndex(unit => unit.box === name);
    this.scan = box('pixel_scan');
    this.generator = box('view_vector_generator');
    this.classifier = box('pyramid_classifier');
    this.controller = box('subdivision_controller');
    this.colorUnit = box('color_unit');
    this.accumulator = box('tree_accumulator');
    this.frameBuffer = box('frame_buffer');
    const wire = (writer, reader) => fifos.findIndex(fifo => fifo.writer === writer && fifo.reader === reader);
    this.corners = wire(this.scan, this.generator);
    this.toController = wire(this.classifier, this.controller);
    this.requests = wire(this.controller, this.generator);
    this.toColor = wire(this.classifier, this.colorUnit);
    this.toAccumulator = wire(this.colorUnit, this.accumulator);
    this.toFrameBuffer = wire(this.accumulator, this.frameBuffer);

    this.maxLevel = header.run.max_level;
    const {screen, window} = header.run;
    this.window = window ?? {x: 0, y: 0, columns: screen.columns, rows: screen.rows};
    this.count = this.window.columns * this.window.rows;

    this.primary = run.primary;
    this.firstOfRequest = [];
    for (let ray = 0; ray < rays.count; ++ray) {
      if (rays.request[ray] > 0) this.firstOfRequest[rays.request[ray] - 1] ??= ray;
    }
    this.nodeOfRequest = this.requests < 0 ? [] : fifos[this.requests].subject;
    this.requestOfNode = placesOf(this.nodeOfRequest, nodes.count);
    this.sentToController = this.toController < 0 ? new Int32Array(nodes.count).fill(-1) :
                                                    placesOf(fifos[this.toController].subject, nodes.count);
    this.sentToColor = placesOf(fifos[this.toColor].subject, nodes.count);
    this.followRays();
    this.measure();
  }

  /** Where each ray was worked on. Token and firing n of a unit's FIFOs belong to each other. */
  followRays() {
    const {units, fifos, rays} = this.run;
    this.unitOfRay = new Int16Array(rays.count).fill(-1);
    this.firingOfRay = new Int32Array(rays.count);
    this.fifosOfUnit = units.map((unit, k) => ({
      in: fifos.findIndex(fifo => fifo.reader === k),
      out: fifos.findIndex(fifo => fifo.writer === k),
    }));
    units.forEach((unit, k) => {
      if (unit.box !== 'intersection_units') return;
      const {subject} = fifos[this.fifosOfUnit[k].in];
      for (let n = 0; n < subject.length; ++n) {
        this.unitOfRay[subject[n]] = k;
        this.firingOfRay[subject[n]] = n;
      }
    });
  }

  /** Latency, rays and the last node of each pixel, and its nodes: nodes[first[pixel]] up to nodes[first[pixel + 1]]. */
  measure() {
    const {nodes, fifos, units} = this.run, stored = fifos[this.toFrameBuffer];
    this.admitted = new Float64Array(this.count).fill(NaN);
    this.finished = new Float64Array(this.count).fill(NaN);
    this.lastNode = new Int32Array(this.count).fill(-1);
    this.place = new Int32Array(this.count);  // in the order of being finished
    this.rays = new Float64Array(this.count).fill(1);
    this.first = new Int32Array(this.count + 1);
    for (let node = 0; node < nodes.count; ++node) {
      const pixel = this.ofNode(node);
      ++this.first[pixel + 1];
      if (nodes.which[node] === 0) this.rays[pixel] += POINTS.length;
    }
    for (let pixel = 0; pixel < this.count; ++pixel) this.first[pixel + 1] += this.first[pixel];
    this.nodes = new Int32Array(nodes.count);
    const next = this.first.slice();
    for (let node = 0; node < nodes.count; ++node) this.nodes[next[this.ofNode(node)]++] = node;
    const {at} = units[this.scan], across = this.window.columns + 1;
    for (let corner = 0; corner < at.length; ++corner) {
      const row = Math.floor(corner / across) - 1, column = corner % across - 1;
      if (row >= 0 && column >= 0) this.admitted[row * this.window.columns + column] = at[corner];
    }
    for (let n = 0; n < stored.tokens; ++n) {
      const pixel = this.ofNode(stored.subject[n]);
      this.finished[pixel] = stored.visible[n];
      this.lastNode[pixel] = stored.subject[n];
      this.place[pixel] = n;
    }
  }

  latency(pixel) {
    return this.finished[pixel] - this.admitted[pixel];
  }
  /** Row and column on the screen. */
  placeOf(pixel) {
    return [this.window.y + Math.floor(pixel / this.window.columns), this.window.x + pixel % this.window.columns];
  }
  /** -1: outside the window. */
  at(row, column) {
    const y = row - this.window.y, x = column - this.window.x;
    const inside = x >= 0 && y >= 0 && x < this.window.columns && y < this.window.rows;
    return inside ? y * this.window.columns + x : -1;
  }
  ofNode(node) {
    const {row, column} = this.run.nodes;
    return this.at(row[node] >>> this.maxLevel, column[node] >>> this.maxLevel);
  }
  /** That asked for the ray; -1: it completes none. */
  ofRay(ray) {
    const {row, column, request} = this.run.rays;
    if (request[ray] > 0) return this.ofNode(this.nodeOfRequest[request[ray] - 1]);
    return this.at((row[ray] >>> this.maxLevel) - 1, (column[ray] >>> this.maxLevel) - 1);
  }
  nodesOf(pixel) {
    return this.nodes.subarray(this.first[pixel], this.first[pixel + 1]);
  }
  /** The corner's ray that completes the pixel, or one of the three before it; undefined: it has not been sent. */
  cornerRay(pixel, corner = 3) {
    const across = this.window.columns + 1;
    const row = Math.floor(pixel / this.window.columns) + (corner >> 1), column = pixel % this.window.columns + (corner & 1);
    return this.primary[row * across + column];
  }
  /** The pixel's own rays, in the order of their issue. */
  raysOf(pixel) {
    const rays = [this.cornerRay(pixel)].filter(ray => ray !== undefined);
    for (const node of this.nodesOf(pixel)) {
      const request = this.requestOfNode[node];
      const first = request < 0 ? undefined : this.firstOfRequest[request];
      for (let k = 0; first !== undefined && k < POINTS.length && first + k < this.run.rays.count; ++k) rays.push(first + k);
    }
    return rays.sort((a, b) => a - b);
  }
  /** The four parts of a node that was split, as far as they are classified; of a pixel's tree the top is part 3. */
  partsOf(node) {
    const request = this.requestOfNode[node] + 1;
    return request === 0 ? [] : [...this.nodesOf(this.ofNode(node))].filter(part => this.run.nodes.request[part] === request);
  }
  topOf(pixel) {
    return this.nodesOf(pixel).find(node => this.run.nodes.log2Side[node] === this.maxLevel);
  }

  /** Steps {unit or fifo, from, to} of a ray, up to its reading by the classifier. */
  wayOfRay(ray) {
    const {units, fifos, rays} = this.run, steps = [];
    const corner = rays.request[ray] === 0;
    const request = corner ? countBelow(this.primary, ray) : rays.request[ray] - 1;
    const source = fifos[corner ? this.corners : this.requests];
    if (corner) {
      steps.push({unit: this.scan, from: source.written[request], to: source.visible[request]});
      steps.push({fifo: this.corners, from: source.visible[request], to: source.left[request]});
    }
    const unit = this.unitOfRay[ray];
    if (unit < 0) return steps;
    const n = this.firingOfRay[ray], issued = units[this.generator].at[ray];
    if (!corner) steps.push({unit: this.generator, from: source.left[request], to: issued, waits: true});
    let step = {unit: this.generator, from: issued, to: fifos[this.fifosOfUnit[unit].in].visible[n]};
    for (let at = unit; at !== this.classifier; at = fifos[this.fifosOfUnit[at].out].reader) {
      steps.push(step);
      const before = fifos[this.fifosOfUnit[at].in], after = fifos[this.fifosOfUnit[at].out];
      steps.push({fifo: this.fifosOfUnit[at].in, from: before.visible[n], to: before.left[n]});
      if (!(n < after.tokens)) return steps;
      step = {unit: at, from: before.left[n], to: after.visible[n]};
      if (after.reader === this.classifier) {
        steps.push(step, {fifo: this.fifosOfUnit[at].out, from: after.visible[n], to: after.left[n]});
      }
    }
    return steps;
  }

  /** Steps of a node from its classification on: up to its pixel's sum, or to the reading of its request. */
  wayOfNode(node) {
    const {fifos, units} = this.run, steps = [];
    const through = (fifo, n) => {
      const {writer, written, visible, left} = fifos[fifo];
      steps.push({unit: writer, from: written[n], to: visible[n]}, {fifo, from: visible[n], to: left[n]});
      return left[n];
    };
    const request = this.requestOfNode[node], color = this.sentToColor[node];
    if (color < 0) {
      const accepted = this.sentToController[node] < 0 ? Infinity : through(this.toController, this.sentToController[node]);
      if (request < 0) return steps;
      steps.push({unit: this.controller, from: accepted, to: fifos[this.requests].written[request], waits: true});
      through(this.requests, request);
      return steps;
    }
    through(this.toColor, color);
    if (color >= fifos[this.toAccumulator].tokens) return steps;
    const summed = through(this.toAccumulator, color);
    if (summed === Infinity) return steps;
    const pixel = this.ofNode(node), last = this.lastNode[pixel] === node;
    steps.push({unit: this.accumulator, from: summed, to: last ? this.finished[pixel] : units[this.accumulator].until[color]});
    return steps;
  }

  /** When the node was classified, and the ray whose sample was the newest then. */
  classified(node) {
    const {fifos, units} = this.run, color = this.sentToColor[node];
    const date = color < 0 ? fifos[this.toController].written[this.sentToController[node]] : fifos[this.toColor].written[color];
    const {at, subject} = units[this.classifier];
    return {date, ray: subject[countBelow(at, date)]};
  }

  /** The life of a finished pixel, step by step from its corner's sending on to its colour: what the node that came last
   * went through, and before it the rays and nodes that it came from. Each step begins where the one before ends. */
  lifeOf(pixel) {
    let steps = [];
    for (let node = this.lastNode[pixel]; node >= 0;) {
      const {date, ray} = this.classified(node), way = this.wayOfRay(ray);
      const read = way.at(-1).to;
      if (read < date) way.push({unit: this.classifier, from: read, to: date, waits: true});
      steps = [...way.map(step => ({...step, ray})), ...this.wayOfNode(node).map(step => ({...step, node})), ...steps];
      const request = this.run.rays.request[ray];
      node = request === 0 ? -1 : this.nodeOfRequest[request - 1];
    }
    return steps.filter(step => step.to > step.from);
  }
}

/** Why something was not taken on from `from` to `to`: what the unit that takes it did meanwhile, as a list of
 * {state, cause (a FIFO's number, of a wait), cycles}. */
function reasonsOf(times, from, to) {
  const reasons = new Map();
  for (let date = from; date < to;) {
    const span = times.spanAt(date), end = Math.min(span.to, to);
    const cause = span.state === STARVED || span.state === BLOCKED ? times.unit.cause[span.firing] - 1 : -1;
    const key = `${span.state} ${cause}`;
    if (!reasons.has(key)) reasons.set(key, {state: span.state, cause, cycles: 0});
    reasons.get(key).cycles += end - date;
    if (!(end > date)) break;
    date = end;
  }
  return [...reasons.values()].sort((a, b) => b.cycles - a.cycles);
}
