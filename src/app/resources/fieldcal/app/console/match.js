/* The page of a match: medians of the ball with their history, warnings, limits of both teams, cameras; live or from a recording. */
import {button, field, refill, select, table} from './parts.js';

const {el, known, number, signed, withError, tip, base} = Charts;
const {$, content, draw, forget, badge, swatch} = Frame;

export function matchPage(app) {
  const page = {id: 'match', title: 'Match', always: true, show, told: showStatus, resized: () => {}, keys: {}, keyWords: [], badge: warned};
  const order = {source: null, vision: '224.5.23.2:10006', referee: '224.5.23.1:10003', recording: '', speed: '0', own: false, yellow: '', blue: ''};
  let theme, built = '', laidOut = '';

  const match = () => app.state.match;
  const status = () => match().status || null;

  function warned() {
    return app.state && app.state.match && status() && status().warnings.length ? ' ⚠' : '';
  }

  function show() {
    theme = app.colours();
    buildForm();
    showStatus();
  }

  // ---- what is watched ----

  function buildForm() {
    const recordings = app.state.watchable;
    const key = JSON.stringify([recordings, match().running, order.source, Boolean(app.state.calibration)]);
    if (key === built) return;
    built = key;
    if (!order.source) order.source = 'network';
    if (!recordings.includes(order.recording)) order.recording = recordings[0] || '';
    const text = (id, size, placeholder) => el('input', {id: 'watch-' + id, value: order[id], size, maxlength: 200, placeholder, oninput: event => { order[id] = event.target.value; }});
    const form = $('watch-form');
    form.onsubmit = event => { event.preventDefault(); start(); };
    if (match().running) {
      refill(form, button('End', () => app.run('match/end'), {id: 'watch-end'}));
      return;
    }
    const live = order.source === 'network';
    refill(form,
      select('watch-source', [['network', 'from the network'], ...(recordings.length ? [['recording', 'a recording']] : [])], order.source, value => { order.source = value; buildForm(); }),
      ...(live ? [field('vision', text('vision', 17)), field('referee', text('referee', 17, 'none'))] : [
        select('watch-recording', recordings.map(name => [name, name]), order.recording, value => { order.recording = value; }),
        select('watch-speed', [['0', 'as fast as possible'], ['1', 'at its own speed'], ['10', '10 times as fast']], order.speed, value => { order.speed = value; })]),
      ...(app.state.calibration ? [el('label', {title: 'instead of what vision publishes'}, el('input', {type: 'checkbox', id: 'watch-own', checked: order.own ? '' : null, onchange: event => { order.own = event.target.checked; }}), " compare with this session's model")] : []),
      ...['yellow', 'blue'].map(team => el('label', {title: 'what the robots of ' + team + ' are configured to do: velocity m/s, acceleration and braking m/s²; warns when they move differently'}, team + ' limits, m/s and m/s² ', text(team, 15, 'speed, acc., braking'))),
      el('button', {type: 'submit', id: 'watch-start', class: 'strong'}, 'Watch'));
  }

  function start() {
    const body = order.source === 'network' ? {source: 'network', vision: order.vision, referee: order.referee} : {source: 'recording', recording: order.recording, speed: Number(order.speed)};
    app.run('match', Object.assign(body, {own_models: order.own, yellow_limits: order.yellow, blue_limits: order.blue}));
  }

  // ---- what there is to see ----

  function showStatus() {
    const now = status();
    for (const id of ['medians', 'last-kicks', 'teams', 'health']) $(id).hidden = !now;
    const rows = [];
    if (match().failure) rows.push(el('p', {class: 'notice bad'}, match().failure));
    if (!now) {
      if (!match().failure) rows.push(el('p', {}, match().running ? 'Waiting for the first frame …' : 'Watches a match: whether the ball still moves as published, how fast the robots of both teams are, and how good the cameras are.'));
      $('watch-state').replaceChildren(...rows);
      return;
    }
    rows.push(...now.warnings.map(text => el('p', {class: 'notice bad warning'}, '⚠ ' + text)));
    rows.push(headline(now));
    $('watch-state').replaceChildren(...rows);
    showMedians(now);
    showKicks(now);
    showTeams(now);
    showCameras(now);
  }

  const clock = unix => known(unix) ? new Date(unix * 1000).toISOString().slice(11, 19) : '--:--:--';

  function headline(now) {
    const r = now.referee;
    const words = r ? r.stage + ', ' + r.command + '; ' + (r.yellow || 'yellow') + ' ' + r.yellowScore + ' : ' + r.blueScore + ' ' + (r.blue || 'blue') : 'no referee: everything counts';
    const c = now.kickCounts;
    return el('p', {id: 'watch-line'}, badge(match().running ? 'good' : 'warn', match().running ? '● watching' : 'ended'), ' ' + clock(now.time) + ' UTC · ' + words + (now.counts ? '' : ' (not in play, nothing counts)'),
      ' · ' + c.found + ' kicks, ' + c.used + ' used, ' + c.unused + ' determine no parameter' + (c.waiting ? ', ' + c.waiting + ' waiting' : '') + ' ',
      el('span', {class: 'note'}, now.title + (now.notes.length ? ': ' + now.notes.join('; ') : '')));
  }

  function showMedians(now) {
    $('medians-legend').replaceChildren(el('span', {}, swatch('line', theme.accent), 'median'), el('span', {}, swatch('band', theme.accent), 'middle 50 % of the kicks'), el('span', {}, swatch('dashes', theme.text), 'published'),
      el('span', {}, swatch('band', theme.good), '± 20 %'), el('span', {}, 'estimate from ' + now.enough + ' kicks on'));
    const box = content('medians');
    // A kind that nobody kicked yet would only show empty plots.
    const kinds = ['flat', 'chip'].filter(kind => now.parameters.some(p => p.kind === kind && p.samples > 0));
    const shown = now.parameters.filter(p => kinds.length === 0 || kinds.includes(p.kind));
    const layout = shown.map(p => p.name).join();
    if (layout !== laidOut) {
      forget(box);
      laidOut = layout;
      box.append(...shown.map(p => el('figure', {'data-parameter': p.name}, el('div', {class: 'value'}), el('div', {class: 'chart', role: 'img', 'aria-label': 'median of the ' + p.words + ' over time'}))));
    }
    for (const p of shown) {
      const figure = box.querySelector('figure[data-parameter="' + p.name + '"]');
      const off = known(p.percent) ? signed(p.percent, 0) + ' %' : '–';
      figure.querySelector('.value').replaceChildren(
        el('p', {}, el('b', {}, p.words), p.unit ? el('small', {}, ' ' + p.unit) : '', el('span', {class: 'spring'}), p.enough ? badge(p.warning ? 'bad' : 'good', (p.warning ? '⚠ ' : '') + off) : el('span', {class: 'note'}, p.samples + ' of ' + now.enough + ' kicks')),
        el('p', {}, el('b', {class: 'mean'}, number(p.median, 3)), el('span', {class: 'note'}, known(p.lower) ? number(p.lower, 3) + ' … ' + number(p.upper, 3) : ''), el('span', {class: 'spring'}), el('span', {class: 'note'}, 'published ' + number(p.published, 3))));
      draw(figure.querySelector('.chart'), medianPlot(p));
    }
  }

  function medianPlot(p) {
    const option = base(theme, 'time [UTC]', '');
    option.grid = {left: 58, right: 32, top: 8, bottom: 40};
    const times = p.history.map(point => point[0]), span = times.length ? times[times.length - 1] - times[0] : 0;
    // Always hours first: minutes and seconds alone read as hours and minutes. One kick alone has no span, so the axis has at least a minute.
    option.xAxis.axisLabel.formatter = value => clock(value).slice(...(span < 600 ? [0, 8] : [0, 5]));
    option.xAxis.splitNumber = 3;
    if (times.length) Object.assign(option.xAxis, {min: times[0], max: Math.max(times[times.length - 1], times[0] + 60)});
    const values = [...p.history.map(point => point[1]), p.lower, p.upper, p.median, p.published, known(p.published) ? p.published * 1.2 : null, known(p.published) ? p.published * 0.8 : null].filter(known);
    const low = Math.min(...values), high = Math.max(...values), margin = (high - low || 0.1) * 0.08;
    if (values.length) Object.assign(option.yAxis, {min: low - margin, max: high + margin});
    option.yAxis.axisLabel.formatter = value => number(value, 2);
    option.yAxis.axisLabel.showMinLabel = option.yAxis.axisLabel.showMaxLabel = false;
    const reference = {type: 'scatter', data: [], silent: true, markLine: {precision: 8, silent: true, symbol: 'none', animation: false, data: []}, markArea: {silent: true, data: []}};
    if (known(p.published)) {
      reference.markLine.data.push({yAxis: p.published, lineStyle: {color: theme.text, width: 2, type: 'dashed'}, label: {show: false}});
      const [a, b] = [p.published * 0.8, p.published * 1.2].sort((x, y) => x - y);
      reference.markArea.data.push([{yAxis: a, itemStyle: {color: theme.good, opacity: 0.12}}, {yAxis: b}]);
    }
    if (known(p.lower) && p.samples > 1) reference.markArea.data.push([{yAxis: Math.min(p.lower, p.upper), itemStyle: {color: theme.accent, opacity: 0.18}}, {yAxis: Math.max(p.lower, p.upper)}]);
    option.tooltip.formatter = ({value}) => tip(number(value[1], 4), clock(value[0]) + ' UTC, median of ' + value[2]);
    option.series = [reference, {type: 'line', data: p.history, symbolSize: 5, lineStyle: {color: p.warning ? theme.bad : theme.accent, width: 2}, itemStyle: {color: p.warning ? theme.bad : theme.accent}}];
    return option;
  }

  function showKicks(now) {
    const rows = [...now.kicks].reverse().map(k => el('tr', {}, el('td', {}, k.id), el('td', {class: 'text'}, clock(k.time)), el('td', {class: 'text'}, k.kind), el('td', {}, number(k.speed, 1)), el('td', {class: 'text'}, k.robot), el('td', {}, number(k.rmsMm, 1)),
      el('td', {class: 'text wrap'}, (k.unused ? k.unused : k.says.join(', ')) + (k.spin ? ' (may have spin)' : ''))));
    content('last-kicks').replaceChildren(rows.length ? table([['#'], ['UTC', true], ['Kind', true], ['Speed, m/s'], ['Robot', true], ['rms, mm', false, 'Residual per axis'], ['Determines', true]], rows) : el('p', {class: 'empty'}, 'None yet.'));
  }

  const limit = l => !l || !known(l.value) ? '–' : (l.reached ? '' : '≥ ') + withError(l.value, l.error);

  function showTeams(now) {
    const rows = now.teams.flatMap(t => [
      el('tr', {}, el('td', {class: 'text'}, t.team + (t.beforeBreak ? ' (before the break)' : '')), ...['velocity', 'acceleration', 'braking', 'turning', 'turningFaster', 'turningSlower'].map(what => el('td', {title: t[what] && known(t[what].league) ? "the league's estimate: " + number(t[what].league, 2) : null}, limit(t[what])))),
      ...(t.deviations || []).map(words => el('tr', {}, el('td', {class: 'text wrap', colspan: 4}, words)))]);
    content('teams').replaceChildren(table([['Team', true], ['Velocity, m/s'], ['Acceleration, m/s²'], ['Braking, m/s²'], ['Turning, rad/s'], ['speeding up, rad/s²'], ['slowing down, rad/s²']], rows), el('p', {class: 'note'}, '≥: a lower bound. The robots were seldom or never seen at this limit. –: the manoeuvres so far do not determine it.'));
  }

  function showCameras(now) {
    const rows = now.cameras.map(c => el('tr', {}, el('td', {class: 'text'}, c.silentFor > 1 ? badge('bad', '⚠ ' + c.id + ' silent for ' + number(c.silentFor, 0) + ' s') : !c.calibrated ? badge('warn', c.id + ' not calibrated') : c.disagrees ? badge('warn', '⚠ ' + c.id + ': ' + number(c.apartMm, 0) + ' mm from camera ' + c.apartFrom) : badge('good', '✔ ' + c.id)),
      el('td', {}, number(c.rateHz, 1)), el('td', {}, number(c.noiseMm, 2)), el('td', {}, known(c.offsetXMm) ? number(c.offsetXMm, 1) + ', ' + number(c.offsetYMm, 1) : '–'), el('td', {}, c.gaps), el('td', {}, number(c.longestGap, 1))));
    const faults = now.cameraFaults.map(text => el('p', {class: 'note camera-fault'}, '⚠ ' + text[0].toUpperCase() + text.slice(1) + '.'));
    const apart = now.cameras.some(c => c.disagrees) ? [el('p', {class: 'note'}, 'A mark says how far apart this camera and another one report the same ball. These offsets are taken out of the kicks here; in an AI that does not do so, the ball jumps. Calibrate these cameras again.')] : [];
    content('health').replaceChildren(...rows.length ? [table([['Camera', true], ['Rate, Hz'], ['Noise, mm'], ['Offset x, y, mm'], ['Gaps'], ['Longest, s']], rows), ...faults, ...apart] : [ el('p', {class: 'empty'}, 'No frame yet.'), ...faults]);
  }

  return page;
}
