// SPDX-License-Identifier: Apache-2.0
// The keyboard, the search and the help.
'use strict';

const KEYS = [
  ['←  →', 'pan'], ['+  −', 'zoom'], ['0', 'the whole frame'], ['z', 'what is selected'], ['↑  ↓', 'the unit above, below'],
  ['n  p', "the selected unit's next, previous wait"], ['l', 'the longest pixel'], ['f', 'the first stall'], ['w', 'the longest wait'],
  ['m', 'the next map'], ['/', 'find'], ['Esc', 'select nothing'], ['?', 'this help'],
];

class Keyboard {
  constructor(app) {
    this.app = app;
    this.help = document.getElementById('help');
    this.search = document.getElementById('search');
    document.getElementById('keys').replaceChildren(...KEYS.flatMap(([key, text]) => [element('dt', {}, key), element('dd', {}, text)]));
    document.getElementById('help-button').addEventListener('click', () => this.help.showModal());
    document.getElementById('find-button').addEventListener('click', () => this.openSearch());
    document.addEventListener('keydown', event => this.press(event));
    this.input = this.search.querySelector('input');
    this.input.addEventListener('input', () => this.showFound());
    this.search.querySelector('form').addEventListener('submit', () => this.found()[0]?.go());
  }

  press(event) {
    if (event.ctrlKey || event.altKey || event.metaKey || document.querySelector('dialog[open]')) return;
    if (event.target.matches('input[type=text]')) return;
    if (event.target.matches('input, summary, [role=tab]') && event.key.startsWith('Arrow')) return;
    const {app} = this, {timeline} = app, find = app.finds.find(one => one.key === event.key);
    const actions = {
      ArrowLeft: () => timeline.pan(-0.2), ArrowRight: () => timeline.pan(0.2),
      ArrowUp: () => this.stepUnit(-1), ArrowDown: () => this.stepUnit(1),
      '+': () => timeline.zoom(0.5), '=': () => timeline.zoom(0.5), '-': () => timeline.zoom(2),
      0: () => timeline.show(0, timeline.end), z: () => this.zoomToSelection(), n: () => this.stepWait(1), p: () => this.stepWait(-1),
      m: () => this.nextMap(), '/': () => this.openSearch(), '?': () => this.help.showModal(), Escape: () => app.clear(),
    };
    const action = find ? find.go : actions[event.key];
    if (!action) return;
    event.preventDefault();
    action();
  }

  stepUnit(direction) {
    const {app} = this, count = app.model.run.units.length;
    app.unit = (app.unit + direction + count) % count;
    app.changed();
  }
  stepWait(direction) {
    const {app} = this, times = app.model.times[app.unit], {at} = times.unit, {span} = app;
    const here = span && span.unit === app.unit && span.model === app.model;
    const middle = countBelow(at, (app.from + app.to) / 2);
    const firing = nextWait(times, here ? span.firing : direction > 0 ? middle - 1 : middle, direction);
    if (firing === undefined) return app.say(`${times.unit.name} has no ${direction > 0 ? 'further' : 'earlier'} wait`);
    app.selectSpan(app.model, app.unit, {state: times.stateBefore(firing), from: times.unit.until[firing - 1], to: at[firing], firing}, true);
  }
  zoomToSelection() {
    const {app} = this, {pixels} = app.model;
    if (app.span) app.timeline.reveal(app.span.from, app.span.to, 0);
    else if (app.subject) app.revealSubject(0);
    else if (app.pixel >= 0) app.timeline.reveal(pixels.admitted[app.pixel], pixels.finished[app.pixel] || app.model.cycles, 0);
  }
  nextMap() {
    const choices = [...document.querySelectorAll('input[name=map]')], k = choices.findIndex(choice => choice.checked);
    choices[(k + 1) % choices.length].click();
  }

  openSearch() {
    this.input.value = '';
    this.showFound();
    this.search.showModal();
    this.input.focus();
  }
  /** Finds by their names; units; and "R,C" a pixel, "ray N", "cycle N". */
  found() {
    const {app} = this, text = this.input.value.trim().toLowerCase(), numbers = (text.match(/\d+/g) ?? []).map(Number);
    const {pixels, run} = app.model, list = [];
    const add = (name, go) => list.push({name, go: () => (this.search.close(), go())});
    if (/^(pixel|row)?\D*\d+\D+\d+$/.test(text) && pixels.at(...numbers) >= 0) {
      add(`Pixel row ${numbers[0]}, column ${numbers[1]}`, () => app.selectPixel(pixels.at(...numbers), true));
    }
    if (/^(ray )?\d+$/.test(text) && numbers[0] < run.rays.count) add(`Ray ${numbers[0]}`, () => app.selectSubject({ray: numbers[0]}));
    if (/^(cycle )?\d+$/.test(text) && numbers[0] < app.model.cycles) add(`Cycle ${grouped(numbers[0])}`, () => app.timeline.show(numbers[0] - 20, numbers[0] + 20));
    const all = [...app.finds.map(find => ({name: `${find.kind}: ${find.name}, ${find.value}`, go: find.go})),
                 ...run.units.map((unit, k) => ({name: `Unit ${unit.name}`, go: () => (app.unit = k, app.changed())}))];
    for (const {name, go} of all) {
      if (text.split(/\s+/).every(word => name.toLowerCase().replace(/_/g, ' ').includes(word.replace(/_/g, ' ')))) add(name, go);
    }
    return list;
  }
  showFound() {
    this.search.querySelector('ul').replaceChildren(...this.found().slice(0, 12).map(({name, go}) => element('li', {}, element('button', {type: 'button', onclick: go}, name))));
  }
}
