/* A field beside a simulator: what differs, what it costs, and everything that was compared. */
(() => {
  'use strict';
  const {el, known, number, withError, fileName} = Charts;
  const {$, content, badge, showProvenance, showProblems, start} = Frame;
  const report = JSON.parse($('data').textContent);

  /** Four significant figures. */
  const figures = value => !known(value) ? '–' : value === 0 ? '0' : number(value, Math.max(0, Math.min(6, 3 - Math.floor(Math.log10(Math.abs(value))))));
  const cell = (value, error) => !known(value) ? 'none' : known(error) ? withError(value, error) : figures(value);
  const share = value => known(value) ? number(100 * value, 0) + ' %' : '–';
  const metres = value => known(value) && known(report.passReal) ? (value * (report.passReal - report.passSim) > 0 ? '+' : '') + number(value * (report.passReal - report.passSim), 2) + ' m' : '–';
  const list = texts => texts.length === 0 ? el('p', {class: 'empty'}, 'None.') : el('ul', {}, texts.map(text => el('li', {}, text)));

  function table(id, head, rows, note) {
    if (rows.length === 0) {
      content(id).replaceChildren(el('p', {class: 'empty'}, 'Nothing.'));
      return;
    }
    content(id).replaceChildren(
      Frame.cards(el('table', {}, el('thead', {}, el('tr', {}, head.map((h, i) => el('th', {scope: 'col', class: i === 0 ? 'text' : null}, h)))), el('tbody', {}, rows))),
      el('p', {class: 'note'}, note));
  }

  const sides = row => [el('td', {class: 'words'}, row.words), el('td', {}, cell(row.real, row.realError)), el('td', {}, cell(row.sim, row.simError)), el('td', {}, row.unit)];
  const compared = row => el('tr', {}, ...sides(row), el('td', {}, row.differs ? badge('warn', 'differs') : ''));

  function showAll() {
    $('verdict').replaceChildren(el('p', {}, el('b', {}, report.verdict)), el('p', {}, 'Simulator: ' + report.simSources.map(fileName).join(', ')));
    table('differences', ['Difference', 'Field', 'Simulator', 'Unit', 'Share of the error 1 s ahead', 'Pass on the field'], report.differences.map(row => el('tr', {},
      ...sides(row), el('td', {}, share(row.shareOfError)), el('td', {}, metres(row.shareOfPass)))),
      'A share is the part of the error that vanishes when this difference alone is taken away; shares need not add up to 100 %, since differences can act together or against each other. The last column is how much farther this difference alone lets a pass at 5 m/s roll on the field.');
    const lines = report.prediction.map(p => 'The predictions of an AI that was tuned on the simulator are off by ' + number(p.mm, 0) + ' mm on the field after ' + number(p.seconds, 1) + ' s.');
    if (known(report.passReal)) lines.push('A pass at 5 m/s rolls ' + number(report.passReal, 2) + ' m on the field and ' + number(report.passSim, 2) + ' m in the simulator.');
    content('cost').replaceChildren(list(lines));
    const head = ['', 'Field', 'Simulator', 'Unit', ''];
    table('parameters', head, report.parameters.map(compared), 'Values with their standard errors. Two values differ where chance is less likely than 1 %, corrected for the number of all differences of the ball (Holm).');
    content('causes').replaceChildren(el('p', {}, 'On the field:'), list(report.realCauses), el('p', {}, 'In the simulator:'), list(report.simCauses));
    table('cameras', head, report.cameras.map(compared), 'Medians of kicks or of stretches of 2 s, or means where the medians are equal; rank-sum test, corrected for their number (Holm).');
    table('others', head, report.others.map(compared), 'Without a standard error a row is for information only.');
  }

  showProvenance(report.provenance);
  showProblems(report.problems);
  start([], {use() {}, showAll, resized() {}, keys: {}});
})();
