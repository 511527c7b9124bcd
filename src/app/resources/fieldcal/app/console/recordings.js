/* The recordings of the session: which are used and why not, and a recording from the network. */
import {button, field, renew} from './parts.js';

const {el} = Charts;
const {$} = Frame;

export function recordingsPage(app) {
  const page = {id: 'recordings', title: 'Recordings', show, told, always: true, keys: {}, keyWords: []};
  const view = {vision: '224.5.23.2:10006', referee: ''};

  function show() {
    showRecord($('record-box'));
    showList($('recordings-list'));
  }

  /** The recorder's status comes more often than the state. */
  function told() {
    const line = document.querySelector('.record-line');
    if (line) line.textContent = lineOf(app.state.record);
  }

  const lineOf = record => record.status ? record.status.line : 'listening to ' + view.vision + ' …';

  /** Begins or ends a recording from the network; used by the empty page, too. */
  function showRecord(box) {
    const {record} = app.state;
    renew(box, [record.running, record.failure], () => [
      ...(record.failure ? [el('p', {class: 'notice bad', id: 'record-failure'}, record.failure)] : []),
      record.running ? el('div', {class: 'bar'}, el('span', {class: 'badge bad'}, '● recording'), el('span', {class: 'record-line'}, lineOf(record)), button('Stop recording', () => app.run('record/end'), {id: 'record-end', strong: true}))
        : el('form', {class: 'bar', onsubmit: event => { event.preventDefault(); app.run('record', {vision: view.vision, referee: view.referee}); }},
          field('Vision', el('input', {id: 'record-vision', value: view.vision, required: '', size: 17, maxlength: 200, oninput: event => { view.vision = event.target.value; }})),
          field('Referee', el('input', {id: 'record-referee', value: view.referee, size: 17, maxlength: 200, placeholder: 'not recorded', title: "the league's is 224.5.23.1:10003", oninput: event => { view.referee = event.target.value; }})),
          el('button', {type: 'submit', id: 'record-start', class: 'strong'}, '● Record'))]);
    told();
  }

  function showList(box) {
    const {choice, work} = app.state;
    renew(box, [choice, Boolean(work.title)], () => choice.length === 0 ? [el('p', {class: 'note'}, 'No recording yet.')] : [
      el('div', {class: 'scroll'}, el('table', {}, el('thead', {}, el('tr', {}, ['Use', 'Recording', 'Recorded (UTC)', 'Kicks'].map((head, i) => el('th', {scope: 'col', class: i === 3 ? null : 'text'}, head)))), el('tbody', {}, choice.flatMap(rows))))]);
  }

  /** Why a recording is left out has a row of its own: on a phone there is no room beside it. */
  function rows(recording) {
    const use = el('input', {type: 'checkbox', 'aria-label': 'use ' + recording.name, disabled: app.state.work.title ? '' : null, onchange: event => app.run('recordings', {name: recording.name, use: event.target.checked})});
    use.checked = recording.used;
    const why = recording.why ? (recording.used ? '' : 'Left out: ') + recording.why : '';
    const row = el('tr', {'data-recording': recording.name, class: recording.used ? null : 'dropped'},
      el('td', {class: 'text'}, use), el('td', {class: 'text'}, recording.name),
      el('td', {class: 'text'}, recording.start > 0 ? new Date(recording.start * 1000).toISOString().slice(0, 16).replace('T', ' ') : '–'),
      el('td', {}, recording.kicks === null ? '–' : recording.kicks));
    const rule = recording.byHand ? [' ', button('Leave it to the rule', () => app.run('recordings', {name: recording.name, use: null}))] : [];
    return why || rule.length ? [row, el('tr', {class: 'why', 'data-why': recording.name}, el('td', {}), el('td', {colspan: 3, class: 'text'}, why, ...rule))] : [row];
  }

  page.showRecord = showRecord;
  return page;
}
