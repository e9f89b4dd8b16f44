"use strict";
// Of several figures one is shown: a list of their names chooses it where the page has one, else a button for each. Without scripts all are there.
(() => {
    document.querySelectorAll('[data-chooser]').forEach((chooser) => {
        const choices = [...chooser.querySelectorAll(':scope > :is(figure, [data-choice])')];
        const list = chooser.querySelector('select');
        chooser.dataset.drawn = 'true';
        if (choices.length < 2)
            return;
        const show = (shown) => choices.forEach((choice, place) => { choice.hidden = place !== shown; });
        if (list) {
            list.addEventListener('change', () => show(list.selectedIndex));
            show(list.selectedIndex);
            return;
        }
        const row = document.createElement('div');
        row.className = 'choices';
        row.setAttribute('role', 'group');
        row.setAttribute('aria-label', 'Shown of ' + (chooser.dataset.chooser ?? ''));
        const buttons = choices.map((choice) => {
            const button = document.createElement('button');
            button.type = 'button';
            button.textContent = choice.dataset.choice ?? '';
            return button;
        });
        const press = (pressed) => {
            show(pressed);
            buttons.forEach((button, place) => button.setAttribute('aria-pressed', String(place === pressed)));
        };
        buttons.forEach((button, place) => button.addEventListener('click', () => press(place)));
        row.append(...buttons);
        chooser.prepend(row);
        press(0);
    });
})();
