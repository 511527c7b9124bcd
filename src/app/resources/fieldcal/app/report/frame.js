/* The frame of every report: charts that are drawn once per place, small parts of a page, what was read, light and dark, printing, keys. */
const Frame = (() => {
  'use strict';
  const {el, known, number} = Charts;
  const $ = id => document.getElementById(id);
  const content = id => $(id).querySelector('.content');

  // ---- charts: created once per place, given options, resized together ----

  const charts = new Map();

  /** Twice the pixels, also on plain screens, so that a printed page is sharp. */
  const screen = {pixelRatio: Math.max(2, window.devicePixelRatio || 1)};

  function draw(box, option, onClick) {
    let chart = charts.get(box);
    if (!chart) {
      chart = echarts.init(box, null, {renderer: 'canvas', devicePixelRatio: screen.pixelRatio});
      charts.set(box, chart);
      if (onClick) chart.on('click', onClick);
    } else {
      fit(box, chart);
    }
    chart.setOption(option, true);
  }

  /** Gives a chart the size of its box; one that is hidden has none, and keeps what it had until it is seen again. */
  function fit(box, chart) {
    const {clientWidth: width, clientHeight: height} = box;
    if (width > 0 && (chart.getWidth() !== width || chart.getHeight() !== height)) chart.resize();
  }

  const fitAll = () => { for (const [box, chart] of charts) fit(box, chart); };

  function forget(container) {
    for (const [box, chart] of charts) {
      if (container.contains(box)) {
        chart.dispose();
        charts.delete(box);
      }
    }
    container.replaceChildren();
  }

  function figure(container, title, explanation, className = 'chart') {
    const box = el('div', {class: className, role: 'img', 'aria-label': title + (explanation ? ', ' + explanation : '')});
    container.append(el('figure', {}, el('figcaption', {}, title, el('span', {}, explanation)), box));
    return box;
  }

  function choices(group, values, current, choose) {
    const box = $(group), focused = box.contains(document.activeElement);
    box.replaceChildren(...values.map(([key, label]) =>
      el('button', {type: 'button', 'aria-pressed': String(key === current), onclick: () => choose(key)}, label)));
    // Who works with the keyboard stays where they are.
    const pressed = focused && box.querySelector('[aria-pressed="true"]');
    if (pressed) pressed.focus({preventScroll: true});
  }

  function badge(level, text) {
    return el('span', {class: 'badge ' + level}, text);
  }

  /** A small picture of a symbol for a legend, drawn like in the plots. */
  function swatch(shape, colour, hollow) {
    const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
    svg.setAttribute('width', shape === 'line' || shape === 'dashes' || shape === 'band' ? 26 : 14);
    svg.setAttribute('height', 14);
    svg.setAttribute('aria-hidden', 'true');
    const paths = {
      circle: 'M2,7a5,5 0 1,0 10,0a5,5 0 1,0 -10,0', triangle: 'M7,2L12,12H2Z', rect: 'M2,2H12V12H2Z', diamond: 'M7,1L13,7L7,13L1,7Z',
      line: 'M0,7H26', dashes: 'M0,7H7M10,7H17M20,7H26', band: 'M0,1H26V13H0Z', cross: 'M3,3L11,11M3,11L11,3',
    };
    const node = document.createElementNS('http://www.w3.org/2000/svg', 'path');
    node.setAttribute('d', paths[shape]);
    const stroke = hollow || ['line', 'dashes', 'cross'].includes(shape);
    node.setAttribute('fill', stroke ? 'none' : colour);
    if (stroke) { node.setAttribute('stroke', colour); node.setAttribute('stroke-width', 2); }
    if (shape === 'band') node.setAttribute('opacity', 0.3);
    svg.append(node);
    return svg;
  }

  /** A button that copies a text. Where a browser lets nobody write to the clipboard, the text is shown to be copied by hand. */
  function copyButton(text, what) {
    const press = async () => {
      try {
        await navigator.clipboard.writeText(text());
        node.textContent = '✔ copied';
      } catch (refused) {
        const copy = el('textarea', {class: 'copied', readonly: '', rows: 4, 'aria-label': what}, text());
        node.after(copy);
        copy.select();
        copy.addEventListener('blur', () => copy.remove());
        node.textContent = 'Ctrl+C copies it';
      }
      setTimeout(() => { node.textContent = 'Copy'; }, 3000);
    };
    const node = el('button', {type: 'button', class: 'copy', title: 'Copies ' + what, 'aria-label': 'Copy ' + what, onclick: press}, 'Copy');
    return node;
  }

  // ---- what a report is made from ----

  /** The line under the heading and the one at the end of the page, with the keys that the page has in addition to t. */
  function showProvenance({sources, recordedUnix, duration, generatedBy, seed}, keys) {
    const facts = [sources.map(Charts.fileName).join(', ')];
    if (known(recordedUnix)) facts.push('recorded ' + new Date(recordedUnix * 1000).toISOString().slice(0, 16).replace('T', ' ') + ' UTC');
    if (known(duration)) facts.push(Math.floor(duration / 60) + ' min ' + number(duration % 60, 0) + ' s');
    $('provenance').textContent = facts.filter(Boolean).join(' · ');
    $('provenance').title = sources.join('\n');
    $('footer').textContent = 'Made by ' + generatedBy + ', seed ' + seed + '. Charts by Apache ECharts 5.6.0 (Apache License 2.0). ' + (keys ? 'Keys: ' + keys + ', t changes' : 'Key: t changes') + ' between light and dark.';
  }

  /** On a phone the columns of a wide table do not fit beside each other: there each cell says what it is. */
  function cards(table) {
    const heads = [...table.querySelectorAll('thead th')].map(head => head.textContent.trim());
    for (const row of table.querySelectorAll('tbody tr')) {
      [...row.children].forEach((cell, i) => { if (cell.colSpan === 1 && heads[i] && (cell.textContent || cell.firstElementChild)) cell.dataset.head = heads[i]; });
    }
    table.classList.add('cards');
    return table;
  }

  function showProblems(problems) {
    const box = content('problems');
    if (problems.length === 0) {
      box.replaceChildren(el('p', {class: 'empty'}, 'None: every record was read and used.'));
      return;
    }
    const rows = problems.map(problem => el('tr', {}, el('td', {}, problem.count + ' ×'), el('td', {class: 'text wrap'}, problem.what), el('td', {class: 'text wrap'}, problem.where), el('td', {class: 'text wrap'}, problem.advice)));
    box.replaceChildren(cards(el('table', {}, el('thead', {}, el('tr', {}, ['Count', 'What', 'Where', 'What it means'].map((h, i) => el('th', {scope: 'col', class: i ? 'text' : null}, h)))), el('tbody', {}, rows))));
  }

  // ---- theme, paper, keys ----

  /**
   * Shows a page and keeps it right. The page gives: use(theme), which is told the colours; showAll(); resized(); and keys, what each key
   * does.
   */
  function start(cameraIds, page) {
    const setTheme = name => {
      document.documentElement.dataset.theme = name;
      $('theme').textContent = name === 'dark' ? 'Light' : 'Dark';
      page.use(Charts.theme(cameraIds));
    };
    const dark = window.matchMedia('(prefers-color-scheme: dark)');
    const wanted = new URLSearchParams(location.search).get('theme');
    setTheme(wanted === 'dark' || wanted === 'light' ? wanted : dark.matches ? 'dark' : 'light');
    const change = name => { setTheme(name); page.showAll(); };
    const other = () => document.documentElement.dataset.theme === 'dark' ? 'light' : 'dark';
    dark.addEventListener('change', event => change(event.matches ? 'dark' : 'light'));
    $('theme').addEventListener('click', () => change(other()));
    $('print').addEventListener('click', () => window.print());
    document.addEventListener('keydown', event => {
      if (event.ctrlKey || event.altKey || event.metaKey || (event.target instanceof Element && event.target.matches('input, textarea, select'))) return;
      if (event.key === 't') change(other());
      else if (Object.hasOwn(page.keys, event.key)) page.keys[event.key]();
    });

    // Paper is white, and a little narrower than the screen.
    let beforePrint = null;
    window.addEventListener('beforeprint', () => { beforePrint = document.documentElement.dataset.theme; if (beforePrint !== 'light') change('light'); });
    window.addEventListener('afterprint', () => { if (beforePrint && beforePrint !== 'light') change(beforePrint); });

    let resizing = 0;
    window.addEventListener('resize', () => {
      cancelAnimationFrame(resizing);
      resizing = requestAnimationFrame(() => {
        fitAll();
        page.resized();
      });
    });
    page.showAll();
  }

  return {$, content, charts, screen, draw, fitAll, forget, figure, choices, badge, swatch, copyButton, cards, showProvenance, showProblems, start};
})();
