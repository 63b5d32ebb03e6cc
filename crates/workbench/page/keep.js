// What the browser keeps: `local` for all pages of this address, `session` for this tab. Where that is blocked, nothing is kept.

export function keep(where, name, value) { try { window[`${where}Storage`].setItem(`workbench.${name}`, value); } catch { /* then not */ } }
export function kept(where, name) { try { return window[`${where}Storage`].getItem(`workbench.${name}`); } catch { return null; } }
export function forget(where, name) { try { window[`${where}Storage`].removeItem(`workbench.${name}`); } catch { /* then not */ } }

// Unsaved work, by the name of the file that it is of.
const work = file => `work.${file ?? ''}`;
export function keepWork(file, problem) { keep('local', work(file), JSON.stringify(problem)); }
export function forgetWork(file) { forget('local', work(file)); }
// None if it is no document: `check` throws or returns nothing then.
export function keptWork(file, check) {
  try {
    const problem = JSON.parse(kept('local', work(file)));
    return problem && typeof problem === 'object' && problem.objective && check(problem) ? problem : null;
  } catch { return null; }
}
