// SPDX-License-Identifier: Apache-2.0
// The picture and its maps: what pixels look like, what cases they are, what they took.
'use strict';

/** Of each map: its name, and the numbers that it shows of a run's pixels. */
const MAPS = {
  picture: {name: 'Picture'},
  cases: {name: 'Cases'},
  rays: {name: 'Rays', unit: 'rays', value: (pixels, pixel) => pixels.rays[pixel]},
  latency: {name: 'Latency', unit: 'cycles', value: (pixels, pixel) => pixels.latency(pixel)},
  difference: {name: 'B − A', unit: 'cycles'},
};

class PictureView {
  constructor(app, canvas, legend) {
    this.app = app;
    this.canvas = canvas;
    this.legend = legend;
    this.made = new Map();
    this.zoom = 1;
    this.center = [0.5, 0.5];  // of what is shown, in parts of the picture
    canvas.addEventListener('wheel', event => this.wheel(event), {passive: false});
    canvas.addEventListener('pointerdown', event => this.press(event));
    canvas.addEventListener('pointermove', event => this.hover(event));
    canvas.addEventListener('pointerleave', () => app.say(''));
    canvas.addEventListener('keydown', event => this.key(event));
    new ResizeObserver(() => this.draw()).observe(canvas);
  }

  /** The map that is chosen as a canvas of a dot a pixel. */
  async image(model, map) {
    const key = `${this.app.models.indexOf(model)} ${map}`;
    if (!this.made.has(key)) this.made.set(key, map === 'picture' ? await this.decoded(model) : this.painted(model, map));
    return this.made.get(key);
  }
  async decoded(model) {
    const image = new Image();
    image.src = `data:image/png;base64,${model.run.header.picture}`;
    await image.decode();
    return image;
  }

  painted(model, map) {
    const {pixels} = model, {columns, rows} = pixels.window;
    const canvas = document.createElement('canvas');
    canvas.width = columns;
    canvas.height = rows;
    const context = canvas.getContext('2d'), data = context.createImageData(columns, rows);
    const colorOf = map === 'cases' ? this.casePainter(model) : this.heatPainter(model, map);
    for (let pixel = 0; pixel < pixels.count; ++pixel) {
      const color = colorOf(pixel);
      for (let k = 0; k < 3; ++k) data.data[4 * pixel + k] = color ? color[k] : 128;
      data.data[4 * pixel + 3] = color ? 255 : 0;
    }
    context.putImageData(data, 0, 0);
    return canvas;
  }

  casePainter({pixels, run}) {
    const {which, log2Side} = run.nodes, {maxLevel} = pixels;
    return pixel => {
      const sum = [0, 0, 0];
      for (const node of pixels.nodesOf(pixel)) {
        if (which[node] === 0) continue;
        const level = maxLevel - log2Side[node], color = nodeColor(which[node], level, maxLevel);
        for (let k = 0; k < 3; ++k) sum[k] += color[k] / 4 ** level;
      }
      return sum.map(byteOfLinear);
    };
  }

  valuesOf(model, map) {
    const {pixels} = model;
    if (map !== 'difference') return Float64Array.from({length: pixels.count}, (_, pixel) => MAPS[map].value(pixels, pixel));
    const [a, b] = this.app.models;
    return Float64Array.from({length: pixels.count}, (_, pixel) => b.pixels.latency(pixel) - a.pixels.latency(pixel));
  }

  /** By logarithms, as the program's own maps; of differences, from blue (less) to red (more). */
  heatPainter(model, map) {
    const values = this.valuesOf(model, map);
    let least = Infinity, most = -Infinity;
    for (const value of values) {
      if (Number.isNaN(value)) continue;
      least = Math.min(least, value);
      most = Math.max(most, value);
    }
    const range = map === 'difference' ? [-Math.max(-least, most, 1), Math.max(-least, most, 1)] : [least, most];
    this.made.set(`range ${this.app.models.indexOf(model)} ${map}`, range);
    const log = value => Math.log(Math.max(value, 1)), from = log(range[0]), width = log(range[1]) - from;
    return pixel => {
      const value = values[pixel];
      if (Number.isNaN(value)) return undefined;
      if (map === 'difference') return colorOn(DIFFERENCE, 0.5 + (Math.sign(value) * Math.log1p(Math.abs(value))) / Math.log1p(range[1]) / 2);
      return colorOn(HEAT, width > 0 ? (log(value) - from) / width : 0);
    };
  }

  /** {x, y: of the picture's upper left corner on the canvas, scale: of a pixel}. */
  layout() {
    const {columns, rows} = this.app.model.pixels.window;
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    const scale = Math.min(width / columns, height / rows) * this.zoom;
    const place = (size, count, at) => {
      const free = size - count * scale;
      return free >= 0 ? free / 2 : Math.max(free, Math.min(0, size / 2 - at * count * scale));
    };
    return {x: place(width, columns, this.center[0]), y: place(height, rows, this.center[1]), scale};
  }
  pixelAt(event) {
    const {pixels} = this.app.model, {x, y, scale} = this.layout(), {columns, rows} = pixels.window;
    const bounds = this.canvas.getBoundingClientRect();
    const column = Math.floor((event.clientX - bounds.left - x) / scale), row = Math.floor((event.clientY - bounds.top - y) / scale);
    return column >= 0 && row >= 0 && column < columns && row < rows ? row * columns + column : -1;
  }

  async draw() {
    const {app, canvas} = this, {model, map} = app;
    canvas.style.aspectRatio = `${model.pixels.window.columns} / ${model.pixels.window.rows}`;
    const image = await this.image(model, map), ratio = devicePixelRatio;
    this.showLegend();
    const width = Math.round(canvas.clientWidth * ratio), height = Math.round(canvas.clientHeight * ratio);
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
    const context = canvas.getContext('2d'), {x, y, scale} = this.layout();
    const {columns, rows} = model.pixels.window;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, canvas.clientWidth, canvas.clientHeight);
    context.imageSmoothingEnabled = scale < 1;
    context.drawImage(image, x, y, columns * scale, rows * scale);
    if (app.pixel < 0) return;
    const size = Math.max(scale, 5), inset = (size - scale) / 2;
    const left = x + (app.pixel % columns) * scale - inset, top = y + Math.floor(app.pixel / columns) * scale - inset;
    for (const [color, wide] of [['#000', 5], ['#fff', 2]]) {
      context.strokeStyle = color;
      context.lineWidth = wide;
      context.strokeRect(left - 1.5, top - 1.5, size + 3, size + 3);
    }
  }

  showLegend() {
    const {app} = this, {map} = app;
    const swatch = (color, text) => element('span', {class: 'key'}, element('i', {style: `background:${color}`}), text);
    if (map === 'picture') return this.legend.replaceChildren();
    if (map === 'cases') {
      const css = linear => cssOf(linear.map(byteOfLinear)), {maxLevel} = app.model.pixels;
      return this.legend.replaceChildren(swatch(css(NODE_COLORS[1]), 'empty'), swatch(css(NODE_COLORS[2]), 'covered'),
                                         swatch(css(nodeColor(2, maxLevel || 1, maxLevel || 1)), 'the deeper, the more orange'),
                                         swatch(css(NODE_COLORS[3]), `edge at level ${maxLevel}`));
    }
    const range = this.made.get(`range ${app.models.indexOf(app.model)} ${map}`), scale = map === 'difference' ? DIFFERENCE : HEAT;
    const text = map === 'difference' ? signed : grouped;
    this.legend.replaceChildren(text(range[0]), element('i', {class: 'scale', style: `background:${gradientOf(scale)}`}),
                                `${text(range[1])} ${MAPS[map].unit} a pixel`, map === 'difference' ? ': B less A' : '');
  }

  wheel(event) {
    event.preventDefault();
    const {columns, rows} = this.app.model.pixels.window, bounds = this.canvas.getBoundingClientRect();
    const at = [event.clientX - bounds.left, event.clientY - bounds.top];
    const before = this.layout(), zoom = this.zoom;
    this.zoom = Math.max(1, Math.min(64, zoom * Math.exp(-event.deltaY / 400)));
    const size = [this.canvas.clientWidth, this.canvas.clientHeight], counts = [columns, rows], corner = [before.x, before.y];
    const scale = (before.scale * this.zoom) / zoom;
    this.center = at.map((place, k) => ((place - corner[k]) / before.scale + (size[k] / 2 - place) / scale) / counts[k]);
    this.draw();
  }
  press(event) {
    this.canvas.focus();
    const pixel = this.pixelAt(event);
    if (pixel >= 0) this.app.selectPixel(pixel);
  }
  hover(event) {
    const pixel = this.pixelAt(event);
    this.app.say(pixel < 0 ? '' : this.app.pixelText(pixel));
  }
  key(event) {
    const {columns, rows} = this.app.model.pixels.window;
    const move = {ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowUp: [-1, 0], ArrowDown: [1, 0]}[event.key];
    if (!move || event.altKey || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    const pixel = Math.max(this.app.pixel, 0);
    const row = Math.max(0, Math.min(rows - 1, Math.floor(pixel / columns) + move[0]));
    const column = Math.max(0, Math.min(columns - 1, (pixel % columns) + move[1]));
    this.app.selectPixel(row * columns + column);
  }
}
