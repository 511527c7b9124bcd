/* A kick once more, as it went: the ball on the drawing of its path, and the same moment in all other plots. */
import {button, refill, select} from './parts.js';

const {el, number} = Charts;
const {charts} = Frame;
const RATES = [['1', 'real time'], ['0.25', '¼ × real time'], ['0.1', '⅒ × real time']];
/** Steps of the slider, s. */
const STEP = 0.01;

export function replayPart(bar, places) {
  let kick = null, now = 0, rate = 1, since = null;
  const playing = () => since !== null;

  function show(next) {
    const same = kick && kick.id === next.id;
    kick = next;
    bar.hidden = kick.fitted.t.length === 0;
    if (same) return void (places.querySelector('.ball') && move(now));
    since = null;
    const {start, end} = Plots.prepare(kick);
    now = end;
    refill(bar, button('▶ Replay', toggle, {id: 'replay', key: 'p'}), select('replay-rate', RATES, String(rate), value => { rate = Number(value); }),
      el('input', {type: 'range', id: 'replay-time', min: start, max: end, step: STEP, value: end, 'aria-label': 'time since the kick, s', oninput: event => { pause(); move(Number(event.target.value)); }}), el('output', {id: 'replay-words', for: 'replay-time'}));
    for (const mark of places.querySelectorAll('.moment, .ball')) mark.remove();
  }

  function toggle() {
    if (!kick || bar.hidden) return;
    if (playing()) return void pause();
    if (now >= Plots.prepare(kick).end) now = Plots.prepare(kick).start;
    since = performance.now();
    label();
    requestAnimationFrame(frame);
  }

  function pause() {
    since = null;
    label();
  }

  function label() {
    const node = document.getElementById('replay');
    if (node) node.textContent = playing() ? '❙❙ Pause' : '▶ Replay';
  }

  function frame(at) {
    if (!playing()) return;
    const end = Plots.prepare(kick).end, next = Math.min(end, now + rate * Math.max(0, at - since) / 1000);
    since = at;
    move(next);
    if (next >= end) pause();
    else requestAnimationFrame(frame);
  }

  /** Shows the moment t in every plot. */
  function move(t) {
    now = t;
    const path = kick.fitted, of = column => t < 0 && column === 'speed' ? 0 : Plots.along(path, column, t), high = kick.kind === 'CHIP';
    document.getElementById('replay-time').value = t;
    document.getElementById('replay-words').textContent = number(t, 2) + ' s · ' + number(of('speed'), 2) + ' m/s' + (high ? ' · ' + number(of('z') * 1000, 0) + ' mm high' : '');
    for (const place of places.querySelectorAll('[data-plot]')) {
      const chart = charts.get(place);
      if (!chart) continue;
      const onField = place.dataset.plot === 'path';
      const [x, y] = chart.convertToPixel({xAxisIndex: 0, yAxisIndex: 0}, onField ? [of('x'), of('y')] : [t, 0]);
      const mark = place.querySelector('.ball, .moment') || place.appendChild(el('div', {class: onField ? 'ball' : 'moment'}));
      mark.style.left = x + 'px';
      if (onField) mark.style.top = y + 'px';
    }
  }

  return {show, toggle};
}
