// SPDX-License-Identifier: Apache-2.0
// Opens a profile in speedscope in headless Chromium and prints what speedscope exports of it: its own file format.
// Usage: node speedscope.cjs NODE_MODULES CHROMIUM PROFILE FOLDER      FOLDER: for the browser's own files, empty
'use strict';
const fs = require('fs');
const path = require('path');

const [modules, chromium, profile, folder] = process.argv.slice(2);
const playwright = require(path.join(modules, 'playwright-core'));
const flags = ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking',
               '--disable-component-update', '--disable-sync'];
const patience = 300000; // milliseconds for a step: machines may be slow and busy

async function main() {
  const browser = await playwright.chromium.launchPersistentContext(
      folder, {executablePath: chromium, headless: true, args: flags, timeout: patience, acceptDownloads: true});
  try {
    browser.setDefaultTimeout(patience);
    const page = await browser.newPage();
    // As speedscope's own command does it.
    const script = path.join(folder, 'profile.js');
    const base64 = fs.readFileSync(profile).toString('base64');
    fs.writeFileSync(script, `speedscope.loadFileFromBase64("${path.basename(profile)}", "${base64}")`);
    await page.goto('file://' + path.join(modules, 'speedscope/dist/release/index.html') + '#localProfilePath=' + script);
    await page.waitForFunction(() => document.querySelector('canvas') !== null);
    const download = page.waitForEvent('download');
    await page.keyboard.press('Control+s');
    process.stdout.write(fs.readFileSync(await (await download).path()));
  } finally {
    await browser.close();
  }
}

main().catch(error => {
  console.error(error);
  process.exitCode = 1;
});
