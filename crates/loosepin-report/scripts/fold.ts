// Sections that open on click. The page has them open, for readers without scripts: they are closed here, but for the one in the address.
// On paper those are open that the page means for it, and those that the reader has opened.
(() => {
  const folds = [...document.querySelectorAll<HTMLDetailsElement>('details.fold')];
  if (folds.length === 0) return;
  const all = document.querySelector<HTMLButtonElement>('.fold-all button');
  const ofSections = folds.filter((fold) => fold.closest('.folds'));
  const areOpen = (): boolean => ofSections.every((fold) => fold.open);
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
    ofSections.forEach((fold) => { fold.open = isOpen; });
  });
  addEventListener('hashchange', openNamed);
  addEventListener('load', openNamed);

  let opened: HTMLDetailsElement[] = [];
  addEventListener('beforeprint', () => {
    opened = folds.filter((fold) => !fold.open && fold.matches('.printed'));
    opened.forEach((fold) => { fold.open = true; });
  });
  addEventListener('afterprint', () => {
    opened.forEach((fold) => { fold.open = false; });
    opened = [];
  });
})();
