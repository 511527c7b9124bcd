/* The check of a twin: what it is made of, and every statistic beside the recording's. */
(() => {
  'use strict';
  const {el, known, number} = Charts;
  const {$, content, badge, showProvenance, showProblems, start} = Frame;
  const report = JSON.parse($('data').textContent);

  const list = texts => el('ul', {}, texts.map(text => el('li', {}, text)));

  function showVerdict() {
    const wrong = report.rows.filter(row => row.differs).length;
    const words = wrong === 0
      ? 'The twin behaves like the field: none of ' + report.statistics + ' statistics differs.'
      : 'The twin behaves like the field in ' + (report.statistics - wrong) + ' of ' + report.statistics + ' statistics.';
    $('verdict').replaceChildren(
      el('p', {}, el('b', {}, words)),
      el('p', {}, report.found + ' of ' + report.kicks + ' kicks were found again.'));
    content('differences').replaceChildren(report.sentences.length === 0
      ? el('p', {class: 'empty'}, 'These kicks show no difference.') : list(report.sentences));
  }

  function table(id, head, rows, note) {
    content(id).replaceChildren(
      Frame.cards(el('table', {}, el('thead', {}, el('tr', {}, head.map((h, i) => el('th', {scope: 'col', class: i === 0 ? 'text' : null}, h)))), el('tbody', {}, rows))),
      el('p', {class: 'note'}, note));
  }

  const minus = text => text.replace(/^-/, '−');
  const verdict = row => row.differs ? badge('warn', 'differs') : badge('good', 'agrees');

  function showAll() {
    showVerdict();
    table('parameters', ['Parameter', 'Recording', 'Twin', 'Standard errors apart', ''], report.parameters.map(row => el('tr', {},
      el('td', {class: 'words'}, row.words), el('td', {}, minus(row.recorded)), el('td', {}, minus(row.twin)), el('td', {}, number(row.sigmas, 1)), el('td', {}, verdict(row)))),
      'Means of the single kicks with their standard errors. More than two standard errors apart counts as different.');
    const parts = report.causes.slice();
    if (report.learned > 0) parts.push(report.learned + (report.learned === 1 ? ' learned law' : ' learned laws') + ' of the ball');
    content('field').replaceChildren(
      parts.length === 0 ? el('p', {}, 'The simple ball model: the diagnosis named no cause.') : list(parts),
      ...(report.notes.length === 0 ? [] : [el('p', {}, 'Assumed, or left out:'), list(report.notes)]));
    table('statistics', ['Statistic', 'Recording', 'Twin', 'Unit', 'Samples', 'Standard errors apart', 'p (Holm)', ''], report.rows.map(row => el('tr', {},
      el('td', {class: 'words'}, row.words), el('td', {}, minus(row.recorded)), el('td', {}, minus(row.twin)), el('td', {}, row.unit), el('td', {}, String(row.samples)),
      el('td', {}, known(row.sigmas) ? number(row.sigmas, 1) : '–'), el('td', {}, row.p < 0.001 ? '< 0.001' : number(row.p, 3)), el('td', {}, verdict(row)))),
      'Medians. Rank tests: the same kicks in pairs (Wilcoxon), stretches of time and scatters against each other (Mann and Whitney). p is corrected for the number of statistics (Holm); below 0.05 they differ.');
  }

  showProvenance(report.provenance);
  showProblems(report.problems);
  start([], {use() {}, showAll, resized() {}, keys: {}});
})();
