"use strict";
// What if the unknown values were known: a slider over the values that were run, or a map of them, gives the first chart the band of one.
(() => {
    const namespace = 'http://www.w3.org/2000/svg';
    const levels = 9999;
    const side = 220;
    const room = 14;
    function build(holder) {
        const data = JSON.parse(holder.querySelector('script')?.textContent ?? '');
        const chart = document.getElementById(data.chart)?.querySelector('[data-chart]');
        const choice = holder.querySelector('.choice');
        const chosen = holder.querySelector('.chosen');
        if (!chart || !choice || !chosen)
            return;
        const value = (level) => level < 0 ? NaN : data.range[0] + level / levels * (data.range[1] - data.range[0]);
        let mark = () => undefined;
        function choose(place) {
            const point = data.points[place];
            if (!point || !chart || !chosen)
                return;
            const [lower, upper] = [point.lower.map(value), point.upper.map(value)];
            chart.dispatchEvent(new CustomEvent('band', { detail: { entry: data.entry, lower, upper } }));
            const finite = (list) => list.filter((one) => isFinite(one));
            const unit = chart.dataset.yUnit ?? '';
            chosen.textContent = point.words + ': the band lies within ' + withUnit(readText(Math.min(...finite(lower))) + ' … '
                + readText(Math.max(...finite(upper))), unit) + ' (counted from ' + point.runs + ' runs).';
            mark(place);
        }
        if (data.inputs.length === 1) {
            const order = data.points.map((_, place) => place).sort((a, b) => (data.points[a]?.at[0] ?? 0) - (data.points[b]?.at[0] ?? 0));
            const input = data.inputs[0];
            const slider = document.createElement('input');
            slider.type = 'range';
            slider.min = '0';
            slider.max = String(order.length - 1);
            slider.value = String(Math.floor(order.length / 2));
            slider.setAttribute('aria-label', input?.name ?? '');
            slider.addEventListener('input', () => choose(order[Number(slider.value)] ?? 0));
            const [from, to] = [document.createElement('span'), document.createElement('span')];
            from.textContent = input?.from ?? '';
            to.textContent = input?.to ?? '';
            choice.append(from, slider, to);
        }
        else {
            choice.append(map());
        }
        /** A map of the first two inputs: a button for each value that was run. */
        function map() {
            const box = document.createElement('div');
            box.className = 'map';
            const svg = document.createElementNS(namespace, 'svg');
            svg.setAttribute('viewBox', '0 0 ' + (side + 2 * room) + ' ' + (side + 2 * room));
            const dots = data.points.map((point, place) => {
                const dot = document.createElementNS(namespace, 'circle');
                dot.setAttribute('cx', String(room + side * (point.at[0] ?? 0)));
                dot.setAttribute('cy', String(room + side * (1 - (point.at[1] ?? 0))));
                dot.setAttribute('r', '5');
                dot.setAttribute('tabindex', '0');
                dot.setAttribute('role', 'button');
                dot.setAttribute('aria-pressed', 'false');
                dot.setAttribute('aria-label', point.words);
                dot.addEventListener('keydown', (event) => {
                    if (event.key !== 'Enter' && event.key !== ' ')
                        return;
                    event.preventDefault();
                    choose(place);
                });
                return dot;
            });
            svg.append(...dots);
            svg.addEventListener('click', (event) => {
                const frame = svg.getBoundingClientRect();
                const scale = (side + 2 * room) / frame.width;
                const [x, y] = [(event.clientX - frame.left) * scale - room, side + room - (event.clientY - frame.top) * scale];
                const distance = (point) => Math.hypot(x - side * (point.at[0] ?? 0), y - side * (point.at[1] ?? 0));
                let best = 0;
                data.points.forEach((point, place) => { if (distance(point) < distance(data.points[best] ?? point))
                    best = place; });
                choose(best);
            });
            mark = (place) => dots.forEach((dot, own) => dot.setAttribute('aria-pressed', String(own === place)));
            const label = (index) => {
                const input = data.inputs[index];
                return input ? input.name + ', ' + input.from + ' to ' + input.to : '';
            };
            const [across, up] = [document.createElement('span'), document.createElement('span')];
            across.className = 'across';
            up.className = 'up';
            across.textContent = label(0) + ' →';
            up.textContent = label(1) + ' →';
            box.append(up, svg, across);
            return box;
        }
        holder.hidden = false;
    }
    document.querySelectorAll('[data-what-if]').forEach(build);
})();
