// SPDX-License-Identifier: Apache-2.0
// Colours of the theme, and of maps.
'use strict';

/** The style sheet's colours, by name; to be read again when the theme changes. */
const theme = {
  read() {
    const style = getComputedStyle(document.documentElement);
    for (const name of ['ink', 'dim', 'line', 'panel', 'busy', 'starved', 'blocked', 'idle', 'mark', 'more', 'less', 'fill']) {
      this[name] = style.getPropertyValue(`--${name}`).trim();
    }
    this.states = [this.busy, this.starved, this.hatched(this.blocked), this.idle];
  },
  /** Blocked time is hatched, so that nobody needs colours to tell it. */
  hatched(color) {
    const tile = document.createElement('canvas');
    tile.width = tile.height = 6;
    const context = tile.getContext('2d');
    context.fillStyle = color;
    context.fillRect(0, 0, 6, 6);
    context.strokeStyle = this.panel;
    context.globalAlpha = 0.55;
    context.lineWidth = 1.2;
    context.beginPath();
    for (const x of [-6, 0, 6]) {
      context.moveTo(x, 6);
      context.lineTo(x + 6, 0);
    }
    context.stroke();
    return context.createPattern(tile, 'repeat');
  },
};

const linearOfByte = byte => (byte <= 10.31475 ? byte / 255 / 12.92 : ((byte / 255 + 0.055) / 1.055) ** 2.4);
const byteOfLinear = linear => Math.round(255 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055));
const linearOf = (...bytes) => bytes.map(linearOfByte);
const mixed = (a, b, share) => a.map((value, k) => value + (b[k] - value) * share);

const NODE_COLORS = [null, linearOf(18, 22, 46), linearOf(70, 104, 150), linearOf(255, 244, 170)];  // by case
const SUBDIVIDED = linearOf(236, 106, 34);

/** Of a terminal node in the map of cases, linear. */
function nodeColor(which, level, maxLevel) {
  if (which === 3 || level === 0) return NODE_COLORS[which];
  return mixed(NODE_COLORS[which], SUBDIVIDED, 0.3 + (0.6 * level) / maxLevel);
}

// Both in sRGB bytes.
const HEAT = [[10, 8, 34], [72, 18, 106], [150, 38, 98], [218, 76, 58], [248, 158, 46], [252, 252, 186]];
const DIFFERENCE = [[17, 84, 150], [103, 169, 207], [240, 240, 240], [239, 138, 98], [170, 20, 40]];

/** From the first colour of a scale (0) to its last (1). */
function colorOn(scale, share) {
  const place = Math.max(0, Math.min(1, share)) * (scale.length - 1), k = Math.min(Math.floor(place), scale.length - 2);
  return mixed(scale[k], scale[k + 1], place - k);
}

const cssOf = bytes => `rgb(${bytes.map(Math.round).join(' ')})`;
const gradientOf = scale => `linear-gradient(to right, ${scale.map(cssOf).join(', ')})`;
