/*
 * The parts of a calibration that a page shows as tables and words, and the pictures of one kick: each function turns the view model
 * (CalibrationReport as JSON) into nodes. They know no page, so that the report and the console share them.
 */
const CalibrationViews = (() => {
  'use strict';
  const {el, known, number, signed, withError} = Charts;
  const {draw, forget, figure, badge, swatch} = Frame;
  const KINDS = {FLAT: 'flat', CHIP: 'chip'};
  /** How each decision looks: the level of its colours, and its mark. */
  const DECISIONS = {publish: ['good', '✔'], record_more: ['warn', '⚠'], check_first: ['warn', '⚠'], do_not_publish: ['bad', '✘']};

  // ---- verdict, model, cameras ----

  /** The verdict in one line, its reasons, and what else to know before publishing. */
  function verdict(box, words, warnings) {
    const [level, mark] = DECISIONS[words.decision];
    box.className = level;
    box.replaceChildren(
      Frame.copyButton(() => inWords(words, warnings), 'the verdict'),
      el('p', {class: 'decision'}, el('b', {class: 'action'}, mark + ' ' + words.title[0].toUpperCase() + words.title.slice(1)), words.toDo.join(' ')),
      ...words.reasons.map(reason => el('p', {class: 'reason'}, reason)),
      ...words.notes.map(note => el('p', {class: 'note'}, note)));
    if (warnings.length) box.append(el('ul', {}, warnings.map(warning => el('li', {}, warning))));
  }

  /** The same as text. */
  const inWords = (words, warnings) => ['Verdict: ' + words.title + '. ' + words.toDo.join(' '), ...words.reasons, ...words.notes, ...warnings].join('\n') + '\n';

  /** The decision as a badge, for a line that has no room for more. */
  function decisionBadge(words) {
    const [level, mark] = DECISIONS[words.decision];
    return badge(level, mark + ' ' + words.title);
  }

  /** A model that is farther off is wrong for passes; within the errors nobody knows whether it is. */
  const LARGE_PERCENT = 10;

  /** As VerdictRule has it: a smaller difference is not worth a change. */
  const NOTABLE_PERCENT = 3;

  /** What the marks of differences mean, where there is little room. */
  const MARKS = ['≈ less than ' + NOTABLE_PERCENT + ' % or 3 s.e.', '▲ ▼ larger, smaller than published'];

  function difference(parameter) {
    const percent = parameter.differencePercent;
    if (!known(percent)) return '–';
    const text = signed(percent, Math.abs(percent) < 9.95 ? 1 : 0) + ' %';
    // A large difference that is within the errors is no agreement either.
    if (!parameter.differs) return Object.assign(badge(Math.abs(percent) < LARGE_PERCENT ? 'good' : 'open', '≈ ' + text), {title: Math.abs(percent) < NOTABLE_PERCENT ? 'less than ' + NOTABLE_PERCENT + ' %' : 'within three standard errors'});
    return badge(Math.abs(percent) >= 20 ? 'bad' : 'warn', (percent > 0 ? '▲ ' : '▼ ') + text);
  }

  function modelRow(parameter) {
    const digits = Charts.decimals(parameter.standardError);
    return el('tr', {},
      el('td', {class: 'text wrap'}, parameter.words, parameter.unit ? el('small', {}, ' ' + parameter.unit) : ''),
      el('td', {class: 'big', 'data-label': 'mean', title: known(parameter.sigma) ? 'scatter between the kicks beyond their own errors: ' + number(parameter.sigma, digits) : null}, withError(parameter.mean, parameter.standardError)),
      el('td', {'data-label': 'n'}, parameter.n),
      el('td', {'data-label': 'joint fit'}, withError(parameter.joint, parameter.jointStandardError)),
      el('td', {'data-label': 'published'}, Plots.asPublished(parameter.published)),
      el('td', {'data-label': 'difference', title: parameter.note || null}, difference(parameter)));
  }

  /** The same for a spreadsheet: values between tabulators, SI units. */
  function modelAsText(report) {
    const rows = report.models.flatMap(model => model.parameters.map(p => [Plots.inFiles(p.name), p.unit, p.mean, p.standardError, p.n, p.joint, p.jointStandardError, p.published]));
    return [['parameter', 'unit', 'mean', 'standard_error', 'n', 'joint', 'joint_standard_error', 'published'], ...rows].map(row => row.map(value => known(value) || value ? value : '').join('\t')).join('\n') + '\n';
  }

  /** The models with their errors beside what is published. */
  function model(report) {
    if (report.models.length === 0) {
      return [el('p', {class: 'empty'}, 'No model: no kick could be used.')];
    }
    const body = report.models.flatMap(model => {
      const kicks = report.kicks.filter(k => k.kind === model.kind);
      const used = kicks.filter(k => k.selected).length;
      const group = (model.kind === 'FLAT' ? 'Flat' : 'Chip') + ' — ' + used + ' of ' + kicks.length + (kicks.length === 1 ? ' kick' : ' kicks') + ' used';
      return [el('tr', {class: 'group'}, el('th', {colspan: 6}, el('span', {}, group))), ...model.parameters.map(modelRow)];
    });
    const head = ['Parameter', 'Mean ± s.e.', 'n', 'Joint fit', 'Published', 'Difference'];
    return [
      Frame.copyButton(() => modelAsText(report), 'the table, for a spreadsheet'),
      el('div', {class: 'scroll'}, el('table', {}, el('thead', {}, el('tr', {}, head.map((h, i) => el('th', {scope: 'col', class: i ? null : 'text'}, h)))), el('tbody', {}, body))),
      el('p', {class: 'note'}, ['n: kicks whose value is in the mean.', ...report.models.filter(model => known(model.jointRmsMm)).map(model => 'Joint fit of the ' + (model.kind === 'FLAT' ? 'flat kicks' : 'chips') + ': ' + number(model.jointRmsMm, 2) + ' mm rms per axis, with values of its own for each kick.')].join(' ')),
      ...report.models.flatMap(model => [model.note, ...model.parameters.filter(p => p.note).map(p => Plots.inFiles(p.name) + ': ' + p.note)]).filter(Boolean).map(note => el('p', {class: 'note'}, note)),
      ...(report.models.some(model => model.parameters.some(p => known(p.differencePercent))) ? [el('p', {class: 'note'}, 'Difference: the mean against the published value. ≈: less than ' + NOTABLE_PERCENT + ' %, or less than three standard errors. Grey: ' + LARGE_PERCENT + ' % or more, but less than three standard errors; more kicks would show which is right. ▲ larger, ▼ smaller in size. Red: 20 % or more.')] : [])];
  }

  /** What an offset means, in words; nothing is said of one that is within its error or too small to matter. */
  function offsetWords(camera) {
    if (!known(camera.offsetXMm) && !known(camera.offsetYMm)) return 'offset not determined';
    const parts = [['x', camera.offsetXMm, camera.offsetXErrorMm], ['y', camera.offsetYMm, camera.offsetYErrorMm]]
      .filter(([, offset, error]) => Math.abs(offset) >= 2 && !(Math.abs(offset) < 3 * error))
      .map(([name, offset]) => number(Math.abs(offset), 0) + ' mm too far towards ' + (offset > 0 ? '+' : '−') + name);
    return parts.length ? 'reports ' + parts.join(' and ') : 'agrees with the others';
  }

  /** Noise, rate and offset of each camera. */
  function cameras(theme, report) {
    if (report.cameras.length === 0) {
      return el('p', {class: 'empty'}, 'No camera saw a kick.');
    }
    const rows = report.cameras.flatMap(camera => {
      const style = theme.camera(camera.id);
      const apart = offsetWords(camera);
      return [
        el('tr', {},
          el('td', {class: 'text'}, swatch(style.symbol, style.colour), ' ' + camera.id),
          el('td', {}, number(camera.noiseMm, 1)), el('td', {}, number(camera.rateHz, 1)), 
          el('td', {}, withError(camera.offsetXMm, camera.offsetXErrorMm)), el('td', {}, withError(camera.offsetYMm, camera.offsetYErrorMm))),
        el('tr', {}, el('td', {class: 'text wrap', colspan: 5}, el('div', {class: 'fits'}, badge(apart.startsWith('reports') ? 'warn' : 'good', 'camera ' + camera.id + ' ' + apart), ' ' + camera.observations + ' observations' + (camera.note ? '; ' + camera.note : '')))),
      ];
    });
    const head = [['', ''], ['Noise', 'mm'], ['Rate', 'Hz'], ['Offset x', 'mm'], ['Offset y', 'mm']];
    return el('div', {class: 'scroll'}, el('table', {}, el('thead', {}, el('tr', {}, head.map(([h, unit]) => el('th', {scope: 'col'}, h, ' ', el('small', {}, unit))))), el('tbody', {}, rows)));
  }

  // ---- the parameters over the kicks ----

  function parameterLegend(theme) {
    return [
      el('span', {}, swatch('circle', theme.accent), 'kick ± s.e.'), el('span', {}, swatch('circle', theme.bad, true), 'excluded'),
      el('span', {}, swatch('cross', theme.muted), 'undetermined'), el('span', {}, swatch('triangle', theme.muted, true), 'off the plot'),
      el('span', {}, swatch('line', theme.good), 'mean'), el('span', {}, swatch('band', theme.good), '± 2σ of a typical kick'), el('span', {}, swatch('dashes', theme.text), 'published (at an edge: beyond it)')];
  }

  // ---- kicks ----

  const droppedValues = kick => kick.parameters.filter(p => known(p.value) && p.dropped);

  /** How many of a kick's values are averaged. */
  function usedBadge(kick) {
    const known = kick.parameters.filter(p => Charts.known(p.value)), used = known.filter(p => Plots.isUsed(kick, p));
    if (!kick.selected) return badge('bad', '✘');
    return used.length === known.length ? badge('good', '✔') : badge('warn', used.length + '/' + known.length);
  }

  /** Why a kick, or some of its values, are not part of the model; empty when all are. */
  function whyDropped(kick) {
    return kick.selected ? droppedValues(kick).map(p => p.dropped).join('; ') : kick.rejectedBecause || 'dropped';
  }

  /** The columns of a table of kicks. */
  const COLUMNS = [
    {key: 'id', label: '#', of: k => k.id, text: k => k.id},
    {key: 'kind', label: 'Kind', of: k => k.kind, text: k => (k.kind === 'FLAT' ? '▬ ' : '⌒ ') + KINDS[k.kind], left: true},
    {key: 'speed', label: 'Speed, m/s', title: 'Kick speed', of: Plots.kickSpeed, text: k => number(Plots.kickSpeed(k), 2)},
    {key: 'robot', label: 'Robot', of: Plots.robotName, text: k => Plots.robotName(k), left: true},
    {key: 'end', label: 'End', of: k => Plots.endWords(k.end), text: k => Plots.endWords(k.end), left: true},
    {key: 'rms', label: 'rms, mm', title: 'Residual per axis', of: k => known(k.rmsMm) ? k.rmsMm : Infinity, text: k => number(k.rmsMm, 1)},
    {key: 'used', label: 'Used', title: 'Values that are averaged', of: k => k.selected ? droppedValues(k).length : 99, text: usedBadge, left: true},
  ];
  const FILTERS = {all: () => true, flat: k => k.kind === 'FLAT', chip: k => k.kind === 'CHIP', excluded: k => !k.selected || droppedValues(k).length > 0};

  /** The same kicks in the order of a column; state tells which, and whether downwards. */
  function sorted(kicks, sort) {
    const column = COLUMNS.find(c => c.key === sort.key);
    const compare = (a, b) => {
      const x = column.of(a), y = column.of(b);
      return (x < y ? -1 : x > y ? 1 : 0) * (sort.down ? -1 : 1) || a.id - b.id;
    };
    return [...kicks].sort(compare);
  }

  // ---- one kick ----

  function kickParameterRow(report, kick, parameter) {
    const model = report.models.find(m => m.kind === kick.kind);
    const mean = model && model.parameters.find(p => p.name === parameter.name);
    // One kick is its own mean.
    const sigmas = mean && mean.n > 1 && known(parameter.value) ? Plots.sigmas(mean, parameter) : NaN;
    const name = el('td', {class: 'text name'}, mean ? mean.words : Plots.inFiles(parameter.name));
    if (!known(parameter.value)) {
      return el('tr', {}, name, el('td', {class: 'text wrap', colspan: 2}, 'undetermined: ' + (parameter.undetermined || 'no reason given')));
    }
    return el('tr', {}, name, el('td', {}, withError(parameter.value, parameter.standardError, mean ? mean.unit : '')),
      el('td', {}, known(sigmas) ? el('span', {title: parameter.dropped || null}, badge(parameter.dropped ? 'bad' : Math.abs(sigmas) > 2 ? 'warn' : 'good', (parameter.dropped ? '✘ ' : '') + signed(sigmas, 1) + ' σ')) : ''));
  }

  const kickTitle = kick => 'Kick ' + kick.id + ' — ' + KINDS[kick.kind] + ', ' + number(Plots.kickSpeed(kick), 2) + ' m/s';

  /** Whether a kick is in the model, who kicked it, what it says of each parameter. */
  function kickFacts(report, kick) {
    const elevation = Math.atan2(kick.vz, Math.hypot(kick.vx, kick.vy)) * 180 / Math.PI;
    return [
      el('p', {class: 'status'}, !kick.selected ? badge('bad', '✘ not in the model') : whyDropped(kick) ? badge('warn', '✔ in the model, in part') : badge('good', '✔ in the model'), whyDropped(kick) ? ' ' + whyDropped(kick) : ''),
      el('div', {},
        el('p', {}, 'By ' + Plots.robotName(kick) + ', towards ' + number(Plots.kickDirection(kick), 0) + '°' + (kick.kind === 'CHIP' ? ', ' + number(elevation, 0) + '° steep' : '') + '; ' + Plots.endWords(kick.end) + ' after ' + number(Plots.prepare(kick).end, 1) + '\u00a0s.'),
        el('p', {}, kick.observations + ' observations, ' + kick.rejected + ' left out as outliers; residual ' + number(kick.rmsMm, 2) + ' mm per axis.'),
        el('p', {class: 'note', title: kick.source}, Charts.fileName(kick.source) + (known(kick.unix) ? ', ' + new Date(kick.unix * 1000).toISOString().slice(11, 23) + ' UTC' : ''))),
      el('table', {}, el('thead', {}, el('tr', {}, el('th', {scope: 'col', class: 'text'}, 'Parameter'), el('th', {scope: 'col'}, 'This kick ± s.e.'), el('th', {scope: 'col', title: 'distance from the mean of the kicks, in standard deviations; ✘: excluded'}, 'From the mean'))),
        el('tbody', {}, kick.parameters.map(p => kickParameterRow(report, kick, p)))),
    ];
  }

  function kickLegend(theme, kick, beside = []) {
    return [
      ...Plots.prepare(kick).cameras.map(({camera}) => el('span', {}, swatch(theme.camera(camera).symbol, theme.camera(camera).colour), 'camera ' + camera)),
      el('span', {}, swatch('circle', theme.muted, true), 'outlier'), el('span', {}, swatch('line', theme.text), 'fitted'), el('span', {}, swatch('line', theme.muted), 'other kicks'),
      el('span', {}, swatch('band', theme.good), 'noise ± 2σ'),
      ...(beside.length ? [el('span', {class: 'beside'}, swatch('line', theme.warn), 'marked: ' + beside.map(one => one.id).join(', '))] : [])];
  }

  /** Places for a kick's pictures; made again only when another sort of kick has others. */
  function layOutKick(box, kick) {
    const fitted = kick.fitted.t.length > 0;
    const layout = kick.kind + (fitted ? '' : ' without fit');
    if (box.dataset.layout === layout) return;
    forget(box);
    box.dataset.layout = layout;
    const chip = kick.kind === 'CHIP';
    figure(box, 'Path on the field', chip ? 'line: true path; dots: as the cameras see it' : 'ctrl + wheel zooms', 'chart tall').dataset.plot = 'path';
    figure(box, 'Speed', 'over the ground', 'chart tall').dataset.plot = 'speed';
    if (chip && fitted) {
      const wide = figure(box, 'Height', 'dots: height on the camera’s ray where it meets the plane of the path');
      wide.dataset.plot = 'height';
      wide.parentNode.classList.add('wide');
    }
    if (fitted) {
      figure(box, 'Residual along', 'line: mean over 0.1 s').dataset.plot = 'along';
      figure(box, 'Residual across', '+ is to the left').dataset.plot = 'across';
    }
  }

  /** The pictures of one kick: path among the others of its kind, speed, height, residuals, with the lines of kicks beside it; when(place, paint) says when each is painted. */
  function drawKick(theme, box, report, kick, when = (place, paint) => paint(), beside = []) {
    const others = report.kicks.filter(k => k.kind === kick.kind && k.id !== kick.id);
    const noises = Object.fromEntries(report.cameras.map(c => [c.id, c.noiseMm]));
    const options = {
      path: place => Plots.path(theme, kick, others, report.field, {width: place.clientWidth, height: place.clientHeight}, beside),
      speed: () => Plots.speed(theme, kick, beside), height: () => Plots.height(theme, kick, beside),
      along: () => Plots.residual(theme, kick, 'along', noises, beside), across: () => Plots.residual(theme, kick, 'across', noises, beside),
    };
    for (const place of box.querySelectorAll('[data-plot]')) when(place, () => draw(place, options[place.dataset.plot](place)));
  }

  return {
    KINDS, COLUMNS, FILTERS, verdict, decisionBadge, model, cameras, difference, MARKS, parameterLegend, whyDropped, sorted, kickTitle, kickFacts, kickLegend, layOutKick, drawKick,
  };
})();
