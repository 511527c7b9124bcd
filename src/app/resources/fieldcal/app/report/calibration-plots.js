/*
 * The plots of a calibration: each function turns the view model (CalibrationReport as JSON) into an ECharts option.
 * They know no page, so that the report and the console share them. Tooltips are DOM nodes with text content: nothing
 * from a recording is ever read as markup.
 */
const Plots = (() => {
  'use strict';

  /** A parameter's name in files and messages: accSlide is acc_slide. */
  const inFiles = name => name.replace(/[A-Z]/g, letter => '_' + letter.toLowerCase());

  const HALF_WINDOW = 0.05; // s; about seven frames at 70 Hz, enough to see a slope in 2 mm of noise
  const END_WORDS = {
    stopped: 'came to rest', left_field: 'left the field', touched_robot: 'touched a robot', lost: 'lost from view',
    recording_ended: 'recording ended',
  };

  const {known, number, signed, withError, decimals, tip, base, extent, fieldView} = Charts;

  // ---- words ----

  /** A published value: as it was written, but with two decimals at least. */
  const asPublished = value => !known(value) ? '–' : number(value, Math.max(2, (String(value).split('.')[1] || '').length));

  const kickSpeed = kick => Math.hypot(kick.vx, kick.vy, kick.vz);
  const kickDirection = kick => Math.atan2(kick.vy, kick.vx) * 180 / Math.PI;
  const endWords = end => END_WORDS[end] || end || 'unknown';
  const robotName = kick => (kick.robot < 0 && !kick.team ? 'unknown' : (kick.team + ' ' + (kick.robot < 0 ? '?' : kick.robot)).trim());
  /** Whether this value of this kick is averaged. */
  const isUsed = (kick, fitted) => kick.selected && known(fitted.value) && !fitted.dropped;

  /** Distance of a kick's value from the mean, in units of what is expected: its own error and the scatter between kicks. */
  function sigmas(parameter, fitted) {
    const spread = Math.hypot(fitted.standardError || 0, known(parameter.sigma) ? parameter.sigma : 0);
    return spread > 0 ? (fitted.value - parameter.mean) / spread : NaN;
  }

  /** The spread expected of a typical kick; the band drawn is twice that. */
  function typicalSpread(parameter, points) {
    const errors = points.filter(p => p.used).map(p => p.error).sort((a, b) => a - b);
    return Math.hypot(errors[Math.floor(errors.length / 2)] || 0, known(parameter.sigma) ? parameter.sigma : 0);
  }

  // ---- the parameters over the kicks ----

  const AXES = {
    kick: {label: 'kick', name: 'kick number', of: kick => kick.id, minInterval: 1},
    speed: {label: 'speed', name: 'kick speed [m/s]', of: kickSpeed},
    direction: {label: 'direction', name: 'direction [°]', of: kickDirection},
    place: {label: 'place', name: 'kick position x [m]', of: kick => kick.x},
  };

  /** Range that shows the band and all selected kicks; a dropped kick far away must not flatten the rest. */
  function parameterRange(parameter, points) {
    const spread = typicalSpread(parameter, points) || Math.abs(parameter.mean) * 0.02 || 0.01;
    const values = points.filter(p => p.used).flatMap(p => [p.value - p.error, p.value + p.error]);
    if (known(parameter.mean)) values.push(parameter.mean - 4 * spread, parameter.mean + 4 * spread);
    if (known(parameter.published) && Math.abs(parameter.published - parameter.mean) < 12 * spread) values.push(parameter.published);
    if (values.length === 0) values.push(...points.map(p => p.value));
    if (values.length === 0) return [0, 1];
    const low = Math.min(...values), high = Math.max(...values);
    const margin = (high - low || Math.abs(high) || 1) * 0.06;
    return [low - margin, high + margin];
  }

  function parameterTip(parameter, point) {
    const kick = point.kick;
    const distance = sigmas(parameter, point.fitted);
    return tip('Kick ' + kick.id + ': ' + inFiles(parameter.name) + ' ' + (point.undetermined ? 'undetermined' : withError(point.value, point.error, parameter.unit)),
      point.undetermined,
      known(distance) && signed(distance, 1) + ' σ from the mean',
      number(kickSpeed(kick), 2) + ' m/s at ' + number(kickDirection(kick), 0) + '°, ' + robotName(kick) + ', ' + endWords(kick.end),
      point.used || point.undetermined ? '' : 'Excluded: ' + (point.fitted.dropped || kick.rejectedBecause));
  }

  /**
   * One parameter over the kicks: error bars, mean, band of two sigma, what was dropped. Items carry {kick: id}. Only the kicks that are listed are drawn; mean, band and range are those of all.
   */
  function parameter(theme, parameter, kicks, axisKey, selectedId, listed = () => true) {
    const horizontal = AXES[axisKey];
    let points = [];
    for (const kick of kicks) {
      const fitted = kick.parameters.find(p => p.name === parameter.name);
      if (!fitted) continue;
      points.push({kick, fitted, used: isUsed(kick, fitted), x: horizontal.of(kick), value: fitted.value, error: fitted.standardError || 0, undetermined: known(fitted.value) ? '' : fitted.undetermined || 'undetermined'});
    }
    const all = points.filter(p => !p.undetermined);
    const [low, high] = parameterRange(parameter, all);
    points = points.filter(p => listed(p.kick));
    const seen = points.filter(p => !p.undetermined);
    const option = base(theme, horizontal.name, '');
    option.yAxis.min = low;
    option.yAxis.max = high;
    option.yAxis.axisLabel.showMinLabel = option.yAxis.axisLabel.showMaxLabel = false;
    option.yAxis.splitNumber = 4;
    option.yAxis.axisLabel.formatter = value => number(value, Math.max(1, Math.min(4, Math.ceil(-Math.log10((high - low) / 4)))));
    option.grid.left = 66;
    if (horizontal.minInterval) option.xAxis.minInterval = 1;
    const shown = p => {
      const y = p.undetermined ? low : Math.max(low, Math.min(high, p.value));
      const outside = !p.undetermined && y !== p.value;
      return {
        value: [p.x, y], kick: p.kick.id,
        symbol: p.undetermined ? 'path://M-5,-4L5,4M-5,4L5,-4' : outside ? 'triangle' : 'circle',
        symbolRotate: outside && p.value < low ? 180 : 0,
        symbolOffset: p.undetermined ? [0, -6] : outside ? [0, p.value < low ? -7 : 7] : [0, 0],
      };
    };
    const bars = group => group.flatMap(p => [[p.x, p.value - p.error], [p.x, p.value + p.error], [p.x, null]]);
    const line = (data, colour) => ({type: 'line', data, symbol: 'none', silent: true, lineStyle: {color: colour, width: 1.5}, z: 3, clip: true});
    const selected = seen.filter(p => p.used), dropped = seen.filter(p => !p.used);
    // ECharts rounds the places of lines to two decimals unless told otherwise.
    const reference = {type: 'scatter', data: [], silent: true, z: 1, markLine: {precision: 8, silent: true, symbol: 'none', data: [], animation: false}};
    if (known(parameter.mean)) {
      const band = 2 * typicalSpread(parameter, all);
      reference.markArea = {silent: true, itemStyle: {color: theme.good, opacity: 0.14}, data: [[{yAxis: Math.max(low, parameter.mean - band)}, {yAxis: Math.min(high, parameter.mean + band)}]]};
      reference.markLine.data.push({yAxis: parameter.mean, lineStyle: {color: theme.good, width: 2, type: 'solid'}, label: {show: false}});
    }
    if (known(parameter.published) && parameter.published >= low && parameter.published <= high) {
      reference.markLine.data.push({
        yAxis: parameter.published, lineStyle: {color: theme.text, width: 2, type: 'dashed'}, label: {show: false},
      });
    }
    if (known(parameter.published) && (parameter.published < low || parameter.published > high)) {
      // A mark at the edge: the line itself is beyond it.
      const above = parameter.published > high;
      reference.markLine.data.push({
        yAxis: above ? high : low, lineStyle: {color: 'transparent'},
        label: {show: true, position: above ? 'insideEndBottom' : 'insideEndTop', color: theme.text, fontSize: 12, formatter: (above ? '▲' : '▼') + ' published ' + asPublished(parameter.published)},
      });
    }
    const circled = points.filter(p => p.kick.id === selectedId);
    option.tooltip.formatter = item => {
      const point = item.data && points.find(p => p.kick.id === item.data.kick);
      return point ? parameterTip(parameter, point) : '';
    };
    option.series = [
      reference,
      line(bars(selected), theme.accent),
      line(bars(dropped), theme.bad),
      {type: 'scatter', symbolSize: 9, itemStyle: {color: theme.accent}, data: selected.map(shown), z: 4, cursor: 'pointer'},
      {type: 'scatter', symbolSize: 11, itemStyle: {color: theme.panel, borderColor: theme.bad, borderWidth: 2}, data: dropped.map(shown), z: 5, cursor: 'pointer'},
      {type: 'scatter', symbolSize: 8, itemStyle: {color: 'transparent', borderColor: theme.muted, borderWidth: 2}, data: points.filter(p => p.undetermined).map(shown), z: 4, cursor: 'pointer'},
      {type: 'scatter', symbolSize: 20, silent: true, itemStyle: {color: 'transparent', borderColor: theme.text, borderWidth: 2.5}, z: 6,
        data: circled.map(p => Object.assign(shown(p), {symbol: 'circle', symbolRotate: 0}))},
    ];
    return option;
  }

  // ---- one kick ----

  /** Value of a column of the fitted path at time t; its ends beyond them. */
  function along(path, column, t) {
    const times = path.t, values = path[column];
    if (times.length === 0) return NaN;
    let low = 0, high = times.length - 1;
    if (t <= times[0]) return values[0];
    if (t >= times[high]) return values[high];
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (times[middle] <= t) low = middle; else high = middle;
    }
    const part = (t - times[low]) / (times[high] - times[low] || 1);
    return values[low] + part * (values[high] - values[low]);
  }

  /** Direction of travel at time t: of the last piece of the path that moves. */
  function heading(kick) {
    const path = kick.fitted;
    const cosines = [], sines = [];
    const speed = Math.hypot(kick.vx, kick.vy) || 1;
    let cos = kick.vx / speed, sin = kick.vy / speed;
    for (let i = 0; i < path.t.length; i++) {
      const next = Math.min(i + 1, path.t.length - 1);
      const dx = path.x[next] - path.x[i], dy = path.y[next] - path.y[i], length = Math.hypot(dx, dy);
      if (length > 1e-3) { cos = dx / length; sin = dy / length; }
      cosines.push(cos);
      sines.push(sin);
    }
    if (cosines.length === 0) return () => [cos, sin];
    const columns = {t: path.t, cos: cosines, sin: sines};
    return t => [along(columns, 'cos', t), along(columns, 'sin', t)];
  }

  function slope(t, y, from, to) {
    let n = 0, st = 0, sy = 0;
    for (let i = from; i < to; i++) { n++; st += t[i]; sy += y[i]; }
    let stt = 0, sty = 0;
    for (let i = from; i < to; i++) { const d = t[i] - st / n; stt += d * d; sty += d * (y[i] - sy / n); }
    return n >= 4 && stt > 0 ? sty / stt : NaN;
  }

  /**
   * What the plots need of one kick, worked out once: per camera the residuals along and across the direction of travel, their
   * running mean, and the speed seen. The speed is the fitted one plus the slope of the residual: for a ball in the air the slope of
   * what the camera reports is not the ball's.
   */
  function prepare(kick) {
    if (kick.prepared) return kick.prepared;
    const direction = heading(kick);
    const hasFit = kick.fitted.t.length > 0;
    const cameras = kick.seen.map(seen => {
      const rows = seen.t.map((t, i) => {
        const [cos, sin] = direction(t);
        const rx = seen.residualXMm[i], ry = seen.residualYMm[i];
        const fits = known(rx) && known(ry);
        return {
          t, x: seen.x[i], y: seen.y[i], used: seen.used[i], height: seen.height.length ? seen.height[i] : null,
          along: fits ? rx * cos + ry * sin : null, across: fits ? ry * cos - rx * sin : null,
          travelled: (seen.x[i] - kick.x) * cos + (seen.y[i] - kick.y) * sin,
        };
      });
      const used = rows.filter(row => row.used);
      const times = used.map(row => row.t);
      const offsets = used.map(row => hasFit && row.along !== null ? row.along / 1000 : row.travelled);
      let from = 0, to = 0;
      for (let i = 0; i < used.length; i++) {
        const row = used[i];
        // A window never reaches over the kick: on its other side the ball rests.
        while (times[from] < row.t - HALF_WINDOW || (row.t >= 0 && times[from] < 0)) from++;
        while (to < used.length && times[to] <= row.t + HALF_WINDOW && (row.t >= 0 || times[to] < 0)) to++;
        const rate = slope(times, offsets, from, to);
        row.speed = row.t < 0 ? (hasFit ? rate : NaN) : rate + (hasFit ? along(kick.fitted, 'speed', row.t) : 0);
        for (const column of ['along', 'across']) {
          let sum = 0;
          for (let k = from; k < to; k++) sum += used[k][column];
          row[column + 'Mean'] = row[column] === null ? null : sum / (to - from);
        }
      }
      return {camera: seen.camera, rows, used, outliers: rows.filter(row => !row.used)};
    });
    const times = cameras.flatMap(camera => [camera.rows[0], camera.rows[camera.rows.length - 1]]).filter(Boolean).map(row => row.t);
    const end = Math.max(0.1, ...times, ...kick.fitted.t.slice(-1));
    const start = Math.min(-0.1, ...times);
    Object.defineProperty(kick, 'prepared', {value: {cameras, start, end}, enumerable: false});
    return kick.prepared;
  }

  function eventName(event, number) {
    return event.type === 'LANDING' ? 'landing ' + number : event.type === 'ROLLING' ? 'rolls' : 'stops';
  }

  /** Events with names; those too close to the one before have no label. */
  function namedEvents(kick) {
    const prepared = prepare(kick);
    const all = [{name: 'kick', label: 'kick', t: 0, x: kick.x, y: kick.y, type: 'KICK'}];
    let landings = 0;
    for (const event of kick.events) {
      if (event.type === 'LANDING') landings++;
      const name = eventName(event, landings);
      all.push({name, label: event.type === 'LANDING' ? String(landings) : name, t: event.t, x: event.x, y: event.y, type: event.type});
    }
    const room = (prepared.end - prepared.start) * 0.07;
    let last = -Infinity;
    return all.filter(event => event.t <= prepared.end).map(event => {
      const shown = event.t - last >= room;
      if (shown) last = event.t;
      return Object.assign(event, {shown});
    });
  }

  function eventLines(theme, kick) {
    return {
      type: 'scatter', data: [], silent: true, z: 1,
      markLine: {precision: 8, 
        silent: true, symbol: 'none', animation: false,
        data: namedEvents(kick).map(event => ({
          xAxis: event.t, lineStyle: {color: theme.muted, width: 1, type: event.type === 'KICK' ? 'solid' : 'dashed'},
          label: {show: event.shown, formatter: event.label, position: 'end', color: theme.muted, fontSize: 12, distance: 2},
        })),
      },
    };
  }

  /** From the kick's first observation to its last, or to that of the longest kick beside it. */
  function timeAxes(option, kick, beside = []) {
    const {start} = prepare(kick), end = Math.max(...[kick, ...beside].map(one => prepare(one).end));
    option.grid.top = 20;
    option.xAxis.min = Math.floor(start * 5) / 5;
    option.xAxis.max = Math.ceil(end * 5) / 5;
    option.xAxis.scale = false;
    option.xAxis.axisLabel.showMinLabel = option.xAxis.axisLabel.showMaxLabel = false;
    return option;
  }

  /** Kicks that are drawn beside another one: thin lines with their number. at(kick) gives the places of a line. */
  function besideIt(theme, kicks, at) {
    return kicks.flatMap(kick => {
      const line = at(kick), last = line.filter(([x, y]) => x !== null && y !== null).pop();
      const label = {show: true, formatter: String(kick.id), position: 'right', color: theme.warn, fontSize: 12, fontWeight: 700, textBorderColor: theme.panel, textBorderWidth: 3};
      return [{type: 'line', ...packed(line), symbol: 'none', silent: true, lineStyle: {color: theme.warn, width: 1.5}, z: 4, name: 'beside ' + kick.id},
        ...(last ? [{type: 'scatter', data: [last], symbolSize: 1, silent: true, z: 6, label}] : [])];
    });
  }

  const seconds = row => number(row.t, 3) + ' s after the kick';

  /** Pairs of numbers as ECharts copies them fastest; null becomes a gap. */
  function packed(pairs) {
    const data = new Float64Array(2 * pairs.length);
    pairs.forEach(([x, y], i) => {
      data[2 * i] = x === null ? NaN : x;
      data[2 * i + 1] = y === null ? NaN : y;
    });
    return {data, dimensions: ['x', 'y']};
  }

  /**
   * Observations of one camera as points: at(row) says where, hints are told by tipOf(). Hundreds are drawn as one shape; with an element for each, ECharts takes several
   * times as long. What ECharts need not know it shall not copy either.
   */
  function points(style, camera, rows, at, more) {
    const series = Object.assign({
      type: 'scatter', symbol: style.symbol, symbolSize: 5, itemStyle: {color: style.colour, opacity: 0.75}, z: 3, large: true, largeThreshold: 50,
    }, packed(rows.map(at)), more);
    Object.defineProperty(series, 'seen', {value: {camera, rows}});
    return series;
  }

  /** What is told of the point under the mouse; words(row, camera) for an observation, other(data) for anything else. */
  const tipOf = (option, words, other = () => '') => ({seriesIndex, dataIndex, data}) => {
    const {seen} = option.series[seriesIndex];
    return seen ? words(seen.rows[dataIndex], seen.camera) : other(data);
  };

  /** Beside the path, and inside the drawing. */
  function labelPosition(kick, event, box) {
    const room = (box.x1 - box.x0) * 0.12;
    if (event.x < box.x0 + room) return 'right';
    if (event.x > box.x1 - room) return 'left';
    return Math.abs(kick.vx) > Math.abs(kick.vy) ? (event.y > box.y1 - room ? 'bottom' : 'top') : 'right';
  }

  /** The path on the field, true to scale in a box of the given size in pixels. */
  function path(theme, kick, others, field, size, beside = []) {
    const prepared = prepare(kick);
    const box = extent(field, [kick.x, ...kick.fitted.x, ...kick.seen.flatMap(seen => seen.x)], [kick.y, ...kick.fitted.y, ...kick.seen.flatMap(seen => seen.y)]);
    const option = fieldView(theme, field, box, size);
    const line = (data, colour, lineWidth, z, more) => Object.assign({type: 'line', symbol: 'none', silent: true, lineStyle: {color: colour, width: lineWidth}, z}, packed(data), more);
    const every = others.flatMap(other => [...other.fitted.x.filter((_, i) => i % 4 === 0).map((x, i) => [x, other.fitted.y[i * 4]]), [null, null]]);
    option.series.push(line(every, theme.muted, 1, 2, {lineStyle: {color: theme.muted, width: 1, opacity: 0.35}}));
    for (const {camera, used, outliers} of prepared.cameras) {
      const style = theme.camera(camera);
      const at = row => [row.x, row.y];
      option.series.push(points(style, camera, used, at));
      option.series.push(points(style, camera, outliers, at, {symbolSize: 7, itemStyle: {color: 'transparent', borderColor: style.colour, borderWidth: 1.5}, z: 4}));
    }
    option.series.push(...besideIt(theme, beside, one => one.fitted.x.map((x, i) => [x, one.fitted.y[i]])));
    option.series.push(line(kick.fitted.x.map((x, i) => [x, kick.fitted.y[i]]), theme.text, 2, 5));
    option.series.push({
      type: 'scatter', z: 6,
      data: namedEvents(kick).map(event => ({
        value: [event.x, event.y], event,
        symbol: event.type === 'KICK' ? 'circle' : event.type === 'LANDING' ? 'diamond' : event.type === 'STOP' ? 'rect' : 'circle',
        symbolSize: event.type === 'KICK' ? 15 : event.type === 'LANDING' ? 13 : 9,
        itemStyle: {color: event.type === 'KICK' ? 'transparent' : theme.panel, borderColor: theme.text, borderWidth: event.type === 'KICK' ? 3 : 2},
        label: {show: event.shown, formatter: event.label, position: labelPosition(kick, event, box), color: theme.text, fontSize: 12, fontWeight: 600, textBorderColor: theme.field, textBorderWidth: 3},
      })),
    });
    option.tooltip.formatter = tipOf(option,
      (row, camera) => tip('Camera ' + camera + (row.used ? '' : ', outlier'), seconds(row), 'x ' + number(row.x, 3) + ' m, y ' + number(row.y, 3) + ' m'),
      ({event}) => event ? tip(event.name, number(event.t, 3) + ' s, x ' + number(event.x, 3) + ' m, y ' + number(event.y, 3) + ' m') : '');
    return option;
  }

  /** The fitted speed; from rest it jumps at the kick. */
  function speedLine(path) {
    const moving = path.t.map((t, i) => [t, path.speed[i]]).filter(([t]) => t >= 0);
    return path.t[0] < 0 ? [[path.t[0], 0], [0, 0], ...moving] : moving;
  }

  /** Speed over the ground over time. */
  function speed(theme, kick, beside = []) {
    const {cameras} = prepare(kick);
    const option = timeAxes(base(theme, 'time since the kick [s]', 'speed [m/s]'), kick, beside);
    const top = Math.max(0.1, ...[kick, ...beside].flatMap(one => [Math.hypot(one.vx, one.vy), ...one.fitted.speed])) * 1.1;
    option.yAxis.min = 0;
    option.yAxis.max = Math.ceil(top * 2) / 2;
    option.series.push(eventLines(theme, kick));
    for (const {camera, used} of cameras) {
      const style = theme.camera(camera);
      const rows = used.filter(row => known(row.speed) && row.t >= 0);
      option.series.push(points(style, camera, rows, row => [row.t, Math.max(0, Math.min(option.yAxis.max, row.speed))]));
    }
    option.series.push(...besideIt(theme, beside, one => speedLine(one.fitted)));
    option.series.push({type: 'line', data: speedLine(kick.fitted), symbol: 'none', silent: true, lineStyle: {color: theme.text, width: 2}, z: 5});
    option.tooltip.formatter = tipOf(option, (row, camera) => tip(number(row.speed, 3) + ' m/s, camera ' + camera, seconds(row), 'fitted ' + number(along(kick.fitted, 'speed', row.t), 3) + ' m/s'));
    return option;
  }

  /** Half the height of a residual plot: nearly all used observations, in round numbers. */
  function residualRange(cameras) {
    const sizes = cameras.flatMap(({used}) => used.flatMap(row => [Math.abs(row.along), Math.abs(row.across)])).filter(known).sort((a, b) => a - b);
    const wanted = Math.max(4, (sizes[Math.floor(sizes.length * 0.995)] || 0) * 1.15);
    return [4, 6, 8, 10, 15, 20, 30, 40, 60, 80, 100, 150, 200, 300].find(range => range >= wanted) || Math.ceil(wanted / 100) * 100;
  }

  /** The mean over the time around each observation; gaps where there is none, and at the kick. */
  function runningMean(used, column) {
    const mean = [];
    used.filter(row => known(row[column + 'Mean'])).forEach((row, i, all) => {
      if (i > 0 && (row.t - all[i - 1].t > 4 * HALF_WINDOW || (row.t >= 0) !== (all[i - 1].t >= 0))) mean.push([row.t, null]);
      mean.push([row.t, row[column + 'Mean']]);
    });
    return mean;
  }

  /** Residuals along or across the direction of travel; what is outside the plot stands at its edge. */
  function residual(theme, kick, column, noises, beside = []) {
    const {cameras} = prepare(kick);
    const range = residualRange(cameras);
    const option = timeAxes(base(theme, 'time since the kick [s]', column + ' [mm]'), kick, beside);
    Object.assign(option.yAxis, {min: -range, max: range, interval: range / 2});
    const noise = Math.max(0, ...cameras.map(({camera}) => noises[camera]).filter(known));
    option.series.push(Object.assign(eventLines(theme, kick), noise === 0 ? {} : {
      markArea: {silent: true, itemStyle: {color: theme.good, opacity: 0.14}, data: [[{yAxis: -2 * noise}, {yAxis: 2 * noise}]]},
    }));
    for (const {camera, used, outliers} of cameras) {
      const style = theme.camera(camera);
      const at = row => [row.t, Math.max(-range, Math.min(range, row[column]))];
      const add = (rows, look) => {
        const within = rows.filter(row => row[column] !== null && Math.abs(row[column]) <= range);
        const above = rows.filter(row => row[column] > range), below = rows.filter(row => row[column] < -range);
        option.series.push(points(style, camera, within, at, look));
        if (above.length) option.series.push(points(style, camera, above, at, Object.assign({}, look, {symbol: 'triangle', symbolOffset: [0, 5]})));
        if (below.length) option.series.push(points(style, camera, below, at, Object.assign({}, look, {symbol: 'triangle', symbolRotate: 180, symbolOffset: [0, -5]})));
      };
      add(used, {symbolSize: 4});
      add(outliers, {symbolSize: 8, itemStyle: {color: 'transparent', borderColor: style.colour, borderWidth: 1.5}, z: 4});
      option.series.push({type: 'line', ...packed(runningMean(used, column)), symbol: 'none', silent: true, lineStyle: {color: style.colour, width: 2}, z: 5});
    }
    option.series.push(...besideIt(theme, beside, one => prepare(one).cameras.flatMap(({used}) => [...runningMean(used, column), [null, null]])));
    option.tooltip.formatter = tipOf(option, (row, camera) => tip('Camera ' + camera + (row.used ? '' : ', outlier'), seconds(row), signed(row.along, 1) + ' mm along, ' + signed(row.across, 1) + ' mm across'));
    return option;
  }

  /** Height over time; the seen one is what the ray implies in the plane of the fitted path. */
  function height(theme, kick, beside = []) {
    const {cameras} = prepare(kick);
    const option = timeAxes(base(theme, 'time since the kick [s]', 'height [m]'), kick, beside);
    const top = Math.max(0.05, ...[kick, ...beside].flatMap(one => one.fitted.z)) * 1.15;
    option.yAxis.min = 0;
    option.yAxis.max = Math.ceil(top * 20) / 20;
    option.yAxis.axisLabel.showMaxLabel = false;
    option.series.push(eventLines(theme, kick));
    for (const {camera, used} of cameras) {
      const rows = used.filter(row => known(row.height) && row.t >= 0);
      option.series.push(points(theme.camera(camera), camera, rows, row => [row.t, Math.max(0, Math.min(option.yAxis.max, row.height))]));
    }
    option.series.push(...besideIt(theme, beside, one => one.fitted.t.map((t, i) => [t, one.fitted.z[i]])));
    option.series.push({type: 'line', data: kick.fitted.t.map((t, i) => [t, kick.fitted.z[i]]), symbol: 'none', silent: true, lineStyle: {color: theme.text, width: 2}, areaStyle: {color: theme.text, opacity: 0.06}, z: 5});
    option.tooltip.formatter = tipOf(option, (row, camera) => tip(number(row.height * 1000, 0) + ' mm high, camera ' + camera, seconds(row), 'fitted ' + number(along(kick.fitted, 'z', row.t) * 1000, 0) + ' mm'));
    return option;
  }

  return {
    AXES, along, inFiles, asPublished, kickSpeed, kickDirection, endWords, robotName, isUsed, sigmas, prepare, parameter, path, speed, residual, height,
  };
})();
