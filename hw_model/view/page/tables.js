// SPDX-License-Identifier: Apache-2.0
// A run as the page holds it, made into arrays: see docs/trace_page.md.
'use strict';

/** Reads columns of varints, one after another. */
class ColumnReader {
  constructor(bytes) {
    this.bytes = bytes;
    this.at = 0;
  }

  varint() {
    let byte = this.bytes[this.at++];
    if (byte < 128) return byte;
    let value = byte & 127;
    for (let scale = 128; byte >= 128; scale *= 128) {
      byte = this.bytes[this.at++];
      value += (byte & 127) * scale;
    }
    return value;
  }

  numbers(array) {
    for (let k = 0; k < array.length; ++k) array[k] = this.varint();
    return array;
  }

  /** Numbers that are kept as differences to the one before. */
  sums(array, first = 0) {
    let sum = 0;
    for (let k = first; k < array.length; ++k) {
      const code = this.varint();
      sum += code % 2 ? -(code + 1) / 2 : code / 2;
      array[k] = sum;
    }
    return array;
  }
}

/** Firing n of a unit works from at[n] to until[n]; before it, from the firing before on, the unit waits for the FIFO
 * cause[n] - 1, where there is one. */
function readUnit(reader, unit) {
  const at = new Float64Array(unit.firings), until = reader.numbers(new Float64Array(unit.firings));
  const busy = reader.numbers(new Float64Array(unit.firings));
  let ready = 0;
  for (let n = 0; n < unit.firings; ++n) {
    at[n] = ready + until[n];
    until[n] = ready = at[n] + busy[n];
  }
  return {...unit, at, until, cause: reader.numbers(new Int32Array(unit.firings)),
          subject: reader.sums(new Int32Array(unit.firings))};
}

/** Token n of a FIFO is written at written[n], can be read from visible[n] on, and is read at left[n]; never: Infinity. */
function readFifo(reader, fifo) {
  const first = fifo.preloaded, tokens = first + fifo.written;
  const written = reader.sums(new Float64Array(tokens), first), visible = new Float64Array(tokens);
  for (let n = first; n < tokens; ++n) visible[n] = written[n] + reader.varint();
  const left = new Float64Array(tokens).fill(Infinity);
  for (let n = 0; n < fifo.read; ++n) left[n] = visible[n] + reader.varint();
  return {...fifo, tokens, written, visible, left, subject: reader.sums(new Int32Array(tokens), first)};
}

function readTables(header, bytes) {
  const reader = new ColumnReader(bytes);
  const units = header.units.map(unit => readUnit(reader, unit));
  const fifos = header.fifos.map(fifo => readFifo(reader, fifo));
  const sums = count => reader.sums(new Uint32Array(count));
  const rays = {count: header.rays, row: sums(header.rays), column: sums(header.rays), request: sums(header.rays),
                object: reader.numbers(new Uint32Array(header.rays))};
  const nodes = {count: header.nodes, row: sums(header.nodes), column: sums(header.nodes), log2Side: sums(header.nodes),
                 request: sums(header.nodes), which: reader.numbers(new Uint8Array(header.nodes))};
  const primary = [];  // rays through corners of the raster, in the order in which these are scanned
  rays.request.forEach((request, ray) => request === 0 && primary.push(ray));
  for (const part of [...units, ...fifos]) {
    if (part.about === 'corners') part.subject = part.subject.map(corner => primary[corner] ?? -1);
  }
  if (reader.at !== bytes.length) throw new Error('the tables do not fit their description');
  return {header, units, fifos, rays, nodes, primary};
}

function bytesOfBase64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  return Uint8Array.from(atob(text), character => character.charCodeAt(0));
}

async function inflated(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** The runs that the page holds. */
async function readRuns() {
  const columns = [...document.querySelectorAll('script.columns')];
  return Promise.all([...document.querySelectorAll('script.run')].map(async (script, k) =>
      readTables(JSON.parse(script.textContent), await inflated(bytesOfBase64(columns[k].textContent)))));
}
