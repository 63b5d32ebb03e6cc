// Light or dark, for all pages of the workbench.
import {keep, kept} from './keep.js';

// From now on; null for what the system says.
export function theme(name) {
  if (name) document.documentElement.dataset.theme = name;
  keep('local', 'theme', name ?? '');
}

export const keptTheme = () => theme(kept('local', 'theme') || null);

// The other one.
export function turnTheme() {
  const now = document.documentElement.dataset.theme || (matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light');
  theme(now === 'dark' ? 'light' : 'dark');
}
