// SPDX-License-Identifier: Apache-2.0
// The selected pixel: where its latency went, and its trace tree with every ray.
'use strict';

const OPEN_NODES = 24;  // splits of a tree that is shown open

const nameOfStep = (run, step) => step.fifo === undefined ?
    `${step.waits ? 'waits in' : 'in'} ${run.units[step.unit].name.replace(/_\d+$/, '').replace(/_/g, ' ')}` :
    `waits in FIFO ${shortName(run.fifos[step.fifo].name.replace(/_\d+(?=_to_|$)/g, ''))}`;
const classOfStep = step => (step.fifo !== undefined ? 'queue' : step.waits ? 'hold' : 'work');

/** Bars of steps, on the axis of `from` to `to`. */
function stepBars(run, steps, from, to) {
  const bars = element('span', {class: 'bars', 'aria-hidden': 'true'});
  for (const step of steps) {
    const begin = Math.max(step.from, from), end = Math.min(step.to, to);
    if (!(end > begin)) continue;
    bars.append(element('i', {class: classOfStep(step), title: `${nameOfStep(run, step)}: ${cyclesText(step.to - step.from)}`,
                              style: `left:${(100 * (begin - from)) / (to - from)}%;width:${(100 * (end - begin)) / (to - from)}%`}));
  }
  return bars;
}

class PixelPanel {
  constructor(app, panel) {
    this.app = app;
    this.panel = panel;
  }

  /** Brings what is selected in the tree into view, where the panel scrolls by itself. */
  reveal() {
    const line = this.panel.querySelector('.tree .selected');
    if (!line || this.panel.scrollHeight <= this.panel.clientHeight) return;
    const bounds = line.getBoundingClientRect(), its = this.panel.getBoundingClientRect();
    if (bounds.top < its.top || bounds.bottom > its.bottom) this.panel.scrollTop += bounds.top - its.top - its.height / 2;
  }

  show() {
    const {app, panel} = this, {model, pixel} = app, shown = `${app.active} ${pixel}`;
    if (shown !== this.shown) this.make(model, pixel);
    this.shown = shown;
    for (const button of panel.querySelectorAll('.tree button')) {
      const {ray, node} = button.subject;
      button.classList.toggle('selected', app.subject !== undefined && app.subject.ray === ray && app.subject.node === node);
    }
  }
  make(model, pixel) {
    const {app, panel} = this;
    if (pixel < 0) {
      panel.replaceChildren(element('h2', {}, 'Pixel'), element('p', {class: 'hint'}, 'Click a pixel, or a span of the timeline that is about one.'));
      return;
    }
    const {pixels, run} = model, [row, column] = pixels.placeOf(pixel);
    this.from = pixels.admitted[pixel];
    this.to = Number.isNaN(pixels.finished[pixel]) ? model.cycles : pixels.finished[pixel];
    panel.scrollTop = 0;
    panel.replaceChildren(element('h2', {}, `Pixel row ${row}, column ${column}`), this.facts(model, pixel), ...this.life(model, pixel),
                          element('h3', {}, 'Trace tree'), this.tree(pixels, run, pixel));
  }

  facts({pixels, run}, pixel) {
    const levels = [...pixels.nodesOf(pixel)].map(node => pixels.maxLevel - run.nodes.log2Side[node]);
    const {app} = this, models = app.comparable ? app.models : [app.model];
    const latencies = models.map(model => model.pixels.latency(pixel));
    const texts = latencies.map((latency, k) => `${latencies.length > 1 ? `${'AB'[k]} ` : ''}${Number.isNaN(latency) ? 'not finished' : cyclesText(latency)}`);
    if (latencies.length > 1) texts.push(`B − A ${signed(latencies[1] - latencies[0])}`);
    return element('dl', {class: 'facts'},
                   element('div', {}, element('dt', {}, 'Latency'), element('dd', {id: 'latency'}, texts.join(', '))),
                   element('div', {}, element('dt', {}, 'Own rays'), element('dd', {id: 'rays'}, grouped(pixels.rays[pixel]))),
                   element('div', {}, element('dt', {}, 'Deepest level'), element('dd', {}, String(Math.max(0, ...levels)))),
                   element('div', {}, element('dt', {}, 'Its time'), element('dd', {}, Number.isNaN(this.from) ? '–' : spanText(this.from, this.to))));
  }

  /** Where the time went: of the node that came last, and of what it came from. */
  life(model, pixel) {
    const steps = model.pixels.lifeOf(pixel), latency = this.to - this.from;
    if (steps.length === 0) return [];
    const sums = new Map();
    for (const step of steps) {
      const name = nameOfStep(model.run, step), sum = sums.get(name) ?? {step, cycles: 0};
      sum.cycles += step.to - step.from;
      sums.set(name, sum);
    }
    const rows = [...sums].sort((a, b) => b[1].cycles - a[1].cycles).map(([name, {step, cycles}]) => [
      element('span', {class: 'key'}, element('i', {class: classOfStep(step)}), name), grouped(cycles), percent(cycles, latency, 3)]);
    const total = steps.reduce((sum, step) => sum + step.to - step.from, 0);
    const [first, second] = [...sums].sort((a, b) => b[1].cycles - a[1].cycles).map(([name, {cycles}]) => `${percent(cycles, latency, 0)} ${name}`);
    const key = (name, text) => element('span', {class: 'key'}, element('i', {class: name}), text);
    return [element('h3', {class: 'keys'}, 'Its life: ', key('work', 'in a unit'), key('queue', 'in a FIFO'), key('hold', 'waits for its turn in a unit')), stepBars(model.run, steps, this.from, this.to),
            element('details', {id: 'life'}, element('summary', {}, [first, second].filter(Boolean).join(', '), ' …'),
                    table(['of the node that came last', 'cycles', 'share'], [...rows, ['all', grouped(total), percent(total, latency, 3)]],
                          {class: 'numbers life'}))];
  }

  tree(pixels, run, pixel) {
    const tree = element('ul', {class: 'tree'}), corners = element('ul');
    CORNERS.forEach((name, corner) => {
      const ray = pixels.cornerRay(pixel, corner);
      if (ray !== undefined) corners.append(this.ray(ray, `${name}${corner < 3 ? ' (shared)' : ''}`));
    });
    const top = pixels.topOf(pixel), open = pixels.rays[pixel] <= 1 + POINTS.length * OPEN_NODES;
    tree.append(element('li', {}, element('details', {open: true}, element('summary', {}, 'corners'), corners)));
    if (top !== undefined) tree.append(this.node(top, 'the pixel', open));
    return tree;
  }

  /** A node with the rays and parts that it was split into; these are made when they are first seen. */
  node(node, name, open) {
    const {pixels, run} = this.app.model, which = run.nodes.which[node], request = pixels.requestOfNode[node];
    const level = pixels.maxLevel - run.nodes.log2Side[node];
    const line = this.line({node}, `${name}: ${CASES[which]}`, `level ${level}`, pixels.wayOfNode(node), 'node');
    if (request < 0) return element('li', {}, line);
    const children = element('ul'), fill = () => {
      if (children.childElementCount) return;
      const first = pixels.firstOfRequest[request];
      for (let k = 0; first !== undefined && k < POINTS.length && first + k < run.rays.count; ++k) {
        children.append(this.ray(first + k, POINTS[k]));
      }
      for (const part of pixels.partsOf(node)) {
        const right = run.nodes.column[part] > run.nodes.column[node], lower = run.nodes.row[part] > run.nodes.row[node];
        children.append(this.node(part, CORNERS[2 * lower + right], open));
      }
    };
    if (open) fill();
    return element('li', {}, element('details', {open, ontoggle: fill}, element('summary', {}, line), children));
  }
  ray(ray, name) {
    const {pixels, run} = this.app.model, object = run.rays.object[ray];
    const seen = object === 0 ? 'sees nothing' : `sees ${run.header.run.objects[object - 1] || `object ${object - 1}`}`;
    return element('li', {}, this.line({ray}, `ray ${ray} ${name}`, seen, pixels.wayOfRay(ray), 'ray'));
  }
  line(subject, text, more, steps, kind) {
    const {app} = this;
    const button = element('button', {type: 'button', class: kind, title: `${text}, ${more}`, 'data-ray': subject.ray, onclick: event => {
      event.preventDefault();
      app.selectSubject(subject);
    }}, text, ' ', element('small', {}, more));
    button.subject = subject;
    return element('span', {class: 'line'}, button, stepBars(app.model.run, steps, this.from, this.to));
  }
}
