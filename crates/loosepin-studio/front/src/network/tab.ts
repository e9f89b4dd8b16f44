// The name of this tab, by which the server knows whose unsaved texts are whose.
const key = 'loosepin-tab';

function fresh(): string {
  return [...crypto.getRandomValues(new Uint8Array(16))].map((byte) => byte.toString(16).padStart(2, '0')).join('');
}

/** It is stored while the page is away alone: a tab that is duplicated meanwhile is another one. */
export const tab = sessionStorage.getItem(key) ?? fresh();

sessionStorage.removeItem(key);
addEventListener('pagehide', () => sessionStorage.setItem(key, tab));
addEventListener('pageshow', () => sessionStorage.removeItem(key));
