/* The calibration report's page: puts the view model into tables and plots, and keeps one kick selected. */
(() => {
  'use strict';
  const {el, withError} = Charts;
  const {$, content, charts, draw, forget, figure, choices} = Frame;
  const {KINDS, COLUMNS, FILTERS, whyDropped, sorted} = CalibrationViews;
  const {report} = JSON.parse(document.getElementById('data').textContent);
  const cameraIds = [...new Set([...report.cameras.map(c => c.id), ...report.kicks.flatMap(k => k.seen.map(s => s.camera))])].sort((a, b) => a - b);
  const kinds = Object.keys(KINDS).filter(kind => report.kicks.some(k => k.kind === kind));
  const state = {kick: null, kind: kinds[0], axis: 'kick', filter: 'all', sort: {key: 'id', down: false}, shown: []};
  let theme;

  // ---- top: provenance, verdict, model, cameras ----

  function showTop() {
    Frame.showProvenance(report.provenance, 'j and k go to the next and the previous kick');
    CalibrationViews.verdict($('verdict'), report.verdict, report.warnings);
    content('model').replaceChildren(...CalibrationViews.model(report));
    content('cameras').replaceChildren(CalibrationViews.cameras(theme, report));
  }

  // ---- parameters over the kicks ----

  function showParameters() {
    const box = content('parameters');
    forget(box);
    choices('parameter-kind', kinds.map(kind => [kind, KINDS[kind]]), state.kind, kind => { state.kind = kind; showParameters(); });
    choices('parameter-axis', Object.entries(Plots.AXES).map(([key, axis]) => [key, 'over ' + axis.label]), state.axis, key => { state.axis = key; showParameters(); });
    $('parameter-legend').replaceChildren(...CalibrationViews.parameterLegend(theme));
    const model = report.models.find(m => m.kind === state.kind);
    const kicks = report.kicks.filter(k => k.kind === state.kind);
    if (!model || kicks.length === 0) {
      box.append(el('p', {class: 'empty'}, report.kicks.length ? 'None of these kicks has a fit.' : 'No kicks.'));
      return;
    }
    const fitted = model.parameters.filter(parameter => kicks.some(k => k.parameters.some(p => p.name === parameter.name)));
    const places = fitted.map(parameter => figure(box, parameter.words + (parameter.unit ? ' [' + parameter.unit + ']' : ''), withError(parameter.mean, parameter.standardError)));
    // Drawn when all are there: their number decides how wide each is.
    for (const [i, chart] of places.entries()) {
      const parameter = fitted[i];
      chart.dataset.parameter = parameter.name;
      draw(chart, Plots.parameter(theme, parameter, kicks, state.axis, state.kick && state.kick.id), event => event.data && event.data.kick && select(event.data.kick));
    }
  }

  function markParameters() {
    const model = report.models.find(m => m.kind === state.kind);
    for (const [chart] of charts) {
      const parameter = model && model.parameters.find(p => p.name === chart.dataset.parameter);
      if (parameter) draw(chart, Plots.parameter(theme, parameter, report.kicks.filter(k => k.kind === state.kind), state.axis, state.kick && state.kick.id));
    }
  }

  // ---- the table of kicks ----

  function showKicks() {
    choices('kick-filter', Object.keys(FILTERS).map(key => [key, key + ' ' + report.kicks.filter(FILTERS[key]).length]), state.filter, key => { state.filter = key; showKicks(); });
    state.shown = sorted(report.kicks.filter(FILTERS[state.filter]), state.sort);
    const box = content('kicks');
    if (state.shown.length === 0) {
      box.replaceChildren(el('p', {class: 'empty', style: 'padding-left: 12px'}, report.kicks.length ? 'None.' : 'No kick was found in the recording.'));
      return;
    }
    const head = COLUMNS.map(column => {
      const current = state.sort.key === column.key;
      const sort = () => {
        state.sort = {key: column.key, down: current && !state.sort.down};
        showKicks();
        box.querySelector('th[data-key="' + column.key + '"] button').focus();
      };
      return el('th', {scope: 'col', 'data-key': column.key, class: column.left ? 'text' : null, title: column.title, 'aria-sort': current ? (state.sort.down ? 'descending' : 'ascending') : null},
        el('button', {type: 'button', onclick: sort}, column.label + (current ? (state.sort.down ? '\u00a0▾' : '\u00a0▴') : '')));
    });
    const rows = state.shown.flatMap(kick => {
      const row = el('tr', {'data-kick': kick.id, class: whyDropped(kick) ? 'dropped' : null, onclick: () => select(kick.id)},
        COLUMNS.map(column => el('td', {class: column.left ? 'text' : null}, column.text(kick))));
      const why = whyDropped(kick);
      return why ? [row, el('tr', {class: kick.selected ? 'why part' : 'why', onclick: () => select(kick.id)}, el('td', {colspan: COLUMNS.length}, why))] : [row];
    });
    const body = el('tbody', {}, rows);
    body.addEventListener('keydown', tableKeys);
    box.replaceChildren(el('table', {}, el('thead', {}, el('tr', {}, head)), body));
    markRow(false);
  }

  function tableKeys(event) {
    const steps = {ArrowDown: 1, ArrowUp: -1, PageDown: 10, PageUp: -10, Home: -Infinity, End: Infinity};
    if (!(event.key in steps) || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    step(steps[event.key], true);
  }

  /** Selects the kick so many rows further down in the table as it is shown. */
  function step(rows, focus) {
    if (state.shown.length === 0) return;
    const now = state.shown.indexOf(state.kick);
    const next = now < 0 ? 0 : Math.max(0, Math.min(state.shown.length - 1, now + rows));
    select(state.shown[next].id, focus);
  }

  function markRow(focus) {
    const box = content('kicks');
    let reachable = null;
    for (const row of box.querySelectorAll('tr[data-kick]')) {
      const selected = state.kick && row.dataset.kick === String(state.kick.id);
      row.setAttribute('aria-selected', String(Boolean(selected)));
      row.tabIndex = selected ? 0 : -1;
      if (selected) reachable = row;
    }
    if (!reachable) {
      const first = box.querySelector('tr[data-kick]');
      if (first) first.tabIndex = 0;
      return;
    }
    // Scrolls the list only, never the page: the operator may be looking at the parameters above.
    const list = reachable.closest('.content');
    const head = list.querySelector('thead').offsetHeight;
    const top = reachable.offsetTop - head;
    if (top < list.scrollTop) list.scrollTop = top;
    const bottom = reachable.offsetTop + reachable.offsetHeight * 2;
    if (bottom > list.scrollTop + list.clientHeight) list.scrollTop = bottom - list.clientHeight;
    if (focus) reachable.focus({preventScroll: true});
  }

  // ---- the selected kick ----

  function select(id, focus) {
    const kick = report.kicks.find(k => k.id === id);
    if (!kick || kick === state.kick) return;
    state.kick = kick;
    try { history.replaceState(null, '', '#kick=' + id); } catch (refused) { /* some browsers refuse this for files */ }
    if (kick.kind !== state.kind) {
      state.kind = kick.kind;
      showParameters();
    } else {
      markParameters();
    }
    markRow(focus);
    showKick();
  }

  function showKick() {
    const kick = state.kick;
    const box = $('kick-charts');
    $('previous').disabled = $('next').disabled = !kick;
    if (!kick) {
      forget(box);
      return;
    }
    $('kick-title').textContent = CalibrationViews.kickTitle(kick);
    $('kick-facts').replaceChildren(...CalibrationViews.kickFacts(report, kick));
    $('kick-legend').replaceChildren(...CalibrationViews.kickLegend(theme, kick));
    CalibrationViews.layOutKick(box, kick);
    CalibrationViews.drawKick(theme, box, report, kick);
  }

  // ---- the whole page ----

  function showAll() {
    showTop();
    Frame.showProblems(report.problems);
    $('parameters').hidden = $('bench').hidden = report.kicks.length === 0;
    if (report.kicks.length === 0) return;
    showParameters();
    showKicks();
    showKick();
  }

  $('previous').addEventListener('click', () => step(-1));
  $('next').addEventListener('click', () => step(1));
  const asked = Number((/^#kick=(\d+)$/.exec(location.hash) || [])[1]);
  state.kick = report.kicks.find(k => k.id === asked) || report.kicks.find(k => k.selected) || report.kicks[0] || null;
  if (state.kick) state.kind = state.kick.kind;
  Frame.start(cameraIds, {
    use: colours => { theme = colours; },
    showAll,
    resized: () => { if (state.kick) CalibrationViews.drawKick(theme, $('kick-charts'), report, state.kick); },
    keys: {j: () => step(1), k: () => step(-1)},
  });
  window.addEventListener('hashchange', () => select(Number((/^#kick=(\d+)$/.exec(location.hash) || [])[1])));
})();
