/*
 * The plots of a diagnosis: each function turns a part of the view model (DiagnosisReport as JSON) into an ECharts option, or into a table. They know no page. Before is the simple
 * model, hollow and dashed; after is the extended model, filled and solid.
 */
const DiagnosisPlots = (() => {
  'use strict';
  const {el, known, number, signed, tip, axis, base, extent, fieldView} = Charts;

  const HALF_WINDOW = 0.1; // s; a mean over so much of a kick shows millimetres in noise of the same size
  const MARK_EVERY = 0.5; // s
  const STEPS = [1, 2, 3, 5, 7, 10, 15, 20, 30, 50]; // more would make noise look like something
  const DRAWN = 0.6; // m; how large on the field a large deviation of 95 % is drawn

  const line = (data, colour, more) => Object.assign({type: 'line', data, symbol: 'none', silent: true, lineStyle: {color: colour, width: 2}, z: 4}, more);
  const zero = theme => ({type: 'scatter', data: [], silent: true, z: 1, markLine: {precision: 8, silent: true, symbol: 'none', animation: false, label: {show: false}, lineStyle: {color: theme.muted, width: 1, type: 'solid'}, data: [{yAxis: 0}]}});
  const noiseBand = (theme, noise) => known(noise) ? {silent: true, itemStyle: {color: theme.good, opacity: 0.14}, data: [[{yAxis: -2 * noise}, {yAxis: 2 * noise}]]} : undefined;

  /** Before and after have their colours; what stands alone has the plain one. */
  const colourOf = (theme, side, sides) => side === 'before' && sides.length > 1 ? theme.warn : theme.accent;

  function quantile(values, share) {
    const sorted = values.filter(known).map(Math.abs).sort((a, b) => a - b);
    return sorted.length ? sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] : NaN;
  }

  /** How many times larger than it is a deviation of so many mm is drawn on the field. */
  function magnification(valuesMm) {
    const large = quantile(valuesMm, 0.95);
    return [...STEPS].reverse().find(step => step * large / 1000 <= DRAWN) || 1;
  }

  /** Half the height of a plot of residuals: nearly all of them, in round numbers. */
  function range(valuesMm, least) {
    const wanted = Math.max(least, (quantile(valuesMm, 0.99) || 0) * 1.15);
    return [0.2, 0.5, 1, 2, 3, 4, 6, 8, 10, 15, 20, 30, 40, 60, 80, 100, 150, 200, 300].find(size => size >= wanted) || Math.ceil(wanted / 100) * 100;
  }

  const UNITS = {rad: '°'};
  const unitOf = profile => UNITS[profile.unit] || profile.unit;

  // ---- what the error depends on ----

  function profileTip(profile, bins, i, name) {
    const at = profile.names.length ? profile.names[i] : profile.label + ' ' + number(bins.at[i], 2) + ' ' + unitOf(profile);
    return tip(at + ', ' + name, signed(bins.first[i], 2) + ' mm ' + profile.axes[0].split(',')[0], signed(bins.second[i], 2) + ' mm ' + profile.axes[1].split(',')[0], 'noise makes ± ' + number(bins.error[i], 2) + ' mm of it');
  }

  /** Mean residual along one axis ('first' or 'second') against a variable; sides says which of before and after are drawn. */
  function profile(theme, profile, column, sides, noise) {
    const named = profile.names.length > 0;
    const option = base(theme, profile.label + (unitOf(profile) ? ' [' + unitOf(profile) + ']' : ''), 'mean [mm]');
    option.grid.right = 26;
    const all = sides.flatMap(side => ['first', 'second'].flatMap(c => profile[side][c].map((v, i) => Math.abs(v) + 2 * profile[side].error[i])));
    const high = range([Math.max(0, ...all) / 1.15], Math.min(1, known(noise) ? noise / 2 : 1));
    Object.assign(option.yAxis, {min: -high, max: high, interval: high / 2});
    if (named) {
      Object.assign(option.xAxis, axis(theme, '', {type: 'category', data: profile.names, axisLabel: {color: theme.text, fontSize: 13, hideOverlap: true}}));
    } else if (profile.variable === 'direction') {
      Object.assign(option.xAxis, {min: -180, max: 180, interval: 90});
    }
    option.series.push(zero(theme));
    for (const side of sides) {
      const bins = profile[side];
      const colour = colourOf(theme, side, sides);
      const at = i => named ? i : bins.at[i];
      const data = bins.at.map((_, i) => ({value: [at(i), bins[column][i]], bins, i, name: side}));
      if (named) {
        option.series.push({type: 'bar', data, barMaxWidth: 36, itemStyle: {color: side === 'before' && sides.length > 1 ? 'transparent' : colour, borderColor: colour, borderWidth: 2}, z: 3});
        continue;
      }
      const bars = bins.at.flatMap((_, i) => [[at(i), bins[column][i] - 2 * bins.error[i]], [at(i), bins[column][i] + 2 * bins.error[i]], [at(i), null]]);
      option.series.push(line(bars, colour, {lineStyle: {color: colour, width: 1.5}, z: 2}));
      option.series.push({
        type: 'line', data, symbol: side === 'before' && sides.length > 1 ? 'emptyCircle' : 'circle', symbolSize: 8, showAllSymbol: true, z: side === 'before' ? 3 : 4,
        lineStyle: {color: colour, width: 2, type: side === 'before' && sides.length > 1 ? 'dashed' : 'solid'}, itemStyle: {color: colour, borderWidth: 2},
      });
    }
    option.tooltip.formatter = ({data}) => data.bins ? profileTip(profile, data.bins, data.i, data.name) : '';
    return option;
  }

  // ---- kicks ----

  /** Residual of every kick, held out, before and after; items carry {kick: id}. */
  function kickByKick(theme, kicks, sides, noise, selectedId) {
    const option = base(theme, 'kick', 'rms [mm]');
    const index = new Map(kicks.map((kick, i) => [kick.id, i]));
    Object.assign(option.xAxis, axis(theme, 'kick', {type: 'category', data: kicks.map(kick => String(kick.id)), axisLabel: {color: theme.text, fontSize: 12, hideOverlap: true}}));
    const values = kicks.flatMap(kick => sides.map(side => side === 'before' ? kick.rmsBeforeMm : kick.rmsAfterMm)).filter(known);
    // Where one kick is many times worse than the rest, equal steps would hide these.
    const spread = Math.max(...values) / Math.max(0.1, Math.min(...values));
    if (spread > 12) Object.assign(option.yAxis, {type: 'log', logBase: 10, min: Math.pow(10, Math.floor(Math.log10(Math.min(...values))))});
    else option.yAxis.min = 0;
    option.grid.top = 16;
    option.series.push({type: 'scatter', data: [], silent: true, z: 1, markLine: {precision: 8, silent: true, symbol: 'none', animation: false, data: known(noise) ? [{yAxis: noise, lineStyle: {color: theme.good, width: 2, type: 'solid'}, label: {show: false}}] : []}});
    if (sides.length > 1) {
      option.series.push(line(kicks.flatMap((kick, i) => [[i, kick.rmsBeforeMm], [i, kick.rmsAfterMm], [i, null]]), theme.muted, {lineStyle: {color: theme.muted, width: 2}, z: 2}));
    }
    for (const side of sides) {
      const of = kick => side === 'before' ? kick.rmsBeforeMm : kick.rmsAfterMm;
      const colour = colourOf(theme, side, sides);
      const hollow = side === 'before' && sides.length > 1;
      option.series.push({
        type: 'scatter', symbolSize: kicks.length > 60 ? 7 : 10, cursor: 'pointer', z: 4, itemStyle: {color: hollow ? theme.panel : colour, borderColor: colour, borderWidth: 2},
        data: kicks.filter(kick => known(of(kick))).map(kick => ({value: [index.get(kick.id), of(kick)], kick: kick.id, of: kick})),
      });
    }
    const selected = kicks.find(kick => kick.id === selectedId);
    const value = selected && (sides.includes('after') ? selected.rmsAfterMm : selected.rmsBeforeMm);
    if (known(value)) option.series.push({type: 'scatter', silent: true, symbolSize: 20, z: 5, itemStyle: {color: 'transparent', borderColor: theme.text, borderWidth: 2.5}, data: [[index.get(selectedId), value]]});
    option.tooltip.formatter = ({data}) => !data.of ? '' : tip('Kick ' + data.of.id + ', ' + data.of.kind + ', ' + number(data.of.speed, 1) + ' m/s' + (data.of.robot ? ', ' + data.of.robot : ''),
      'calibrated model ' + number(data.of.rmsBeforeMm, 1) + ' mm', sides.length > 1 && 'extended model ' + number(data.of.rmsAfterMm, 1) + ' mm');
    return option;
  }

  function at(path, column, t) {
    const times = path.t, values = path[column];
    let low = 0, high = times.length - 1;
    if (t <= times[0]) return values[0];
    if (t >= times[high]) return values[high];
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (times[middle] <= t) low = middle; else high = middle;
    }
    return values[low] + (t - times[low]) / (times[high] - times[low] || 1) * (values[high] - values[low]);
  }

  /** Deviations of one kick that decide how it is drawn: those of the simple model, so that both pictures have one scale. */
  const deviations = kick => [...kick.seen.beforeAlong, ...kick.seen.beforeAcross];

  /** Every half second: where the ball should be, and where each camera that sees it then sees it on average, drawn farther off. */
  function timeMarks(rows, way, factor) {
    const marks = [];
    const end = rows.length ? rows[rows.length - 1].t : 0;
    for (let t = MARK_EVERY; t < end; t += MARK_EVERY) {
      const should = [at(way, 'x', t), at(way, 'y', t)];
      const heading = at(way, 'heading', t), cos = Math.cos(heading), sin = Math.sin(heading);
      const near = rows.filter(row => Math.abs(row.t - t) <= HALF_WINDOW);
      for (const camera of new Set(near.map(row => row.camera))) {
        const its = near.filter(row => row.camera === camera);
        const mean = column => its.reduce((sum, row) => sum + row[column], 0) / its.length * factor / 1000;
        const along = mean('along'), across = mean('across');
        marks.push({should, is: [should[0] + along * cos - across * sin, should[1] + along * sin + across * cos]});
      }
    }
    return marks;
  }

  /** Where the model says the ball goes (line), and where it was seen, drawn farther off than it was (dots). */
  function path(theme, kick, side, field, factor, size) {
    const box = extent(field, [...kick.before.x, ...kick.after.x], [...kick.before.y, ...kick.after.y]);
    const option = fieldView(theme, field, box, size);
    const way = kick[side];
    const rows = kick.seen.t.map((t, i) => {
      const heading = at(way, 'heading', t), cos = Math.cos(heading), sin = Math.sin(heading);
      const along = kick.seen[side + 'Along'][i], across = kick.seen[side + 'Across'][i], scale = factor / 1000;
      return {t, along, across, camera: kick.seen.camera[i], value: [at(way, 'x', t) + scale * (along * cos - across * sin), at(way, 'y', t) + scale * (along * sin + across * cos)]};
    });
    for (const camera of new Set(kick.seen.camera)) {
      const style = theme.camera(camera);
      option.series.push({type: 'scatter', symbol: style.symbol, symbolSize: 5, itemStyle: {color: style.colour, opacity: 0.75}, z: 3, data: rows.filter(row => row.camera === camera)});
    }
    option.series.push(line(way.x.map((x, i) => [x, way.y[i]]), theme.text, {z: 4, lineStyle: {color: theme.text, width: 2}}));
    // A ball that is too early or too late stays on the line: marks of the same time show it.
    const marks = timeMarks(rows, way, factor);
    option.series.push({type: 'scatter', symbol: 'circle', symbolSize: 11, silent: true, z: 5, itemStyle: {color: theme.panel, borderColor: theme.text, borderWidth: 2}, data: marks.map(mark => mark.should)});
    option.series.push(line(marks.flatMap(mark => [mark.should, mark.is, [null, null]]), theme.bad, {z: 6, lineStyle: {color: theme.bad, width: 2.5}}));
    option.series.push({type: 'scatter', symbol: 'circle', symbolSize: 5, silent: true, z: 7, itemStyle: {color: theme.bad}, data: marks.map(mark => mark.is)});
    option.series.push({type: 'scatter', symbol: 'circle', symbolSize: 14, silent: true, z: 6, itemStyle: {color: 'transparent', borderColor: theme.text, borderWidth: 3}, data: [[way.x[0], way.y[0]]]});
    option.tooltip.formatter = ({data}) => known(data.t) ? tip('Camera ' + data.camera, number(data.t, 2) + ' s after the kick', signed(data.along, 1) + ' mm along, ' + signed(data.across, 1) + ' mm across') : '';
    return option;
  }

  /** Residuals of one kick along or across its path over time, one colour for each camera, with running means. */
  function residual(theme, kick, side, direction, noise) {
    const name = direction === 'Along' ? 'along [mm]' : 'across [mm]';
    const option = base(theme, 'time since the kick [s]', name);
    const high = range(deviations(kick), 4);
    const values = kick.seen[side + direction];
    Object.assign(option.yAxis, {min: -high, max: high, interval: high / 2});
    Object.assign(option.xAxis, {min: 0, scale: false, max: Math.ceil(Math.max(0.1, ...kick.seen.t) * 5) / 5});
    option.xAxis.axisLabel.showMaxLabel = false;
    option.series.push(Object.assign(zero(theme), {markArea: noiseBand(theme, noise)}));
    for (const camera of new Set(kick.seen.camera)) {
      const style = theme.camera(camera);
      const rows = kick.seen.t.map((t, i) => ({t, v: values[i], camera: kick.seen.camera[i]})).filter(row => row.camera === camera && known(row.v));
      option.series.push({
        type: 'scatter', symbol: style.symbol, symbolSize: 4, z: 3, itemStyle: {color: style.colour, opacity: 0.5},
        data: rows.map(row => ({value: [row.t, Math.max(-high, Math.min(high, row.v))], row})),
      });
      const means = [];
      let from = 0, to = 0, sum = 0;
      rows.forEach((row, i) => {
        while (to < rows.length && rows[to].t <= row.t + HALF_WINDOW) sum += rows[to++].v;
        while (rows[from].t < row.t - HALF_WINDOW) sum -= rows[from++].v;
        if (i > 0 && row.t - rows[i - 1].t > 4 * HALF_WINDOW) means.push([row.t, null]);
        means.push([row.t, sum / (to - from)]);
      });
      option.series.push(line(means, style.colour, {z: 5}));
    }
    option.tooltip.formatter = ({data}) => data.row ? tip('Camera ' + data.row.camera, number(data.row.t, 2) + ' s after the kick', signed(data.row.v, 1) + ' mm ' + direction.toLowerCase()) : '';
    return option;
  }

  // ---- over the field ----

  /** Mean residuals as arrows from where the ball should be to where it is seen, longer than they are by a factor; one colour for each camera. */
  function map(theme, map, side, field, factor, size) {
    const option = fieldView(theme, field, extent(field, map.x, map.y), size);
    const dx = map[side + 'X'], dy = map[side + 'Y'];
    for (const camera of new Set(map.camera)) {
      const {colour} = theme.camera(camera);
      const cells = map.x.map((_, i) => i).filter(i => map.camera[i] === camera);
      const end = i => [map.x[i] + dx[i] * factor / 1000, map.y[i] + dy[i] * factor / 1000];
      option.series.push(line(cells.flatMap(i => [[map.x[i], map.y[i]], end(i), [null, null]]), colour, {lineStyle: {color: colour, width: 1.5}, z: 3}));
      option.series.push({
        type: 'scatter', z: 4, itemStyle: {color: colour},
        data: cells.map(i => {
          const long = Math.hypot(dx[i], dy[i]) * factor / 1000 > 0.12;
          return {value: end(i), cell: i, symbol: long ? 'triangle' : 'circle', symbolSize: long ? 7 : 4, symbolRotate: Math.atan2(dy[i], dx[i]) * 180 / Math.PI - 90};
        }),
      });
    }
    option.tooltip.formatter = ({data}) => known(data.cell)
      ? tip('Camera ' + map.camera[data.cell] + ' around x ' + number(map.x[data.cell], 1) + ', y ' + number(map.y[data.cell], 1) + ' m', 'x ' + signed(dx[data.cell], 1) + ' mm, y ' + signed(dy[data.cell], 1) + ' mm', map.count[data.cell] + ' observations') : '';
    return option;
  }

  const mapFactor = map => magnification([...map.beforeX, ...map.beforeY]);

  // ---- what was learned ----

  const named = (curve, i) => curve.axes[i] + (curve.axisUnits[i] ? ' [' + curve.axisUnits[i] + ']' : '');
  const digits = values => { const size = Math.max(...values.map(Math.abs)); return size > 0 ? Math.max(0, Math.min(5, 2 - Math.floor(Math.log10(size)))) : 2; };

  /** A learned curve with bounds of two standard errors. */
  function curve(theme, curve) {
    const option = base(theme, named(curve, 0), curve.unit || 'change');
    const rows = curve.x.map((x, i) => ({x, v: curve.value[i], e: known(curve.error[i]) ? 2 * curve.error[i] : 0}));
    const decimals = digits(curve.value);
    // Values of a few thousandths have long labels.
    option.grid.left = 74;
    option.yAxis.nameGap = 58;
    option.xAxis.min = rows[0].x;
    option.xAxis.max = rows[rows.length - 1].x;
    const high = Math.max(...rows.map(row => row.v + row.e), 0), low = Math.min(...rows.map(row => row.v - row.e), 0);
    const room = 0.08 * (high - low || 1);
    Object.assign(option.yAxis, {min: low - room, max: high + room});
    option.yAxis.axisLabel.showMinLabel = option.yAxis.axisLabel.showMaxLabel = false;
    const bound = sign => line(rows.map(row => [row.x, row.v + sign * row.e]), theme.accent, {lineStyle: {color: theme.accent, width: 1, opacity: 0.6}, z: 3});
    // The charts that the page carries fill no area between two lines: bars that touch do.
    const bars = rows.flatMap(row => [[row.x, row.v - row.e], [row.x, row.v + row.e], [row.x, null]]);
    option.series.push(zero(theme), bound(1), bound(-1), line(bars, theme.accent, {lineStyle: {color: theme.accent, width: rows.length > 12 ? 9 : 4, opacity: 0.2}, z: 2}),
      {type: 'line', data: rows.map(row => ({value: [row.x, row.v], row})), symbol: 'circle', symbolSize: rows.length > 12 ? 5 : 8, showAllSymbol: true, z: 4, lineStyle: {color: theme.accent, width: 2.5}, itemStyle: {color: theme.accent}});
    option.tooltip.formatter = ({data}) => data && data.row ? tip(curve.axes[0] + ' ' + number(data.row.x, 2) + ' ' + curve.axisUnits[0], signed(data.row.v, decimals) + ' ' + curve.unit, '± ' + number(data.row.e / 2, decimals) + ' (standard error)') : '';
    return option;
  }

  /** A table over two numbers, coloured by value; a number where it is more than two standard errors. */
  function table(curve) {
    const xs = [...new Set(curve.x)].sort((a, b) => a - b), ys = [...new Set(curve.y)].sort((a, b) => b - a);
    const size = Math.max(...curve.value.map(Math.abs)) || 1;
    const decimals = Math.max(0, digits(curve.value) - 1);
    const cell = (x, y) => {
      const i = curve.x.findIndex((_, k) => curve.x[k] === x && curve.y[k] === y);
      const v = curve.value[i], e = known(curve.error[i]) ? curve.error[i] : 0;
      const strength = (85 * Math.abs(v) / size).toFixed(0);
      return el('td', {style: 'background: color-mix(in srgb, var(--' + (v > 0 ? 'warn' : 'accent') + ') ' + strength + '%, var(--panel))', class: strength > 50 ? 'strong' : null,
        title: named(curve, 0) + ' ' + number(x, 1) + ', ' + named(curve, 1) + ' ' + number(y, 1) + ': ' + signed(v, decimals + 1) + ' ' + curve.unit + ' ± ' + number(e, decimals + 1)}, Math.abs(v) > 2 * e ? signed(v, decimals) : '·');
    };
    return el('table', {class: 'heat'}, el('tbody', {},
      ys.map((y, i) => el('tr', {}, i === 0 ? el('th', {rowspan: ys.length, class: 'axis'}, named(curve, 1)) : '', el('th', {scope: 'row'}, number(y, 1)), xs.map(x => cell(x, y)))),
      el('tr', {}, el('th', {}), el('th', {}), xs.map(x => el('th', {scope: 'col'}, number(x, 1)))),
      el('tr', {}, el('th', {}), el('th', {}), el('th', {colspan: xs.length, class: 'axis'}, named(curve, 0)))));
  }

  // ---- gain ----

  /** Prediction error by horizon as bars. */
  function horizons(theme, qualities) {
    const option = base(theme, 'predicted ahead, from the first 0.3 s of a kick', 'error [mm]');
    const all = [...new Set(qualities.flatMap(q => q.quality.horizons))].sort((a, b) => a - b);
    Object.assign(option.xAxis, axis(theme, option.xAxis.name, {type: 'category', data: all.map(h => String(h) + ' s'), axisLabel: {color: theme.text, fontSize: 13}}));
    Object.assign(option.yAxis, {min: 0, scale: false});
    option.grid.top = 24;
    for (const {quality, side, name} of qualities) {
      const colour = colourOf(theme, side, qualities);
      const hollow = side === 'before' && qualities.length > 1;
      option.series.push({
        type: 'bar', barMaxWidth: 46, itemStyle: {color: hollow ? 'transparent' : colour, borderColor: colour, borderWidth: 2},
        label: {show: true, position: 'top', color: theme.text, fontSize: 13, formatter: ({data}) => data ? number(data.mm, data.mm < 10 ? 1 : 0) : ''},
        data: all.map(h => {
          const i = quality.horizons.indexOf(h);
          return i < 0 ? null : {value: quality.typicalErrorMm[i], mm: quality.typicalErrorMm[i], name};
        }),
      });
    }
    option.tooltip.formatter = ({data, name}) => data ? tip(data.name, name + ' ahead: ' + number(data.mm, 1) + ' mm') : '';
    return option;
  }

  return {curve, table, profile, kickByKick, path, residual, map, mapFactor, magnification, deviations, horizons};
})();
