/* The page of the kicks: table, model, pictures of one kick, and the decisions about them. */
import {ask} from './server.js';
import {button, refill, renew, soon} from './parts.js';
import {kickTable} from './kick-table.js';
import {replayPart} from './replay.js';

const {el, known, withError} = Charts;
const {$, content, draw, forget, choices, charts} = Frame;
const {KINDS, difference, kickTitle, kickFacts, kickLegend, layOutKick, drawKick} = CalibrationViews;
const MOST_BESIDE = 8;
const REASONS = ['touched by a robot or a foot', 'ball was not at rest', 'two balls in view', 'hit the goal or the wall', 'kicked over a line or a seam', 'the robot slipped'];

export function kicksPage(app) {
  const page = {id: 'kicks', title: 'Kicks', show, resized, keys: {}, keyWords: []};
  const view = {selected: null, kind: null, axis: 'kick', marks: new Set(), details: new Map(), fits: null, laidOut: '', pictured: ''};
  const table = kickTable({pickKick: select, mark, toggle, filtered, narrowed: () => drawModel()});
  const replay = replayPart($('kick-replay'), $('kick-charts'));
  let theme, reason = '';

  const state = () => app.state;
  const report = () => state().calibration.report;
  const kickOf = id => report().kicks.find(kick => kick.id === id);
  const hand = id => state().selection.byHand[id];

  // ---- the whole page ----

  function show() {
    theme = app.colours();
    if (view.fits !== state().fits) {
      view.fits = state().fits;
      view.details = new Map();
    }
    const kicks = report().kicks;
    if (!kickOf(view.selected)) {
      const asked = Number((/^#kicks\/(\d+)$/.exec(location.hash) || [])[1]);
      const first = kickOf(asked) || kicks.find(kick => kick.selected) || kicks[0];
      view.selected = first ? first.id : null;
    }
    for (const id of view.marks) if (!kickOf(id)) view.marks.delete(id);
    const selected = kickOf(view.selected);
    if (!view.kind || !kicks.some(kick => kick.kind === view.kind)) view.kind = selected ? selected.kind : null;
    table.show(report(), state().selection.byHand, view.marks, view.selected);
    showRules();
    showMarked();
    showModel();
    showKick();
    Frame.showProblems(report().problems);
    $('parameters').hidden = $('kick').hidden = kicks.length === 0;
  }

  function resized() {
    for (const box of content('parameters').querySelectorAll('.chart')) if (charts.has(box)) circle(box);
    view.pictured = '';
    showKick();
  }

  /** Only kicks of one kind are listed: their plots belong beside them. */
  function filtered(filter) {
    const kind = filter.toUpperCase();
    if (!(kind in KINDS) || kind === view.kind || !report().kicks.some(kick => kick.kind === kind)) return;
    view.kind = kind;
    showModel();
  }

  // ---- decisions ----

  function showRules() {
    const {rounds, leftOut, wouldLeave, undo, redo} = state().selection;
    const values = n => n + (n === 1 ? ' value' : ' values');
    const words = rounds === null ? '2σ rule: repeated until no value is beyond 2σ, ' + values(leftOut) + ' excluded'
      : rounds === 0 ? '2σ rule: not applied' + (wouldLeave ? ', ' + values(wouldLeave) + ' beyond 2σ' : '')
      : '2σ rule: ' + rounds + (rounds === 1 ? ' round, ' : ' rounds, ') + values(leftOut) + ' excluded' + (wouldLeave ? '' : ', no other beyond 2σ');
    refill($('rules'), 
      button('2σ once more' + (wouldLeave ? ' (' + wouldLeave + ' beyond)' : ''), twoSigma, {key: 's', id: 'two-sigma', title: 'One more round: excludes values more than 2σ from the mean', disabled: wouldLeave === 0}),
      el('div', {class: 'choices', role: 'group', 'aria-label': '2σ rule'},
        button('2σ until none is beyond', () => app.decide('all_two_sigma'), {id: 'all-two-sigma', pressed: rounds === null}),
        button('without 2σ', () => app.decide('no_two_sigma'), {id: 'no-two-sigma', pressed: rounds === 0, title: 'Start again from all values; then press 2σ once more as often as you like'})),
      el('span', {id: 'rule-words'}, words));
    refill($('steps'),
      button('↶ Undo' + (undo ? ': ' + undo : ''), () => step('undo'), {key: 'u', id: 'undo', title: undo, disabled: !undo}),
      button('↷ Redo' + (redo ? ': ' + redo : ''), () => step('redo'), {key: 'U', id: 'redo', title: redo, disabled: !redo}));
  }

  const twoSigma = () => app.decide('two_sigma', {seen: state().decisions});
  const step = what => app.decide(what, {seen: state().decisions});

  function showMarked() {
    const ids = [...view.marks].sort((a, b) => a - b);
    // What somebody is typing is not replaced under their hands.
    renew($('marked'), ids, () => markedWords(ids));
    if ($('reason').value !== reason) $('reason').value = reason;
  }

  function markedWords(ids) {
    const input = el('input', {id: 'reason', list: 'reasons', placeholder: 'reason for dropping', value: reason, maxlength: 200, 'aria-label': 'Reason for dropping', title: 'The report gives this reason (key f; Enter drops the kicks)', onkeydown: reasoned, oninput: event => { reason = event.target.value; }});
    const list = el('datalist', {id: 'reasons'}, REASONS.map(value => el('option', {value})));
    const marked = ids.length === 0 ? [el('span', {class: 'note'}, 'Drag over points or tick kicks to mark them.')] : [
      el('b', {}, ids.length + (ids.length === 1 ? ' kick marked' : ' kicks marked')),
      button('Drop them', () => drop(ids), {id: 'drop-marked', strong: true}),
      button('Restore them', () => restore(ids), {id: 'restore-marked'}),
      button('Clear', () => setMarks([]), {key: 'Esc', id: 'clear-marks'})];
    return [...marked, el('span', {class: 'spring'}), input, list];
  }

  function drop(ids) {
    table.expect(ids, false);
    return app.decide('drop', {kicks: ids, reason}).then(done => {
      if (!done) return show();
      reason = '';
      setMarks([]);
    });
  }

  /** What was dropped by hand is left to the rules again; what the rules leave out is used all the same. */
  async function restore(ids) {
    const byHand = ids.filter(id => hand(id) === 'drop'), byRule = ids.filter(id => hand(id) !== 'drop' && CalibrationViews.whyDropped(kickOf(id)));
    table.expect(ids, true);
    const done = (byHand.length === 0 || await app.decide('auto', {kicks: byHand})) && (byRule.length === 0 || await app.decide('keep', {kicks: byRule}));
    if (!done) show();
    setMarks([]);
  }

  function toggle(id) {
    const kick = kickOf(id);
    if (kick.selected) return drop([id]);
    return restore([id]);
  }

  /** One is marked or no longer; several are marked. */
  function mark(...ids) {
    if (ids.length > 1 || !view.marks.delete(ids[0])) ids.forEach(id => view.marks.add(id));
    setMarks(view.marks);
  }

  function setMarks(ids) {
    view.marks = new Set(ids);
    table.setMarks(view.marks);
    showMarked();
    drawModel();
    showKick();
  }

  // ---- the model and its parameters over the kicks ----

  function showModel() {
    const kinds = Object.keys(KINDS).filter(kind => report().kicks.some(kick => kick.kind === kind));
    choices('parameter-kind', kinds.map(kind => [kind, KINDS[kind] + ' ' + report().kicks.filter(k => k.kind === kind && k.selected).length + '/' + report().kicks.filter(k => k.kind === kind).length]), view.kind, kind => { view.kind = kind; showModel(); });
    choices('parameter-axis', Object.entries(Plots.AXES).map(([key, axis]) => [key, axis.label]), view.axis, key => { view.axis = key; showModel(); });
    const {verdict} = report();
    $('advice').replaceChildren(
      CalibrationViews.decisionBadge(verdict), ' ' + verdict.toDo[0] + ' ', verdict.reasons.length || verdict.notes.length ? el('a', {href: '#publish'}, 'Why') : '',
      state().settled ? '' : el('span', {class: 'note', id: 'refining'}, ' The joint fit follows …'),
      state().model.effects.length ? el('span', {class: 'note'}, ' with ' + state().model.effects.join(', ')) : '');
    $('advice').title = [...verdict.toDo, ...verdict.reasons, ...verdict.notes].join('\n');
    $('parameter-legend').replaceChildren(...CalibrationViews.parameterLegend(theme), ...CalibrationViews.MARKS.map(words => el('span', {}, words)));
    const model = report().models.find(m => m.kind === view.kind);
    const shown = model ? model.parameters : [];
    const box = content('parameters');
    const layout = shown.map(parameter => parameter.name).join();
    if (view.laidOut !== layout) {
      forget(box);
      view.laidOut = layout;
      box.append(...shown.map(parameter => el('figure', {'data-parameter': parameter.name}, el('div', {class: 'value'}), el('div', {class: 'chart', role: 'img', 'aria-label': parameter.name + ' of each kick; drag to mark kicks'}))));
    }
    if (view.themed !== theme.text) for (const place of box.querySelectorAll('.chart')) delete place.dataset.layout;
    view.themed = theme.text;
    for (const parameter of shown) {
      box.querySelector('figure[data-parameter="' + parameter.name + '"] .value').replaceChildren(...valueOf(parameter));
    }
    drawModel();
  }

  function valueOf(parameter) {
    return [
      el('p', {}, el('b', {}, parameter.words), parameter.unit ? el('small', {}, ' ' + parameter.unit) : '', el('span', {class: 'spring'}), el('span', {title: 'against the published ' + Plots.asPublished(parameter.published)}, difference(parameter))),
      el('p', {}, el('b', {class: 'mean'}, withError(parameter.mean, parameter.standardError)), el('span', {class: 'spring'}), el('span', {class: 'note', title: 'kicks in the mean'}, 'n ' + parameter.n))];
  }

  /** Draws what is not drawn as it should be, after everything that tells in words. */
  function drawModel() {
    const shown = JSON.stringify([state().run, state().calibration.version, view.kind, view.axis, [...view.marks], table.picks(), theme.text]);
    for (const box of content('parameters').querySelectorAll('.chart')) {
      if (box.dataset.shows === shown) circle(box);
      else soon(box, () => drawParameter(box));
      box.dataset.shows = shown;
    }
  }

  const points = new WeakMap();

  /** The circle around the selected kick lies over the picture, which need not be drawn again for it. */
  function circle(box) {
    const point = (points.get(box) || []).find(item => item.kick === view.selected);
    const old = box.querySelector('.ring');
    if (old) old.remove();
    if (!point) return;
    const [x, y] = charts.get(box).convertToPixel({xAxisIndex: 0, yAxisIndex: 0}, point.value), [dx, dy] = point.symbolOffset;
    box.append(el('div', {class: 'ring', style: 'left: ' + (x + dx) + 'px; top: ' + (y + dy) + 'px'}));
  }

  function drawParameter(box) {
    const model = report().models.find(m => m.kind === view.kind);
    const parameter = model && model.parameters.find(p => p.name === box.parentNode.dataset.parameter);
    if (!parameter) return;
    const kicks = report().kicks.filter(kick => kick.kind === view.kind);
    const option = Plots.parameter(theme, parameter, kicks, view.axis, null, table.picked);
    option.series.push(markedPoints(option));
    points.set(box, items(option));
    option.grid.bottom = 38;
    const layout = view.kind + view.axis, made = charts.get(box);
    if (made && box.dataset.layout === layout) {
      // The same axes: only points and lines are others.
      made.setOption(option, {replaceMerge: ['series']});
      circle(box);
      return;
    }
    box.dataset.layout = layout;
    option.brush = {xAxisIndex: 0, yAxisIndex: 0, brushStyle: {color: theme.accent, opacity: 0.15, borderColor: theme.accent}, outOfBrush: {colorAlpha: 1}, throttleType: 'debounce', throttleDelay: 0};
    option.toolbox = {show: false};
    draw(box, option, event => event.data && event.data.kick && select(event.data.kick));
    const chart = charts.get(box);
    if (!made) chart.on('brushEnd', event => brushed(chart, event));
    chart.dispatchAction({type: 'takeGlobalCursor', key: 'brush', brushOption: {brushType: 'rect', brushMode: 'single'}});
    circle(box);
  }

  const items = option => option.series.filter(series => series.type === 'scatter' && !series.silent).flatMap(series => series.data).filter(item => item && item.kick);

  function markedPoints(option) {
    const data = items(option).filter(item => view.marks.has(item.kick)).map(item => Object.assign({}, item, {symbol: 'rect', symbolRotate: 0}));
    return {type: 'scatter', symbolSize: 17, silent: true, itemStyle: {color: 'transparent', borderColor: theme.warn, borderWidth: 2.5}, z: 7, data};
  }

  function brushed(chart, event) {
    const area = event.areas && event.areas[0];
    if (!area) return;
    const [[x0, x1], [y0, y1]] = area.coordRange;
    const inside = items(chart.getOption()).filter(({value: [x, y]}) => x >= x0 && x <= x1 && y >= y0 && y <= y1).map(item => item.kick);
    chart.dispatchAction({type: 'brush', areas: []});
    if (inside.length) setMarks([...view.marks, ...inside]);
  }

  // ---- one kick ----

  function select(id, focus) {
    const kick = kickOf(id);
    if (!kick || id === view.selected) return;
    view.selected = id;
    history.replaceState(null, '', '#kicks/' + id);
    table.pick(id, focus);
    // What was pressed comes first, the circle around it in the other pictures after that.
    showKick().then(() => {
      if (kick.kind === view.kind) return drawModel();
      view.kind = kick.kind;
      showModel();
    });
  }

  /** What was seen of a kick, which is asked for once, with what is decided about it now. */
  const merged = detail => Object.assign(Object.create(detail), kickOf(detail.id), {seen: detail.seen, fitted: detail.fitted, events: detail.events});

  async function showKick() {
    const id = view.selected, kick = kickOf(id);
    if (!kick) return;
    $('kick-title').textContent = kickTitle(kick);
    refill($('kick-actions'), ...actionsOf(kick));
    let detail;
    try {
      detail = await detailOf(id);
    } catch (failure) {
      app.fail(failure);
      return;
    }
    if (view.selected !== id || !kickOf(id)) return;
    const all = merged(detail);
    $('kick-facts').replaceChildren(...kickFacts(report(), all));
    const marked = besides(kick), beside = await Promise.all(marked.map(detailOf)).catch(() => []);
    if (view.selected !== id || !kickOf(id)) return;
    const pictured = JSON.stringify([state().run, view.fits, id, marked, theme.text]);
    if (view.pictured === pictured) return;
    view.pictured = pictured;
    $('kick-legend').replaceChildren(...kickLegend(theme, all, beside));
    layOutKick($('kick-charts'), all);
    drawKick(theme, $('kick-charts'), report(), all, soon, beside);
    soon($('kick'), () => {
      $('kick').dataset.shown = id;
      $('kick').dataset.beside = beside.map(one => one.id).join(' ');
      replay.show(all);
      // Most go on to the next one, or back.
      for (const near of table.beside()) detailOf(near).catch(() => {});
    });
  }

  /** The marked kicks of the same kind, whose lines are drawn beside those of the selected one; of many the first: more could not be told apart. */
  const besides = kick => [...view.marks].filter(id => id !== kick.id && kickOf(id).kind === kick.kind).sort((a, b) => a - b).slice(0, MOST_BESIDE);

  /** What was seen of a kick, asked for once as long as it is not fitted again. */
  function detailOf(id) {
    const known = view.details;
    if (!known.has(id)) {
      const asked = ask('kicks/' + id);
      asked.catch(() => known.delete(id));
      known.set(id, asked);
    }
    return known.get(id);
  }

  function actionsOf(kick) {
    const ids = [kick.id], why = CalibrationViews.whyDropped(kick);
    const rules = button('Leave it to the rules', () => app.decide('auto', {kicks: ids}), {id: 'auto', key: 'r'});
    const keep = button(kick.selected ? 'Use all its values' : 'Use it anyway', () => app.decide('keep', {kicks: ids}), {id: 'keep', key: 'r'});
    const dropIt = button('Drop', () => drop(ids), {id: 'drop', key: 'd', strong: true});
    if (hand(kick.id) === 'drop') return [button('Restore', () => app.decide('auto', {kicks: ids}), {id: 'restore', key: 'r', strong: true})];
    if (hand(kick.id) === 'keep') return [dropIt, rules];
    return why ? [dropIt, keep] : [dropIt];
  }

  /** From the reason back to the kicks. */
  function reasoned(event) {
    if (event.key !== 'Enter' && event.key !== 'Escape') return;
    event.target.blur();
    if (event.key === 'Enter') page.keys.d();
  }

  const press = (...ids) => () => { const found = ids.map(id => $(id)).find(node => node && !node.disabled); if (found) found.click(); };
  $('previous').addEventListener('click', () => table.step(-1));
  $('next').addEventListener('click', () => table.step(1));
  page.keys = {
    p: () => replay.toggle(),
    j: () => table.step(1), k: () => table.step(-1), d: press('drop-marked', 'drop'), r: press('restore-marked', 'restore', 'auto', 'keep'),
    s: press('two-sigma'), u: press('undo'), U: press('redo'), m: () => view.selected !== null && mark(view.selected), Escape: press('clear-marks'), f: () => $('reason').focus(),
  };
  page.keyWords = [['j, k', 'next and previous kick; arrows in the table'], ['d', 'drop the marked kicks, or the selected one'], ['r', 'restore them'], ['m, space', 'mark the selected kick; shift and an arrow mark several'], ['Esc', 'clear all marks'],
    ['s', 'one more round of 2σ'], ['u, U or Ctrl+Z, Ctrl+Y', 'undo, redo'], ['f', 'write a reason; Enter drops the kicks with it'], ['p', 'replay the kick, or pause it']];
  return page;
}
