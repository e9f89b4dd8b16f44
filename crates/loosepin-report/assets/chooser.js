"use strict";
// Shows one of several figures at a time, with a button for each.
(() => {
    document.querySelectorAll('[data-chooser]').forEach((chooser) => {
        const choices = [...chooser.querySelectorAll(':scope > [data-choice]')];
        chooser.dataset.drawn = 'true';
        if (choices.length < 2)
            return;
        const row = document.createElement('div');
        row.className = 'choices';
        row.setAttribute('role', 'group');
        row.setAttribute('aria-label', 'Shown of ' + (chooser.dataset.chooser ?? ''));
        const buttons = choices.map((choice) => {
            const button = document.createElement('button');
            button.type = 'button';
            button.textContent = choice.dataset.choice ?? '';
            button.addEventListener('click', () => show(choice));
            return button;
        });
        const show = (shown) => choices.forEach((choice, place) => {
            choice.hidden = choice !== shown;
            buttons[place]?.setAttribute('aria-pressed', String(choice === shown));
        });
        row.append(...buttons);
        chooser.prepend(row);
        if (choices[0])
            show(choices[0]);
    });
})();
