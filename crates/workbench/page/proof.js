// What is kept of a solution: its certificate and the calculation. Certificates of others are proven anew.
import {get, html, say} from './dom.js';
import {download, fileName} from './files.js';

export class Proof {
  // `tell` says how it went, `tab` shows the results.
  constructor(link, solver, {tell, tab}) {
    Object.assign(this, {link, solver, tell, tab});
    get('certificate').addEventListener('click', () => this.keep());
    get('report').addEventListener('click', () => this.report());
  }

  // Downloads what proves the bounds: what `soilctl certify` reads.
  async keep() {
    const answer = await this.link.ask({type: 'certificate'}, 'certificate');
    if (!answer || answer.error) { this.tell(answer?.error.words ?? 'there is no connection to the workbench', 'bad'); return; }
    for (const {part, text} of answer.files) download(fileName(this.solver.problem, part ? `certificate.${part}.json` : 'certificate.json'), 'application/json', text);
    this.tell(`SHA-256 ${answer.files.map(file => file.sha256).join(', ')}`, 'good');
  }

  // Downloads the calculation, a page that prints.
  async report() {
    const {problem} = this.solver, answer = await this.link.ask({type: 'report', name: fileName(problem, 'toml')}, 'report');
    if (!answer?.html) { this.tell(answer?.error.words ?? 'there is no connection to the workbench', 'bad'); return; }
    download(fileName(problem, 'html'), 'text/html', answer.html);
    this.tell('the calculation was downloaded; its page prints to paper or PDF', 'good');
  }

  // Proves anew what a saved solution claims, and shows it.
  async check(name, text) {
    const answer = await this.link.ask({type: 'certify', name, text}, 'certified');
    if (!answer || answer.error) { this.tell(answer?.error.words ?? 'there is no connection to the workbench', 'bad'); return; }
    const {answer: found, sha256} = answer;
    const line = (side, one) => one && html('li', {class: one.confirmed ? 'good' : 'bad', 'data-side': side, 'data-proven': one.proven ?? ''}, `${side} bound: ${one.confirmed ? `${one.proven} is proven` : one.proven === null ? `${one.claimed} is claimed and not proven: ${one.refusal}` : `${one.claimed} is claimed, ${one.proven} is proven`}`);
    get('certified').replaceChildren(
      html('h2', null, `${name}: ${found.certified ? 'proven' : 'not proven'}`),
      html('p', {class: 'faint'}, found.description ?? ''),
      html('ul', {class: 'plain'}, line('lower', found.lower), line('upper', found.upper)),
      html('p', {class: 'faint'}, 'In the units of the file, per unit width. What was proven, read from the file:'),
      html('dl', {class: 'said'}, ...found.statement.flatMap(({of, says}) => [html('dt', null, of), html('dd', null, says)])),
      html('p', {class: 'hash'}, `SHA-256 ${sha256}`));
    this.tab('result');
    say(get('certified').firstChild.textContent);
    this.tell(`${name} was checked: ${found.certified ? 'its bounds are proven' : 'not all that it claims is proven'}`, found.certified ? 'good' : 'bad');
  }
}
