/* Talks to the console's server: asks, tells it what to do, and hears of changes. */

/** How long no word may come before the connection counts as lost, ms; the server sends one every three seconds. */
const SILENCE = 9000;

/** What the server refuses with is as on a terminal: it begins small and has no full stop. */
const sentence = text => text[0].toUpperCase() + text.slice(1) + (/[.?!…]$/.test(text) ? '' : '.');

class Refused extends Error {
  constructor(status, message) {
    super(sentence(message));
    this.status = status;
  }
}

async function answer(request) {
  let response;
  try {
    response = await request;
  } catch (unreachable) {
    throw new Refused(0, 'The console cannot be reached.');
  }
  let body = null;
  try {
    body = await response.json();
  } catch (noJson) {
    // Told below.
  }
  if (!response.ok) throw new Refused(response.status, (body && body.error) || 'The console answered with status ' + response.status + '.');
  return body;
}

/** Asks for something. */
export const ask = what => answer(fetch('/api/' + what, {cache: 'no-store'}));

/** Has something done; the answer is the state after it. */
export const act = (what, body = {}) => answer(fetch('/api/' + what, {
  method: 'POST', headers: {'Content-Type': 'application/json', 'X-Fieldcal-Console': '1'}, body: JSON.stringify(body),
}));

/**
 * Hears of changes for ever: told(name, data) for each event, link(connected) when the connection comes or goes. A connection that is silent is given up and
 * made again: a laptop that slept does not notice otherwise.
 */
export function listen(told, link) {
  let source = null, heard = 0, connected = null;
  const state = now => { if (now !== connected) { connected = now; link(now); } };
  const open = () => {
    if (source) source.close();
    heard = Date.now();
    source = new EventSource('/api/events');
    for (const name of ['beat', 'state', 'work', 'match', 'play', 'record']) {
      source.addEventListener(name, event => {
        heard = Date.now();
        state(true);
        if (name !== 'beat') told(name, JSON.parse(event.data));
      });
    }
    source.onerror = () => state(false);
  };
  open();
  setInterval(() => {
    if (Date.now() - heard > SILENCE) {
      state(false);
      open();
    }
  }, 1000);
  window.addEventListener('pagehide', () => source && source.close());
  window.addEventListener('pageshow', event => { if (event.persisted) open(); });
}
