/* The diagnosis report's page: puts the view model into words, pictures and tables, and keeps one kick and one variable selected. */
(() => {
  'use strict';
  const {el, known, number, signed, withError} = Charts;
  const {$, content, draw, forget, figure, choices, badge, swatch} = Frame;
  const report = JSON.parse(document.getElementById('data').textContent);
  const found = report.causes.length + report.learned.length > 0;
  // When nothing was found both models are the same, and one picture is enough.
  const sides = found ? ['before', 'after'] : ['before'];
  const noise = report.before.noiseMm;
  const gainOf = kick => kick.rmsBeforeMm - kick.rmsAfterMm;
  const MAP_HINTS = {
    model_adequate: 'Short arrows that point in all directions: this is what noise looks like. A camera that is off would turn all arrows of its colour the same way, a slope all arrows of the field.',
    unexplained_structure: 'Look for arrows that have something in common: one colour (a camera), one part of the field (carpet, lines, edges of the views), towards or away from one point.',
  };
  const WORST = 6, CANDIDATES = 10;
  const state = {variable: report.shown, kick: null, all: false};
  let theme;

  const sideName = side => found ? (side === 'before' ? 'before: calibrated model' : 'after: extended model') : 'calibrated model';
  const sideSwatches = (...more) => found
    ? [el('span', {}, swatch('circle', theme.warn, true), 'before: calibrated model'), el('span', {}, swatch('circle', theme.accent), 'after: extended model'), ...more]
    : [el('span', {}, swatch('circle', theme.accent), 'calibrated model'), ...more];
  const cameraSwatches = () => report.cameras.map(id => el('span', {}, swatch(theme.camera(id).symbol, theme.camera(id).colour), 'camera ' + id));

  // ---- words ----

  function showVerdict() {
    const box = $('verdict');
    const {id, headline, verdict, lines} = report.verdict;
    const mark = {model_adequate: '✔ ', explained: '⚠ ', partly_explained: '◐ ', unexplained_structure: '? '}[id] || '';
    box.className = id;
    box.replaceChildren(el('p', {class: 'headline'}, mark + headline), el('p', {class: 'came'}, verdict), ...lines.map(line => el('p', {}, line)));
  }

  function fact(label, value) {
    return el('div', {}, el('span', {}, label), el('span', {}, value));
  }

  function gainWords(cause) {
    if (!known(cause.gainMm)) return 'too few kicks to tell';
    const percent = known(cause.gainPercent) ? ' (' + number(cause.gainPercent, 0) + ' %)' : '';
    return number(cause.gainMm, 2) + ' mm' + percent;
  }

  const bounds = cause => known(cause.gainLowMm) && known(cause.gainHighMm) ? number(cause.gainLowMm, 2) + ' to ' + number(cause.gainHighMm, 2) + ' mm' : '–';

  function causeItem(cause, i) {
    const rivals = [cause.rivals, cause.kicksToRecord].filter(Boolean);
    return el('li', {},
      el('div', {class: 'rank', 'aria-hidden': 'true'}, String(i + 1)),
      el('div', {class: 'words'},
        el('p', {class: 'what'}, cause.what),
        cause.consequence ? el('p', {}, cause.consequence) : '',
        cause.advice ? el('p', {}, el('b', {}, 'To do: '), cause.advice) : '',
        rivals.length ? el('p', {class: 'rivals'}, rivals.join(' ')) : ''),
      el('div', {class: 'facts'},
        fact('Strength', cause.strength),
        fact('Gain, held-out kicks', gainWords(cause)),
        fact('95 % bounds', bounds(cause)),
        fact('Certainty', cause.certainty)));
  }

  function showCauses() {
    $('causes').hidden = report.causes.length === 0;
    content('causes').replaceChildren(...report.causes.map(causeItem));
  }

  // ---- what has no name ----

  function learnedItem(box, finding) {
    const item = el('article', {},
      el('p', {class: 'what'}, finding.what),
      finding.kind !== 'curve' || finding.curves.length === 1 ? el('p', {class: 'formula'}, {law: 'This law takes the place of a law of the calibrated model. Its numbers: ', unproven: 'Not proven to be a cause. Its size: ', scatter: 'How much: ', curve: 'Formula: '}[finding.kind] + finding.formula) : '',
      el('p', {}, 'Gain on held-out kicks: ', el('b', {}, gainWords(finding)), ', 95 % bounds ' + bounds(finding) + '.', finding.helps ? '' : ' They do not show that it helps.'),
      finding.advice ? el('p', {}, el('b', {}, 'To do: '), finding.advice) : '',
      el('div', {class: 'charts two'}));
    box.append(item);
    const pictures = item.querySelector('.charts');
    for (const curve of finding.curves) {
      const formula = finding.curves.length > 1 ? curve.formula : '';
      const title = curve.title.charAt(0).toUpperCase() + curve.title.slice(1) + (curve.unit ? ' [' + curve.unit + ']' : '');
      if (curve.axes.length > 1) pictures.append(el('figure', {}, el('figcaption', {}, title, el('span', {}, formula)), el('div', {class: 'scroll'}, DiagnosisPlots.table(curve))));
      else draw(figure(pictures, title, formula), DiagnosisPlots.curve(theme, curve));
    }
  }

  function showLearned() {
    $('learned').hidden = report.learned.length === 0;
    const box = content('learned');
    forget(box);
    const drawn = report.learned.flatMap(finding => finding.curves);
    $('learned-legend').replaceChildren(...(drawn.length ? [
      el('span', {}, 'What the calibrated model lacks, as learned from the kicks, over the range that they cover'),
      ...(drawn.some(curve => curve.axes.length === 1) ? [el('span', {}, swatch('line', theme.accent), 'the curve'), el('span', {}, swatch('band', theme.accent), '± 2 standard errors')] : []),
      ...(drawn.some(curve => curve.axes.length > 1) ? [el('span', {}, swatch('rect', theme.warn), 'more,'), el('span', {}, swatch('rect', theme.accent), 'less; a dot is within two standard errors of zero')] : [])] : []));
    const laws = report.learned.filter(finding => finding.kind === 'law');
    const helping = report.learned.filter(finding => finding.kind !== 'law' && finding.helps);
    const others = report.learned.filter(finding => finding.kind !== 'law' && !finding.helps);
    const titles = [
      ...(laws.length ? ['A law that replaces a law of the calibrated model'] : []),
      ...(helping.length ? ['What helps without a proven cause'] : [])];
    $('learned-title').textContent = titles.join('; ') || 'In the extended model, but held-out kicks do not show that it helps';
    [...laws, ...helping, ...others].forEach(finding => learnedItem(box, finding));
  }

  // ---- what the error depends on ----

  const profileOf = id => report.profiles.find(profile => profile.variable === id);

  function drawProfile(box, profile, which) {
    forget(box);
    if (!profile) {
      box.append(el('p', {class: 'empty'}, 'Too few observations.'));
      return;
    }
    const places = ['first', 'second'].map((column, i) => [column, figure(box, 'Mean residual ' + profile.axes[i], i === 0 ? 'seen minus predicted' : '')]);
    for (const [column, place] of places) draw(place, DiagnosisPlots.profile(theme, profile, column, which, noise));
  }

  function depends(bins) {
    if (bins.deviation > 1000) return 'more than 1000 σ';
    return known(bins.deviation) ? number(Math.max(0, bins.deviation), bins.deviation < 10 ? 1 : 0) + ' σ' : '–';
  }

  function showProfiles() {
    $('profiles').hidden = report.profiles.length === 0;
    const profile = profileOf(state.variable);
    choices('profile-variable', report.profiles.map(p => [p.variable, p.label]), state.variable, variable => { state.variable = variable; showProfiles(); });
    $('profile-legend').replaceChildren(...sideSwatches(el('span', {}, swatch('line', theme.muted), 'bars: what noise can do (± 2 standard errors)')));
    drawProfile(content('profiles'), profile, sides);
    $('profile-note').textContent = !profile ? '' : 'Above noise: ' + depends(profile.before) + (found ? ' before, ' + depends(profile.after) + ' after' : '') + '. A model that is right leaves points on the zero line whatever the variable.';
  }

  // ---- kicks ----

  function worst() {
    const size = found ? gainOf : kick => kick.rmsBeforeMm;
    return report.kicks.filter(kick => known(size(kick))).sort((a, b) => size(b) - size(a)).slice(0, WORST);
  }

  function showKickByKick() {
    const box = content('kicks');
    forget(box);
    $('kicks-legend').replaceChildren(...sideSwatches(el('span', {}, swatch('line', theme.good), "the cameras' noise"), el('span', {}, 'each kick predicted by a model that was fitted without it; click for its pictures')));
    const place = figure(box, 'Residual of each kick', 'held out, per axis', 'chart low');
    place.id = 'kick-by-kick';
    drawKickByKick();
  }

  function drawKickByKick() {
    draw($('kick-by-kick'), DiagnosisPlots.kickByKick(theme, report.kicks, sides, noise, state.kick && state.kick.id), event => event.data && event.data.kick && select(event.data.kick));
  }

  function select(id) {
    const kick = report.kicks.find(k => k.id === id);
    if (!kick || kick === state.kick) return;
    state.kick = kick;
    try { history.replaceState(null, '', '#kick=' + id); } catch (refused) { /* some browsers refuse this for files */ }
    drawKickByKick();
    showKick();
  }

  function step(by) {
    const i = report.kicks.indexOf(state.kick) + by;
    if (report.kicks[i]) select(report.kicks[i].id);
  }

  function showKick() {
    const kick = state.kick;
    const i = report.kicks.indexOf(kick);
    $('previous').disabled = i <= 0;
    $('next').disabled = i >= report.kicks.length - 1;
    $('kick-title').textContent = 'Kick ' + kick.id + ' — ' + kick.kind + ', ' + number(kick.speed, 1) + ' m/s towards ' + number(kick.direction, 0) + '°' + (kick.robot ? ', by ' + kick.robot : '')
      + (known(kick.rmsBeforeMm) ? ': ' + number(kick.rmsBeforeMm, 1) + (found ? ' → ' + number(kick.rmsAfterMm, 1) : '') + ' mm' : '');
    $('kick-title').title = [kick.source, known(kick.unix) ? new Date(kick.unix * 1000).toISOString().slice(11, 23) + ' UTC' : '', kick.observations + ' observations, ' + kick.rejected + ' put aside'].filter(Boolean).join(', ');
    choices('kick-worst', worst().map(k => [k.id, 'kick ' + k.id]), kick.id, select);
    $('kick-worst').prepend(el('span', {class: 'note'}, found ? 'largest gains:' : 'worst:'));
    const factor = DiagnosisPlots.magnification(DiagnosisPlots.deviations(kick));
    $('kick-legend').replaceChildren(...cameraSwatches(), el('span', {}, swatch('line', theme.text), 'predicted path'), el('span', {}, swatch('circle', theme.text, true), 'where the ball should be every half second'), el('span', {}, swatch('line', theme.bad), 'and from there to where it is seen'), el('span', {}, 'on the field, deviations are drawn ' + factor + ' times larger'), el('span', {}, swatch('band', theme.good), 'noise ± 2σ'));
    const box = $('kick-charts');
    forget(box);
    const places = [
      ...sides.map(side => [figure(box, 'Path', sideName(side), 'chart field'), place => DiagnosisPlots.path(theme, kick, side, report.field, factor, {width: place.clientWidth, height: place.clientHeight})]),
      ...['Along', 'Across'].flatMap(direction => sides.map(side => [
        figure(box, direction + ' the path', direction === 'Along' ? '+ is farther than predicted' : '+ is to the left', 'chart low'), () => DiagnosisPlots.residual(theme, kick, side, direction, noise)])),
    ];
    if (!found) places[0][0].parentNode.classList.add('beside');
    // Drawn when all are there: their number decides how wide each is.
    for (const [place, option] of places) draw(place, option(place));
  }

  // ---- field, gain, candidates ----

  function showMap() {
    $('map').hidden = report.map.x.length === 0;
    if (report.map.x.length === 0) return;
    const factor = DiagnosisPlots.mapFactor(report.map);
    const box = content('map');
    forget(box);
    $('map-legend').replaceChildren(...cameraSwatches(), el('span', {}, 'arrows go from where the ball should be to where it is seen, ' + factor + ' times longer: one metre on the field is ' + number(1000 / factor, 0) + ' mm'));
    const places = sides.map(side => [side, figure(box, 'Mean residual', sideName(side), 'chart field')]);
    if (!found) box.append(el('p', {class: 'hint'}, MAP_HINTS[report.verdict.id] || ''));
    for (const [side, place] of places) draw(place, DiagnosisPlots.map(theme, report.map, side, report.field, factor, {width: place.clientWidth, height: place.clientHeight}));
  }

  function showGain() {
    const box = content('gain');
    forget(box);
    $('gain-title').textContent = found ? 'What it gains' : 'How well the model predicts';
    const rows = [['rms', 'Residual in the fit', 'rmsMm'], ['holdout', 'Residual of held-out kicks', 'holdoutRmsMm']];
    box.append(el('table', {},
      el('thead', {}, el('tr', {}, el('th', {class: 'text'}, 'mm, per axis'), sides.map(side => el('th', {}, side === 'before' && !found ? '' : side)))),
      el('tbody', {}, rows.map(([, label, key]) => el('tr', {}, el('td', {class: 'text'}, label), sides.map(side => el('td', {class: 'big'}, number(report[side][key], 2))))),
        el('tr', {}, el('td', {class: 'text'}, "The cameras' noise"), sides.map(side => el('td', {}, number(report[side].noiseMm, 2)))))),
      report.cameras.length > 1 ? el('p', {class: 'note'}, 'The calibrated model is the ball model alone. The residuals that calibrate shows can be smaller, because it takes out the offsets of the cameras.') : null);
    if (report.before.horizons.length === 0) {
      box.append(el('p', {class: 'empty'}, 'No kick is long enough to predict ahead.'));
      return;
    }
    const place = figure(box, 'Prediction error', 'held-out kicks, typical distance');
    draw(place, DiagnosisPlots.horizons(theme, sides.map(side => ({side, name: sideName(side), quality: report[side]}))));
    box.append(el('p', {class: 'legend'}, sideSwatches()));
  }

  /** What a candidate explains alone, as a share of what the best one does. */
  function showCandidates() {
    const best = Math.max(...report.candidates.map(c => c.scoreGain).filter(known), 0);
    const share = c => best > 0 && known(c.scoreGain) ? Math.max(0, 100 * c.scoreGain / best) : 0;
    const words = percent => percent >= 9.5 ? number(percent, 0) + ' %' : percent >= 0.1 ? number(percent, 1) + ' %' : 'nothing';
    const shown = state.all ? report.candidates : report.candidates.filter((c, i) => c.named || i < CANDIDATES);
    const rows = shown.map(c => el('tr', {class: c.named ? 'named' : null},
      el('td', {class: 'text wrap'}, c.name, ' ', el('small', {}, c.strength)),
      el('td', {class: 'evidence'}, share(c) > 0 ? el('i', {style: 'width: ' + share(c).toFixed(1) + '%'}) : ''),
      el('td', {}, words(share(c))),
      el('td', {class: 'text'}, c.named ? badge('warn', '✔ cause') : '')));
    const head = ['Possible cause', 'Explains alone', 'of the best', ''];
    content('candidates').replaceChildren(el('div', {class: 'scroll'}, Frame.cards(el('table', {}, el('thead', {}, el('tr', {}, head.map((h, i) => el('th', {scope: 'col', class: i < 2 ? 'text' : null}, h)))), el('tbody', {}, rows)))),
      el('p', {class: 'note'}, 'How much of the misfit each would explain if it were the only cause, and how strong it would then be. Similar causes explain the same error. A cause is named only if it improves held-out kicks beyond all others.'));
    const more = report.candidates.length - CANDIDATES;
    if (more > 0) choices('candidates-shown', [[false, 'best ' + CANDIDATES], [true, 'all ' + report.candidates.length]], state.all, all => { state.all = all; showCandidates(); });
  }

  function showRemains() {
    const {significant, systematicMm, deviation, words, dependsOn, shown} = report.remains;
    const text = significant
      ? words.charAt(0).toUpperCase() + words.slice(1) + ' (' + number(deviation, 1) + ' standard deviations of noise.)'
      : 'Nothing but noise is left (systematic part: ' + number(systematicMm, 2) + ' mm).';
    $('remains').querySelector('.text').textContent = text;
    // Where nothing was found, the first picture of the page is already of the strongest variable.
    const profile = profileOf(found ? shown : dependsOn.find(variable => variable !== report.shown));
    if (profile) drawProfile(content('remains'), profile, [found ? 'after' : 'before']);
    else forget(content('remains'));
  }

  // ---- tables ----

  function showCauseTable() {
    const box = content('cause-table');
    $('cause-table').hidden = report.causes.length === 0;
    const rows = report.causes.flatMap(cause => [
      el('tr', {class: 'group'}, el('th', {colspan: 3}, cause.name, ' ', el('small', {}, cause.id + ' · ' + cause.certainty + ' · gain ' + gainWords(cause) + ', ' + bounds(cause)))),
      ...cause.parameters.map(p => el('tr', {}, el('td', {class: 'text'}, p.name), el('td', {class: known(p.error) ? 'big' : null}, known(p.error) ? withError(p.value, p.error) : Charts.number(p.value, Number.isInteger(p.value) ? 0 : 3)), el('td', {class: 'text'}, p.unit === 'rad' ? 'rad = ' + number(p.value * 180 / Math.PI, 1) + '°' : p.unit))),
    ]);
    box.replaceChildren(el('table', {}, el('thead', {}, el('tr', {}, el('th', {class: 'text'}, 'Parameter'), el('th', {}, 'Value ± s.e.'), el('th', {class: 'text'}, 'Unit'))), el('tbody', {}, rows)));
  }

  function showParameters() {
    const rows = ['flat', 'chip'].flatMap(kind => {
      const its = report.parameters.filter(p => p.kind === kind);
      return its.length === 0 ? [] : [el('tr', {class: 'group'}, el('th', {colspan: 4}, kind === 'flat' ? 'Flat' : 'Chip')), ...its.map(p => el('tr', {},
        el('td', {class: 'text wrap'}, p.name, p.unit ? el('small', {}, ' ' + p.unit) : ''), el('td', {}, number(p.before, 4)), ...(found ? [el('td', {class: 'big'}, number(p.after, 4)), el('td', {}, signed(p.after - p.before, 4))] : [])))];
    });
    const head = ['Parameter', found ? 'before' : 'Value', ...(found ? ['after', 'change'] : [])];
    content('parameters').replaceChildren(el('div', {class: 'scroll'}, Frame.cards(el('table', {}, el('thead', {}, el('tr', {}, head.map((h, i) => el('th', {scope: 'col', class: i ? null : 'text'}, h)))), el('tbody', {}, rows)))),
      el('p', {class: 'note'}, 'Fitted to all kicks together' + (found ? '. The parameters of the calibrated model also make up for what it leaves out; in the extended model they are those of ball and carpet alone.' : '.')));
  }

  // ---- the whole page ----

  function showAll() {
    Frame.showProvenance(report.provenance, 'j and k go to the next and the previous kick');
    showVerdict();
    showCauses();
    showLearned();
    showProfiles();
    $('kicks').hidden = report.kicks.length === 0;
    if (report.kicks.length > 0) {
      showKickByKick();
      showKick();
    }
    showMap();
    showCandidates();
    showGain();
    showRemains();
    showCauseTable();
    showParameters();
    Frame.showProblems(report.problems);
  }

  const asked = () => Number((/^#kick=(\d+)$/.exec(location.hash) || [])[1]);
  state.kick = report.kicks.find(k => k.id === asked()) || worst()[0] || report.kicks[0] || null;
  $('previous').addEventListener('click', () => step(-1));
  $('next').addEventListener('click', () => step(1));
  window.addEventListener('hashchange', () => select(asked()));
  Frame.start(report.cameras, {
    use: colours => { theme = colours; },
    showAll,
    resized: () => { if (state.kick) showKick(); showMap(); },
    keys: {j: () => step(1), k: () => step(-1)},
  });
})();
