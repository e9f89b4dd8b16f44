"use strict";
// Turns the picture of a mechanism in space, and moves it: dragged, by arrow keys, to a standard view, through its turn. Follows the cursor of the
// page, and moves it. It is drawn by space-scene.ts.
(() => {
    const secondsPerTurn = 4;
    const degreesPerPixel = 0.5;
    const widestLetter = 0.62;
    const edgeLetters = 0.4;
    function build(figure) {
        const data = JSON.parse(figure.querySelector('script[type="application/json"]')?.textContent ?? '');
        const svg = figure.querySelector('svg.figure');
        if (!svg)
            throw new Error('the picture is not whole');
        const scene = window.spaceScene(svg, data);
        const play = figure.querySelector('.play');
        const slider = figure.querySelector('.pose');
        const output = figure.querySelector('.angle');
        const views = [...figure.querySelectorAll('[data-azimuth]')];
        const { inputs } = data;
        const count = inputs.length;
        let [azimuth, elevation] = [data.azimuth, data.elevation];
        let pose = data.start;
        let isRunning = false;
        let lastTime = 0;
        const names = [...svg.querySelectorAll('.names text')];
        const sheet = svg.viewBox.baseVal;
        const toldAngle = (angle) => data.is_turn ? ((angle % 360) + 360) % 360 : angle;
        /** Names that the edge of the sheet would cut, moved so far that it does not: as in src/spatial/names.rs. */
        function keepInside() {
            const edge = edgeLetters * data.font;
            names.forEach((name) => {
                const width = widestLetter * [...(name.textContent ?? '')].length * data.font;
                const anchor = name.getAttribute('text-anchor');
                const before = anchor === 'start' ? 0 : anchor === 'end' ? width : 0.5 * width;
                const bounded = (attribute, least, most) => {
                    const own = Number(name.getAttribute(attribute));
                    const moved = Math.max(Math.min(own, most), least);
                    if (moved !== own)
                        name.setAttribute(attribute, moved.toFixed(6));
                };
                bounded('x', sheet.x + edge + before, sheet.x + sheet.width - edge - width + before);
                bounded('y', sheet.y + edge + data.font, sheet.y + sheet.height - edge - 0.3 * data.font);
            });
        }
        function draw() {
            scene.draw(pose, azimuth, elevation);
            keepInside();
            views.forEach((view) => {
                const isShown = Math.abs(Number(view.dataset.azimuth) - azimuth) < 1e-3 && Math.abs(Number(view.dataset.elevation) - elevation) < 1e-3;
                view.setAttribute('aria-pressed', String(isShown));
            });
            const input = inputs[Math.min(Math.round(pose), count - 1)] ?? 0;
            if (output)
                output.textContent = data.is_angle ? toldAngle(scene.inputAt(pose)).toFixed(0) + '°' : readText(input) + '\u00a0s';
            if (slider)
                slider.value = String(Math.round(pose));
        }
        function moved(reason) {
            draw();
            if (data.is_angle)
                pageCursor.set(scene.inputAt(pose), figure, reason);
        }
        function frame(time) {
            if (!isRunning)
                return;
            if (lastTime) {
                pose = (pose + (time - lastTime) / 1000 / secondsPerTurn * (count - 1)) % (count - 1);
                moved('played');
            }
            lastTime = time;
            requestAnimationFrame(frame);
        }
        function run(isStarted) {
            isRunning = isStarted && count > 1;
            if (play) {
                play.textContent = isRunning ? 'Pause' : 'Animate';
                play.setAttribute('aria-pressed', String(isRunning));
            }
            lastTime = 0;
            if (isRunning)
                requestAnimationFrame(frame);
        }
        function turnTo(azimuthDeg, elevationDeg) {
            azimuth = ((azimuthDeg % 360) + 360) % 360;
            elevation = Math.max(-90, Math.min(90, elevationDeg));
            draw();
        }
        play?.addEventListener('click', () => run(!isRunning));
        slider?.addEventListener('input', () => {
            run(false);
            pose = Number(slider.value);
            moved('chosen');
        });
        views.forEach((view) => view.addEventListener('click', () => turnTo(Number(view.dataset.azimuth), Number(view.dataset.elevation))));
        let dragged = null;
        svg.addEventListener('pointerdown', (event) => {
            if (event.button !== 0)
                return;
            dragged = [event.clientX, event.clientY];
            svg.setPointerCapture(event.pointerId);
            svg.classList.add('turning');
        });
        svg.addEventListener('pointermove', (event) => {
            if (!dragged)
                return;
            const [right, down] = [event.clientX - dragged[0], event.clientY - dragged[1]];
            dragged = [event.clientX, event.clientY];
            turnTo(azimuth - degreesPerPixel * right, elevation + degreesPerPixel * down);
        });
        const release = () => {
            dragged = null;
            svg.classList.remove('turning');
        };
        svg.addEventListener('pointerup', release);
        svg.addEventListener('pointercancel', release);
        svg.setAttribute('tabindex', '0');
        svg.setAttribute('aria-label', (svg.getAttribute('aria-label') ?? '') + ' Arrow keys turn it, Home shows it as at first.');
        svg.addEventListener('keydown', (event) => {
            // Those are the browser's.
            if (event.ctrlKey || event.metaKey || event.altKey)
                return;
            const stride = event.shiftKey ? 15 : 5;
            if (event.key === 'ArrowRight')
                turnTo(azimuth - stride, elevation);
            else if (event.key === 'ArrowLeft')
                turnTo(azimuth + stride, elevation);
            else if (event.key === 'ArrowUp')
                turnTo(azimuth, elevation - stride);
            else if (event.key === 'ArrowDown')
                turnTo(azimuth, elevation + stride);
            else if (event.key === 'Home')
                turnTo(data.azimuth, data.elevation);
            else
                return;
            event.preventDefault();
        });
        if (data.is_angle) {
            pageCursor.listen((angleDeg, from) => {
                if (from === figure)
                    return;
                run(false);
                // The angle within the turn that is drawn, between its two positions.
                const [start = 0, last = 0] = [inputs[0], inputs[count - 1]];
                const sign = last < start ? -1 : 1;
                const isThere = sign * (angleDeg - start) >= 0 && sign * (last - angleDeg) >= 0;
                const inTurn = isThere ? angleDeg : start + sign * ((((angleDeg - start) * sign) % 360) + 360) % 360;
                pose = scene.poseAt(inTurn);
                draw();
            });
        }
        draw();
        figure.dataset.drawn = 'true';
        // Begins by itself when first seen, unless the reader asked for less motion or for an angle.
        if (!matchMedia('(prefers-reduced-motion: reduce)').matches && pageCursor.inAddress() === null) {
            const observer = new IntersectionObserver((entries) => {
                if (!entries.some((entry) => entry.isIntersecting))
                    return;
                observer.disconnect();
                run(true);
            }, { threshold: 0.6 });
            // On a narrow screen the figure has no box of its own.
            observer.observe(svg);
        }
    }
    document.querySelectorAll('[data-space]').forEach(build);
})();
