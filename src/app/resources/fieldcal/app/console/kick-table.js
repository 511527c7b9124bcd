/* The table of kicks: sorted, filtered, one kick selected, any number marked. Told what to show; tells what was pressed. */
import {button, renew, select} from './parts.js';

const {el} = Charts;
const {content, choices} = Frame;
const {KINDS, COLUMNS, FILTERS, whyDropped, sorted} = CalibrationViews;
const LISTED = COLUMNS.filter(column => column.key !== 'used');
const STEPS = {ArrowDown: 1, ArrowUp: -1, PageDown: 10, PageUp: -10, Home: -Infinity, End: Infinity};

export function kickTable({pickKick, mark, toggle, filtered, narrowed}) {
  const state = {filter: 'all', robot: '', recording: '', slowest: '', fastest: '', sort: {key: 'id', down: false}, shown: [], rows: new Map(), selected: null, listed: ''};
  const parts = new Map();
  let last = null;

  function show(report, byHand, marks, selected) {
    last = [report, byHand, marks, selected];
    choices('kick-filter', Object.keys(FILTERS).map(key => [key, key + ' ' + report.kicks.filter(FILTERS[key]).length]), state.filter, key => { state.filter = key; show(...last); filtered(key); });
    showPicks(report.kicks);
    state.shown = sorted(report.kicks.filter(kick => FILTERS[state.filter](kick) && picked(kick)), state.sort);
    const focused = document.activeElement && document.activeElement.closest('#kicks tr[data-kick]');
    const box = content('kicks');
    if (state.shown.length === 0) {
      state.rows = new Map();
      state.listed = '';
      box.replaceChildren(el('p', {class: 'empty'}, report.kicks.length ? 'None.' : 'No kick was found in the recordings.'));
      return;
    }
    // Rows of kicks that did not change stay as they are: there may be hundreds.
    const listed = JSON.stringify([state.sort, state.shown.map(kick => kick.id)]), same = listed === state.listed;
    const rows = state.shown.map(kick => {
      const old = parts.get(kick.id), decision = byHand[kick.id];
      if (old && old.kick === kick && old.decision === decision) return old;
      const part = {kick, decision, nodes: rowsOf(kick, decision, marks.has(kick.id))};
      if (same && old) {
        old.nodes.slice(1).forEach(node => node.remove());
        old.nodes[0].replaceWith(...part.nodes);
      }
      parts.set(kick.id, part);
      return part;
    });
    state.rows = new Map(rows.map(part => [part.kick.id, part.nodes[0]]));
    if (!same) {
      state.listed = listed;
      const body = el('tbody', {}, rows.flatMap(part => part.nodes));
      body.addEventListener('keydown', pressed);
      box.replaceChildren(el('table', {}, el('thead', {}, el('tr', {}, el('th', {class: 'text', title: 'a decision holds for all marked kicks'}, ''), LISTED.map(heading), el('th', {class: 'text'}, 'Used'))), body));
    }
    setMarks(marks);
    pick(selected, Boolean(focused));
  }

  // ---- of the kicks, those of one robot, one recording, or a range of speeds ----

  const chosen = () => [state.robot, state.recording, state.slowest, state.fastest].some(value => value !== '');

  function picked(kick) {
    const speed = Plots.kickSpeed(kick);
    return (state.robot === '' || Plots.robotName(kick) === state.robot) && (state.recording === '' || kick.source === state.recording)
      && (state.slowest === '' || speed >= Number(state.slowest)) && (state.fastest === '' || speed <= Number(state.fastest));
  }

  /** Choices of one thing only are left out: they would choose nothing. */
  function showPicks(kicks) {
    const of = name => [...new Set(kicks.map(name))].sort((a, b) => a.localeCompare(b, 'en', {numeric: true}));
    const robots = of(Plots.robotName), recordings = of(kick => kick.source);
    if (!robots.includes(state.robot)) state.robot = '';
    if (!recordings.includes(state.recording)) state.recording = '';
    const choose = key => value => { state[key] = value; again(); };
    const speed = (key, label) => el('input', {id: 'pick-' + key, type: 'number', min: 0, max: 15, step: 0.1, value: state[key], placeholder: label, 'aria-label': label + ' kick, m/s', oninput: event => choose(key)(event.target.value)});
    renew(document.getElementById('kick-pick'), [robots, recordings], () => [
      ...(robots.length > 1 ? [select('pick-robot', [['', 'all robots'], ...robots.map(name => [name, name])], state.robot, choose('robot'))] : []),
      ...(recordings.length > 1 ? [select('pick-recording', [['', 'all recordings'], ...recordings.map(name => [name, Charts.fileName(name)])], state.recording, choose('recording'))] : []),
      el('span', {class: 'speeds'}, speed('slowest', 'slowest'), ' – ', speed('fastest', 'fastest'), ' m/s'),
      button('All', everything, {id: 'pick-all', title: 'Lists the kicks of all robots, recordings and speeds'})]);
    document.getElementById('pick-all').disabled = !chosen();
  }

  function again() {
    show(...last);
    narrowed();
  }

  function everything() {
    Object.assign(state, {robot: '', recording: '', slowest: '', fastest: ''});
    for (const node of document.querySelectorAll('#kick-pick select, #kick-pick input')) node.value = '';
    again();
  }

  /** The kicks that are listed, in their order, as CSV for a spreadsheet: SI units, a point as decimal mark. */
  function csv() {
    const names = [...new Set(state.shown.flatMap(kick => kick.parameters.map(p => p.name)))];
    const quoted = value => /[",\n]/.test(value) ? '"' + value.replaceAll('"', '""') + '"' : value;
    const rows = [['id', 'kind', 'source', 't_unix', 'team', 'robot', 'speed_mps', 'end', 'observations', 'rms_mm', 'used', 'why_not', ...names.flatMap(name => [Plots.inFiles(name), Plots.inFiles(name) + '_standard_error'])],
      ...state.shown.map(kick => [kick.id, KINDS[kick.kind], kick.source, kick.unix, kick.team, kick.robot < 0 ? '' : kick.robot, Plots.kickSpeed(kick).toFixed(4), kick.end, kick.observations, kick.rmsMm, kick.selected, whyDropped(kick),
        ...names.flatMap(name => { const p = kick.parameters.find(one => one.name === name) || {}; return [p.value, p.standardError]; })])];
    return rows.map(row => row.map(value => quoted(value === null || value === undefined ? '' : String(value))).join(',')).join('\n') + '\n';
  }

  function download() {
    const link = el('a', {href: URL.createObjectURL(new Blob([csv()], {type: 'text/csv'})), download: 'kicks.csv'});
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  }
  document.getElementById('kicks-csv').addEventListener('click', download);

  /** Shows at once what was decided about kicks; what comes of it is shown when the server has answered. */
  function expect(ids, used) {
    for (const id of ids) {
      const part = parts.get(id), row = state.rows.get(id);
      if (!part || !row) continue;
      part.kick = null;
      row.classList.toggle('dropped', !used);
      row.classList.add('pending');
      row.querySelector('button.use').replaceChildren(Frame.badge(used ? 'good' : 'bad', used ? '✔' : '✘'), el('span', {}, '…'));
    }
  }

  function heading(column) {
    const current = state.sort.key === column.key;
    const sort = () => {
      state.sort = {key: column.key, down: current && !state.sort.down};
      show(...last);
      content('kicks').querySelector('th[data-key="' + column.key + '"] button').focus();
    };
    return el('th', {scope: 'col', 'data-key': column.key, class: column.left ? 'text' : null, title: column.title, 'aria-sort': current ? (state.sort.down ? 'descending' : 'ascending') : null},
      el('button', {type: 'button', onclick: sort}, column.label + (current ? (state.sort.down ? '\u00a0▾' : '\u00a0▴') : '')));
  }

  function rowsOf(kick, decision, marked) {
    const used = COLUMNS.find(column => column.key === 'used').text(kick);
    const check = el('input', {type: 'checkbox', 'aria-label': 'mark kick ' + kick.id, tabindex: -1, onclick: event => { event.stopPropagation(); mark(kick.id); }});
    check.checked = marked;
    const why = whyDropped(kick);
    const press = el('button', {
      type: 'button', class: 'use', tabindex: -1, 'aria-label': (kick.selected ? 'drop' : 'use') + ' kick ' + kick.id,
      title: kick.selected ? 'Drop this kick' : 'Use this kick', onclick: event => { event.stopPropagation(); toggle(kick.id); },
    }, used, decision ? el('span', {title: decision === 'drop' ? 'dropped by hand' : 'kept by hand'}, 'hand') : '');
    const row = el('tr', {'data-kick': kick.id, class: why ? 'dropped' : null, onclick: () => pickKick(kick.id)},
      el('td', {}, check), LISTED.map(column => el('td', {class: column.left ? 'text' : null}, column.text(kick))), el('td', {class: 'text'}, press));
    state.rows.set(kick.id, row);
    return why ? [row, el('tr', {class: kick.selected ? 'why part' : 'why', onclick: () => pickKick(kick.id)}, el('td', {colspan: LISTED.length + 2}, why))] : [row];
  }

  function pressed(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (event.key === ' ') {
      event.preventDefault();
      if (state.selected !== null) mark(state.selected);
    } else if (event.key in STEPS) {
      event.preventDefault();
      if (event.shiftKey) markOnTheWay(STEPS[event.key]);
      step(STEPS[event.key], true);
    }
  }

  /** Marks all kicks from the selected one to where a step leads. */
  function markOnTheWay(rows) {
    const now = state.shown.findIndex(kick => kick.id === state.selected);
    if (now < 0) return;
    const end = Math.max(0, Math.min(state.shown.length - 1, now + rows));
    mark(...state.shown.slice(Math.min(now, end), Math.max(now, end) + 1).map(kick => kick.id));
  }

  /** Selects the kick so many rows further down in the table as it is shown. */
  function step(rows, focus) {
    if (state.shown.length === 0) return;
    const now = state.shown.findIndex(kick => kick.id === state.selected);
    const next = now < 0 ? 0 : Math.max(0, Math.min(state.shown.length - 1, now + rows));
    pickKick(state.shown[next].id, focus);
  }

  /** Shows which kick is selected, and where it is in the list. */
  function pick(id, focus) {
    state.selected = id;
    for (const [kick, row] of state.rows) {
      const selected = String(kick === id);
      if (row.getAttribute('aria-selected') === selected) continue;
      row.setAttribute('aria-selected', selected);
      row.tabIndex = kick === id ? 0 : -1;
    }
    const row = state.rows.get(id);
    if (!row) {
      const first = state.rows.values().next().value;
      if (first) first.tabIndex = 0;
      return;
    }
    const list = content('kicks'), head = list.querySelector('thead').offsetHeight;
    const top = row.offsetTop - head, bottom = row.offsetTop + row.offsetHeight * 2;
    if (top < list.scrollTop) list.scrollTop = top;
    if (bottom > list.scrollTop + list.clientHeight) list.scrollTop = bottom - list.clientHeight;
    if (focus) row.focus({preventScroll: true});
  }

  function setMarks(marks) {
    for (const [kick, row] of state.rows) row.firstChild.firstChild.checked = marks.has(kick);
  }

  /** The kicks before and after the selected one. */
  function beside() {
    const now = state.shown.findIndex(kick => kick.id === state.selected);
    return now < 0 ? [] : [state.shown[now + 1], state.shown[now - 1]].filter(Boolean).map(kick => kick.id);
  }

  /** What is picked, to tell whether it changed. */
  const picks = () => [state.robot, state.recording, state.slowest, state.fastest].join('|');

  return {show, pick, step, setMarks, expect, beside, picked, picks};
}
