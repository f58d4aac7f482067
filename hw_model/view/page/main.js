// SPDX-License-Identifier: Apache-2.0
'use strict';

/** Tabs of the panel below the timeline. */
function makeTabs() {
  const tabs = [...document.querySelectorAll('[role=tab]')];
  const choose = chosen => {
    for (const tab of tabs) {
      tab.setAttribute('aria-selected', String(tab === chosen));
      tab.tabIndex = tab === chosen ? 0 : -1;
      document.getElementById(tab.getAttribute('aria-controls')).hidden = tab !== chosen;
    }
  };
  tabs.forEach((tab, k) => {
    tab.addEventListener('click', () => choose(tab));
    tab.addEventListener('keydown', event => {
      const step = {ArrowLeft: -1, ArrowRight: 1}[event.key];
      if (!step) return;
      const next = tabs[(k + step + tabs.length) % tabs.length];
      choose(next);
      next.focus();
    });
  });
  choose(tabs[0]);
}

async function main() {
  const models = (await readRuns()).map(run => new Model(run));
  theme.read();
  document.title = `${models.map(model => model.run.header.name || model.run.header.run.scene.name).join(' and ')}: pyrasim trace`;
  document.body.classList.toggle('two', models.length > 1);
  document.getElementById('loading').remove();
  makeTabs();
  const app = new App(models);
  new Keyboard(app);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
    theme.read();
    app.changed();
  });
  requestAnimationFrame(() => requestAnimationFrame(() => document.body.classList.add('ready')));
}

main().catch(error => {
  const place = document.getElementById('loading') ?? document.body.appendChild(document.createElement('p'));
  place.textContent = `This page cannot be shown: ${error.message}`;
  throw error;
});
