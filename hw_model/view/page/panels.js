// SPDX-License-Identifier: Apache-2.0
// Texts beside the pictures: the frame's numbers, what is selected, tables of units and FIFOs, finds.
'use strict';

function titleOf(model) {
  const {run} = model.run.header, {window} = model.pixels;
  return `${run.scene.name.split('/').at(-1)}, ${window.columns}×${window.rows} pixels, MAX_LEVEL ${model.pixels.maxLevel}, on machine ${run.machine.name}`;
}

/** Numbers of a run, by name. */
function factsOf(model) {
  const {header, rays, nodes} = model.run, {cycles, clock_mhz: clock} = header;
  const primary = model.pixels.primary.length;
  let terminal = 0;
  for (const which of nodes.which) terminal += which > 0;
  return {
    cycles: [grouped(cycles), header.complete ? `${grouped((clock * 1e6) / cycles)} frames per second at ${clock} MHz` : 'broken off'],
    budget: [header.complete ? (cycles <= header.budget ? 'met' : 'missed') : '–', `${grouped(header.budget)} cycles`],
    rays: [grouped(rays.count), `${grouped(primary)} primary, ${grouped(rays.count - primary)} of subdivisions`],
    'terminal nodes': [grouped(terminal), ''],
    'longest latency': [grouped(model.latencies.max), `cycles of a pixel; ${grouped(model.latencies.mean)} in the mean`],
  };
}

function summary(app, place) {
  place.replaceChildren(...app.models.map((model, r) => element(
      'section', {class: r === app.active ? 'active' : ''},
      app.models.length > 1 ? element('button', {type: 'button', 'aria-pressed': String(r === app.active), onclick: () => app.activate(r)}, 'AB'[r]) : '',
      element('h1', {}, model.run.header.name ? `${model.run.header.name}: ` : '', titleOf(model)),
      element('dl', {}, ...Object.entries(factsOf(model)).map(([name, [value, more]]) => element(
          'div', {title: more}, element('dt', {}, name), element('dd', {}, value), element('dd', {class: 'aside'}, more)))))));
}

/** Cycles in each state of each unit, of the whole frame; of two runs, and their difference. */
function unitTable(app) {
  const headings = ['unit', ...STATES.flatMap(state => [state, 'cycles'])], rows = [];
  for (const row of new Rows(app.models).groups.values()) {
    for (const unit of row.kind === 'unit' ? row.rows : []) {
      const shares = app.models.map((model, r) => unit.members[r].length ? model.times[unit.members[r][0]].between(0, model.cycles) : undefined);
      shares.forEach((sums, r) => sums && rows.push([
        app.models.length > 1 ? `${'AB'[r]} ${unit.name}` : unit.name,
        ...sums.flatMap(cycles => [percent(cycles, app.models[r].cycles), grouped(cycles)])]));
      if (shares.length < 2 || !shares[0] || !shares[1]) continue;
      rows.push(['B − A', ...STATES.flatMap((_, state) => [
        `${signed(100 * (shares[1][state] / app.models[1].cycles - shares[0][state] / app.models[0].cycles))} points`,
        signed(shares[1][state] - shares[0][state])])]);
    }
  }
  return table(headings, rows, {class: 'numbers', id: 'units'});
}

function fifoTable(app) {
  const rows = app.models.flatMap((model, r) => model.run.fifos.map((fifo, k) => [
    app.models.length > 1 ? `${'AB'[r]} ${fifo.name}` : fifo.name, grouped(fifo.depth), grouped(model.fills[k].max(0, model.cycles)),
    model.fills[k].mean(0, model.cycles).toFixed(2), grouped(fifo.read)]));
  return table(['FIFO', 'depth', 'max', 'mean', 'tokens read'], rows, {class: 'numbers', id: 'fifos'});
}

/** What the keys and the search find: {name, go}. */
function findsOf(app) {
  const {model} = app, finds = [];
  longestPixels(model.pixels).forEach((pixel, k) => {
    const [row, column] = model.pixels.placeOf(pixel);
    finds.push({kind: 'Longest pixels', name: `row ${row}, column ${column}`, value: cyclesText(model.pixels.latency(pixel)),
                go: () => app.selectPixel(pixel, true), key: k === 0 ? 'l' : undefined});
  });
  const waitFind = (kind, wait, key) => ({
    kind, key, name: `${model.run.units[wait.unit].name} ${STATES[wait.state]} ${wait.state === STARVED ? 'by' : 'for room in'} ${shortName(model.run.fifos[wait.cause].name)}`,
    value: `${cyclesText(wait.to - wait.from)} at ${grouped(wait.from)}`, go: () => app.selectSpan(model, wait.unit, wait, true)});
  const stall = firstStall(model.times);
  if (stall) finds.push(waitFind('First stall', stall, 'f'));
  longestWaits(model.times).forEach((wait, k) => finds.push(waitFind('Longest waits', wait, k === 0 ? 'w' : undefined)));
  return finds;
}

function findPanel(app) {
  const {bottleneck} = app.model.run.header, panel = element('div', {id: 'finds'});
  if (bottleneck) panel.append(element('h3', {}, 'Bottleneck'), element('p', {}, bottleneck.replaceAll('<-', '←')));
  let kind;
  for (const find of app.finds) {
    if (find.kind !== kind) panel.append(element('h3', {}, kind = find.kind), element('ol'));
    panel.lastChild.append(element('li', {}, element('button', {type: 'button', onclick: find.go}, element('span', {}, find.name),
                                                     element('span', {class: 'value'}, find.value),
                                                     find.key ? element('kbd', {}, find.key) : '')));
  }
  return panel;
}

/** The steps of a ray or node: where it was, for how long, and why it waited. */
function stepTable(model, steps) {
  const rows = steps.map(step => {
    const end = Math.min(step.to, model.cycles);
    let why = '';
    if (step.fifo !== undefined && end > step.from) {
      const {reader} = model.run.fifos[step.fifo];
      why = reasonsOf(model.times[reader], step.from, end).map(({state, cause, cycles}) => state === BUSY || state === IDLE ?
          `reader ${STATES[state]} for ${cycles}` :
          `reader ${STATES[state]} ${state === STARVED ? 'by' : 'for room in'} ${shortName(model.run.fifos[cause].name)} for ${cycles}`).join('; ');
    } else if (step.unit !== undefined && step.waits) {
      why = 'its turn';
    }
    const name = step.fifo === undefined ? model.run.units[step.unit].name : `FIFO ${shortName(model.run.fifos[step.fifo].name)}`;
    return [element('span', {class: 'key'}, element('i', {class: classOfStep(step)}), name), grouped(step.from), grouped(step.to),
            grouped(step.to - step.from), why];
  });
  return table(['where', 'from', 'to', 'cycles', 'waited because'], rows, {class: 'numbers steps'});
}

function selectionPanel(app, panel) {
  const {model, subject, span, fifo} = app, parts = [];
  if (span) {
    const unit = span.model.run.units[span.unit], {cause} = span;
    const about = span.state === BUSY ? ` with ${subjectText(unit, unit.subject[span.firing])}` :
        span.state === STARVED ? `: nothing to read in ${span.model.run.fifos[cause].name}` :
        span.state === BLOCKED ? `: no room in ${span.model.run.fifos[cause].name}` : '';
    parts.push(element('h2', {id: 'span'}, `${unit.name} ${STATES[span.state]}${about}`),
               element('p', {}, `${spanText(span.from, span.to)}, ${cyclesText(span.to - span.from)}`));
  }
  if (fifo) {
    const its = model.run.fifos[fifo.number], first = countBelow(its.left, fifo.date), last = countBelow(its.written, fifo.date + 1);
    parts.push(element('h2', {id: 'span'}, `${its.name}: ${last - first} of ${its.depth} tokens in cycle ${grouped(fifo.date)}`));
    const about = its.about === 'nothing' ? '' : its.about === 'nodes' ? 'node' : 'ray';
    const tokens = [...its.subject.subarray(first, last)];
    if (about) parts.push(element('p', {}, ...tokens.flatMap(token => [element('button', {type: 'button', onclick: () => app.selectSubject({[about]: token})}, `${about} ${token}`), ' '])));
  }
  if (subject) {
    const ray = subject.ray !== undefined, pixel = app.pixelOf(subject);
    const [row, column] = pixel < 0 ? [] : model.pixels.placeOf(pixel);
    parts.push(element('h3', {id: 'subject'}, `${ray ? `Ray ${subject.ray}` : `Node ${subject.node}`}${pixel < 0 ? ', which completes no pixel' : ` of the pixel in row ${row}, column ${column}`}`),
               stepTable(model, app.wayOf(subject)));
  }
  if (parts.length === 0) parts.push(element('p', {class: 'hint'}, 'Click a span for its ray and pixel. Wheel: zoom; drag: pan; ? for keys.'));
  panel.replaceChildren(...parts);
}
