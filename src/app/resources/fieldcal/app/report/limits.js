/* The page of movement limits: the numbers of both teams, and where their manoeuvres lie. */
(() => {
  'use strict';
  const {el, known, number, withError, tip, base} = Charts;
  const {$, content, draw, forget, figure, badge, swatch, showProvenance, showProblems, start} = Frame;
  const report = JSON.parse($('data').textContent);
  const KINDS = [['velocity', 'Velocity', 'm/s'], ['acceleration', 'Acceleration', 'm/s²'], ['braking', 'Braking', 'm/s²']];
  const TURNS = [['turnVelocity', 'Turning', 'rad/s'], ['turnAcceleration', 'Turning, speeding up', 'rad/s²'], ['turnBraking', 'Turning, slowing down', 'rad/s²']];
  const boxes = [];
  let theme;

  // ---- the limits as functions ----

  const effect = (team, id, seenIn) => team.effects.find(e => e.effect === id && (!seenIn || e.seenIn === seenIn));

  /** Limit of acceleration (or braking) at a speed and an angle from the front; unknown parts are left out. */
  function limit(team, kind, speed, angle) {
    let value = team[kind].value;
    const torque = kind === 'acceleration' && effect(team, 'torque_limited');
    const aside = effect(team, 'directional', kind) || effect(team, 'directional');
    if (torque && known(team.velocity.value)) value *= Math.max(0, 1 - torque.coefficient * speed / team.velocity.value);
    if (aside) value *= 1 - aside.coefficient * Math.abs(Math.sin(angle));
    return value;
  }

  // ---- words ----

  function showVerdict() {
    const lines = [];
    for (const team of report.teams) {
      const name = team.team[0].toUpperCase() + team.team.slice(1);
      if (!known(team.acceleration.value) && !known(team.braking.value)) {
        lines.push(el('p', {}, el('b', {}, name), ': its robots were not seen for long enough.'));
        continue;
      }
      const numbers = KINDS.map(([key, label, unit]) => label.toLowerCase() + (team[key].reached || !known(team[key].value) ? ' ' : ' at least ') + withError(team[key].value, team[key].standardError, unit));
      const shaped = team.envelopes.filter(e => e.shaped);
      const what = team.effects.length === 0 ? shaped.length > 0 ? 'the limit depends on the direction.' : team.oneLimit + '.'
        : team.effects.map(e => 'it ' + e.sentence + ' (' + e.effect + ', coefficient ' + withError(e.coefficient, e.standardError) + '; seen in ' + e.seenIn + ': '
          + number(100 * e.shareWith, 0) + ' % of the manoeuvres are at the limit with it, ' + number(100 * e.shareWithout, 0) + ' % without)').join('; ') + '.';
      lines.push(el('p', {}, el('b', {}, name), ': ' + numbers.join(', ') + '; ' + what));
      for (const e of team.envelopes) if (e.sentence) lines.push(el('p', {}, name + ', ' + e.sentence + '.'));
      for (const robot of team.robots) lines.push(el('p', {}, name + ': ' + robot.sentence + '.'));
      for (const cap of team.caps) lines.push(el('p', {}, name + ' ' + cap.robot + ' never drives faster than ' + withError(cap.speed, cap.standardError, 'm/s') + '.'));
    }
    if (!report.refereeSeen) lines.push(el('ul', {}, el('li', {}, 'No referee was recorded: everything was counted, including breaks.')));
    $('verdict').replaceChildren(...lines);
  }

  function showLimits() {
    const head = ['Team', 'Limit', 'Estimate', 'Manoeuvres', 'Reached', 'League’s estimate', 'Its samples'];
    const rows = report.teams.flatMap(team => [...KINDS, ...TURNS].flatMap(([key, label, unit], i) => {
      const own = team[key];
      const league = team['league' + label] || {};
      const row = el('tr', {},
        el('td', {class: 'team'}, i === 0 ? team.team : ''), el('td', {class: 'text'}, label),
        el('td', {class: 'big'}, (own.reached || !known(own.value) ? '' : '≥ ') + withError(own.value, own.standardError, unit)),
        el('td', {}, String(own.samples)),
        el('td', {}, !known(own.value) ? '–' : own.reached ? badge('good', 'yes') : badge('warn', 'no')),
        el('td', {class: 'league'}, known(league.value) ? number(league.value, 2) + ' ' + unit : '–'), el('td', {class: 'league'}, league.samples === undefined ? '–' : String(league.samples)));
      const note = own.note || league.note;
      return note ? [row, el('tr', {}, el('td', {}), el('td', {class: 'text wrap', colspan: head.length - 1}, note[0].toUpperCase() + note.slice(1) + '.'))] : [row];
    }));
    content('limits').replaceChildren(Frame.cards(el('table', {},
      el('thead', {}, el('tr', {}, head.map((h, i) => el('th', {scope: 'col', class: i < 2 ? 'text' : null}, h)))), el('tbody', {}, rows))),
      el('p', {class: 'note'}, 'The estimate is the value at which fitted manoeuvres cluster, with its standard error. ' + report.leaguesEstimate));
  }

  // ---- pictures ----

  /** Cells as squares, darker where more lies, on a logarithmic scale. */
  function cells(picture, size, span, place) {
    const most = Math.log(1 + Math.max(1, ...picture.count));
    // A little larger, so that no gaps show between neighbours.
    const symbol = [0.3 + size.width * picture.cellX / span.x, 0.3 + size.height * picture.cellY / span.y];
    return {
      type: 'scatter', symbol: 'rect', symbolSize: symbol, silent: false, itemStyle: {color: theme.accent},
      data: picture.count.map((count, i) => ({value: place(picture.x[i], picture.y[i], count), itemStyle: {opacity: 0.06 + 0.94 * Math.log(1 + count) / most}})),
    };
  }

  const line = (points, colour, type = 'solid', width = 2) => ({
    type: 'line', data: points, showSymbol: false, silent: true, lineStyle: {color: colour, width, type}, itemStyle: {color: colour}, z: 3,
  });

  /** A round curve in polar form about zero. */
  const round = radius => Array.from({length: 121}, (_, i) => { const a = i * Math.PI / 60; return [radius(a) * Math.sin(a), radius(a) * Math.cos(a)]; });

  /** A square picture about zero, as large as its box allows. */
  function square(box, option, reach) {
    const room = {left: 58, right: 12, top: 10, bottom: 44};
    const side = Math.max(60, Math.min(box.clientWidth - room.left - room.right, box.clientHeight - room.top - room.bottom));
    const left = room.left + Math.max(0, (box.clientWidth - room.left - room.right - side) / 2);
    option.grid = {left, top: room.top, width: side, height: side};
    Object.assign(option.xAxis, {min: -reach, max: reach, scale: false});
    Object.assign(option.yAxis, {min: -reach, max: reach, scale: false});
    return {width: side, height: side};
  }

  /** A multiple of the unit that holds all but the rarest cells and the limits. */
  function reach(picture, unit, ...limits) {
    const total = picture.count.reduce((a, b) => a + b, 0);
    const radii = picture.count.map((c, i) => [Math.max(Math.abs(picture.x[i]), Math.abs(picture.y[i])), c]).sort((a, b) => a[0] - b[0]);
    let sum = 0, far = 0;
    for (const [r, c] of radii) { sum += c; if (sum <= 0.998 * total) far = r; }
    return unit * Math.ceil(Math.max(far + picture.cellX, ...limits.filter(known).map(l => 1.15 * l), unit) / unit);
  }

  /** A robot from above, front upwards, in the middle of the picture: a disc with a flat front. */
  function outline(radius) {
    const flat = Math.acos(0.8);
    const arc = Array.from({length: 61}, (_, i) => { const a = flat + i * (2 * Math.PI - 2 * flat) / 60; return [radius * Math.sin(a), radius * Math.cos(a)]; });
    return [...arc, arc[0]];
  }

  /** An envelope with a bar of two standard errors at each direction; open where directions are not known. */
  function polygon(envelope, colour, type) {
    const at = (p, value) => [-value * Math.sin(p.angle), value * Math.cos(p.angle)];
    const step = 2 * Math.PI / 36;
    const points = [...envelope.points, {...envelope.points[0], angle: envelope.points[0].angle + 2 * Math.PI}];
    const path = points.flatMap((p, i) => i > 0 && p.angle - points[i - 1].angle > 1.5 * step ? [[null, null], at(p, p.value)] : [at(p, p.value)]);
    const bars = envelope.points.flatMap(p => [at(p, p.value - 2 * p.standardError), at(p, p.value + 2 * p.standardError), [null, null]]);
    return [line(path, colour, type), line(bars, colour, 'solid', 2)];
  }

  /** What the pictures show, direction by direction. */
  function showDirections() {
    const cell = (team, kind, k) => {
      const e = team.envelopes.find(x => x.seenIn === kind);
      const p = e && e.points.find(x => Math.round(x.angle * 18 / Math.PI) === k);
      return p ? withError(p.value, p.standardError, 'm/s²') + ' (' + number(p.manoeuvres, 0) + ')' : '–';
    };
    const columns = report.teams.flatMap(team => ['acceleration', 'braking'].map(kind => [team, kind]));
    const rows = Array.from({length: 36}, (_, k) => k).filter(k => columns.some(([team, kind]) => cell(team, kind, k) !== '–'));
    const table = $('own-frame').querySelector('.table');
    if (rows.length === 0) { table.replaceChildren(); return; }
    table.replaceChildren(el('details', {}, el('summary', {}, 'Limits by direction (manoeuvres at the limit)'), Frame.cards(el('table', {},
      el('thead', {}, el('tr', {}, el('th', {scope: 'col'}, 'Direction'), columns.map(([team, kind]) => el('th', {scope: 'col'}, team.team + ', ' + kind)))),
      el('tbody', {}, rows.map(k => el('tr', {}, el('td', {}, k * 10 + '°'), columns.map(([team, kind]) => el('td', {}, cell(team, kind, k))))))))),
      el('p', {class: 'note'}, '0° is the front, 90° the left. Directions in which the robots hardly ever used all they have are missing.'));
  }

  function ownFrame(box, team) {
    const option = base(theme, 'acceleration to the right (m/s²)', 'to the front (m/s²)');
    const span = reach(team.ownFrame, 1, team.acceleration.value, team.braking.value);
    const size = square(box, option, span);
    option.tooltip.formatter = p => Array.isArray(p.value) ? tip(p.value[2] + ' detections', number(p.value[1], 2) + ' m/s² to the front', number(p.value[0], 2) + ' m/s² to the right') : '';
    option.series = [cells(team.ownFrame, size, {x: 2 * span, y: 2 * span}, (x, y, n) => [-y, x, n]), line(outline(0.14 * span), theme.muted, 'solid', 2)];
    for (const [kind, colour, type] of [['acceleration', theme.good, 'solid'], ['braking', theme.bad, 'dashed']]) {
      const envelope = team.envelopes.find(e => e.seenIn === kind && e.points.length > 0);
      if (envelope) option.series.push(...polygon(envelope, colour, type));
      if (known(team[kind].value) && !(envelope && envelope.shaped)) option.series.push(line(round(a => limit(team, kind, 0, a)), colour, envelope ? 'dotted' : type, envelope ? 1 : 2));
    }
    draw(box, option);
  }

  function againstSpeed(box, team) {
    const option = base(theme, 'speed (m/s)', 'change of speed (m/s²)');
    const p = team.againstSpeed;
    const fastest = Math.ceil(2 * Math.max(1, 1.1 * (team.velocity.value || 0), ...p.x.filter((_, i) => p.count[i] > 2).map(x => x + p.cellX))) / 2;
    const most = Math.ceil(Math.max(1, 1.3 * (team.acceleration.value || 0), 1.3 * (team.braking.value || 0)));
    option.xAxis.min = 0; option.xAxis.max = fastest;
    option.yAxis.min = -most; option.yAxis.max = most;
    const size = {width: Math.max(60, box.clientWidth - option.grid.left - option.grid.right), height: Math.max(60, box.clientHeight - option.grid.top - option.grid.bottom)};
    option.tooltip.formatter = q => Array.isArray(q.value) ? tip(q.value[2] + ' detections', number(q.value[0], 2) + ' m/s', number(q.value[1], 2) + ' m/s²') : '';
    const shown = p.count.map((_, i) => i).filter(i => Math.abs(p.y[i]) < most && p.x[i] < fastest);
    const part = {...p, x: shown.map(i => p.x[i]), y: shown.map(i => p.y[i]), count: shown.map(i => p.count[i])};
    option.series = [cells(part, size, {x: fastest, y: 2 * most}, (x, y, n) => [x, y, n])];
    const top = known(team.velocity.value) ? team.velocity.value : fastest;
    const ramp = (kind, sign) => Array.from({length: 31}, (_, i) => [top * i / 30, sign * limit(team, kind, top * i / 30, 0)]);
    if (known(team.acceleration.value)) option.series.push(line(ramp('acceleration', 1), theme.good));
    if (known(team.braking.value)) option.series.push(line(ramp('braking', -1), theme.bad, 'dashed'));
    if (known(team.velocity.value)) option.series.push(line([[top, -most], [top, most]], theme.text, team.velocity.reached ? 'solid' : 'dotted'));
    draw(box, option);
  }

  function noise(box) {
    const option = base(theme, 'deviation in x (mm)', 'in y (mm)');
    const span = reach(report.standing, 2, 3 * report.standingNoiseMm);
    const size = square(box, option, span);
    option.tooltip.formatter = p => Array.isArray(p.value) ? tip(p.value[2] + ' detections', 'x ' + number(p.value[0], 2) + ' mm', 'y ' + number(p.value[1], 2) + ' mm') : '';
    option.series = [cells(report.standing, size, {x: 2 * span, y: 2 * span}, (x, y, n) => [x, y, n])];
    for (const k of [1, 2]) if (known(report.standingNoiseMm)) option.series.push(line(round(() => k * report.standingNoiseMm), theme.text, k === 1 ? 'solid' : 'dashed'));
    draw(box, option);
  }

  const entry = (shape, colour, text) => el('span', {}, swatch(shape, colour), text);
  const legend = (id, ...entries) => $(id).querySelector('.legend').replaceChildren(...entries);

  function build() {
    boxes.length = 0;
    for (const [id, title, drawer] of [['own-frame', 'front upwards, with the robot’s outline', ownFrame], ['against-speed', 'above zero faster, below slower', againstSpeed]]) {
      forget(content(id));
      for (const team of report.teams) {
        if (team.manoeuvres === 0) continue;
        const box = figure(content(id), team.team, title, id === 'own-frame' ? 'chart square' : 'chart tall');
        boxes.push(() => drawer(box, team));
      }
      if (content(id).childElementCount === 0) content(id).replaceChildren(el('p', {class: 'empty'}, 'No manoeuvre was seen.'));
    }
    forget(content('noise'));
    if (report.standing.count.length === 0) {
      content('noise').replaceChildren(el('p', {class: 'empty'}, 'No robot stood still while the referee said halt.'));
    } else {
      const box = figure(content('noise'), 'both teams, all cameras', 'in HALT, about the mean of 16 detections', 'chart square');
      boxes.push(() => noise(box));
    }
  }

  function showAll() {
    legend('own-frame', entry('band', theme.accent, 'detections, darker where more'), entry('line', theme.good, 'limit of acceleration by direction, with two standard errors'), entry('dashes', theme.bad, 'the same of braking'), report.teams.some(team => team.effects.length) ? el('span', {}, 'Dotted lines follow the effects that are named above.') : '');
    legend('against-speed', entry('band', theme.accent, 'detections, darker where more'), entry('line', theme.good, 'limit of acceleration along the front'), entry('dashes', theme.bad, 'limit of braking'), entry('line', theme.text, 'limit of velocity'));
    legend('noise', entry('line', theme.text, 'one standard deviation: ' + number(report.standingNoiseMm, 2) + ' mm per axis'), entry('dashes', theme.text, 'two'), el('span', {}, 'Driving robots: ' + number(report.noiseMm, 2) + ' mm.'));
    showVerdict();
    showLimits();
    showDirections();
    for (const picture of boxes) picture();
  }

  showProvenance(report.provenance);
  // Nothing here is drawn by lot, so there is no seed to name.
  $('footer').textContent = 'Made by ' + report.provenance.generatedBy + '. Charts by Apache ECharts 5.6.0 (Apache License 2.0). Key: t changes between light and dark.';
  showProblems(report.problems);
  build();
  start([], {use(colours) { theme = colours; }, showAll, resized: () => boxes.forEach(picture => picture()), keys: {}});
})();
