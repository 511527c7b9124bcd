/* The page of an archive: carpets, venues, cameras, teams and kick speeds of many matches. Each picture has its table. */
(() => {
  'use strict';
  const {el, known, number, signed, withError, tip, base} = Charts;
  const {$, content, draw, forget, figure, choices, swatch, start} = Frame;
  const atlas = JSON.parse($('data').textContent);
  const PARAMETERS = [['acc_slide', 'sliding deceleration', 'm/s²'], ['acc_roll', 'rolling deceleration', 'm/s²'], ['k_switch', 'switch to rolling', ''],
    ['damping_xy_first_hop', 'horizontal damping at the first impact', ''], ['damping_xy_other_hops', 'horizontal damping at later impacts', ''], ['damping_z', 'vertical damping', '']];
  const LIMITS = [['velocity_max', 'Velocity', 'm/s'], ['acceleration_max', 'Acceleration', 'm/s²'], ['braking_max', 'Braking', 'm/s²']];
  const TURNS = [['angular_velocity_max', 'Turning', 'rad/s'], ['angular_acceleration_max', 'Turning, speeding up', 'rad/s²'], ['angular_braking_max', 'Turning, slowing down', 'rad/s²']];
  /** What the quantities of the table robots are called, and their units. */
  const QUANTITIES = Object.fromEntries([...LIMITS, ...TURNS].map(([id, words, unit]) => [id, [words, unit]]));
  for (const [id, words, unit] of LIMITS) QUANTITIES['league_' + id] = [words + ', as the league estimates it', unit];
  Object.assign(QUANTITIES, {torque_limited: ['Acceleration falls with speed', ''], directional: ['Acceleration depends on direction', ''], acceleration_by_direction: ['Acceleration towards', 'm/s²'], braking_by_direction: ['Braking towards', 'm/s²'],
    speed_cap: ['Highest speed of this robot', 'm/s'], robot_acceleration: ['Acceleration of this robot', 'm/s²'], robot_braking: ['Braking of this robot', 'm/s²']});
  const ALLOWED = 6.5;
  const spelled = name => PARAMETERS.filter(p => p[0] === name).map(([, words, unit]) => words + (unit ? ', ' + unit : ''))[0] || name;
  const carpets = atlas.venues.flatMap(venue => venue.carpets.map(carpet => ({...carpet, venue})));
  let theme;
  let venue = atlas.venues.length ? 0 : -1;
  let team = 0;

  // ---- small parts ----

  const scaled = (value, factor, digits, unit) => known(value) ? number(factor * value, digits) + ' ' + unit : '–';
  const minute = seconds => new Date(seconds * 1000).toISOString().slice(0, 16).replace('T', ' ');
  const table = (id, head, rows, none, note = '') => $(id).querySelector('.table').replaceChildren(grid(head, rows, none), note && rows.length ? el('p', {class: 'note'}, note) : '');
  const several = (n, one) => n + ' ' + one + (n === 1 ? '' : one.endsWith('ch') ? 'es' : 's');

  /** A table, or the words for none; cells are text or nodes, columns whose head ends with ← are aligned left, and those with ↵ wrap, too. */
  function grid(head, rows, none) {
    if (rows.length === 0) return none ? el('p', {class: 'empty'}, none) : '';
    const style = head.map(h => h.endsWith('↵') ? 'text wrap' : h.endsWith('←') ? 'text' : null);
    const cell = (tag, value, i) => el(tag, {class: style[i], scope: tag === 'th' ? 'col' : null}, value);
    return el('table', {}, el('thead', {}, el('tr', {}, head.map((h, i) => cell('th', h.replace(/[←↵]$/, ''), i)))),
      el('tbody', {}, rows.map(row => el('tr', {}, row.map((value, i) => cell('td', value, i))))));
  }

  /** Points with two standard errors each side. */
  function points(series, colour, symbol) {
    const bars = series.filter(p => known(p.error)).flatMap(p => [[p.at, p.value - 2 * p.error], [p.at, p.value + 2 * p.error], [null, null]]);
    return [
      {type: 'line', data: bars, showSymbol: false, silent: true, lineStyle: {color: colour, width: 2}, z: 2},
      {type: 'scatter', symbol, symbolSize: 9, itemStyle: {color: colour}, data: series.map(p => ({value: [p.at, p.value], tip: p.tip})), z: 3},
    ];
  }

  const line = (data, colour, type = 'solid', width = 2) => ({type: 'line', data, showSymbol: false, silent: true, lineStyle: {color: colour, width, type}, itemStyle: {color: colour}, z: 1});
  const fromTip = p => p.data && p.data.tip ? tip(...p.data.tip) : '';
  const legend = (id, ...entries) => $(id).querySelector('.legend').replaceChildren(...entries);
  const entry = (shape, colour, text) => el('span', {}, swatch(shape, colour), text);

  function categories(option, names) {
    Object.assign(option.xAxis, {type: 'category', data: names, scale: false, axisLabel: {...option.xAxis.axisLabel, formatter: undefined, interval: 0, hideOverlap: false, rotate: names.length > 5 ? 40 : 0, width: names.length > 5 ? 110 : 90, overflow: names.length > 5 ? 'truncate' : 'break'}});
    if (names.length > 12) option.xAxis.axisLabel.interval = 'auto';
    if (names.length > 1) option.grid.bottom = names.length > 5 ? 96 : 58;
    option.xAxis.name = '';
  }

  /** Pictures are drawn when all of a row are there: then each knows its width. */
  const waiting = [];
  const later = picture => waiting.push(picture);
  const drawAll = () => waiting.splice(0).forEach(picture => picture());

  // ---- carpets ----

  const parameter = (carpet, name) => carpet.parameters.find(p => p.parameter === name);

  function showCarpets() {
    forget(content('carpets'));
    legend('carpets', entry('circle', theme.accent, 'pooled over the matches, with two standard errors'), entry('diamond', theme.bad, 'published'));
    for (const [name, words, unit] of PARAMETERS) {
      const with_ = carpets.filter(c => parameter(c, name));
      if (with_.length === 0) continue;
      const box = figure(content('carpets'), words, unit);
      const option = base(theme, '', unit);
      categories(option, with_.map(c => c.name));
      option.tooltip.formatter = fromTip;
      option.series = points(with_.map(c => {
        const p = parameter(c, name);
        return {at: c.name, value: p.value, error: p.error, tip: [c.name, withError(p.value, p.error, unit), several(p.n, 'match'), known(p.published) ? 'published ' + number(p.published, 3) : '']};
      }), theme.accent, 'circle');
      option.series.push({type: 'scatter', symbol: 'diamond', symbolSize: 10, itemStyle: {color: theme.bad},
        data: with_.filter(c => known(parameter(c, name).published)).map(c => ({value: [c.name, parameter(c, name).published], tip: [c.name, 'published ' + number(parameter(c, name).published, 4)]}))});
      later(() => draw(box, option));
    }
    table('carpets', ['Carpet←', 'From←', 'To←', 'Matches', 'Parameter←', 'Value', 'Scatter between matches', 'Drift per day', 'Published', 'Value − published'],
      carpets.flatMap(c => c.parameters.map((p, i) => [i ? '' : c.name, i ? '' : minute(c.first), i ? '' : minute(c.last), String(p.n), spelled(p.parameter), withError(p.value, p.error), p.n > 1 ? number(p.scatter, 5) : '–',
        known(p.drift) ? withError(p.drift, p.driftError) : '–', number(p.published, 4), known(p.published) ? signed(100 * (p.value / p.published - 1), 1) + ' %' : '–'])),
      'No carpet was found.', 'Scatter between matches and drift are known from several matches on. Value − published: in per cent of the published value, as calibrate prints it.');
  }

  // ---- a venue over time ----

  function showDrift() {
    forget(content('drift'));
    if (venue < 0) {
      content('drift').replaceChildren(el('p', {class: 'empty'}, 'No match has a geometry.'));
      return;
    }
    choices('venue-choice', atlas.venues.map((v, i) => [i, v.name]), venue, key => { venue = key; showDrift(); drawAll(); });
    const its = atlas.venues[venue];
    legend('drift', entry('circle', theme.accent, 'a match, with two standard errors'), entry('line', theme.good, 'carpet, pooled'), entry('dashes', theme.bad, 'published'), entry('line', theme.warn, 'carpet or ball changed'));
    for (const [name, words, unit] of PARAMETERS) {
      const value = (list, match) => list.find(v => v.parameter === name);
      const with_ = its.matches.filter(m => value(m.model));
      if (with_.length === 0) continue;
      const box = figure(content('drift'), words, unit);
      const option = base(theme, '', unit);
      Object.assign(option.xAxis, {type: 'time', axisLabel: {color: theme.text, hideOverlap: true}});
      option.tooltip.formatter = fromTip;
      option.series = points(with_.map(m => {
        const v = value(m.model);
        return {at: 1000 * m.start, value: v.value, error: v.error, tip: [m.file, minute(m.start), withError(v.value, v.error, unit), m.carpet]};
      }), theme.accent, 'circle');
      for (const c of its.carpets) {
        const p = parameter(c, name);
        if (p) option.series.push(line([[1000 * c.first, p.value], [1000 * Math.max(c.last, c.first + 60), p.value]], theme.good, 'solid', 3));
      }
      const published = its.matches.filter(m => value(m.published));
      if (published.length) option.series.push(line(published.map(m => [1000 * m.start, value(m.published).value]), theme.bad, 'dashed'));
      const values = [...with_.map(m => value(m.model).value), ...published.map(m => value(m.published).value)];
      const low = Math.min(...values), high = Math.max(...values), margin = 0.1 * (high - low || Math.abs(high) || 1);
      Object.assign(option.yAxis, {min: low - margin, max: high + margin, scale: true});
      Object.assign(option.yAxis.axisLabel, {showMinLabel: false, showMaxLabel: false});
      for (const c of its.changes.filter(c => !c.kind.startsWith('camera'))) {
        const at = 500 * (c.after + c.before);
        option.series.push(line([[at, option.yAxis.min], [at, option.yAxis.max]], theme.warn));
      }
      later(() => draw(box, option));
    }
    table('drift', ['After←', 'Before←', 'What changed↵'], its.changes.map(c => [minute(c.after), minute(c.before), c.words.replace(/^between .*? UTC: /, '')]), 'No change was found.');
  }

  // ---- cameras ----

  function showCameras() {
    forget(content('cameras'));
    const all = atlas.venues.flatMap(v => v.cameras.map(c => ({...c, name: v.name + ' / ' + c.id})));
    const shown = [['noise', 'noise of a resting ball', 'mm', 1000], ['jitter', 'jitter of capture times', 'ms', 1000], ['loss', 'frames that are missing', '%', 100], ['offset', 'distance from the mean of all cameras', 'mm', 1000]];
    for (const [key, words, unit, factor] of shown) {
      if (all.length === 0) continue;
      const box = figure(content('cameras'), words, unit + ', median of the matches');
      const option = base(theme, '', unit);
      categories(option, all.map(c => c.name));
      option.yAxis.scale = false;
      option.tooltip.formatter = fromTip;
      option.series = [{type: 'bar', barMaxWidth: 26, itemStyle: {color: theme.accent}, data: all.map(c => ({value: known(c[key]) ? factor * c[key] : null, tip: [c.name, number(factor * c[key], 2) + ' ' + unit, several(c.matches, 'match')]}))}];
      later(() => draw(box, option));
    }
    table('cameras', ['Venue / camera←', 'Matches', 'Rate', 'Noise at rest', 'Jitter', 'Missing frames', 'Outages', 'Offset', 'Distortion'],
      all.map(c => [c.name, String(c.matches), scaled(c.rate, 1, 1, 'Hz'), scaled(c.noise, 1000, 2, 'mm'), scaled(c.jitter, 1000, 2, 'ms'), scaled(c.loss, 100, 2, '%'), String(c.gaps), scaled(c.offset, 1000, 1, 'mm'), number(c.distortion, 3)]), 'No camera was found.');
  }

  // ---- teams ----

  const quantity = (t, name) => t.quantities.find(q => q.name === name && q.robot < 0);
  const tournaments = [...new Set(atlas.teams.map(t => t.tournament))];

  function showLimits() {
    forget(content('limits'));
    const names = [...new Set(atlas.teams.map(t => t.team))];
    const symbols = ['circle', 'triangle', 'rect', 'diamond'];
    legend('limits', ...tournaments.slice(0, 8).map((t, i) => entry(symbols[i % 4], theme.camera(i).colour, t)));
    for (const [name, words, unit] of LIMITS) {
      if (names.length === 0) continue;
      const box = figure(content('limits'), words, unit + ', with two standard errors');
      const option = base(theme, '', unit);
      categories(option, names);
      option.tooltip.formatter = fromTip;
      option.series = tournaments.flatMap((tournament, i) => points(atlas.teams.filter(t => t.tournament === tournament && known(quantity(t, name).value)).map(t => {
        const q = quantity(t, name);
        return {at: t.team, value: q.value, error: q.error, tip: [t.team, tournament, (q.reached ? '' : 'at least ') + withError(q.value, q.error, unit), several(t.matches, 'match')]};
      }), theme.camera(i).colour, symbols[i % 4]));
      later(() => draw(box, option));
    }
    table('limits', ['Team←', 'Tournament←', 'Matches', 'Manoeuvres', ...LIMITS.map(l => l[1]), ...TURNS.map(l => l[1]), 'Departures from one limit↵', 'Robots that differ↵'],
      atlas.teams.map(t => [t.team, t.tournament, String(t.matches), String(t.manoeuvres),
        ...[...LIMITS, ...TURNS].map(([name, , unit]) => { const q = quantity(t, name); return (q.reached === false ? '≥ ' : '') + withError(q.value, q.error, unit); }),
        t.quantities.filter(q => q.name === 'torque_limited' || q.name === 'directional').map(q => QUANTITIES[q.name][0].toLowerCase() + ' ' + withError(q.value, q.error) + ' (' + q.note + ')').join(', ') || 'none',
        t.quantities.filter(q => q.robot >= 0).map(q => q.robot + ': ' + (q.name === 'speed_cap' ? 'at most ' + withError(q.value, q.error, 'm/s') : q.name.replace('robot_', '') + ' ' + withError(q.value, q.error, 'm/s²'))).join(', ') || 'none']), 'No team was found.', '≥: the robots did not reach the limit; it is at least as high.');
  }

  /** Cells as squares, darker where more lies, on a logarithmic scale. */
  function cells(box, picture, xName, yName, {turn, square}, lines) {
    const option = base(theme, xName, yName);
    const all = picture.count.map((count, i) => ({at: turn ? [-picture.y[i], picture.x[i]] : [picture.x[i], picture.y[i]], count}));
    const total = picture.count.reduce((a, b) => a + b, 0);
    const reach = axis => { let sum = 0, far = 0; for (const c of [...all].sort((a, b) => Math.abs(a.at[axis]) - Math.abs(b.at[axis]))) { sum += c.count; if (sum <= 0.998 * total) far = Math.abs(c.at[axis]); } return Math.max(1, Math.ceil(far + 0.5)); };
    const far = square ? Array(2).fill(Math.max(reach(0), reach(1))) : [reach(0), reach(1)];
    if (square) {
      const side = Math.max(60, Math.min(box.clientWidth - option.grid.left - option.grid.right, box.clientHeight - option.grid.top - option.grid.bottom));
      option.grid = {left: option.grid.left, top: option.grid.top, width: side, height: side};
    }
    const positive = !square;
    Object.assign(option.xAxis, {min: positive ? 0 : -far[0], max: far[0], scale: false});
    Object.assign(option.yAxis, {min: -far[1], max: far[1], scale: false});
    const width = option.grid.width || Math.max(60, box.clientWidth - option.grid.left - option.grid.right);
    const height = option.grid.height || Math.max(60, box.clientHeight - option.grid.top - option.grid.bottom);
    const size = [0.3 + width * (turn ? picture.cellY : picture.cellX) / (option.xAxis.max - option.xAxis.min), 0.3 + height * (turn ? picture.cellX : picture.cellY) / (2 * far[1])];
    const most = Math.log(1 + Math.max(1, ...picture.count));
    option.tooltip.formatter = p => Array.isArray(p.value) ? tip(p.value[2] + ' detections', number(p.value[0], 2) + ', ' + number(p.value[1], 2)) : '';
    option.series = [{type: 'scatter', symbol: 'rect', symbolSize: size, itemStyle: {color: theme.accent},
      data: all.filter(c => Math.abs(c.at[0]) < far[0] && Math.abs(c.at[1]) < far[1]).map(c => ({value: [...c.at, c.count], itemStyle: {opacity: 0.06 + 0.94 * Math.log(1 + c.count) / most}}))}, ...lines];
    draw(box, option);
  }

  const round = radius => Array.from({length: 73}, (_, i) => [radius * Math.sin(i * Math.PI / 36), radius * Math.cos(i * Math.PI / 36)]);

  /** The limit by direction with two standard errors at each; a circle where it is not known by direction. */
  function byDirection(t, kind, limit, colour, type) {
    const all = t.quantities.filter(q => q.name === kind + '_by_direction');
    if (all.length === 0) return known(limit) ? [line(round(limit), colour, type)] : [];
    const at = (q, value) => [-value * Math.sin(q.direction), value * Math.cos(q.direction)];
    const gap = (q, i, list) => i > 0 && q.direction - list[i - 1].direction > 0.27;
    const path = [...all, {...all[0], direction: all[0].direction + 2 * Math.PI}].flatMap((q, i, list) => gap(q, i, list) ? [[null, null], at(q, q.value)] : [at(q, q.value)]);
    const bars = all.flatMap(q => [at(q, q.value - 2 * q.error), at(q, q.value + 2 * q.error), [null, null]]);
    return [line(path, colour, type), line(bars, colour)];
  }

  function showPictures() {
    forget(content('pictures'));
    if (atlas.teams.length === 0) {
      content('pictures').replaceChildren(el('p', {class: 'empty'}, 'No referee named a team.'));
      table('pictures', [], []);
      return;
    }
    const t = atlas.teams[team];
    const a = quantity(t, 'acceleration_max').value, b = quantity(t, 'braking_max').value, v = quantity(t, 'velocity_max').value;
    if (t.manoeuvres > 0) {
      const own = figure(content('pictures'), 'acceleration in the robot’s own frame', 'front upwards; solid: limit of acceleration, dashed: of braking', 'chart square');
      later(() => cells(own, t.ownFrame, 'to the right (m/s²)', 'to the front (m/s²)', {turn: true, square: true},
        [...byDirection(t, 'acceleration', a, theme.good, 'solid'), ...byDirection(t, 'braking', b, theme.bad, 'dashed')]));
      const against = figure(content('pictures'), 'change of speed against speed', 'above zero faster, below slower', 'chart square');
      later(() => cells(against, t.againstSpeed, 'speed (m/s)', 'change of speed (m/s²)', {},
        [...(known(a) ? [line([[0, a], [v || 4, a]], theme.good)] : []), ...(known(b) ? [line([[0, -b], [v || 4, -b]], theme.bad, 'dashed')] : []), ...(known(v) ? [line([[v, -b || -4], [v, a || 4]], theme.text)] : [])]));
    }
    if (t.standing.count.length > 0) {
      const halt = figure(content('pictures'), 'standing robots while the referee says halt', 'both teams of its matches; circle: ' + number(1000 * t.standingNoise, 2) + ' mm per axis', 'chart square');
      later(() => cells(halt, t.standing, 'deviation in x (mm)', 'in y (mm)', {square: true},
        known(t.standingNoise) ? [line(round(1000 * t.standingNoise), theme.text)] : []));
    }
    table('pictures', ['Quantity←', 'Robot', 'Value', 'Observations', 'Reached', 'Note↵'],
      t.quantities.map(q => [(QUANTITIES[q.name] || [q.name])[0] + (known(q.direction) ? ' ' + number(q.direction * 180 / Math.PI, 0) + '°' : ''), q.robot < 0 ? 'all' : String(q.robot), (q.reached === false ? '≥ ' : '') + withError(q.value, q.error, (QUANTITIES[q.name] || [])[1]), String(q.samples), q.reached === null ? '–' : q.reached ? 'yes' : 'no', q.note || '']), 'No limit was measured.');
  }

  function chooseTeam() {
    const names = atlas.teams.map((t, i) => el('option', {value: String(i)}, t.team + ', ' + t.tournament));
    $('team-choice').replaceChildren(...names);
    $('team-choice').addEventListener('change', event => { team = Number(event.target.value); showPictures(); drawAll(); });
  }

  // ---- kick speeds ----

  function showSpeeds() {
    forget(content('speeds'));
    const all = atlas.speeds.filter(s => s.kicks > 0);
    if (all.length > 0) {
      const box = figure(content('speeds'), 'kicks by speed, all teams', 'only kicks whose speed is known to 0.5 m/s', 'chart tall');
      later(() => {
        const option = base(theme, 'speed (m/s)', 'kicks');
        const sum = all[0].bins.map((_, i) => all.reduce((n, s) => n + s.bins[i], 0));
        const last = sum.reduce((far, n, i) => n > 0 ? i : far, 0) + 2;
        option.tooltip.formatter = fromTip;
        option.yAxis.scale = false;
        Object.assign(option.xAxis, {scale: false, min: 0, max: Math.max(7, Math.ceil(last * atlas.binOfSpeeds))});
        option.series = [{type: 'bar', barWidth: Math.max(2, 0.9 * (box.clientWidth - 80) * atlas.binOfSpeeds / option.xAxis.max), itemStyle: {color: theme.accent},
          data: sum.slice(0, last).map((n, i) => ({value: [(i + 0.5) * atlas.binOfSpeeds, n], tip: [number(i * atlas.binOfSpeeds, 2) + ' to ' + number((i + 1) * atlas.binOfSpeeds, 2) + ' m/s', n + ' kicks']}))},
          {...line([[ALLOWED, 0], [ALLOWED, Math.max(1, ...sum)]], theme.bad), z: 3}];
        draw(box, option);
      });
    }
    legend('speeds', atlas.fast.length === 0 ? '' : 'Too fast: the probability that the kick broke the limit. The speed is the highest that the ball has: right after the kick, while it still slides. It is lower when the ball rolls. A ball that was dribbled before may have spin and slide for a shorter time; then less is known of its speed than the interval says.');
    if (atlas.fast.length > 0) {
      const near = [...atlas.fast].sort((a, b) => a.speed - b.speed);
      const box = figure(content('speeds'), 'kicks near the limit', 'speed with two standard errors', 'chart tall');
      later(() => {
        const option = base(theme, 'kicks, the slowest first', 'speed (m/s)');
        option.tooltip.formatter = fromTip;
        Object.assign(option.xAxis, {scale: false, min: 0, max: near.length + 1, minInterval: 1});
        option.series = [...points(near.map((k, i) => ({at: i + 1, value: k.speed, error: k.error, tip: [k.team || 'unknown team', withError(k.speed, k.error, 'm/s'), 'too fast: ' + probability(k), k.file]})), theme.accent, 'circle'),
          line([[0, ALLOWED], [near.length + 1, ALLOWED]], theme.bad)];
        draw(box, option);
      });
    }
    table('speeds', ['Too fast', 'Speed', '95 % interval (m/s)', 'When it rolls', 'Kind←', 'Dribbled before←', 'Team←', 'Robot', 'Tournament←', 'When←', 'Log←'],
      atlas.fast.map(k => [probability(k), withError(k.speed, k.error, 'm/s'), number(k.speed - 1.96 * k.error, 2) + ' to ' + number(k.speed + 1.96 * k.error, 2), known(k.rolling) ? number(k.rolling, 2) + ' m/s' : '–', k.kind, k.maySpin ? 'yes' : 'no',
        k.team || '–', k.robot < 0 ? '–' : String(k.robot), k.tournament, minute(k.time), k.file]), 'No kick was near the limit.');
  }

  const probability = k => k.odds > 0.999 ? 'certain' : number(100 * k.odds, 1) + ' %';

  // ---- trackers ----

  function showTrackers() {
    forget(content('trackers'));
    const all = atlas.trackers.map(t => ({...t, name: (t.source || 'without a name') + (tournaments.length > 1 ? ', ' + t.tournament : '')}));
    if (all.length === 0) {
      content('trackers').replaceChildren(el('p', {class: 'empty'}, 'No log holds messages of trackers.'));
      table('trackers', [], []);
      return;
    }
    legend('trackers', entry('circle', theme.accent, 'mean, with two standard deviations from kick to kick'), 'Each is compared with the fits of the kicks.');
    const picture = (words, unit, draws) => {
      const box = figure(content('trackers'), words, unit);
      later(() => {
        const option = base(theme, '', unit);
        categories(option, all.map(t => t.name));
        option.xAxis.axisLabel.width = 130;
        option.grid.bottom = all.length > 5 ? 110 : option.grid.bottom;
        option.yAxis.scale = false;
        option.tooltip.formatter = fromTip;
        option.series = draws();
        draw(box, option);
      });
    };
    const bars = (words, unit, of) => picture(words, unit, () => [{type: 'bar', barMaxWidth: 26, itemStyle: {color: theme.accent}, data: all.map(t => ({value: of(t), tip: [t.name, scaled(of(t), 1, 1, unit), several(t.matches, 'match')]}))}]);
    bars('how late its ball is', 'ms', t => known(t.delay) ? 1000 * t.delay : null);
    bars('error of its position, without the delay', 'mm', t => known(t.position) ? 1000 * t.position : null);
    picture('reported speed of a kick minus that of the fit', 'm/s', () => points(all.filter(t => known(t.speedBias)).map(t => ({at: t.name, value: t.speedBias, error: t.speedScatter, tip: [t.name, signed(t.speedBias, 2) + ' m/s, standard deviation ' + number(t.speedScatter, 2), t.matched + ' kicks']})), theme.accent, 'circle'));
    table('trackers', ['Tracker←', 'Tournament←', 'Matches', 'Delay', 'Position', 'Velocity', 'Kicks it reports', 'Missed', 'Invented', 'Speed of a kick', 'Place of rest', 'Time of rest'],
      all.map(t => [t.source || 'without a name', t.tournament, String(t.matches), scaled(t.delay, 1000, 1, 'ms'), scaled(t.position, 1000, 1, 'mm'), scaled(t.velocity, 1, 2, 'm/s'), t.kicks === 0 ? 'none' : String(t.kicks), t.kicks === 0 ? '–' : t.missed + ' of ' + (t.matched + t.missed), t.kicks === 0 ? '–' : String(t.invented),
        known(t.speedBias) ? signed(t.speedBias, 2) + ' m/s, ± ' + number(t.speedScatter, 2) + ' m/s' : '–', scaled(t.stopPosition, 1, 2, 'm'), scaled(t.stopTime, 1, 2, 's')]));
  }

  // ---- the page ----

  function showSummary() {
    const lines = [el('p', {}, el('b', {}, several(atlas.logs, 'log')), ', ' + number(atlas.play, 1) + ' minutes, ' + several(atlas.kicks, 'kick') + ', ' + several(carpets.length, 'carpet') + ' at ' + several(atlas.venues.length, 'venue') + ', '
      + several(new Set(atlas.teams.map(t => t.team)).size, 'team') + ' in ' + several(tournaments.length, 'tournament') + '.')];
    if (atlas.findings.length) lines.push(el('pre', {}, atlas.findings.join('\n')));
    $('verdict').replaceChildren(...lines);
    content('broken').replaceChildren(atlas.broken.length === 0 ? el('p', {class: 'empty'}, 'Every log was read.') : grid(['Log←', 'Tournament←', 'Why↵'], atlas.broken.map(b => [b.file, b.tournament, b.why])));
    content('problems').replaceChildren(grid(['Logs', 'What↵'], atlas.problems.map(p => [String(p.logs), p.what]), 'No problem was found.'));
  }

  function showAll() {
    showSummary();
    for (const show of [showCarpets, showDrift, showCameras, showLimits, showPictures, showSpeeds, showTrackers]) show();
    drawAll();
  }

  $('provenance').textContent = tournaments.join(', ');
  $('footer').textContent = 'Made by ' + atlas.generatedBy + '. Charts by Apache ECharts 5.6.0 (Apache License 2.0). Key: t changes between light and dark.';
  chooseTeam();
  start([...Array(8).keys()], {use(colours) { theme = colours; }, showAll, resized() { showPictures(); showSpeeds(); showTrackers(); drawAll(); }, keys: {}});
})();
