"use strict";
// Marks in each orbit where the journal was at the angle of the page's cursor. The places stand in the table behind the figure; a table
// without angles has nothing to show.
(() => {
    const radius = 38;
    document.querySelectorAll('figure.orbit').forEach((figure) => {
        const circle = figure.querySelector('.clearance');
        const [head = '', ...rows] = (figure.querySelector('script[type="text/csv"]')?.textContent ?? '').trim().split('\n');
        const clearance = Number(circle?.dataset.radius);
        if (!circle || !head.startsWith('angle') || !(clearance > 0))
            return;
        const samples = rows.map((row) => row.split(',').map((cell) => cell === '' ? NaN : Number(cell)));
        const scale = Number(circle.getAttribute('r')) / clearance;
        const angles = samples.map((sample) => sample[0] ?? NaN);
        const [least, most] = angles.reduce(([low, high], angle) => [Math.min(low, angle), Math.max(high, angle)], [Infinity, -Infinity]);
        const dot = document.createElementNS('http://www.w3.org/2000/svg', 'circle');
        dot.setAttribute('class', 'now');
        dot.setAttribute('r', String(radius));
        dot.setAttribute('visibility', 'hidden');
        circle.parentElement?.append(dot);
        pageCursor.listen((angleDeg) => {
            // Of several turns that one which the angle names, else the first one, as in the charts.
            const inTurn = (((angleDeg - least) % 360) + 360) % 360;
            const wanted = angleDeg >= least && angleDeg <= most ? angleDeg : least + inTurn;
            let best = 0;
            angles.forEach((angle, place) => { if (Math.abs(angle - wanted) < Math.abs((angles[best] ?? NaN) - wanted))
                best = place; });
            const [, x = NaN, y = NaN] = samples[best] ?? [];
            const isKnown = isFinite(x) && isFinite(y);
            dot.setAttribute('visibility', isKnown ? 'visible' : 'hidden');
            if (!isKnown)
                return;
            dot.setAttribute('cx', (x * scale).toFixed(0));
            dot.setAttribute('cy', (y * scale).toFixed(0));
        });
        figure.dataset.drawn = 'true';
    });
})();
