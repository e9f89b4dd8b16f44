// Sections that open on click. The page has them open, for readers without scripts: they are closed here, but for the one in the address.
// Paper shows what the screen shows: a line says which sections are closed, and how all of them are printed.
(() => {
  const folds = [...document.querySelectorAll<HTMLDetailsElement>('details.fold')];
  if (folds.length === 0) return;
  const all = document.querySelector<HTMLButtonElement>('.fold-all button');
  const areOpen = (): boolean => folds.every((fold) => fold.open);
  const showState = (): void => { if (all) all.textContent = areOpen() ? 'Close all sections' : 'Open all sections'; };

  function openNamed(): void {
    const named = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    const inside = named?.closest<HTMLDetailsElement>('details.fold') ?? named?.querySelector<HTMLDetailsElement>(':scope > details.fold');
    if (!named || !inside || inside.open) return;
    inside.open = true;
    named.scrollIntoView();
  }

  folds.forEach((fold) => {
    fold.open = false;
    fold.addEventListener('toggle', showState);
  });
  all?.addEventListener('click', () => {
    const isOpen = !areOpen();
    folds.forEach((fold) => { fold.open = isOpen; });
  });
  addEventListener('hashchange', openNamed);
  addEventListener('load', openNamed);

  const leftOut = document.querySelector<HTMLElement>('.left-out');
  addEventListener('beforeprint', () => {
    if (!leftOut) return;
    const closed = folds.filter((fold) => !fold.open).map((fold) => fold.querySelector('summary')?.textContent ?? '');
    leftOut.hidden = closed.length === 0;
    leftOut.textContent = 'Closed sections are not printed: ' + closed.join('; ') + '. “Open all sections” on the page prints them too.';
  });
  addEventListener('afterprint', () => { if (leftOut) leftOut.hidden = true; });
})();
