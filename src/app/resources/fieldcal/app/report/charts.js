/*
 * What all reports draw with: elements and numbers, colours, axes, the field. Knows ECharts and no report. Tooltips are DOM nodes with text content:
 * nothing from a recording is ever read as markup.
 */
const Charts = (() => {
  'use strict';

  const SYMBOLS = ['circle', 'triangle', 'rect', 'diamond', 'circle', 'triangle', 'rect', 'diamond'];

  // ---- words and numbers ----

  /** An element with attributes and children; strings become text. */
  function el(tag, attributes, ...children) {
    const node = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes || {})) {
      if (name.startsWith('on')) node.addEventListener(name.slice(2), value);
      else if (value !== null && value !== undefined && value !== false) node.setAttribute(name, value);
    }
    node.append(...children.flat().filter(child => child !== null && child !== undefined && child !== ''));
    return node;
  }

  const known = value => typeof value === 'number' && isFinite(value);

  /** A number with a true minus sign; a dash when unknown. */
  function number(value, decimals) {
    if (!known(value)) return '–';
    const text = value.toFixed(decimals).replace('-', '−');
    return /^−0(\.0*)?$/.test(text) ? text.slice(1) : text;
  }

  const signed = (value, decimals) => (value > 0 ? '+' : '') + number(value, decimals);

  /** Decimals that show an error as physicists do: with two digits when it begins with 1 to 3, else with one. */
  function decimals(error, fallback = 3) {
    if (!known(error) || error <= 0) return fallback;
    const places = -Math.floor(Math.log10(error));
    return Math.max(0, Math.min(5, error * Math.pow(10, places) < 3.55 ? places + 1 : places));
  }

  function withError(value, error, unit) {
    if (!known(value)) return '–';
    const digits = decimals(error);
    return number(value, digits) + (known(error) ? ' ± ' + number(error, digits) : '') + (unit ? ' ' + unit : '');
  }

  /** Last part of a path, for places where all of it is too long. */
  const fileName = path => path.split(/[\\/]/).pop() || path;

  const tip = (title, ...lines) => el('div', {class: 'tip'}, el('b', {}, title), lines.filter(Boolean).map(line => el('div', {}, line)));

  // ---- theme ----

  /** Colours of the page as it is now; cameras keep their colour and symbol on all plots. */
  function theme(cameraIds) {
    const style = getComputedStyle(document.documentElement);
    const colour = name => style.getPropertyValue('--' + name).trim();
    return {
      text: colour('text'), muted: colour('muted'), line: colour('line'), soft: colour('soft'), panel: colour('panel'),
      accent: colour('accent'), good: colour('good'), warn: colour('warn'), bad: colour('bad'),
      field: colour('field'), fieldLine: colour('field-line'),
      camera(id) {
        const index = Math.max(0, cameraIds.indexOf(id)) % SYMBOLS.length;
        return {colour: colour('camera-' + index), symbol: SYMBOLS[index]};
      },
    };
  }

  function axis(theme, name, more) {
    return Object.assign({
      type: 'value', name, nameLocation: 'middle', nameGap: 26, scale: true,
      nameTextStyle: {color: theme.muted, fontSize: 13},
      axisLabel: {color: theme.text, fontSize: 13, hideOverlap: true, formatter: value => String(+value.toFixed(6)).replace('-', '−')},
      axisLine: {show: true, onZero: false, lineStyle: {color: theme.line}},
      axisTick: {lineStyle: {color: theme.line}},
      splitLine: {lineStyle: {color: theme.soft}},
    }, more);
  }

  function base(theme, xName, yName) {
    return {
      animation: false,
      textStyle: {color: theme.text, fontFamily: 'system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif', fontSize: 13},
      grid: {left: 62, right: 14, top: 12, bottom: 42},
      tooltip: {
        trigger: 'item', confine: true, backgroundColor: theme.panel, borderColor: theme.line, padding: [6, 10],
        textStyle: {color: theme.text}, transitionDuration: 0, extraCssText: 'max-width: 360px;',
      },
      xAxis: axis(theme, xName),
      yAxis: axis(theme, yName, {nameGap: 46}),
      series: [],
    };
  }

  // ---- the field ----

  /** The field's lines as one polyline with gaps. */
  function fieldLines(field) {
    const l = field.length / 2, w = field.width / 2, lines = [];
    const draw = (...corners) => lines.push(...corners, [null, null]);
    draw([-l, -w], [l, -w], [l, w], [-l, w], [-l, -w]);
    draw([0, -w], [0, w]);
    draw([-l, 0], [l, 0]);
    for (const side of [-1, 1]) {
      const {penaltyAreaDepth: depth, penaltyAreaWidth: width, goalWidth, goalDepth} = field;
      if (known(depth) && known(width)) draw([side * l, -width / 2], [side * (l - depth), -width / 2], [side * (l - depth), width / 2], [side * l, width / 2]);
      if (known(goalWidth) && known(goalDepth)) draw([side * l, -goalWidth / 2], [side * (l + goalDepth), -goalWidth / 2], [side * (l + goalDepth), goalWidth / 2], [side * l, goalWidth / 2]);
    }
    if (known(field.centreCircleRadius)) {
      draw(...Array.from({length: 61}, (_, i) => [field.centreCircleRadius * Math.cos(i * Math.PI / 30), field.centreCircleRadius * Math.sin(i * Math.PI / 30)]));
    }
    return lines;
  }

  /** What to draw of the field: all of it, or without geometry whatever these places need. */
  function extent(field, x, y) {
    if (field) {
      const border = Math.max(known(field.boundary) ? field.boundary : 0, known(field.goalDepth) ? field.goalDepth : 0) + 0.05;
      return {x0: -field.length / 2 - border, x1: field.length / 2 + border, y0: -field.width / 2 - border, y1: field.width / 2 + border};
    }
    const xs = x.filter(known), ys = y.filter(known);
    return {x0: Math.min(...xs) - 0.3, x1: Math.max(...xs) + 0.3, y0: Math.min(...ys) - 0.3, y1: Math.max(...ys) + 0.3};
  }

  /** The field with its lines, true to scale in a box of the given size in pixels; ctrl and the wheel zoom. */
  function fieldView(theme, field, box, size) {
    const option = base(theme, '', '');
    const room = {left: 34, right: 8, top: 6, bottom: 24};
    const scale = Math.min((size.width - room.left - room.right) / (box.x1 - box.x0), (size.height - room.top - room.bottom) / (box.y1 - box.y0));
    const width = (box.x1 - box.x0) * scale, height = (box.y1 - box.y0) * scale;
    option.grid = {left: room.left + (size.width - room.left - room.right - width) / 2, top: room.top, width, height, show: true, backgroundColor: theme.field, borderWidth: 0};
    const plain = (min, max) => axis(theme, '', {
      min, max, splitLine: {show: false}, axisLine: {show: false}, axisTick: {show: false},
      axisLabel: {color: theme.muted, fontSize: 12, showMinLabel: false, showMaxLabel: false, formatter: value => number(value, 0) + (value === 0 ? ' m' : '')},
      minInterval: 1,
    });
    option.xAxis = plain(box.x0, box.x1);
    option.yAxis = plain(box.y0, box.y1);
    option.dataZoom = ['xAxisIndex', 'yAxisIndex'].map(which => ({type: 'inside', [which]: 0, zoomOnMouseWheel: 'ctrl', moveOnMouseWheel: false, filterMode: 'none'}));
    option.series.push({type: 'line', data: field ? fieldLines(field) : [], symbol: 'none', silent: true, lineStyle: {color: theme.fieldLine, width: 2}, z: 1});
    return option;
  }

  return {el, known, number, signed, decimals, withError, fileName, tip, theme, axis, base, extent, fieldView};
})();
