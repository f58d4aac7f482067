// SPDX-License-Identifier: Apache-2.0
// Numbers and names as texts, and elements made of them.
'use strict';

const grouped = number => Number.isFinite(number) ? number.toLocaleString('en-US', {maximumFractionDigits: 1}) : '…';
const signed = (number, digits = 1) =>
    `${number < 0 ? '−' : '+'}${Math.abs(number).toLocaleString('en-US', {maximumFractionDigits: digits})}`;
const percent = (part, whole, digits = 1) => `${((100 * part) / whole).toFixed(digits)} %`;
const cyclesText = cycles => `${grouped(cycles)} cycle${cycles === 1 ? '' : 's'}`;
const spanText = (from, to) => `cycle ${grouped(from)} to ${grouped(to)}`;

/** FIFOs by their two ends, in few words; the names of statistics are in titles. */
function shortName(name) {
  return name.replace(/view_vector_|pixel_(?=scan)|pyramid_|subdivision_|tree_|_unit/g, '').replace('_to_', ' → ').replace(/_/g, ' ');
}

/** An element with attributes (onclick and the like are listeners) and children: texts or elements. */
function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === 'function') made.addEventListener(name.slice(2), value);
    else if (value !== undefined && value !== false) made.setAttribute(name, value === true ? '' : value);
  }
  made.append(...children.filter(child => child !== undefined));
  return made;
}

/** A table of texts or elements; `headings` name the columns. */
function table(headings, rows, attributes = {}) {
  return element('table', attributes, element('thead', {}, element('tr', {}, ...headings.map(text => element('th', {scope: 'col'}, text)))),
                 element('tbody', {}, ...rows.map(row => element('tr', {}, ...row.map(cell => element('td', {}, cell))))));
}
