"use strict";
// Figures of one kind of which one is shown: a list of their names chooses it. Without scripts all of them are there.
(() => {
    document.querySelectorAll('[data-chooser]').forEach((chooser) => {
        const list = chooser.querySelector('select');
        const figures = [...chooser.querySelectorAll(':scope > figure')];
        if (!list || figures.length < 2)
            return;
        const show = () => figures.forEach((figure, place) => { figure.hidden = place !== list.selectedIndex; });
        list.addEventListener('change', show);
        show();
    });
})();
