// SPDX-License-Identifier: Apache-2.0
// What units and FIFOs did over any stretch of time, in exact cycles however long it is: sums up to each firing and
// token are kept, so that a stretch costs two searches.
'use strict';

const STATES = ['busy', 'starved', 'blocked', 'idle'];
const BUSY = 0, STARVED = 1, BLOCKED = 2, IDLE = 3;

/** How many of the ascending `dates` are below `date`. */
function countBelow(dates, date, end = dates.length) {
  let low = 0, high = end;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (dates[middle] < date) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Time in states of a unit. */
class UnitTime {
  constructor(run, number) {
    this.unit = run.units[number];
    this.number = number;
    this.run = run;
    this.cycles = run.header.cycles;
    const {at, until, firings} = this.unit;
    this.before = STATES.slice(0, 3).map(() => new Float64Array(firings + 1));  // up to the end of each firing
    const [busy, starved, blocked] = this.before;
    for (let n = 0; n < firings; ++n) {
      const wait = at[n] - (n ? until[n - 1] : 0), state = this.stateBefore(n);
      busy[n + 1] = busy[n] + until[n] - at[n];
      starved[n + 1] = starved[n] + (state === STARVED ? wait : 0);
      blocked[n + 1] = blocked[n] + (state === BLOCKED ? wait : 0);
    }
  }

  /** What the unit is from the end of the firing before on until firing n. */
  stateBefore(n) {
    if (n === 0 || n >= this.unit.firings || this.unit.cause[n] === 0) return IDLE;
    return this.run.fifos[this.unit.cause[n] - 1].reader === this.number ? STARVED : BLOCKED;
  }

  /** Adds cycles in each state from 0 to `date`, times `sign`, to `sums`. */
  addUpTo(date, sign, sums) {
    const {at, until, firings} = this.unit;
    const n = countBelow(until, date), [busy, starved, blocked] = this.before;
    const inBusy = n < firings && date > at[n] ? date - at[n] : 0;
    const wait = (n < firings ? Math.min(date, at[n]) : date) - (n ? until[n - 1] : 0);
    const cycles = [busy[n] + inBusy, starved[n], blocked[n]];
    const state = this.stateBefore(n);
    if (state !== IDLE) cycles[state] += wait;
    sums[BUSY] += sign * cycles[BUSY];
    sums[STARVED] += sign * cycles[STARVED];
    sums[BLOCKED] += sign * cycles[BLOCKED];
    sums[IDLE] += sign * (date - cycles[BUSY] - cycles[STARVED] - cycles[BLOCKED]);
  }

  /** Cycles in each state. */
  between(from, to, sums = [0, 0, 0, 0]) {
    this.addUpTo(to, 1, sums);
    this.addUpTo(from, -1, sums);
    return sums;
  }

  /** The stretch that holds the cycle `date`: {state, from, to, firing}; firing is the one that works or ends a wait. */
  spanAt(date) {
    const {at, until, firings} = this.unit, n = countBelow(until, date + 1);
    const ready = n ? until[n - 1] : 0;
    if (n < firings && date >= at[n]) return {state: BUSY, from: at[n], to: until[n], firing: n};
    return {state: this.stateBefore(n), from: ready, to: n < firings ? at[n] : this.cycles, firing: n};
  }
}

/** How full a FIFO is: a token counts from the cycle of its write to that of its read, both included. */
class FifoFill {
  constructor(run, number) {
    this.fifo = run.fifos[number];
    const {written, left, tokens} = this.fifo;
    this.writes = new Float64Array(tokens + 1);  // sums of dates
    this.reads = new Float64Array(tokens + 1);
    const levels = new Int32Array(tokens);  // with each token's write
    for (let n = 0, gone = 0; n < tokens; ++n) {
      while (left[gone] < written[n]) ++gone;
      levels[n] = n + 1 - gone;
      this.writes[n + 1] = this.writes[n] + written[n];
      this.reads[n + 1] = this.reads[n] + left[n] + 1;
    }
    this.most = [levels];  // by level of detail, each of 16 of the one before
    while (this.most.at(-1).length > 16) {
      const fine = this.most.at(-1), coarse = new Int32Array(Math.ceil(fine.length / 16));
      for (let k = 0; k < fine.length; ++k) coarse[k >> 4] = Math.max(coarse[k >> 4], fine[k]);
      this.most.push(coarse);
    }
  }

  at(date) {
    return countBelow(this.fifo.written, date + 1) - countBelow(this.fifo.left, date);
  }

  /** Tokens times cycles from 0 to `date`. */
  upTo(date) {
    const n = countBelow(this.fifo.written, date), gone = countBelow(this.fifo.left, date - 1);
    return n * date - this.writes[n] - (gone * date - this.reads[gone]);
  }
  mean(from, to) {
    return (this.upTo(to) - this.upTo(from)) / (to - from);
  }

  /** The most tokens at once. */
  max(from, to) {
    let most = this.at(from);
    let low = countBelow(this.fifo.written, from), high = countBelow(this.fifo.written, to);
    for (const levels of this.most) {
      for (; low < high && low % 16; ++low) most = Math.max(most, levels[low]);
      for (; low < high && high % 16; --high) most = Math.max(most, levels[high - 1]);
      if (low >= high) break;
      if (levels === this.most.at(-1)) {
        for (; low < high; ++low) most = Math.max(most, levels[low]);
      }
      low >>= 4;
      high >>= 4;
    }
    return most;
  }
}
