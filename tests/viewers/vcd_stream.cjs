// SPDX-License-Identifier: Apache-2.0
// Reads a VCD with vcd-stream and prints, as JSON, each signal's changes: name to the list of [time, value]; x is null.
// Usage: node vcd_stream.cjs NODE_MODULES FILE
'use strict';
const fs = require('fs');
const path = require('path');

const [modules, file] = process.argv.slice(2);
const createVCD = require(path.join(modules, 'vcd-stream/out/vcd.js'));
const parserOf = require(path.join(modules, 'vcd-stream/lib/web-vcd-parser.js'));

async function main() {
  const parser = await parserOf(await createVCD());
  const codes = {}, changes = {};
  const declare = scope => {
    for (const item of scope.body) {
      if (item.kind === 'var') {
        codes[item.link] = item.name;
        changes[item.name] = [];
      } else {
        declare(item);
      }
    }
  };
  parser.on('$enddefinitions', () => declare(parser.info.wires));
  parser.change.any((code, time, command, value, mask) =>
    changes[codes[code]].push([Number(time), mask ? null : Number(value)]));
  fs.createReadStream(file).pipe(parser).on('finish', () => {
    console.log(JSON.stringify({timescale: parser.info.timescale, end: Number(parser.getTime()), changes}));
  });
}

main();
