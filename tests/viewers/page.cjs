// SPDX-License-Identifier: Apache-2.0
// Opens a trace page in headless Chromium, does steps with real clicks and keys, and prints what was seen as JSON.
// Usage: node page.cjs NODE_MODULES CHROMIUM PAGE FOLDER STEPS     FOLDER: for the browser's own files; STEPS: JSON,
// {width, height, scheme, steps: [[step, argument ...] ...]}
'use strict';
const path = require('path');

const [modules, chromium, file, folder, task] = process.argv.slice(2);
const {width, height, scheme, steps} = JSON.parse(task);
const playwright = require(path.join(modules, 'playwright-core'));
const flags = ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking',
               '--disable-component-update', '--disable-sync'];
const patience = 300000; // milliseconds for a step: machines may be slow and busy

/** Each step gives what it saw, or nothing. */
const kinds = {
  key: (page, key, times = 1) => [...Array(times)].reduce(before => before.then(() => page.keyboard.press(key)), Promise.resolve()),
  type: (page, text) => page.keyboard.type(text),
  click: (page, selector, number = 0) => page.locator(selector).nth(number).click(),
  /** At a place in parts of the element's size. */
  clickAt: async (page, selector, x, y) => {
    const box = await page.locator(selector).boundingBox();
    await page.mouse.click(box.x + x * box.width, box.y + y * box.height);
  },
  /** The row of that name, in the middle of a cycle that is shown. */
  clickCycle: async (page, name, cycle) => {
    const label = page.locator(`.label[title="${name}"]`);
    await label.scrollIntoViewIfNeeded();
    const row = await label.boundingBox(), canvas = await page.locator('#rows').boundingBox();
    const [from, to] = (await page.textContent('#readout')).match(/[\d,]+/g).map(text => Number(text.replace(/,/g, '')));
    await page.mouse.click(canvas.x + ((cycle + 0.5 - from) / (to - from)) * canvas.width, row.y + 8);
    await page.mouse.move(2, 2);
  },
  text: (page, selector) => page.textContent(selector),
  texts: (page, selector) => page.locator(selector).allTextContents(),
  table: (page, selector) => page.$$eval(`${selector} tbody tr`, rows => rows.map(row => [...row.cells].map(cell => cell.textContent))),
  value: (page, script) => page.evaluate(script),
  screenshot: (page, name) => page.screenshot({path: name}),
};

async function main() {
  const browser = await playwright.chromium.launchPersistentContext(
      folder, {executablePath: chromium, headless: true, args: flags, timeout: patience, colorScheme: scheme, viewport: {width, height}});
  try {
    browser.setDefaultTimeout(patience);
    const page = await browser.newPage(), seen = [], errors = [], requests = [];
    page.on('pageerror', error => errors.push(error.message));
    page.on('console', message => errors.push(message.text()));
    page.on('request', request => /^(file|data|blob):/.test(request.url()) || requests.push(request.url()));
    const begin = Date.now();
    await page.goto(`file://${file}`);
    await page.waitForSelector('body.ready');
    const milliseconds = Date.now() - begin;
    for (const [kind, ...rest] of steps) {
      const result = await kinds[kind](page, ...rest);
      await page.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));
      if (['text', 'texts', 'table', 'value'].includes(kind)) seen.push(result);
    }
    console.log(JSON.stringify({milliseconds, seen, errors, requests}));
  } finally {
    await browser.close();
  }
}

main().catch(error => {
  console.error(error);
  process.exitCode = 1;
});
