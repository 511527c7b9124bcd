/* Small parts that the pages share. Charts, Frame, Plots and CalibrationViews are those of the reports. */
const {el} = Charts;

/** What can be sent, by its id in the state. */
export const FORMATS = {wrapper: 'SSL_WrapperPacket with geometry', models: 'SSL_GeometryModels alone'};

/** A button; the key that does the same stands in its tooltip. */
export function button(label, press, {key, title, disabled, id, pressed, strong} = {}) {
  const hint = [title, key && '(key ' + key + ')'].filter(Boolean).join(' ');
  return el('button', {
    type: 'button', id, onclick: press, title: hint || null, disabled: disabled ? '' : null, class: strong ? 'strong' : null,
    'aria-pressed': pressed === undefined ? null : String(pressed),
  }, label);
}

/** Shows a question; resolves to true when it is confirmed. Who asked has the focus again afterwards, also when the page drew that button again meanwhile. */
export function confirmed(title, contents, yes) {
  const dialog = document.getElementById('dialog');
  const asked = document.activeElement, near = asked && asked.closest('section');
  return new Promise(resolve => {
    const end = result => () => {
      dialog.close();
      if (asked && !asked.isConnected) focusOn(asked.id, near);
      resolve(result);
    };
    const confirm = button(yes, end(true), {strong: true, id: 'confirm'});
    dialog.replaceChildren(
      el('h2', {id: 'dialog-title'}, title), ...contents,
      el('div', {class: 'bar'}, confirm, button('Cancel', end(false), {id: 'refuse'})));
    dialog.oncancel = event => { event.preventDefault(); end(false)(); };
    dialog.showModal();
    document.getElementById('refuse').focus();
  });
}

/** Shows something to be read. */
export function shown(title, contents) {
  const dialog = document.getElementById('dialog');
  dialog.replaceChildren(el('h2', {id: 'dialog-title'}, title), ...contents, el('div', {class: 'bar'}, button('Close', () => dialog.close(), {id: 'refuse'})));
  dialog.showModal();
}

/** How much is done. */
export function progress(done, total) {
  return el('progress', total > 0 ? {max: total, value: Math.min(done, total)} : {});
}

/** A table: heads are [label, title]; those of text are left-aligned. */
export function table(heads, rows, more = {}) {
  const made = el('table', more, el('thead', {}, el('tr', {}, heads.map(([label, left, title]) => el('th', {scope: 'col', class: left ? 'text' : null, title}, label)))), el('tbody', {}, rows));
  return heads.length > 3 ? Frame.cards(made) : made;
}

/** A field of a form with its label. */
export function field(label, input) {
  return el('label', {}, label + ' ', input);
}

/** A choice of several values; tells what was chosen. */
export function select(id, options, current, chosen) {
  const node = el('select', {id, onchange: event => chosen(event.target.value)}, options.map(([value, label]) => el('option', {value}, label)));
  node.value = current;
  return node;
}

/** So long is drawn before the browser may show it, ms. */
const AT_A_TIME = 30;

const waiting = new Map();
let drawing = false;

/** Draws once the words are on the screen, one picture after another; of several wishes for one place the last one counts. */
export function soon(box, draw) {
  box.dataset.waiting = '';
  waiting.set(box, draw);
  if (drawing) return;
  drawing = true;
  requestAnimationFrame(() => setTimeout(drawNext));
}

function drawNext() {
  drawing = waiting.size > 0;
  if (!drawing) return;
  // The next ones even if one fails; and the browser may show what there is, or hear of a key, in between. Each time it shows something costs as much as a picture.
  setTimeout(drawNext);
  const end = performance.now() + AT_A_TIME;
  do {
    const [box, draw] = waiting.entries().next().value;
    waiting.delete(box);
    delete box.dataset.waiting;
    if (box.isConnected) draw();
  } while (waiting.size > 0 && performance.now() < end);
}

/**
 * Replaces what is in a box; who had one of its parts in focus has the one of the same name afterwards, or else a button in it or near it: from nowhere, a keyboard would have to begin at the top of the page again.
 */
export function refill(box, ...nodes) {
  const had = box.contains(document.activeElement) ? document.activeElement.id : null;
  box.replaceChildren(...nodes);
  if (had !== null) focusOn(had, box, box.closest('section'));
}

/** The part of that name gets the focus, or else the first button in one of the places. */
function focusOn(id, ...places) {
  const same = id && document.getElementById(id);
  const button = () => places.map(place => place && place.querySelector('button:enabled')).find(Boolean);
  const next = same && !same.matches(':disabled') ? same : button() || document.querySelector('nav a[aria-current]');
  if (next) next.focus({preventScroll: true});
}

/** Replaces what is in a box only when it would be something else: a button that is replaced while it is pressed is never pressed. */
export function renew(box, key, make) {
  const text = JSON.stringify(key);
  if (box.dataset.shows === text) return;
  box.dataset.shows = text;
  refill(box, ...make());
}
