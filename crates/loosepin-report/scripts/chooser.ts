// Figures of one kind of which one is shown: a list of their names chooses it. Without scripts all of them are there.
(() => {
  document.querySelectorAll<HTMLElement>('[data-chooser]').forEach((chooser) => {
    const list = chooser.querySelector('select');
    const figures = [...chooser.querySelectorAll<HTMLElement>(':scope > figure')];
    if (!list || figures.length < 2) return;
    const show = (): void => figures.forEach((figure, place) => { figure.hidden = place !== list.selectedIndex; });
    list.addEventListener('change', show);
    show();
  });
})();
