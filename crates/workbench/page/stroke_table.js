// The table of strokes as text, with its history. A force that is dragged is written into the text; all else in it stays as it was typed.
import {Store} from './store.js';

// The cells of a line with their places; quoted cells may hold commas.
function cells(line) {
  const found = [];
  let start = 0, isQuoted = false;
  for (let k = 0; k <= line.length; k++) {
    if (line[k] === '"') isQuoted = !isQuoted;
    if (k === line.length || line[k] === ',' && !isQuoted) { found.push({start, end: k, words: line.slice(start, k).trim().replace(/^"|"$/g, '')}); start = k + 1; }
  }
  return found;
}

export class StrokeTable extends Store {
  constructor(csv) { super({csv}); }

  get csv() { return this.problem.csv; }
  set(csv, join = null) { this.change(draft => { draft.csv = csv; }, join); }

  get column() { return cells(this.csv.split('\n')[0].replace('\r', '')).findIndex(cell => cell.words === 'force_n'); }

  // The forces of some lines, counted from 1; null where there is none.
  forces(lines) {
    const all = this.csv.split('\n'), {column} = this;
    return lines.map(line => { const value = Number.parseFloat(cells((all[line - 1] ?? '').replace('\r', ''))[column]?.words); return Number.isFinite(value) ? value : null; });
  }

  // Writes forces into lines, in four digits.
  write(lines, forces, join) {
    const all = this.csv.split('\n'), {column} = this;
    lines.forEach((line, k) => {
      const cell = cells((all[line - 1] ?? '').replace('\r', ''))[column];
      if (cell && forces[k] !== null) all[line - 1] = all[line - 1].slice(0, cell.start) + Number(forces[k].toPrecision(4)) + all[line - 1].slice(cell.end);
    });
    this.set(all.join('\n'), join);
  }
}
