/* The page for giving the model away: what changes against the published one, files, packets, text for a configuration. */
import {exportPart} from './export.js';
import {FORMATS, button, confirmed, field, progress, renew, table} from './parts.js';
import {sessionsPart} from './sessions.js';

const {el, known, number, signed} = Charts;
const {$, content, choices, badge} = Frame;
const FORMS = {text: 'protobuf text', properties: 'properties', java: 'Java'};
const FILES = [
  ['report.html', 'Report', 'the whole calibration on one page: every kick, what was dropped and why'],
  ['calibration.json', 'calibration.json', 'all numbers, for scripts'],
  ['geometry_models.pb', 'geometry_models.pb', 'SSL_GeometryModels, binary'],
  ['geometry_models.txt', 'geometry_models.txt', 'the same as text'],
  ['selection.json', 'selection.json', 'the decisions about kicks, as calibrate reads them'],
];

export function publishPage(app) {
  const page = {id: 'publish', title: 'Publish', show, keys: {}, keyWords: []};
  const view = {form: 'text', address: '', port: '', format: 'wrapper', built: null, vision: '224.5.23.2:10006', seconds: 10, written: ''};

  const state = () => app.state;
  const report = () => state().calibration.report;
  const complete = () => state().model.flat || state().model.chip;

  const forPrograms = exportPart(app), otherSession = sessionsPart(app);

  function show() {
    const theme = app.colours();
    CalibrationViews.verdict($('verdict'), report().verdict, report().warnings);
    content('model').replaceChildren(...CalibrationViews.model(report()));
    content('cameras').replaceChildren(CalibrationViews.cameras(theme, report()));
    showVision();
    showSend();
    showFiles();
    showSnippet();
    forPrograms.show();
    otherSession.show();
  }

  // ---- what vision publishes at the moment ----

  const heard = () => state().vision.heard || null;
  /** When it was heard, by this machine's clock. */
  let heardAt = 0;

  function showVision() {
    const {running, failure} = state().vision, last = heard();
    if (last) heardAt = Date.now() - 1000 * last.age;
    renew($('vision-form'), running, () => running ? [progress(0, 0), el('span', {}, 'listening to ' + view.vision + ' …'), button('Stop listening', () => app.run('vision/end'), {id: 'vision-end'})] : [
      field('Address', el('input', {id: 'vision-place', value: view.vision, required: '', size: 17, maxlength: 200, oninput: event => { view.vision = event.target.value; }})),
      field('for', el('input', {id: 'vision-seconds', type: 'number', min: 1, max: 120, value: view.seconds, style: 'width: 4.5em', oninput: event => { view.seconds = Number(event.target.value); }})), el('span', {}, 's at most'),
      el('button', {type: 'submit', id: 'vision-listen', class: last ? null : 'strong'}, last ? 'Listen again' : 'Listen')]);
    $('vision-form').onsubmit = event => { event.preventDefault(); app.run('vision', {vision: view.vision, seconds: view.seconds}); };
    const rows = [];
    if (failure) rows.push(el('p', {class: 'notice bad'}, failure));
    if (!last) rows.push(el('p', {class: 'note', id: 'vision-unknown'}, 'Not known yet. Listen before you publish: somebody may have changed the model or the cameras since the recordings.'));
    else {
      if (last.lacks) rows.push(el('p', {class: 'notice warn', id: 'vision-lacks'}, last.lacks));
      rows.push(...last.differences.map(words => el('p', {class: 'notice bad vision-difference'}, '⚠ ' + words)), ...last.notes.map(words => el('p', {class: 'note'}, words)));
      if (!last.lacks) rows.push(changes(true));
      rows.push(el('p', {class: 'note'}, last.geometry ? 'Heard ' : 'Listened ', el('span', {id: 'vision-age'}, age()), ' at ' + last.place + (last.senders.length ? ', sent by ' + last.senders.join(', ') : '') + '.' + (last.geometry && !last.differences.length && state().model.geometry ? ' Field and cameras are those of the recordings.' : '')));
    }
    content('vision').replaceChildren(...rows);
  }

  function age() {
    const seconds = Math.max(0, (Date.now() - heardAt) / 1000);
    return seconds < 90 ? Math.round(seconds) + ' s ago' : seconds < 5400 ? Math.round(seconds / 60) + ' min ago' : Math.round(seconds / 3600) + ' h ago';
  }
  setInterval(() => { if ($('vision-age')) $('vision-age').textContent = age(); }, 1000);

  /** The parameters of the models that are complete. */
  const sent = () => report().models.filter(model => state().model[model.kind.toLowerCase()]).flatMap(model => model.parameters);

  /** How far the new value is from another one. */
  function change(p, from) {
    if (!known(from)) return badge('warn', 'new');
    const percent = from === 0 ? NaN : (p.mean / from - 1) * 100, same = Math.abs(p.mean - from) < 5e-6;
    return same ? badge('good', '= the same') : badge(Math.abs(percent) >= 20 ? 'bad' : Math.abs(percent) >= 3 ? 'warn' : 'good', known(percent) ? signed(percent, Math.abs(percent) < 9.95 ? 1 : 0) + ' %' : '–');
  }

  /** The new model beside what vision publishes now and what the recordings, or the operator's file, say. */
  function changes(short) {
    const now = heard() && heard().geometry ? heard().values : null, before = state().model.compared;
    const rows = sent().map(p => el('tr', {'data-parameter': p.name}, el('td', {class: 'text name'}, p.words, p.unit ? el('small', {}, ' ' + p.unit) : ''), ...(short ? [] : [el('td', {}, Plots.asPublished(p.published))]),
      ...(now ? [el('td', {}, Plots.asPublished(now[p.name]))] : []), el('td', {class: 'big'}, number(p.mean, 5)), el('td', {}, change(p, now ? now[p.name] : p.published))));
    return table([['Parameter', true], ...(short ? [] : [[before === 'file' ? 'In your file' : 'In the recordings', false, before === 'file' ? 'the model that the console was started with' : 'what vision published in the recordings']]), ...(now ? [['Vision now', false, 'what vision publishes at this moment']] : []), ['New'], ['Change', false, now ? 'against what vision publishes now' : 'against the published one']], rows);
  }

  function showSend() {
    const geometry = Boolean(state().model.geometry || (heard() && heard().geometry));
    // What somebody is typing is not replaced under their hands.
    if (view.built !== geometry) buildSend(geometry);
    view.built = geometry;
    const ready = complete() && state().settled;
    $('send-button').disabled = !ready;
    $('send-note').textContent = !complete() ? 'There is no complete model: record more kicks.' : !state().settled ? 'The joint fit is being refined after the last decision …'
      : missing() ? missing() : '';
    const {running, to, text, everySeconds, failure} = state().sending;
    renew($('sending'), [running, to, failure, text === state().model.text], () => running ? [el('p', {class: 'bar'}, Frame.badge('good', '● sending'), (text === state().model.text ? 'This model' : 'An earlier model') + ' is sent to ' + to + (everySeconds === 1 ? ' every second' : ' every ' + everySeconds + ' s') + ', as vision repeats it, until you stop it or the console ends.', button('Stop sending', () => app.run('publish/end'), {id: 'send-end'}))]
      : failure ? [el('p', {class: 'notice bad'}, 'Sending stopped: ' + failure)] : []);
    const rows = state().published.map(p => el('tr', {}, el('td', {class: 'text wrap'}, new Date(p.unix * 1000).toISOString().slice(0, 19).replace('T', ' ')), el('td', {class: 'text'}, p.to), el('td', {class: 'text wrap'}, FORMATS[p.format] || p.format), el('td', {class: 'text wrap', title: p.text}, p.text === state().model.text ? 'this model' : 'another model')));
    $('published').replaceChildren(rows.length ? table(['Sent (UTC)', 'To', 'As', 'What'].map(head => [head, true]), rows) : el('p', {class: 'note'}, 'Nothing has been sent yet.'));
  }

  const missing = () => !state().model.flat ? 'Only the chip model is complete; the flat one is not sent.' : !state().model.chip ? 'Only the flat model is complete; the chip one is not sent.' : '';

  function buildSend(geometry) {
    const keep = name => event => { view[name] = event.target.value; };
    if (!geometry) view.format = 'models';
    content('send').replaceChildren(
      el('form', {id: 'send-form', onsubmit: event => { event.preventDefault(); send(); }},
        el('label', {}, 'Address ', el('input', {id: 'send-address', value: view.address, required: '', maxlength: 200, placeholder: '224.5.23.2', oninput: keep('address')})),
        el('label', {}, 'Port ', el('input', {id: 'send-port', value: view.port, required: '', inputmode: 'numeric', pattern: '[0-9]{1,5}', size: 6, placeholder: '10006', oninput: keep('port')})),
        el('fieldset', {}, el('legend', {}, 'As'), Object.entries(FORMATS).map(([key, words]) => el('label', {}, el('input', {
          type: 'radio', name: 'format', value: key, checked: key === view.format ? '' : null, disabled: key === 'wrapper' && !geometry ? '' : null, onchange: keep('format'),
        }), ' ' + words))),
        el('button', {type: 'submit', id: 'send-button', class: 'strong'}, 'Send …'), el('span', {class: 'note', id: 'send-note'})),
      el('div', {id: 'sending', 'aria-live': 'polite'}), el('div', {id: 'published'}));
  }

  async function send() {
    const text = state().model.text;
    const {verdict} = report(), against = verdict.decision !== 'publish';
    const sure = await confirmed('Send this model to ' + view.address + ':' + view.port + '?', [
      el('p', {class: 'bar'}, CalibrationViews.decisionBadge(verdict), verdict.toDo.join(' ')), ...verdict.reasons.map(words => el('p', {class: 'notice ' + (verdict.decision === 'do_not_publish' ? 'bad' : 'warn')}, words)),
      changes(false), ...(heard() && heard().geometry ? [] : [el('p', {class: 'notice warn'}, 'What vision publishes now is not known: listen to it first.')]),
      ...(heard() ? heard().differences : []).map(words => el('p', {class: 'notice bad'}, '⚠ ' + words)), ...report().warnings.map(warning => el('p', {class: 'notice warn'}, '⚠ ' + warning)),
      el('p', {}, 'The model is sent as ' + FORMATS[view.format] + '.' + (view.format === 'wrapper' ? ' Its geometry is that of ' + (heard() && heard().geometry ? 'vision, heard ' + age() : 'the recordings') + '.' : '') + ' It is sent again every second until you stop it, and everybody who listens there uses it. SSL-Vision does not change: enter the numbers there, or its own packets go on with the old model.')], against ? 'Send anyway' : 'Send');
    if (sure) await app.run('publish', {address: view.address, port: Number(view.port), format: view.format, confirmed: text});
  }

  function showFiles() {
    const rows = FILES.filter(([name]) => complete() || !name.startsWith('geometry_models')).map(([name, title, what]) => el('tr', {},
      el('td', {class: 'text'}, name.endsWith('.html') ? el('a', {href: '/files/' + name, target: '_blank', rel: 'noopener'}, title) : el('a', {href: '/files/' + name, download: name}, title)),
      el('td', {class: 'text wrap'}, what)));
    renew(content('files'), [complete(), state().settled, state().directory, view.written], () => [el('table', {}, el('tbody', {}, rows)),
      el('div', {class: 'bar'}, button('Write all files into the session', write, {id: 'write-results', disabled: !state().settled})),
      el('p', {class: 'note'}, state().directory + (view.written ? ' · written at ' + view.written : ''))]);
  }

  async function write() {
    if (!await app.run('results')) return;
    view.written = new Date().toTimeString().slice(0, 8);
    showFiles();
  }

  $('snippet-copy').replaceWith(Object.assign(Frame.copyButton(() => $('snippet').textContent, 'the text'), {id: 'snippet-copy'}));

  function showSnippet() {
    choices('snippet-kind', Object.entries(FORMS), view.form, key => { view.form = key; showSnippet(); });
    $('snippet').textContent = state().model[view.form] || 'No complete model.';
  }

  return page;
}
