// SPDX-License-Identifier: Apache-2.0
// What is worth looking at in a run: its slowest pixels, its longest waits, its first stall.
'use strict';

/** Keeps the `most` greatest of what is added, the first of equals first. */
class Greatest {
  constructor(most, valueOf) {
    this.most = most;
    this.valueOf = valueOf;
    this.list = [];
  }
  add(item) {
    const {list, most, valueOf} = this;
    if (list.length === most && valueOf(item) <= valueOf(list[most - 1])) return;
    let place = list.length;
    while (place > 0 && valueOf(list[place - 1]) < valueOf(item)) --place;
    list.splice(place, 0, item);
    list.length = Math.min(list.length, most);
  }
}

/** The slowest first; of those that took equally long, the ones finished first. */
function longestPixels(pixels, most = 10) {
  const found = new Greatest(most, pixel => pixels.latency(pixel));
  const {toFrameBuffer} = pixels, {subject} = pixels.run.fifos[toFrameBuffer];
  for (const node of subject) found.add(pixels.ofNode(node));
  return found.list;
}

/** Of all units: {unit, firing, state, cause, from, to}. Waits before a unit's first firing are none. */
function* waitsOf(times) {
  const {at, until, cause, firings} = times.unit;
  for (let n = 1; n < firings; ++n) {
    if (cause[n] === 0) continue;
    yield {unit: times.number, firing: n, state: times.stateBefore(n), cause: cause[n] - 1, from: until[n - 1], to: at[n]};
  }
}

/** The longest wait of each unit for each FIFO, the longest of all first. */
function longestWaits(allTimes, most = 10) {
  const found = [];
  for (const times of allTimes) {
    const longest = new Map();
    for (const wait of waitsOf(times)) {
      const before = longest.get(wait.cause);
      if (!before || wait.to - wait.from > before.to - before.from) longest.set(wait.cause, wait);
    }
    found.push(...longest.values());
  }
  return found.sort((a, b) => b.to - b.from - (a.to - a.from)).slice(0, most);
}

/** The first wait of a unit for room: from there on the frame's flow is held up. Undefined: there is none. */
function firstStall(allTimes) {
  let first;
  for (const times of allTimes) {
    for (const wait of waitsOf(times)) {
      if (first && wait.from >= first.from) break;
      if (wait.state !== BLOCKED) continue;
      first = wait;
      break;
    }
  }
  return first;
}

/** The next wait of a unit after firing `firing`, or with `direction` -1 the one before; undefined: there is none. */
function nextWait(times, firing, direction) {
  const {cause, firings} = times.unit;
  for (let n = firing + direction; n > 0 && n < firings; n += direction) {
    if (cause[n] > 0) return n;
  }
  return undefined;
}
