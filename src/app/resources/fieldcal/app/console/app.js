/* The console's page: keeps the state that the server tells, shows the page that was chosen, and what holds for all pages. */
import {ask, act, listen} from './server.js';
import {button, progress, renew, shown} from './parts.js';
import {kicksPage} from './kicks.js';
import {diagnosisPage} from './diagnosis.js';
import {publishPage} from './publish.js';
import {matchPage} from './match.js';
import {playPage} from './play.js';
import {recordingsPage} from './recordings.js';

const {el} = Charts;
const {$} = Frame;

// What is printed is the report; on the screen, more pixels than it has would only take time.
Frame.screen.pixelRatio = window.devicePixelRatio || 1;

const app = {state: null, theme: null, decide, run, fail, colours};
const recordings = recordingsPage(app);
const PAGES = [kicksPage(app), playPage(app), diagnosisPage(app), publishPage(app), matchPage(app), recordings];
let current = null;
let lastWork = null, failures = [], asking = false, askAgain = false, acting = 0, newest = 0;

// ---- state ----

/** An answer that was overtaken by a later one is not shown. */
function take(state) {
  const old = app.state;
  if (old && old.run === state.run && old.version > state.version) return;
  if (state.calibration && state.calibration.since !== null) {
    if (!old || old.run !== state.run || !old.calibration) return void refresh();
    // Only the kicks that changed were told; the others stay the very objects they were.
    const changed = new Map(state.calibration.report.kicks.map(kick => [kick.id, kick]));
    state.calibration.report.kicks = old.calibration.report.kicks.map(kick => changed.get(kick.id) || kick);
  }
  app.state = state;
  showAll();
}

/** Asks for the state; of many wishes at once only the last one is asked again. */
async function refresh() {
  if (asking) {
    askAgain = true;
    return;
  }
  asking = true;
  try {
    take(await ask('state' + having()));
  } catch (failure) {
    if (failure.status !== 0) fail(failure); // that there is no connection is shown already
  } finally {
    asking = false;
  }
  if (askAgain) {
    askAgain = false;
    refresh();
  }
}

/** What this page knows already and need not be told again. */
const having = () => app.state && app.state.calibration ? '?run=' + app.state.run + '&calibration=' + app.state.calibration.version : '';

/** Something changed; what this page itself brought about comes as an answer. */
function changed(version) {
  newest = version;
  if (!acting && app.state && app.state.version !== version) refresh();
}

/** Has the server do something, and shows what came of it. */
async function run(what, body) {
  acting++;
  try {
    const state = await act(what + having(), body);
    failures = [];
    take(state);
    return true;
  } catch (failure) {
    fail(failure);
    if (failure.status === 409) await refresh();
    return false;
  } finally {
    acting--;
    if (!acting && app.state && app.state.version < newest) refresh();
  }
}

function decide(action, more = {}) {
  return run('decisions', Object.assign({action}, more));
}

function fail(failure) {
  failures = [failure];
  showNotices();
}

// ---- what holds for all pages ----

function showNotices() {
  const state = app.state || {};
  const notice = (level, text, ...actions) => el('p', {class: 'notice ' + level, role: 'alert'}, el('span', {}, text), ...actions);
  const rows = [];
  for (const failure of failures) {
    const again = failure.status === 401 ? button('Enter the token', () => location.reload()) : button('Close', () => { failures = []; showNotices(); });
    rows.push(notice(failure.status === 409 ? 'warn' : 'bad', failure.message, again));
  }
  for (const text of state.unsaved || []) rows.push(notice('bad', text + '. Nothing is lost while the console runs.', button('Save again', () => run('save'))));
  if (state.failure && state.calibration) rows.push(notice('bad', state.failure, button('Read again', () => run('read'))));
  for (const text of state.leftOut || []) if (!dismissed.has(text)) rows.push(notice('warn', 'Left out: ' + text + '.', button('Read again', () => run('read')), button('Close', () => dismiss(text), {title: 'hides this line while the tab is open'})));
  if (state.unread && state.unread.length && !busy()) rows.push(notice('warn', 'New in the directory: ' + state.unread.join(', '), button('Read it', () => run('read'), {id: 'read'})));
  if (state.changed && state.changed.length && !busy()) rows.push(notice('warn', 'Changed since they were read: ' + state.changed.join(', '), button('Read again', () => run('read'), {id: 'read-changed'})));
  const said = rows.map(row => row.className + row.textContent);
  renew($('notices'), said, () => rows);
}

/** What the operator has read and closed; kept while the tab is open. */
const dismissed = new Set(firstDismissed());

function firstDismissed() {
  try { return JSON.parse(sessionStorage.getItem('fieldcal-dismissed')) || []; } catch (refused) { return []; }
}

function dismiss(text) {
  dismissed.add(text);
  try { sessionStorage.setItem('fieldcal-dismissed', JSON.stringify([...dismissed])); } catch (refused) { /* private windows keep nothing */ }
  showNotices();
}

const busy = () => Boolean(app.state && app.state.work && app.state.work.title);

function showWork(work) {
  if (lastWork && lastWork.run === work.run && lastWork.number > work.number) work = lastWork;
  lastWork = work;
  if (app.state) app.state.work = work;
  const box = $('work');
  renew(box, [work.title, work.asked], () => !work.title ? [] : [el('span', {class: 'what'}), progress(0, 0), ...(work.asked ? [button('Cancel', () => run('cancel'), {id: 'cancel'})] : [])]);
  if (work.title) {
    const counted = work.total > 1 && Number.isInteger(work.done) ? ' ' + work.done + ' of ' + work.total : '';
    box.firstChild.textContent = box.firstChild.title = work.title + (work.text ? ': ' + work.text + counted : '');
    box.children[1].replaceWith(progress(work.done, work.total));
  }
  if (current && current.worked) current.worked(work);
  if (!ready()) showEmpty();
}

/** Whoever looks at another page must not forget that a model is being sent. */
function showSends({running, to}) {
  $('sends').hidden = !running;
  $('sends').textContent = running ? '● sending to ' + to : '';
}

function showLink(connected) {
  $('link').className = 'badge ' + (connected ? 'good' : 'bad');
  $('link').textContent = connected ? '● connected' : '○ connection lost, trying again …';
  document.body.classList.toggle('lost', !connected);
  if (connected) refresh();
}

/** Whether the page that was chosen has something to show; some need no kicks. */
const ready = () => Boolean(app.state && (app.state.calibration || current.always));

function showEmpty() {
  const state = app.state;
  const empty = !state || !ready();
  $('page-empty').hidden = !empty;
  if (!empty) return;
  const words = !state ? ['Connecting …', []]
    : busy() ? ['Reading the recordings …', [el('p', {}, state.work.text), progress(state.work.done, state.work.total)]]
    : state.record.running ? ['Recording', [el('p', {}, 'Let the robots kick a ball that rests: at least twelve flat kicks and twelve chips, of different speeds and in different directions. Some flat kicks should roll until they stop. Then stop the recording: its kicks are calibrated at once.')]]
    : state.failure ? ['The recordings cannot be used', [el('p', {}, state.failure), button('Read again', () => run('read'))]]
    : ['No recording yet', [el('p', {}, 'Record kicks from the network, let the calibration play make some (page Play), or put game logs (*.log, *.log.gz) into the folder ' + state.directory + '.'), button('Look again', () => run('read'))]];
  $('empty-title').textContent = words[0];
  renew($('empty-text'), words[1].map(node => node.outerHTML), () => words[1]);
  $('empty-record').hidden = !state || busy();
  if (!$('empty-record').hidden) recordings.showRecord($('empty-record'));
}

function showNavigation() {
  const titles = PAGES.map(page => page.title + (page.badge ? page.badge() : ''));
  renew($('pages'), [current.id, titles], () => PAGES.map((page, i) => el('a', {
    id: 'nav-' + page.id, href: '#' + page.id, 'aria-current': page === current ? 'page' : null, title: 'key ' + (i + 1),
  }, titles[i])));
}

function showAll() {
  const state = app.state;
  $('session').textContent = state.directory + (state.recordings.length ? ' · ' + state.recordings.join(', ') : '');
  $('session').title = $('session').textContent;
  showWork(state.work);
  showSends(state.sending);
  showNotices();
  showNavigation();
  showEmpty();
  for (const page of PAGES) $('page-' + page.id).hidden = page !== current || !ready();
  if (ready()) current.show();
  Frame.fitAll();
}

// ---- pages, colours, keys ----

function go() {
  const id = location.hash.slice(1).split('/')[0];
  const page = PAGES.find(p => p.id === id) || PAGES[0];
  if (page === current) return;
  current = page;
  document.title = page.title + ' – fieldcal';
  if (app.state) showAll();
}

function colours() {
  const report = app.state && app.state.calibration ? app.state.calibration.report : {cameras: []};
  return Charts.theme(report.cameras.map(camera => camera.id));
}

function setTheme(name) {
  document.documentElement.dataset.theme = name;
  $('theme').textContent = name === 'dark' ? 'Light' : 'Dark';
  try { localStorage.setItem('fieldcal-theme', name); } catch (refused) { /* private windows keep nothing */ }
  for (const page of PAGES) if (page.themed) page.themed(name);
  if (app.state) showAll();
}

function firstTheme() {
  const wanted = new URLSearchParams(location.search).get('theme');
  let kept = null;
  try { kept = localStorage.getItem('fieldcal-theme'); } catch (refused) { /* as above */ }
  const system = window.matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light';
  return [wanted, kept, system].find(name => name === 'dark' || name === 'light');
}

const toggleTheme = () => setTheme(document.documentElement.dataset.theme === 'dark' ? 'light' : 'dark');

function showKeys() {
  const rows = [['1 … ' + PAGES.length, 'the pages'], ['t', 'light or dark'], ['?', 'this list'], ...(current.keyWords || [])];
  shown('Keys', [el('table', {}, el('tbody', {}, rows.map(([key, what]) => el('tr', {}, el('td', {class: 'text'}, el('kbd', {}, key)), el('td', {class: 'text'}, what)))))]);
}

document.addEventListener('keydown', event => {
  if (event.altKey || $('dialog').open) return;
  if (event.target instanceof Element && event.target.matches('input:not([type=checkbox]), textarea, select')) return;
  if (event.ctrlKey || event.metaKey) {
    const step = {z: 'u', Z: 'U', y: 'U'}[event.key];
    if (step && ready() && current.keys && current.keys[step]) {
      event.preventDefault();
      current.keys[step]();
    }
    return;
  }
  const page = PAGES[Number(event.key) - 1];
  if (page) location.hash = page.id;
  else if (event.key === 't') toggleTheme();
  else if (event.key === '?') showKeys();
  else if (ready() && current.keys && Object.hasOwn(current.keys, event.key)) {
    event.preventDefault();
    current.keys[event.key]();
  }
});

let resizing = 0;
window.addEventListener('resize', () => {
  cancelAnimationFrame(resizing);
  resizing = requestAnimationFrame(() => {
    Frame.fitAll();
    if (ready() && current.resized) current.resized();
  });
});

$('theme').addEventListener('click', toggleTheme);
$('keys').addEventListener('click', showKeys);
window.addEventListener('hashchange', go);
setTheme(firstTheme());
go();
showNavigation();
listen((name, data) => {
  if (name === 'state') changed(data);
  else if (name === 'work') showWork(data);
  else {
    if (app.state) app.state[name].status = data;
    if (app.state && name === 'record') recordings.told();
    else if (app.state && current.id === name) current.told(data);
  }
}, showLink);
refresh();
