/* The calibration report's page: puts the view model into tables and plots, and keeps one kick selected. */
(() => {
  'use strict';
  const {el, known, number, signed, withError} = Charts;
  const {$, content, charts, draw, forget, figure, choices, badge, swatch} = Frame;
  const {verdict, report} = JSON.parse(document.getElementById('data').textContent);
  const KINDS = {FLAT: 'flat', CHIP: 'chip'};
  const cameraIds = [...new Set([...report.cameras.map(c => c.id), ...report.kicks.flatMap(k => k.seen.map(s => s.camera))])].sort((a, b) => a - b);
  const noises = Object.fromEntries(report.cameras.map(c => [c.id, c.noiseMm]));
  const kinds = Object.keys(KINDS).filter(kind => report.kicks.some(k => k.kind === kind));
  const state = {kick: null, kind: kinds[0], axis: 'kick', filter: 'all', sort: {key: 'id', down: false}, shown: []};
  let theme;

  // ---- top: provenance, verdict, model, cameras ----

  function showTop() {
    Frame.showProvenance(report.provenance, 'j and k go to the next and the previous kick');
    const ACTIONS = {PUBLISH: '✔ Publish', KEEP: '✔ Keep the published model', CHECK: '⚠ Check before you publish', RECORD_MORE: '⚠ Record more kicks', NO_KICKS: '✘ No kick found'};
    const box = $('verdict');
    box.className = verdict.advice.toLowerCase();
    box.replaceChildren(...verdict.lines.map((line, i) => el('p', {}, i === 0 ? el('b', {class: 'action'}, ACTIONS[verdict.advice]) : '', line)));
    if (report.warnings.length) box.append(el('ul', {}, report.warnings.map(warning => el('li', {}, warning))));
  }

  function difference(parameter) {
    const percent = parameter.differencePercent;
    if (!known(percent)) return '–';
    const text = signed(percent, Math.abs(percent) < 9.95 ? 1 : 0) + ' %';
    if (!parameter.differs) return badge('good', '≈ ' + text);
    return badge(Math.abs(percent) >= 20 ? 'bad' : 'warn', (percent > 0 ? '▲ ' : '▼ ') + text);
  }

  function modelRow(parameter) {
    const digits = Charts.decimals(parameter.standardError);
    return el('tr', {},
      el('td', {class: 'text'}, parameter.name, parameter.unit ? el('small', {}, ' ' + parameter.unit) : ''),
      el('td', {class: 'big', title: known(parameter.sigma) ? 'scatter between the kicks beyond their own errors: ' + number(parameter.sigma, digits) : null}, withError(parameter.mean, parameter.standardError)),
      el('td', {}, parameter.n),
      el('td', {}, withError(parameter.joint, parameter.jointStandardError)),
      el('td', {}, Plots.asPublished(parameter.published)),
      el('td', {title: parameter.note || null}, difference(parameter)));
  }

  function showModel() {
    const box = content('model');
    if (report.models.length === 0) {
      box.replaceChildren(el('p', {class: 'empty'}, 'No model: no kick could be used.'));
      return;
    }
    const body = report.models.flatMap(model => {
      const kicks = report.kicks.filter(k => k.kind === model.kind);
      const used = kicks.filter(k => k.selected).length;
      const group = (model.kind === 'FLAT' ? 'Flat' : 'Chip') + ' — ' + used + ' of ' + kicks.length + ' kicks' + (known(model.jointRmsMm) ? ', joint fit leaves ' + number(model.jointRmsMm, 2) + ' mm per axis' : '');
      return [el('tr', {class: 'group'}, el('th', {colspan: 6}, group)), ...model.parameters.map(modelRow)];
    });
    const head = ['Parameter', 'Mean ± s.e.', 'n', 'Joint fit', 'Published', 'Difference'];
    box.replaceChildren(
      el('div', {class: 'scroll'}, el('table', {}, el('thead', {}, el('tr', {}, head.map((h, i) => el('th', {scope: 'col', class: i ? null : 'text'}, h)))), el('tbody', {}, body))),
      ...report.models.flatMap(model => [model.note, ...model.parameters.filter(p => p.note).map(p => p.name + ': ' + p.note)]).filter(Boolean).map(note => el('p', {class: 'note'}, note)));
  }

  /** What an offset means, in words; nothing is said of one that is within its error or too small to matter. */
  function offsetWords(camera) {
    if (!known(camera.offsetXMm) && !known(camera.offsetYMm)) return 'offset not determined';
    const parts = [['x', camera.offsetXMm, camera.offsetXErrorMm], ['y', camera.offsetYMm, camera.offsetYErrorMm]]
      .filter(([, offset, error]) => Math.abs(offset) >= 2 && !(Math.abs(offset) < 3 * error))
      .map(([name, offset]) => number(Math.abs(offset), 0) + ' mm too far towards ' + (offset > 0 ? '+' : '−') + name);
    return parts.length ? 'reports ' + parts.join(' and ') : 'agrees with the others';
  }

  function showCameras() {
    const box = content('cameras');
    if (report.cameras.length === 0) {
      box.replaceChildren(el('p', {class: 'empty'}, 'No camera saw a kick.'));
      return;
    }
    const rows = report.cameras.flatMap(camera => {
      const style = theme.camera(camera.id);
      const apart = offsetWords(camera);
      return [
        el('tr', {},
          el('td', {class: 'text'}, swatch(style.symbol, style.colour), ' ' + camera.id),
          el('td', {}, number(camera.noiseMm, 1)), el('td', {}, number(camera.rateHz, 1)), 
          el('td', {}, withError(camera.offsetXMm, camera.offsetXErrorMm)), el('td', {}, withError(camera.offsetYMm, camera.offsetYErrorMm))),
        el('tr', {}, el('td', {class: 'text wrap', colspan: 5}, badge(apart.startsWith('reports') ? 'warn' : 'good', 'camera ' + camera.id + ' ' + apart), ' ' + camera.observations + ' observations' + (camera.note ? '; ' + camera.note : ''))),
      ];
    });
    const head = [['', ''], ['Noise', 'mm'], ['Rate', 'Hz'], ['Offset x', 'mm'], ['Offset y', 'mm']];
    box.replaceChildren(el('div', {class: 'scroll'}, el('table', {}, el('thead', {}, el('tr', {}, head.map(([h, unit]) => el('th', {scope: 'col'}, h, ' ', el('small', {}, unit))))), el('tbody', {}, rows))));
  }

  // ---- parameters over the kicks ----

  function showParameters() {
    const box = content('parameters');
    forget(box);
    choices('parameter-kind', kinds.map(kind => [kind, KINDS[kind]]), state.kind, kind => { state.kind = kind; showParameters(); });
    choices('parameter-axis', Object.entries(Plots.AXES).map(([key, axis]) => [key, 'over ' + axis.label]), state.axis, key => { state.axis = key; showParameters(); });
    $('parameter-legend').replaceChildren(
      el('span', {}, swatch('circle', theme.accent), 'kick ± s.e.'), el('span', {}, swatch('circle', theme.bad, true), 'dropped'),
      el('span', {}, swatch('cross', theme.muted), 'undetermined'), el('span', {}, swatch('triangle', theme.muted, true), 'beyond the plot'),
      el('span', {}, swatch('line', theme.good), 'mean'), el('span', {}, swatch('band', theme.good), 'mean ± 2σ of a typical kick'), el('span', {}, swatch('dashes', theme.text), 'published'));
    const model = report.models.find(m => m.kind === state.kind);
    const kicks = report.kicks.filter(k => k.kind === state.kind);
    if (!model || kicks.length === 0) {
      box.append(el('p', {class: 'empty'}, report.kicks.length ? 'None of these kicks has a fit.' : 'No kicks.'));
      return;
    }
    const fitted = model.parameters.filter(parameter => kicks.some(k => k.parameters.some(p => p.name === parameter.name)));
    const places = fitted.map(parameter => figure(box, parameter.name + (parameter.unit ? ' [' + parameter.unit + ']' : ''), withError(parameter.mean, parameter.standardError)));
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

  const droppedValues = kick => kick.parameters.filter(p => known(p.value) && p.dropped);

  function usedBadge(kick) {
    const known = kick.parameters.filter(p => Charts.known(p.value)), used = known.filter(p => Plots.isUsed(kick, p));
    if (!kick.selected) return badge('bad', '✘');
    return used.length === known.length ? badge('good', '✔') : badge('warn', used.length + '/' + known.length);
  }

  /** Why a kick, or some of its values, are not part of the model; empty when all are. */
  function whyDropped(kick) {
    return kick.selected ? droppedValues(kick).map(p => p.dropped).join('; ') : kick.rejectedBecause || 'dropped';
  }

  const COLUMNS = [
    {key: 'id', label: '#', of: k => k.id, text: k => k.id},
    {key: 'kind', label: 'Kind', of: k => k.kind, text: k => (k.kind === 'FLAT' ? '▬ ' : '⌒ ') + KINDS[k.kind], left: true},
    {key: 'speed', label: 'm/s', title: 'Kick speed', of: Plots.kickSpeed, text: k => number(Plots.kickSpeed(k), 2)},
    {key: 'robot', label: 'Robot', of: Plots.robotName, text: k => Plots.robotName(k), left: true},
    {key: 'end', label: 'End', of: k => Plots.endWords(k.end), text: k => Plots.endWords(k.end), left: true},
    {key: 'rms', label: 'mm', title: 'Residual per axis (rms)', of: k => known(k.rmsMm) ? k.rmsMm : Infinity, text: k => number(k.rmsMm, 1)},
    {key: 'used', label: 'Used', title: 'Values that are averaged', of: k => k.selected ? droppedValues(k).length : 99, text: usedBadge, left: true},
  ];
  const FILTERS = {all: () => true, flat: k => k.kind === 'FLAT', chip: k => k.kind === 'CHIP', dropped: k => !k.selected || droppedValues(k).length > 0};

  function sorted(kicks) {
    const column = COLUMNS.find(c => c.key === state.sort.key);
    const compare = (a, b) => {
      const x = column.of(a), y = column.of(b);
      return (x < y ? -1 : x > y ? 1 : 0) * (state.sort.down ? -1 : 1) || a.id - b.id;
    };
    return [...kicks].sort(compare);
  }

  function showKicks() {
    choices('kick-filter', Object.keys(FILTERS).map(key => [key, key + ' ' + report.kicks.filter(FILTERS[key]).length]), state.filter, key => { state.filter = key; showKicks(); });
    state.shown = sorted(report.kicks.filter(FILTERS[state.filter]));
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
        el('button', {type: 'button', onclick: sort}, column.label + (current ? (state.sort.down ? ' ▾' : ' ▴') : '')));
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

  function kickParameterRow(kick, parameter) {
    const model = report.models.find(m => m.kind === kick.kind);
    const mean = model && model.parameters.find(p => p.name === parameter.name);
    const sigmas = mean && known(parameter.value) ? Plots.sigmas(mean, parameter) : NaN;
    if (!known(parameter.value)) {
      return el('tr', {}, el('td', {class: 'text'}, parameter.name), el('td', {class: 'text wrap', colspan: 2}, 'undetermined: ' + (parameter.undetermined || 'no reason given')));
    }
    return el('tr', {}, el('td', {class: 'text'}, parameter.name), el('td', {}, withError(parameter.value, parameter.standardError, mean ? mean.unit : '')),
      el('td', {}, known(sigmas) ? el('span', {title: parameter.dropped || null}, badge(parameter.dropped ? 'bad' : Math.abs(sigmas) > 2 ? 'warn' : 'good', (parameter.dropped ? '✘ ' : '') + signed(sigmas, 1) + ' σ')) : ''));
  }

  function showKick() {
    const kick = state.kick;
    const box = $('kick-charts');
    const before = box.dataset.layout;
    $('previous').disabled = $('next').disabled = !kick;
    if (!kick) {
      forget(box);
      return;
    }
    const prepared = Plots.prepare(kick);
    $('kick-title').textContent = 'Kick ' + kick.id + ' — ' + KINDS[kick.kind] + ', ' + number(Plots.kickSpeed(kick), 2) + ' m/s';
    const elevation = Math.atan2(kick.vz, Math.hypot(kick.vx, kick.vy)) * 180 / Math.PI;
    $('kick-facts').replaceChildren(
      el('p', {class: 'status'}, !kick.selected ? badge('bad', '✘ dropped') : whyDropped(kick) ? badge('warn', '✔ in the model, in part') : badge('good', '✔ in the model'), whyDropped(kick) ? ' ' + whyDropped(kick) : ''),
      el('div', {},
        el('p', {}, 'By ' + Plots.robotName(kick) + ', towards ' + number(Plots.kickDirection(kick), 0) + '°' + (kick.kind === 'CHIP' ? ', ' + number(elevation, 0) + '° steep' : '') + '; ' + Plots.endWords(kick.end) + ' after ' + number(prepared.end, 1) + ' s.'),
        el('p', {}, kick.observations + ' observations, ' + kick.rejected + ' put aside as outliers; residual ' + number(kick.rmsMm, 2) + ' mm per axis.'),
        el('p', {class: 'note', title: kick.source}, Charts.fileName(kick.source) + (known(kick.unix) ? ', ' + new Date(kick.unix * 1000).toISOString().slice(11, 23) + ' UTC' : ''))),
      el('table', {}, el('tbody', {}, kick.parameters.map(p => kickParameterRow(kick, p)))));
    $('kick-legend').replaceChildren(
      ...prepared.cameras.map(({camera}) => el('span', {}, swatch(theme.camera(camera).symbol, theme.camera(camera).colour), 'camera ' + camera)),
      el('span', {}, swatch('circle', theme.muted, true), 'outlier'), el('span', {}, swatch('line', theme.text), 'fitted'),
      el('span', {}, swatch('band', theme.good), 'noise ± 2σ'));
    const fitted = kick.fitted.t.length > 0;
    const layout = kick.kind + (fitted ? '' : ' without fit');
    if (before !== layout) {
      forget(box);
      box.dataset.layout = layout;
      const chip = kick.kind === 'CHIP';
      figure(box, 'Path on the field', chip ? 'line: true path' : 'ctrl + wheel zooms', 'chart tall').dataset.plot = 'path';
      figure(box, 'Speed', 'over the ground', 'chart tall').dataset.plot = 'speed';
      if (chip && fitted) {
        const wide = figure(box, 'Height', 'seen: where the ray meets the plane of the fitted path');
        wide.dataset.plot = 'height';
        wide.parentNode.classList.add('wide');
      }
      if (fitted) {
        figure(box, 'Residual along', 'line: mean over 0.1 s').dataset.plot = 'along';
        figure(box, 'Residual across', '+ is to the left').dataset.plot = 'across';
      }
    }
    drawKick();
  }

  function drawKick() {
    const kick = state.kick;
    const others = report.kicks.filter(k => k.kind === kick.kind && k !== kick);
    const options = {
      path: box => Plots.path(theme, kick, others, report.field, {width: box.clientWidth, height: box.clientHeight}),
      speed: () => Plots.speed(theme, kick), height: () => Plots.height(theme, kick),
      along: () => Plots.residual(theme, kick, 'along', noises), across: () => Plots.residual(theme, kick, 'across', noises),
    };
    for (const box of $('kick-charts').querySelectorAll('[data-plot]')) draw(box, options[box.dataset.plot](box));
  }

  // ---- the whole page ----

  function showAll() {
    showTop();
    showModel();
    showCameras();
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
    resized: () => { if (state.kick) drawKick(); },
    keys: {j: () => step(1), k: () => step(-1)},
  });
  window.addEventListener('hashchange', () => select(Number((/^#kick=(\d+)$/.exec(location.hash) || [])[1])));
})();
