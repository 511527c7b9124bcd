/* This session beside another one: the calibration.json of that session, parameter by parameter. */
import {table} from './parts.js';

const {el, known, number, signed, withError} = Charts;
const {content, badge} = Frame;
const SCHEMA = 'fieldcal.calibration/';
/** From so many combined standard errors on, two sessions differ. */
const CERTAIN = 3;

export function sessionsPart(app) {
  const view = {name: '', other: null, failure: ''};
  let result = null;

  function show() {
    const box = content('sessions');
    if (!result) {
      result = el('div', {'aria-live': 'polite'});
      const file = el('input', {type: 'file', id: 'sessions-file', accept: '.json', onchange: event => read(event.target.files[0])});
      box.replaceChildren(el('p', {}, el('label', {}, 'calibration.json of the other session ', file)), el('p', {class: 'note'}, 'Shows whether two fields, two days or two balls differ by more than chance. The file stays in this browser.'), result);
    }
    showResult();
  }

  async function read(file) {
    if (!file) return;
    Object.assign(view, {name: file.name, other: null, failure: ''});
    try {
      const other = JSON.parse(await file.text());
      if (typeof other.schema !== 'string' || !other.schema.startsWith(SCHEMA)) throw new Error('it has no schema ' + SCHEMA);
      view.other = other;
    } catch (wrong) {
      view.failure = file.name + ' is not a calibration of fieldcal: ' + wrong.message;
    }
    showResult();
  }

  function showResult() {
    if (view.failure) return void result.replaceChildren(el('p', {class: 'notice bad'}, view.failure));
    if (!view.other) return void result.replaceChildren();
    const rows = app.state.calibration.report.models.flatMap(model => model.parameters.map(p => row(p, (view.other[model.kind.toLowerCase()] || {})[Plots.inFiles(p.name)] || {})));
    const from = (view.other.sources || []).map(Charts.fileName).join(', ');
    result.replaceChildren(el('p', {}, view.name + (from ? ': ' + from : '')),
      el('div', {class: 'scroll'}, table([['Parameter', true], ['This session'], ['n'], ['The other'], ['n'], ['Difference'], ['', true]], rows)));
  }

  function row(p, other) {
    const difference = p.mean - other.mean, error = Math.hypot(p.standardError, other.standard_error);
    const words = !known(other.mean) ? badge('warn', 'not in the other') : !(error > 0) ? '' : Math.abs(difference) > CERTAIN * error ? badge('warn', 'they differ: ' + number(Math.abs(difference) / error, 1) + ' standard errors')
      : badge('good', 'they agree: ' + number(Math.abs(difference) / error, 1) + ' standard errors');
    return el('tr', {'data-parameter': p.name}, el('td', {class: 'text wrap'}, p.words, p.unit ? el('small', {}, ' ' + p.unit) : ''), el('td', {class: 'big'}, withError(p.mean, p.standardError)), el('td', {}, p.n),
      el('td', {class: 'big'}, withError(other.mean, other.standard_error)), el('td', {}, known(other.n) ? other.n : '–'), el('td', {}, known(difference) && other.mean ? signed(100 * difference / other.mean, 1) + ' %' : '–'), el('td', {class: 'text'}, words));
  }

  return {show};
}
