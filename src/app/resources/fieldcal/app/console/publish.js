/* The page for giving the model away: what changes against the published one, files, packets, text for a configuration. */
import {button, confirmed} from './parts.js';

const {el, number} = Charts;
const {$, content, choices} = Frame;
const FORMS = {text: 'protobuf text', properties: 'properties', java: 'Java'};
const FORMATS = {wrapper: 'SSL_WrapperPacket with the geometry, as vision sends it', models: 'SSL_GeometryModels alone'};
const FILES = [
  ['report.html', 'Report', 'the whole calibration on one page: every kick, what was dropped and why'],
  ['calibration.json', 'calibration.json', 'all numbers, for scripts'],
  ['geometry_models.pb', 'geometry_models.pb', 'SSL_GeometryModels, binary'],
  ['geometry_models.txt', 'geometry_models.txt', 'the same as text'],
  ['selection.json', 'selection.json', 'the decisions about kicks, as calibrate reads them'],
];

export function publishPage(app) {
  const page = {id: 'publish', title: 'Publish', show, keys: {}, keyWords: []};
  const view = {form: 'text', address: '', port: '', format: 'wrapper', built: false};

  const state = () => app.state;
  const report = () => state().calibration.report;
  const complete = () => state().model.flat || state().model.chip;

  function show() {
    const theme = app.colours();
    CalibrationViews.verdict($('verdict'), state().calibration.verdict, report().warnings);
    content('model').replaceChildren(...CalibrationViews.model(report()));
    content('cameras').replaceChildren(CalibrationViews.cameras(theme, report()));
    showSend();
    showFiles();
    showSnippet();
  }

  function showSend() {
    // What somebody is typing is not replaced under their hands.
    if (!view.built) buildSend();
    view.built = true;
    const ready = complete() && state().settled;
    $('send-button').disabled = !ready;
    $('send-note').textContent = !complete() ? 'There is no complete model: record more kicks.' : !state().settled ? 'The joint fit is being refined after the last decision …'
      : missing() ? missing() : '';
    const rows = state().published.map(p => el('tr', {}, el('td', {class: 'text'}, new Date(p.unix * 1000).toISOString().slice(0, 19).replace('T', ' ')), el('td', {class: 'text'}, p.to), el('td', {class: 'text'}, p.format), el('td', {class: 'text', title: p.text}, p.text === state().model.text ? 'this model' : 'another model')));
    $('published').replaceChildren(rows.length ? el('table', {}, el('thead', {}, el('tr', {}, ['Sent (UTC)', 'To', 'As', 'What'].map(h => el('th', {scope: 'col', class: 'text'}, h)))), el('tbody', {}, rows)) : el('p', {class: 'note'}, 'Nothing was sent yet.'));
  }

  const missing = () => !state().model.flat ? 'Only the chip model is complete; the flat one is not sent.' : !state().model.chip ? 'Only the flat model is complete; the chip one is not sent.' : '';

  function buildSend() {
    const keep = name => event => { view[name] = event.target.value; };
    if (!state().model.geometry) view.format = 'models';
    content('send').replaceChildren(
      el('form', {id: 'send-form', onsubmit: event => { event.preventDefault(); send(); }},
        el('label', {}, 'Address ', el('input', {id: 'send-address', required: '', maxlength: 200, placeholder: '224.5.23.2', oninput: keep('address')})),
        el('label', {}, 'Port ', el('input', {id: 'send-port', required: '', inputmode: 'numeric', pattern: '[0-9]{1,5}', size: 6, placeholder: '10006', oninput: keep('port')})),
        el('fieldset', {}, el('legend', {}, 'As'), Object.entries(FORMATS).map(([key, words]) => el('label', {}, el('input', {
          type: 'radio', name: 'format', value: key, checked: key === view.format ? '' : null, disabled: key === 'wrapper' && !state().model.geometry ? '' : null, onchange: keep('format'),
        }), ' ' + words))),
        el('button', {type: 'submit', id: 'send-button', class: 'strong'}, 'Send …'), el('span', {class: 'note', id: 'send-note'})),
      el('div', {id: 'published'}));
  }

  async function send() {
    const text = state().model.text;
    const sure = await confirmed('Send this model to ' + view.address + ':' + view.port + '?', [
      difference(), ...report().warnings.map(warning => el('p', {class: 'notice warn'}, '⚠ ' + warning)),
      el('p', {}, 'As ' + FORMATS[view.format] + '. Who listens there plays with it from now on.')], 'Send');
    if (sure) await app.run('publish', {address: view.address, port: Number(view.port), format: view.format, confirmed: text});
  }

  /** Old and new, and what changes; only what is sent. */
  function difference() {
    const sent = report().models.filter(model => state().model[model.kind.toLowerCase()]);
    const rows = sent.flatMap(model => model.parameters.map(p => el('tr', {}, el('td', {class: 'text'}, p.name, p.unit ? el('small', {}, ' ' + p.unit) : ''), el('td', {}, Plots.asPublished(p.published)), el('td', {class: 'big'}, number(p.mean, 5)), el('td', {}, CalibrationViews.difference(p)))));
    return el('table', {}, el('thead', {}, el('tr', {}, ['Parameter', 'Published', 'New', 'Change'].map((h, i) => el('th', {scope: 'col', class: i ? null : 'text'}, h)))), el('tbody', {}, rows));
  }

  function showFiles() {
    const rows = FILES.filter(([name]) => complete() || !name.startsWith('geometry_models')).map(([name, title, what]) => el('tr', {},
      el('td', {class: 'text'}, name.endsWith('.html') ? el('a', {href: '/files/' + name, target: '_blank', rel: 'noopener'}, title) : el('a', {href: '/files/' + name, download: name}, title)),
      el('td', {class: 'text wrap'}, what)));
    content('files').replaceChildren(el('table', {}, el('tbody', {}, rows)),
      el('div', {class: 'bar'}, button('Write all files into the session', () => app.run('results'), {id: 'write-results', disabled: !state().settled})),
      el('p', {class: 'note'}, state().directory));
  }

  function showSnippet() {
    choices('snippet-kind', Object.entries(FORMS), view.form, key => { view.form = key; showSnippet(); });
    $('snippet').textContent = state().model[view.form] || 'No complete model.';
  }

  return page;
}
