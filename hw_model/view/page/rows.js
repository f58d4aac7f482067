// SPDX-License-Identifier: Apache-2.0
// The rows of the timeline: units and FIFOs of all runs by their names, and groups of those that stand side by side.
'use strict';

const OPEN_UP_TO = 4;  // a group of more is closed at first

/** A row: {kind: 'unit' or 'fifo', name, members: of each run, numbers; group: its key where it is one of several,
 * count: of members where it stands for several}. */
class Rows {
  constructor(models) {
    this.models = models;
    this.closed = new Set();
    this.groups = new Map();
    this.add('unit', run => run.units, unit => unit.box);
    this.add('fifo', run => run.fifos, fifo => fifo.name.replace(/_\d+(?=_to_|$)/g, 's'));
    for (const [key, group] of this.groups) {
      if (group.rows.length > OPEN_UP_TO || group.kind === 'fifo') this.closed.add(key);
    }
  }

  add(kind, listOf, groupOf) {
    this.models.forEach(({run}, r) => listOf(run).forEach((part, number) => {
      const key = `${kind} ${groupOf(part)}`;
      if (!this.groups.has(key)) this.groups.set(key, {kind, key, name: groupOf(part), rows: []});
      const group = this.groups.get(key);
      let row = group.rows.find(other => other.name === part.name);
      if (!row) group.rows.push(row = {kind, name: part.name, group: key, members: this.models.map(() => [])});
      row.members[r].push(number);
    }));
  }

  toggle(key) {
    if (!this.closed.delete(key)) this.closed.add(key);
  }

  /** Those that are shown, from the top. */
  list() {
    return [...this.groups.values()].flatMap(group => {
      if (group.rows.length === 1) return [{...group.rows[0], group: undefined}];
      const members = this.models.map((_, r) => group.rows.flatMap(row => row.members[r]));
      const head = {kind: group.kind, name: group.name, key: group.key, members, count: group.rows.length};
      return this.closed.has(group.key) ? [head] : [head, ...group.rows];
    });
  }
}
