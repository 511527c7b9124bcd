/* The part of the publish page that gives the model away in the form of other programs, and the history of what left the session. */
import {FORMATS, button, confirmed, field, renew, select, shown, table} from './parts.js';
import {act} from './server.js';

const {el, known, number, signed} = Charts;
const {$, content} = Frame;

/** The parameters in the order in which everybody names them. */
const ORDER = ['acc_slide', 'acc_roll', 'k_switch', 'damping_xy_first_hop', 'damping_xy_other_hops', 'damping_z'];
const DONE = {PUBLISHED: 'sent', EXPORTED: 'exported', APPLIED: 'written', ROLLED_BACK: 'put back'};
/** What was sent has the name that the page Publish gives it; other targets have their own. */
const sentAs = target => FORMATS[target.replace(/^packet:/, '')] || target;
const when = unix => new Date(unix * 1000).toISOString().slice(0, 19).replace('T', ' ');

/** Bytes and base 64: a file must come back as it went, whatever its characters are. */
const toBase64 = bytes => { let text = ''; for (const byte of bytes) text += String.fromCharCode(byte); return btoa(text); };
const fromBase64 = text => Uint8Array.from(atob(text), c => c.charCodeAt(0));

export function exportPart(app) {
  const view = {target: 'ssl-vision-processor', team: '', entry: '', url: '', base: null, from: null, built: null, failure: '', compared: [null, null]};
  const state = () => app.state;
  const target = () => state().targets.find(t => t.name === view.target);

  function show() {
    showExport();
    showHistory();
  }

  function showExport() {
    const ready = (state().model.flat || state().model.chip) && state().settled;
    renew(content('export'), [view.target, view.from, ready, view.failure, state().targets.length], build);
  }

  function build() {
    const t = target(), keep = name => event => { view[name] = event.target.value; };
    const from = view.from ? el('p', {class: 'notice warn'}, 'Exports the model of entry ' + view.from + ' of the history. ', button('Take the current model', () => { view.from = null; show(); })) : '';
    return [el('form', {id: 'export-form', onsubmit: event => { event.preventDefault(); exported(); }},
      el('p', {}, field('To', select('export-target', state().targets.map(x => [x.name, x.name]), view.target, name => { Object.assign(view, {target: name, failure: ''}); showExport(); })), ' ', el('span', {class: 'note'}, t.title)), from,
      el('p', {}, el('label', {}, 'Your current ' + t.file + ' ', el('input', {type: 'file', id: 'export-base', onchange: event => { view.base = event.target.files[0] || null; }})),
      el('br'), el('span', {class: 'note'}, 'Only the exported values change in it. Without it you get a new file.')),
      t.entry ? el('label', {}, 'Entry ', el('input', {id: 'export-entry', value: view.entry, maxlength: 200, title: t.entry, oninput: keep('entry')})) : '',
      el('div', {class: 'bar'}, el('button', {type: 'submit', id: 'export-button', class: 'strong', disabled: ready() ? null : ''}, 'Export …'))),
    t.live ? el('form', {id: 'apply-form', onsubmit: event => { event.preventDefault(); apply(); }},
      field('Or write into the running vision at', el('input', {id: 'apply-url', value: view.url, required: '', maxlength: 200, placeholder: 'http://192.168.0.10:8085', oninput: keep('url')})), ' ',
      el('button', {type: 'submit', id: 'apply-button', disabled: ready() ? null : ''}, 'Show the difference …')) : '',
    el('p', {class: 'notice bad', id: 'export-failure', role: 'alert', hidden: view.failure ? null : ''}, view.failure)];
  }

  const ready = () => (state().model.flat || state().model.chip) && state().settled;

  const body = more => Object.assign({target: view.target, entry: view.entry, team: view.team}, view.from ? {from: view.from} : {}, more);

  async function asked(what, more) {
    view.failure = '';
    try {
      return await act(what, body(more));
    } catch (failure) {
      view.failure = failure.message;
      return null;
    } finally {
      showExport();
    }
  }

  const explained = answer => [
    ...(answer.verdict ? [el('p', {class: 'notice warn'}, answer.verdict)] : []),
    el('pre', {class: 'changes'}, answer.changes.join('\n')), el('ul', {}, answer.notes.map(note => el('li', {}, note)))];

  async function exported() {
    const file = view.base, more = file ? {base: toBase64(new Uint8Array(await file.arrayBuffer())), baseName: file.name} : {};
    const answer = await asked('export', more);
    if (!answer) return;
    const name = answer.file.split('/').pop().split(' ')[0];
    const link = el('a', {href: URL.createObjectURL(new Blob([fromBase64(answer.bytes)])), download: name, id: 'export-file'}, 'Save ' + name);
    shown('The model for ' + view.target, [...explained(answer), el('p', {}, link)]);
  }

  async function apply() {
    const url = view.url.trim(), answer = await asked('export/difference', {url});
    if (answer && await confirmed('Write this into ' + url + ' and save it?', explained(answer), 'Write')) await app.run('export/apply', body({url}));
  }

  function showHistory() {
    const all = state().history, parts = [];
    const rows = all.map(e => el('tr', {'data-entry': e.id}, el('td', {class: 'text'}, e.id), el('td', {class: 'text'}, when(e.unix)), el('td', {class: 'text'}, DONE[e.action]), el('td', {class: 'text wrap', title: e.place}, sentAs(e.target)),
      el('td', {class: 'text wrap'}, e.place), el('td', {class: 'text'}, e.verdict ? e.verdict.replaceAll('_', ' ') : '–'), el('td', {title: 'kicks ' + e.kicks.join(', ') + ' of ' + e.sources.join(', ')}, e.kicks.length || '–'),
      el('td', {class: 'text'}, ...actions(e))));
    if (!all.length) parts.push(el('p', {class: 'note'}, 'No model has been sent or exported yet.'));
    else {
      parts.push(table([['No.', true], ['When (UTC)', true], ['What', true], ['As', true], ['Where', true], ['Verdict', true], ['Kicks'], ['', true]], rows, {id: 'history-table'}), compare(all));
    }
    renew(content('history'), [JSON.stringify(all.map(e => e.id)), ...view.compared], () => parts);
  }

  const undone = id => state().history.some(e => e.undoes === id);

  function actions(e) {
    const all = [];
    if (e.text) all.push(button('Export again', () => { view.from = e.id; show(); $('export').scrollIntoView(); }, {title: 'gives this model to any target'}));
    if (e.action === 'PUBLISHED') all.push(button('Send again', () => back(e, 'Send the model of entry ' + e.id + ' to ' + e.place + ' again?', 'Send')));
    if (e.action === 'APPLIED' && e.before && !undone(e.id)) all.push(button('Put back', () => back(e, 'Put back what was in ' + e.place + ' before entry ' + e.id + '?', 'Put back')));
    return all;
  }

  async function back(e, question, yes) {
    const old = e.action === 'PUBLISHED' ? [differences(e, {model: state().history[0].model})] : [];
    if (await confirmed(question, old, yes)) await app.run('history/rollback', {id: e.id});
  }

  /** Any two models side by side. */
  function compare(all) {
    const models = all.filter(e => Object.keys(e.model).length);
    if (models.length < 2) return '';
    const chosen = i => models.find(e => String(e.id) === view.compared[i]) || models[Math.min(1 - i, models.length - 1)];
    const choice = i => select('compare-' + i, models.map(e => [String(e.id), e.id + ' · ' + when(e.unix)]), String(chosen(i).id), id => { view.compared[i] = id; showHistory(); });
    return el('div', {id: 'history-compare'}, el('div', {class: 'bar'}, el('span', {}, 'Compare '), choice(0), el('span', {}, ' with '), choice(1)), differences(chosen(0), chosen(1)));
  }

  /** What people call a parameter that files call so. */
  function words(name) {
    const models = app.state.calibration ? app.state.calibration.report.models : [];
    const known = models.flatMap(model => model.parameters).find(p => Plots.inFiles(p.name) === name);
    return known ? known.words + (known.unit ? ', ' + known.unit : '') : name;
  }

  function differences(a, b) {
    const names = [...new Set([...ORDER, ...Object.keys(a.model), ...Object.keys(b.model)])].filter(n => known(a.model[n]) || known(b.model[n]));
    const rows = names.map(n => {
      const percent = known(a.model[n]) && known(b.model[n]) && a.model[n] ? (b.model[n] / a.model[n] - 1) * 100 : NaN;
      return el('tr', {'data-parameter': n}, el('td', {class: 'text name'}, words(n)), el('td', {}, known(a.model[n]) ? number(a.model[n], 5) : '–'), el('td', {}, known(b.model[n]) ? number(b.model[n], 5) : '–'),
        el('td', {}, known(percent) ? (Math.abs(percent) < 0.005 ? 'the same' : signed(percent, 2) + ' %') : '–'));
    });
    return table([['Parameter', true], ['First'], ['Second'], ['Change']], rows);
  }

  return {show};
}
