// SPDX-License-Identifier: Apache-2.0
// Reads a trace page with the page's own scripts, but without a browser, and prints what it says of each run as JSON.
// Usage: node page_data.cjs PAGE [PIXEL...]; of each pixel, by its number in the window, its life and its rays too
'use strict';
const fs = require('fs');
const vm = require('vm');
const zlib = require('zlib');

const html = fs.readFileSync(process.argv[2], 'utf8');
const contents = pattern => [...html.matchAll(pattern)].map(match => match[1]);
const code = contents(/<script>\n([^]*?)<\/script>/g).filter(script => !script.includes('async function main()'));
vm.runInThisContext(`${code.join('\n')}\nglobalThis.page = {readTables, UnitTime, FifoFill, Pixels, longestPixels, longestWaits, firstStall, STATES};`);
const {page} = globalThis;

const runs = contents(/<script type="application\/json" class="run">(.*?)<\/script>/g).map(JSON.parse);
const columns = contents(/<script type="text\/plain" class="columns">(.*?)<\/script>/g);

/** What the page says of a pixel: the stretches of its life, and when each ray of its tree was where. */
function reportPixel(run, pixels, pixel) {
  const rays = new Set([...[0, 1, 2, 3].map(corner => pixels.cornerRay(pixel, corner)), ...pixels.raysOf(pixel)]);
  return {
    from: pixels.admitted[pixel], to: pixels.finished[pixel],
    life: pixels.lifeOf(pixel).map(({unit, fifo, waits, from, to}) =>
        ({place: (fifo === undefined ? run.units[unit] : run.fifos[fifo]).name, waits: fifo !== undefined || Boolean(waits), cycles: to - from})),
    rays: [...rays].map(ray => {
      const way = pixels.wayOfRay(ray), issue = way.findIndex(step => step.unit === pixels.generator && !step.waits);
      return {ray, point: [run.rays.row[ray], run.rays.column[ray]], object: run.rays.object[ray], issued: way[issue].from,
              unit: run.units[way[issue + 2].unit].name, from: way[issue + 2].from, to: way.at(-2).to, seen: way.at(-1).to};
    }),
  };
}

function report(run) {
  const times = run.units.map((_, k) => new page.UnitTime(run, k)), fills = run.fifos.map((_, k) => new page.FifoFill(run, k));
  const pixels = new page.Pixels(run), {cycles} = run.header, latencies = [], unlike = [];
  for (let pixel = 0; pixel < pixels.count; ++pixel) {
    latencies.push(pixels.latency(pixel));
    const life = pixels.lifeOf(pixel);
    const follows = life.every((step, k) => step.from === (k ? life[k - 1].to : pixels.admitted[pixel]));
    if (life.length && (!follows || life.at(-1).to !== pixels.finished[pixel])) unlike.push(pixel);
  }
  // Stretches of time, summed up in steps of odd lengths, are the whole.
  const inSteps = times.map(time => {
    const sums = [0, 0, 0, 0];
    for (let from = 0; from < cycles; from += 37) time.between(from, Math.min(from + 37, cycles), sums);
    return sums;
  });
  const mostInSteps = fills.map(fill => {
    let most = 0;
    for (let from = 0; from < cycles; from += 37) most = Math.max(most, fill.max(from, Math.min(from + 37, cycles)));
    return most;
  });
  return {
    cycles, complete: run.header.complete, rays: run.rays.count, primary: pixels.primary.length,
    units: times.map((time, k) => ({name: run.units[k].name, cycles: time.between(0, cycles), inSteps: inSteps[k]})),
    fifos: fills.map((fill, k) => ({name: run.fifos[k].name, depth: run.fifos[k].depth, max: fill.max(0, cycles), mostInSteps: mostInSteps[k],
                                    mean: fill.mean(0, cycles), tokens: run.fifos[k].read})),
    waits: page.longestWaits(times).map(wait => ({...wait, unit: run.units[wait.unit].name, cause: run.fifos[wait.cause].name})),
    stall: page.firstStall(times), latencies, unlike, raysOfPixels: [...pixels.rays], objects: [...run.rays.object],
    raysListed: Array.from({length: pixels.count}, (_, pixel) => pixels.raysOf(pixel).length),
    pixelsOfRays: Array.from({length: run.rays.count}, (_, ray) => pixels.ofRay(ray)),
    scanned: [...run.units[pixels.scan].subject].every((ray, corner) => ray === pixels.primary[corner]),
    points: pixels.primary.map(ray => [run.rays.row[ray] >>> pixels.maxLevel, run.rays.column[ray] >>> pixels.maxLevel]),
    asked: process.argv.slice(3).map(pixel => reportPixel(run, pixels, Number(pixel))),
    slowest: page.longestPixels(pixels, 5).map(pixel => [...pixels.placeOf(pixel), pixels.latency(pixel)]),
  };
}

console.log(JSON.stringify(runs.map((header, k) => report(page.readTables(header, zlib.inflateSync(Buffer.from(columns[k], 'base64')))))));
