/* The page of the calibration play: plan it, start it, watch it, pause or abort it. */
import {act} from './server.js';
import {button, confirmed, field, refill, renew, select, table} from './parts.js';

const {el, known, number, withError, fieldView, extent} = Charts;
const {$, content, draw, charts, badge, swatch} = Frame;
const PACES = [['1', 'real time'], ['4', '4 × real time'], ['0', 'as fast as possible']];
const CHOICES = [['spread', 'spread'], ['adaptive', 'most informative']];

export function playPage(app) {
  const page = {id: 'play', title: 'Play', always: true, show, told: showStatus, resized: () => showField(true), keys: {}, keyWords: [['p', 'pause the play, or resume it']], badge: () => app.state && app.state.play && play().running ? ' ●' : ''};
  const order = {field: 'simulated', host: 'localhost', port: 10300, bridge: '127.0.0.1:10400', driveSpeed: 2.5, vision: '224.5.23.2:10020', referee: '', kind: 'flat', kicks: 12, first: 'yellow0', second: 'yellow1', half: 'whole', across: 0, slowest: 2, fastest: 6.5, elevation: 45, choice: 'spread', seed: 1, pace: '4'};
  let theme, built = '', plan = null, planFailure = null, shape = '', planning = 0;

  const play = () => app.state.play;
  const status = () => play().status || null;
  const live = () => play().running && status();

  function show() {
    theme = app.colours();
    // What can be pressed now first: who pressed what cannot be pressed any more goes on there.
    for (const part of play().running ? [showNext, showWords, buildForm] : [buildForm, showNext, showWords]) part();
    showStatus();
    if (!plan && !planFailure) ask();
  }

  // ---- the order ----

  function buildForm() {
    const key = order.field + order.kind + play().running;
    if (key === built) return;
    built = key;
    const keep = name => event => { order[name] = event.target.type === 'number' ? Number(event.target.value) : event.target.value; ask(); };
    const figure = (name, min, max, step, size) => el('input', {id: 'order-' + name, type: 'number', min, max, step, value: order[name], style: 'width: ' + size + 'em', oninput: keep(name)});
    const text = (name, placeholder) => el('input', {id: 'order-' + name, value: order[name], size: 8, maxlength: 100, placeholder, oninput: keep(name)});
    const robots = order.field === 'robots';
    const place = robots ? [field('Bridge', text('bridge')), field('Fastest drive, m/s', figure('driveSpeed', 0.2, 5, 0.1, 5)), field('Vision', text('vision'))] : [field('Host', text('host')), field('Control port', figure('port', 1, 65533, 1, 6)), field('Its vision', text('vision'))];
    const chip = order.kind === 'chip';
    const choose = name => value => { order[name] = value; if (name === 'field') Object.assign(order, value === 'robots' ? {vision: '224.5.23.2:10006', driveSpeed: 0.5} : {vision: '224.5.23.2:10020', driveSpeed: 2.5}); if (name === 'kind') Object.assign(order, value === 'chip' ? {slowest: 3, fastest: 5.5} : {slowest: 2, fastest: 6.5}); built = ''; buildForm(); ask(); };
    $('order-form').onsubmit = event => { event.preventDefault(); start(); };
    refill($('order-form'), el('fieldset', {disabled: play().running ? '' : null},
      field('Field', select('order-field', [['simulated', 'simulated here'], ['simulator', 'a simulator'], ['robots', 'your field: robots at a bridge']], order.field, choose('field'))),
      field('Kicks', select('order-kind', [['flat', 'flat'], ['chip', 'chips']], order.kind, choose('kind'))),
      field('Good kicks', figure('kicks', 1, 200, 1, 5)),
      field('Slowest, m/s', figure('slowest', 0.7, 8, 0.1, 5)), field('Fastest, m/s', figure('fastest', 0.7, 8, 0.1, 5)), field('Speeds', select('order-choice', CHOICES, order.choice, value => { order.choice = value; })),
      ...(chip ? [field('Elevation, °', figure('elevation', 15, 75, 1, 5)), field('Line at x, m', figure('across', -6, 6, 0.1, 5))] : [field('Part of the field', select('order-half', [['whole', 'all of it'], ['negative', 'half at −x'], ['positive', 'half at +x']], order.half, choose('half')))]),
      field('First robot', text('first')), field('Second robot', text('second')),
      field('Seed', figure('seed', 0, 999999, 1, 6)),
      ...(order.field !== 'simulated' ? [...place, field('Referee', text('referee', 'none'))]
        : [field('Pace', select('order-pace', PACES, order.pace, value => { order.pace = value; }))]),
      el('button', {type: 'submit', id: 'play-start', class: 'strong'}, 'Start')));
  }

  const wanted = () => Object.assign({}, order, {pace: Number(order.pace)});

  /** Asks for the drawing of what is ordered; the last wish counts. */
  async function ask() {
    const mine = ++planning;
    try {
      const answer = await act('play/plan', wanted());
      if (mine !== planning) return;
      plan = answer;
      planFailure = null;
    } catch (failure) {
      if (mine !== planning) return;
      plan = null;
      planFailure = failure.message;
    }
    shape = '';
    showStatus();
  }

  async function start() {
    if (!planFailure) await app.run('play', wanted());
  }

  /** What the diagnosis would like to have. */
  function showNext() {
    const wishes = (app.state.diagnosis.next || []);
    renew($('next-kicks'), [wishes, play().running], () => (wishes.length === 0 ? [] : [el('p', {class: 'note'}, 'The diagnosis asks for:'), el('div', {class: 'choices'}, wishes.map(w => button(w.kicks + ' ' + (w.kind === 'chip' ? 'chips' : 'flat kicks') + ' of ' + w.slowest + ' to ' + w.fastest + ' m/s', () => take(w), {title: w.why, disabled: play().running})))]));
  }

  /** A wish of the diagnosis becomes the order; while it is played, the kicks are chosen that tell the causes apart. */
  function take(wish) {
    Object.assign(order, {kind: wish.kind, kicks: wish.kicks, slowest: wish.slowest, fastest: wish.fastest, choice: 'adaptive'});
    built = '';
    buildForm();
    ask();
  }
  page.take = take;

  // ---- while it runs ----

  function showWords() {
    const word = what => () => app.run('play/word', {word: what});
    const pausing = Boolean(status() && status().paused);
    renew($('play-words'), [play().running, pausing], () => (play().running ? [
      pausing ? button('▶ Resume', word('resume'), {id: 'play-resume', key: 'p', strong: true}) : button('❙❙ Pause', word('pause'), {id: 'play-pause', key: 'p', strong: true}),
      button('■ Abort …', abort, {id: 'play-abort'})] : []));
  }

  function showStatus() {
    const now = status();
    showWords();
    const rows = [];
    if (play().failure) rows.push(el('p', {class: 'notice bad'}, play().failure));
    if (planFailure && !play().running) rows.push(el('p', {class: 'notice warn', id: 'plan-failure'}, planFailure));
    if (now) {
      rows.push(el('p', {id: 'play-line'}, el('b', {}, now.good + ' of ' + now.wanted + ' kicks'), ', ' + now.made + ' made' + (now.unjudged ? ', ' + now.unjudged + ' being fitted' : '') + ' · ' + number(now.time, 0) + ' s'), el('progress', {max: now.wanted, value: now.good}));
      rows.push(el('p', {id: 'play-phase'}, now.paused ? badge('warn', '❙❙ paused') : badge(now.over ? (now.good >= now.wanted ? 'good' : 'warn') : 'good', now.phase), now.nextSpeed && !now.over ? ' next: ' + number(now.nextSpeed, 1) + ' m/s' : ''));
      if (now.waiting) rows.push(el('p', {class: 'notice warn', id: 'play-waiting'}, now.waiting));
      if (now.complaints.length) rows.push(el('div', {class: 'note', id: 'play-complaints'}, now.complaints.map(c => el('p', {}, '⚠ ' + c))));
      if (now.model.length) rows.push(table([['So far', true], ['Mean ± s.e.'], ['n']], now.model.map(m => el('tr', {}, el('td', {class: 'text wrap'}, m.words), el('td', {class: 'big'}, withError(m.mean, m.error)), el('td', {}, m.n)))));
      if (now.over && !play().running) rows.push(el('p', {class: 'note'}, 'The recording is part of the session now: see ', el('a', {href: '#kicks'}, 'Kicks'), '.'));
    } else if (!play().running) rows.push(el('p', {class: 'note'}, 'Two robots kick the ball to each other until there are enough good kicks. Everything is recorded into the session.'));
    $('play-state').replaceChildren(...rows);
    showField(false);
    showKicks();
  }

  async function abort() {
    if (await confirmed('Abort the play?', [el('p', {}, 'Both robots stop. The recording stays in the session.')], 'Abort')) app.run('play/word', {word: 'abort'});
  }

  function showKicks() {
    const kicks = status() ? [...status().kicks].reverse() : [];
    const verdict = k => k.good === null ? badge('warn', '…') : k.good ? badge('good', '✔') : badge('bad', '✘');
    const rows = kicks.map(k => el('tr', {}, el('td', {}, k.number), el('td', {class: 'text'}, verdict(k)), el('td', {class: 'text'}, k.robot), el('td', {}, number(k.wanted, 1)), el('td', {}, number(k.speed, 2)), el('td', {}, number(k.rmsMm, 1)), el('td', {class: 'text'}, k.end),
      el('td', {class: 'text wrap'}, k.good === false ? k.reason : k.says.join(', '))));
    content('play-kicks').replaceChildren(rows.length ? table([['#'], ['', true], ['Robot', true], ['Commanded, m/s'], ['Measured, m/s'], ['rms, mm', false, 'Residual per axis'], ['End', true], ['Determines', true]], rows) : el('p', {class: 'empty'}, 'None yet.'));
  }

  // ---- the field ----

  function showField(anew) {
    const box = $('play-field').querySelector('.chart');
    const now = live() || (status() && !plan ? status() : null);
    const geometry = (now && now.field) || (plan && plan.field);
    $('play-legend').replaceChildren(el('span', {}, swatch('circle', '#c9a400'), 'yellow'), el('span', {}, swatch('circle', theme.accent), 'blue'), el('span', {}, swatch('circle', '#e8641b'), 'ball'),
      el('span', {}, swatch('dashes', theme.text), 'kicks along'), el('span', {}, swatch('cross', theme.bad), 'place the ball here'), el('span', {}, swatch('circle', theme.bad, true), 'what the play waits for'));
    if (!geometry || box.clientWidth === 0) return;
    const wantedShape = JSON.stringify([geometry, plan && plan.lines, box.clientWidth, box.clientHeight, document.documentElement.dataset.theme]);
    if (anew || shape !== wantedShape) {
      shape = wantedShape;
      draw(box, stage(geometry, {width: box.clientWidth, height: box.clientHeight}));
    }
    charts.get(box).setOption({series: moving(now)});
  }

  function stage(geometry, size) {
    const option = fieldView(theme, geometry, extent(geometry, [], []), size);
    option.tooltip.show = false;
    const lines = plan ? plan.lines : [];
    const counts = lines.map((line, i) => plan.kicks.filter(kick => kick.line === i));
    option.series.push(...lines.map((line, i) => ({
      type: 'line', silent: true, symbol: 'none', z: 2, lineStyle: {color: theme.text, width: 2, type: 'dashed', opacity: 0.55}, data: [[line[0], line[1]], [line[2], line[3]]],
      markPoint: {silent: true, symbol: 'circle', symbolSize: 1, label: {show: true, color: theme.text, fontSize: 13, fontWeight: 600, formatter: counts[i].length + ' kicks', textBorderColor: theme.field, textBorderWidth: 3}, data: [{coord: [line[0] + 0.25 * (line[2] - line[0]), line[1] + 0.25 * (line[3] - line[1])]}]},
    })));
    for (const id of ['yellow', 'blue', 'fronts', 'ball', 'wanted', 'waiting', 'way']) {
      const isLine = id === 'fronts' || id === 'way';
      option.series.push({id, type: isLine ? 'line' : 'scatter', silent: true, data: [], symbol: isLine ? 'none' : undefined, z: id === 'waiting' ? 8 : 5});
    }
    return option;
  }

  function moving(now) {
    const robots = now ? now.robots : [];
    const chart = charts.get($('play-field').querySelector('.chart'));
    // A robot is 18 cm wide; smaller ones could not be seen on a small drawing.
    const metre = Math.abs(chart.convertToPixel({xAxisIndex: 0}, 1) - chart.convertToPixel({xAxisIndex: 0}, 0)) || 50;
    const size = Math.max(15, 0.18 * metre);
    const dot = (robot, colour) => ({value: [robot.x, robot.y], symbolSize: size, itemStyle: {color: colour, opacity: robot.unseen > 1 ? 0.3 : robot.plays ? 1 : 0.55, borderColor: theme.text, borderWidth: robot.plays ? 2 : 0}, label: {show: true, formatter: String(robot.number), color: robot.plays ? '#000' : theme.text, fontSize: 12, fontWeight: 700}});
    const of = (team, colour) => robots.filter(robot => robot.team === team).map(robot => dot(robot, colour));
    const reach = 0.14;
    return [
      {id: 'yellow', data: of('yellow', '#f2cc0c')}, {id: 'blue', data: of('blue', '#6cb2ff')},
      {id: 'fronts', data: robots.flatMap(r => [[r.x, r.y], [r.x + reach * Math.cos(r.orientation), r.y + reach * Math.sin(r.orientation)], [null, null]]), lineStyle: {color: theme.text, width: 2}},
      {id: 'ball', data: now && now.ball ? [{value: [now.ball.x, now.ball.y], symbolSize: 11, itemStyle: {color: '#e8641b', opacity: now.ball.unseen > 1 ? 0.3 : 1, borderColor: theme.text, borderWidth: 1}}] : []},
      ...waitedFor(now, robots, size),
      {id: 'wanted', data: now && now.ballWanted ? [{value: now.ballWanted, symbol: 'path://M-5,-5L5,5M-5,5L5,-5', symbolSize: 18, itemStyle: {color: 'transparent', borderColor: theme.bad, borderWidth: 3}}] : []},
    ];
  }

  /** The robot that the play waits for, its place, and the way there; beside it, why. */
  function waitedFor(now, robots, size) {
    const about = now && now.waiting && now.waitingFor || {};
    const robot = robots.find(r => r.team === about.team && r.number === about.number), place = known(about.x) ? [about.x, about.y] : null;
    const spot = robot ? [robot.x, robot.y] : place, ring = {color: 'transparent', borderColor: theme.bad, borderWidth: 3};
    if (!spot) return [{id: 'waiting', data: []}, {id: 'way', data: []}];
    const {length} = now.field || plan.field, words = {show: true, formatter: now.waiting, color: theme.bad, fontSize: 14, fontWeight: 700, textBorderColor: theme.field, textBorderWidth: 3, width: 230, overflow: 'break'};
    // Beside the ring, on the side where there is more room.
    Object.assign(words, {position: spot[0] > length / 6 ? 'left' : spot[0] < -length / 6 ? 'right' : 'top', distance: 8});
    const apart = robot && place && Math.hypot(place[0] - robot.x, place[1] - robot.y) > 0.05;
    return [
      {id: 'waiting', data: [{value: spot, symbol: 'circle', symbolSize: size + 16, itemStyle: ring, label: words}, ...(apart ? [{value: place, symbol: 'circle', symbolSize: size + 6, itemStyle: Object.assign({}, ring, {borderType: 'dashed'})}] : [])]},
      {id: 'way', data: apart ? [[robot.x, robot.y], place] : [], lineStyle: {color: theme.bad, width: 2, type: 'dashed'}}];
  }

  page.keys = {p: () => { const node = $('play-resume') || $('play-pause'); if (node) node.click(); }};
  return page;
}
