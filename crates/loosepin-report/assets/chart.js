"use strict";
// Makes the charts of the page live: each keeps the picture that the library drew, and moves what is in it. Fits the width, reads values
// off, enlarges, hides curves; charts over the angle of a drive follow the cursor of the page.
(() => {
    const namespace = 'http://www.w3.org/2000/svg';
    const narrowPx = 520;
    const paperPx = 680;
    const lowPx = 230;
    const paperHighPx = 225;
    const leastAcross = 58;
    const leastUp = 38;
    const freeShare = 0.06;
    const fits = [];
    /** Columns of numbers; a gap is not a number. */
    function columnsOf(text) {
        const rows = text.trim().split('\n').slice(1).map((row) => row.split(',').map((cell) => cell === '' ? NaN : Number(cell)));
        return (rows[0] ?? []).map((_, column) => rows.map((row) => row[column] ?? NaN));
    }
    function element(name, attributes) {
        const made = document.createElementNS(namespace, name);
        Object.entries(attributes).forEach(([key, value]) => made.setAttribute(key, String(value)));
        return made;
    }
    function build(holder) {
        const figure = holder.closest('figure');
        const svg = holder.querySelector('svg');
        const table = figure?.querySelector('script[type="text/csv"]');
        if (!figure || !svg || !table)
            throw new Error('the chart is not whole');
        const columns = columnsOf(table.textContent ?? '');
        const xs = columns[0] ?? [];
        const [left = 0, top = 0, width = 1, height = 1, x0 = 0, x1 = 1, y0 = 0, y1 = 1] = (holder.dataset.plot ?? '').split(' ').map(Number);
        const [, , viewWidth = 1, viewHeight = 1] = (svg.getAttribute('viewBox') ?? '').split(' ').map(Number);
        const right = viewWidth - left - width;
        const below = viewHeight - top - height;
        const isAngle = holder.dataset.angle !== undefined;
        const isFixed = holder.dataset.fixed !== undefined;
        const xUnit = holder.dataset.xUnit ?? '';
        const yUnit = holder.dataset.yUnit ?? '';
        // One turn that does not begin at 0° is still told in angles from 0° to 360°.
        const isOneTurn = isAngle && Math.abs(x1 - x0 - 360) < 1e-3 && x0 !== 0;
        const told = (x) => isOneTurn ? ((x % 360) + 360) % 360 : x;
        // Places by which neighbours are told apart, where four digits do not do it.
        const gaps = xs.slice(1).map((x, place) => Math.abs(x - (xs[place] ?? NaN))).filter((gap) => gap > 0);
        const least = gaps.reduce((found, gap) => Math.min(found, gap), Infinity);
        const apart = isFinite(least) ? 10 ** Math.floor(Math.log10(least) + 1e-6) : undefined;
        const readApart = (x) => [readText(x), readText(x, apart)].reduce((one, other) => other.length > one.length ? other : one);
        const position = figure.querySelector('.position');
        const values = [...figure.querySelectorAll('[data-value]')];
        const reset = figure.querySelector('.reset');
        const buttons = [...figure.querySelectorAll('[data-entry]')];
        let next = 1;
        const columnsOfEntry = buttons.map((button) => {
            const count = Number(button.dataset.columns);
            next += count;
            return columns.slice(next - count, next);
        });
        // Places of the dots, read off the picture: no table has them.
        const dots = [...svg.querySelectorAll('path.dots')].map((path) => ({
            entry: Number(path.dataset.of),
            points: [...(path.getAttribute('d') ?? '').matchAll(/M(\S+) (\S+)h0/g)].map(([, across, down]) => ({ x: x0 + (Number(across) - left) / width * (x1 - x0), y: y1 - (Number(down) - top) / height * (y1 - y0) })),
        }));
        const line = element('line', { class: 'cursor', visibility: 'hidden' });
        const chosen = element('rect', { class: 'chosen', visibility: 'hidden' });
        svg.append(chosen, line);
        let shown = { from: x0, to: x1, low: y0, high: y1 };
        let plotWidth = width;
        let plotHeight = height;
        let index = null;
        const across = (x) => left + (x - shown.from) / (shown.to - shown.from) * plotWidth;
        const up = (y) => top + (shown.high - y) / (shown.high - shown.low) * plotHeight;
        function draw() {
            const total = left + plotWidth + right;
            svg?.setAttribute('viewBox', '0 0 ' + total + ' ' + (top + plotHeight + below));
            const scaleX = plotWidth / width * (x1 - x0) / (shown.to - shown.from);
            const scaleY = plotHeight / height * (y1 - y0) / (shown.high - shown.low);
            const matrix = [scaleX, 0, 0, scaleY, across(x0) - left * scaleX, up(y1) - top * scaleY];
            svg?.querySelectorAll('.curves > g').forEach((group) => group.setAttribute('transform', 'matrix(' + matrix.join(' ') + ')'));
            svg?.querySelectorAll('clipPath rect').forEach((frame) => {
                frame.setAttribute('width', String(plotWidth));
                frame.setAttribute('height', String(plotHeight));
            });
            const bottom = top + plotHeight;
            const acrossTicks = ticks(shown.from, shown.to, (shown.to - shown.from) * leastAcross / plotWidth, isAngle);
            svg?.querySelector('g.across')?.replaceChildren(...acrossTicks.values.flatMap((tick) => {
                const label = element('text', { x: across(tick), y: bottom + 17, 'text-anchor': 'middle' });
                label.textContent = tickText(told(tick), acrossTicks.step);
                return [element('line', { class: 'grid', x1: across(tick), x2: across(tick), y1: top, y2: bottom }), label];
            }));
            const upTicks = ticks(shown.low, shown.high, (shown.high - shown.low) * leastUp / plotHeight, false);
            svg?.querySelector('g.up')?.replaceChildren(...upTicks.values.flatMap((tick) => {
                const label = element('text', { x: left - 7, y: up(tick) + 4, 'text-anchor': 'end' });
                label.textContent = tickText(tick, upTicks.step);
                return [element('line', { class: 'grid', x1: left, x2: left + plotWidth, y1: up(tick), y2: up(tick) }), label];
            }));
            svg?.querySelectorAll('.marks [data-at]').forEach((mark) => {
                const place = across(Number(mark.dataset.at));
                mark.setAttribute('visibility', place >= left && place <= left + plotWidth ? 'visible' : 'hidden');
                if (mark.tagName === 'text') {
                    // A mark near the right end has its words on its left.
                    const isLate = place > left + 0.75 * plotWidth;
                    mark.setAttribute('x', String(isLate ? place - 5 : place + 5));
                    mark.setAttribute('text-anchor', isLate ? 'end' : 'start');
                }
                else {
                    mark.setAttribute('x1', String(place));
                    mark.setAttribute('x2', String(place));
                    mark.setAttribute('y2', String(bottom));
                }
            });
            const nameOfX = svg?.querySelector('.name.of-x');
            nameOfX?.setAttribute('x', String(left + plotWidth / 2));
            nameOfX?.setAttribute('y', String(top + plotHeight + below - 8));
            placeNameOfY(top + plotHeight + below);
            if (reset)
                reset.hidden = shown.from <= x0 && shown.to >= x1;
            show(index);
        }
        /** The name of the upright axis: beside its middle, but whole within the picture. */
        function placeNameOfY(height) {
            const name = svg?.querySelector('.name.of-y');
            if (!name)
                return;
            name.removeAttribute('textLength');
            const room = height - 4;
            const length = Math.min(name.getComputedTextLength(), room);
            if (length === room) {
                name.setAttribute('textLength', String(room));
                name.setAttribute('lengthAdjust', 'spacingAndGlyphs');
            }
            const middle = Math.max(top + plotHeight / 2, length / 2 + 2);
            name.setAttribute('transform', 'translate(13 ' + Math.min(middle, height - length / 2 - 2) + ') rotate(-90)');
        }
        /** As wide as the page has room; low on narrow screens and on paper. */
        function fit(paper) {
            const room = paper ?? holder.clientWidth;
            if (room === 0)
                return;
            plotWidth = Math.max(room, 220) - left - right;
            const most = paper === undefined ? (room < narrowPx ? lowPx : viewHeight) : paperHighPx;
            plotHeight = Math.min(viewHeight, most) - top - below;
            draw();
        }
        function show(place) {
            index = place;
            const x = place === null ? NaN : xs[place] ?? NaN;
            if (place === null || !isFinite(x)) {
                if (position)
                    position.textContent = 'Move over the chart to read values.';
                values.forEach((value) => { value.textContent = ''; });
                line.setAttribute('visibility', 'hidden');
                return;
            }
            if (position)
                position.textContent = (holder.dataset.xName ?? '') + ': ' + withUnit(readApart(told(x)), xUnit);
            // As many places for all values as a thousandth of the axis needs.
            const range = shown.high - shown.low;
            const step = range > 1e-3 && range < 1e7 ? 10 ** Math.floor(Math.log10(range / 1000)) : undefined;
            values.forEach((value, entry) => {
                const numbers = (columnsOfEntry[entry] ?? []).map((column) => readText(column[place] ?? NaN, step));
                value.textContent = withUnit(numbers.join(' … '), yUnit);
            });
            const isInside = x >= shown.from && x <= shown.to;
            line.setAttribute('visibility', isInside ? 'visible' : 'hidden');
            line.setAttribute('x1', String(across(x)));
            line.setAttribute('x2', String(across(x)));
            line.setAttribute('y1', String(top));
            line.setAttribute('y2', String(top + plotHeight));
        }
        function nearest(x) {
            let best = null;
            xs.forEach((value, place) => {
                if (isFinite(value) && (best === null || Math.abs(value - x) < Math.abs((xs[best] ?? NaN) - x)))
                    best = place;
            });
            return best;
        }
        function zoomTo(from, to) {
            const [least, most] = [Math.max(from, x0), Math.min(to, x1)];
            // Narrower, numbers have no digits left for ticks.
            if (!(most - least > 1e-6 * Math.abs(x1 - x0)))
                return;
            let [low, high] = [y0, y1];
            if (!isFixed && (least > x0 || most < x1)) {
                const isShown = (entry) => buttons[entry]?.getAttribute('aria-pressed') === 'true';
                const isInside = (x) => x >= least && x <= most;
                const seen = columnsOfEntry.filter((_, entry) => isShown(entry)).flat()
                    .flatMap((column) => column.filter((value, place) => isFinite(value) && isInside(xs[place] ?? NaN)));
                dots.filter(({ entry }) => isShown(entry)).forEach(({ points }) => {
                    seen.push(...points.filter(({ x }) => isInside(x)).map(({ y }) => y));
                });
                const ends = seen.reduce((found, value) => [Math.min(found[0] ?? value, value), Math.max(found[1] ?? value, value)], [Infinity, -Infinity]);
                const free = freeShare * ((ends[1] ?? 1) - (ends[0] ?? 0));
                if (free > 0 && isFinite(free))
                    [low, high] = [(ends[0] ?? 0) - free, (ends[1] ?? 1) + free];
            }
            shown = { from: least, to: most, low, high };
            draw();
        }
        const choose = (place) => {
            show(place);
            if (isAngle && place !== null)
                pageCursor.set(xs[place] ?? 0, holder, 'chosen');
        };
        const valueAt = (event) => {
            const box = holder.getBoundingClientRect();
            const scale = (left + plotWidth + right) / box.width;
            return shown.from + ((event.clientX - box.left) * scale - left) / plotWidth * (shown.to - shown.from);
        };
        let dragged = null;
        holder.addEventListener('pointerdown', (event) => { if (event.pointerType === 'mouse' && event.button === 0)
            dragged = valueAt(event); });
        holder.addEventListener('pointermove', (event) => {
            const x = valueAt(event);
            choose(nearest(Math.max(shown.from, Math.min(shown.to, x))));
            const isLong = dragged !== null && Math.abs(across(x) - across(dragged)) > 6;
            chosen.setAttribute('visibility', isLong ? 'visible' : 'hidden');
            if (dragged === null || !isLong)
                return;
            const [from, to] = [Math.max(Math.min(x, dragged), shown.from), Math.min(Math.max(x, dragged), shown.to)];
            chosen.setAttribute('x', String(across(from)));
            chosen.setAttribute('width', String(Math.max(0, across(to) - across(from))));
            chosen.setAttribute('y', String(top));
            chosen.setAttribute('height', String(plotHeight));
        });
        const release = (event) => {
            const from = dragged;
            dragged = null;
            chosen.setAttribute('visibility', 'hidden');
            if (from === null)
                return;
            const to = valueAt(event);
            if (Math.abs(across(to) - across(from)) > 6)
                zoomTo(Math.min(from, to), Math.max(from, to));
        };
        holder.addEventListener('pointerup', release);
        holder.addEventListener('pointerleave', () => {
            dragged = null;
            chosen.setAttribute('visibility', 'hidden');
            if (!isAngle)
                show(null);
        });
        holder.addEventListener('dblclick', () => zoomTo(x0, x1));
        reset?.addEventListener('click', () => zoomTo(x0, x1));
        buttons.forEach((button) => { button.disabled = false; });
        buttons.forEach((button) => button.addEventListener('click', () => {
            const isShown = button.getAttribute('aria-pressed') !== 'true';
            button.setAttribute('aria-pressed', String(isShown));
            svg.querySelectorAll('[data-of="' + button.dataset.entry + '"]').forEach((curve) => {
                curve.setAttribute('display', isShown ? 'inline' : 'none');
            });
            // The height of an enlarged chart is that of what it shows.
            zoomTo(shown.from, shown.to);
        }));
        holder.addEventListener('keydown', (event) => {
            // Those are the browser's.
            if (event.ctrlKey || event.metaKey || event.altKey)
                return;
            const current = index ?? Math.floor(xs.length / 2);
            const stride = event.shiftKey ? 10 : 1;
            const inside = (place) => Math.max(0, Math.min(xs.length - 1, place));
            if (event.key === 'ArrowRight')
                choose(inside(current + stride));
            else if (event.key === 'ArrowLeft')
                choose(inside(current - stride));
            else if (event.key === '0')
                zoomTo(x0, x1);
            else if (event.key === '+' || event.key === '-') {
                const centre = xs[current] ?? x0;
                const factor = event.key === '+' ? 0.5 : 2;
                zoomTo(centre - (centre - shown.from) * factor, centre + (shown.to - centre) * factor);
            }
            else
                return;
            event.preventDefault();
        });
        if (isAngle) {
            const follow = (angleDeg) => {
                const [first, last] = [Math.min(x0, x1), Math.max(x0, x1)];
                // Of several turns that one which the angle names, else the first one.
                const isThere = angleDeg >= first && angleDeg <= last;
                show(nearest(isThere ? angleDeg : first + (((angleDeg - first) % 360) + 360) % 360));
            };
            // While the mechanism plays, charts out of sight wait until they are seen.
            let isSeen = true;
            let missed = null;
            new IntersectionObserver((changes) => {
                isSeen = changes[changes.length - 1]?.isIntersecting ?? true;
                if (isSeen && missed !== null)
                    follow(missed);
                if (isSeen)
                    missed = null;
            }).observe(figure);
            pageCursor.listen((angleDeg, from, reason) => {
                missed = null;
                if (from === holder)
                    return;
                if (reason === 'played' && !isSeen)
                    missed = angleDeg;
                else
                    follow(angleDeg);
            });
        }
        /** A path in the units of the picture as the library drew it. */
        const path = (places, ys, isMoved) => {
            let isDown = isMoved;
            return places.map((place) => {
                // After the last pose comes the first one, a turn later.
                const [x, y] = place < xs.length ? [xs[place] ?? NaN, ys[place] ?? NaN] : [(xs[0] ?? NaN) + 360, ys[0] ?? NaN];
                if (!isFinite(x) || !isFinite(y)) {
                    isDown = false;
                    return '';
                }
                const command = isDown ? 'L' : 'M';
                isDown = true;
                return command + (left + (x - x0) / (x1 - x0) * width).toFixed(1) + ' ' + (top + (y1 - y) / (y1 - y0) * height).toFixed(1);
            }).join('');
        };
        // Another band in the place of one that is there; without ends, the one that was there at first.
        const stored = columnsOfEntry.map((columns, entry) => ({
            columns, paths: [...svg.querySelectorAll('[data-of="' + entry + '"]')].map((path) => path.getAttribute('d') ?? ''),
        }));
        holder.addEventListener('band', (event) => {
            const { entry, ends } = event.detail;
            const drawn = [...svg.querySelectorAll('[data-of="' + entry + '"]')];
            const first = stored[entry];
            if (!first)
                return;
            columnsOfEntry[entry] = ends ?? first.columns;
            if (ends) {
                const places = [...xs.map((_, place) => place), ...(holder.dataset.closed === undefined ? [] : [xs.length])];
                const [lower, upper] = ends;
                const lines = drawn.filter((one) => one.classList.contains('line'));
                ends.forEach((ys, side) => lines[side]?.setAttribute('d', path(places, ys, false)));
                const isWhole = [...lower, ...upper].every(isFinite);
                const filled = isWhole ? path(places, upper, false) + path([...places].reverse(), lower, true) + 'Z' : '';
                drawn.find((one) => one.classList.contains('fill'))?.setAttribute('d', filled);
            }
            else
                drawn.forEach((one, place) => one.setAttribute('d', first.paths[place] ?? ''));
            zoomTo(shown.from, shown.to);
        });
        let known = holder.clientWidth;
        new ResizeObserver(() => {
            if (holder.clientWidth === known)
                return;
            known = holder.clientWidth;
            fit();
        }).observe(holder);
        fits.push(fit);
        fit();
        holder.tabIndex = 0;
        holder.dataset.drawn = 'true';
    }
    document.querySelectorAll('[data-chart]').forEach((holder) => {
        try {
            build(holder);
        }
        catch (error) {
            // The picture stays as the library drew it.
            console.error(error);
        }
    });
    // On paper the page is light and as wide as the paper, whatever the screen was.
    let closed = [];
    addEventListener('beforeprint', () => {
        document.documentElement.classList.add('printing');
        const glossaries = [...document.querySelectorAll('details.glossary:not([open])')];
        // A folded page prints what its reader has opened.
        closed = glossaries.filter((details) => !details.closest('.folds'));
        closed.forEach((details) => { details.open = true; });
        fits.forEach((fit) => fit(paperPx));
    });
    addEventListener('afterprint', () => {
        document.documentElement.classList.remove('printing');
        closed.forEach((details) => { details.open = false; });
        fits.forEach((fit) => fit());
    });
    const follow = () => {
        const angle = pageCursor.inAddress();
        if (angle !== null)
            pageCursor.set(angle, null, 'opened');
    };
    addEventListener('load', follow);
    addEventListener('hashchange', follow);
})();
