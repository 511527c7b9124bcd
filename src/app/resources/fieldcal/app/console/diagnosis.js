/* The page of the diagnosis: run it, see what came of it, accept or refuse its model. */
import {button, progress, renew} from './parts.js';

const {el} = Charts;
const {$} = Frame;
const MARKS = {model_adequate: ['good', '✔'], explained: ['warn', '⚠'], partly_explained: ['warn', '◐'], unexplained_structure: ['warn', '?']};
/** Of a verdict that a later version wrote. */
const markOf = verdict => MARKS[verdict] || ['warn', '?'];

export function diagnosisPage(app) {
  const page = {id: 'diagnosis', title: 'Diagnosis', show, worked, themed, badge, keys: {}, keyWords: []};
  let framed = null;

  const state = () => app.state;
  const note = () => state().diagnosis.note;
  const running = () => state().work.title === 'Diagnosing';

  function badge() {
    if (!app.state || !app.state.diagnosis || !note()) return '';
    return ' ' + markOf(note().verdict)[1];
  }

  function show() {
    showActions();
    showState();
    showReport();
  }

  function worked() {
    showActions();
    showState();
  }

  function showActions() {
    if (!state().calibration) return;
    const {acceptance} = state().diagnosis;
    const found = note() && (note().causes.length > 0 || note().verdict === 'partly_explained');
    const accept = what => () => app.run('diagnosis/acceptance', {acceptance: what});
    renew($('diagnose-actions'), [running(), note(), acceptance, state().diagnosis.outdated, Boolean(state().work.asked)], () => [
      running() ? button('Cancel', () => app.run('cancel'), {id: 'diagnose-cancel'})
        : button(note() ? 'Diagnose again' : 'Diagnose these kicks', () => app.run('diagnosis'), {id: 'diagnose-run', strong: !note() || state().diagnosis.outdated, disabled: Boolean(state().work.asked)}),
      ...(found && !running() ? [
        button('Accept the extended model', accept('accepted'), {id: 'accept', pressed: acceptance === 'accepted', title: 'Calibrate with the causes taken out of the detections'}),
        button('Refuse it', accept('refused'), {id: 'refuse-model', pressed: acceptance === 'refused', title: 'Stay with the calibrated model'})] : [])]);
  }

  function showState() {
    if (!state().calibration) return;
    const {failure, outdated, acceptance} = state().diagnosis;
    const used = state().calibration.report.kicks.filter(kick => state().selection.byHand[kick.id] !== 'drop').length;
    const rows = [];
    if (running()) rows.push(el('p', {}, state().work.text + ' '), progress(state().work.done, state().work.total));
    else if (failure) rows.push(el('p', {class: 'notice bad'}, failure));
    if (!note()) {
      if (!running()) rows.push(el('p', {}, 'Finds what the calibrated model gets wrong, which causes explain it, and what is gained by knowing them. It uses the ' + used + ' kicks that are not dropped by hand. It takes some seconds; chips with several causes take some minutes.'));
    } else {
      const [level, mark] = markOf(note().verdict);
      rows.push(el('p', {id: 'headline', class: 'headline ' + level}, mark + ' ' + note().headline));
      if (outdated) rows.push(el('p', {class: 'notice warn'}, 'The kicks have changed since the diagnosis: diagnose again.'));
      if (note().verdict === 'partly_explained') rows.push(...note().lines.map(line => el('p', {}, line)));
      rows.push(...note().causes.map(causeOf));
      if (state().diagnosis.next.length) rows.push(el('p', {}, el('a', {href: '#play', id: 'to-play'}, 'Order the kicks to record next from the play'), ': ' + state().diagnosis.next.map(w => w.kicks + ' ' + (w.kind === 'chip' ? 'chips' : 'flat kicks') + ' of ' + w.slowest + ' to ' + w.fastest + ' m/s').join('; ') + '.'));
      if (acceptance === 'accepted') rows.push(el('p', {id: 'accepted'}, Frame.badge('good', '✔ accepted'), ' The model on the other pages is valid together with these effects. Programs that know only the league\'s message need the model without them: refuse it for these.'));
      if (acceptance === 'refused') rows.push(el('p', {id: 'refused'}, Frame.badge('warn', 'refused'), ' The model on the other pages is the calibrated one.'));
    }
    // A link that is replaced loses the focus, and what was folded out folds in.
    const {work, diagnosis} = state();
    renew($('diagnose-state'), [running() && work, note(), failure, outdated, acceptance, diagnosis.next, used], () => rows);
  }

  function causeOf(cause) {
    return el('details', {class: 'cause', open: cause.next ? '' : null},
      el('summary', {}, el('b', {}, cause.name), ' ' + cause.strength),
      el('p', {}, cause.what), cause.advice ? el('p', {}, el('b', {}, 'To do: '), cause.advice) : '',
      cause.next ? el('p', {}, el('b', {}, 'Record next: '), cause.next) : '');
  }

  function showReport() {
    const frame = $('diagnosis-report');
    frame.hidden = !state().diagnosis.report;
    const wanted = frame.hidden ? null : '/files/diagnosis.html?theme=' + document.documentElement.dataset.theme + '&of=' + state().diagnosis.report;
    if (wanted !== framed) {
      framed = wanted;
      if (wanted) frame.src = wanted;
      else frame.removeAttribute('src');
    }
  }

  function themed() {
    framed = null;
  }

  return page;
}
