// Marks on each path where its point is at the angle of the page's cursor, with the reach of the play along and across its motion; moves the
// cursor from there. The places stand in the table behind the figure.
(() => {
  const radius = 6;
  const namespace = 'http://www.w3.org/2000/svg';

  function build(figure: HTMLElement): void {
    const svg = figure.querySelector<SVGSVGElement>('svg.figure');
    const ideal = figure.querySelector<SVGElement>('.ideal');
    const [head = '', ...rows] = (figure.querySelector('script[type="text/csv"]')?.textContent ?? '').trim().split('\n');
    const heads = head.split(',');
    if (!svg || !ideal || rows.length === 0 || heads[0] !== 'angle [deg]') return;
    const columnOf = (name: string): number[] => {
      const column = heads.findIndex((own) => own.startsWith(name + ' ['));
      return rows.map((row) => { const cell = row.split(',')[column]; return cell ? Number(cell) : NaN; });
    };
    const [angles, xs, ys, directions, along, across] =
      ['angle', 'x', 'y', 'direction of motion', 'play along', 'play across'].map(columnOf) as [number[], number[], number[], number[], number[], number[]];
    // A run has places beside its ideal ones; the picture magnifies the difference.
    const [idealXs, idealYs] = heads.some((own) => own.startsWith('ideal x [')) ? [columnOf('ideal x'), columnOf('ideal y')] : [xs, ys];
    const unit = /\[(.*)\]/.exec(heads[1] ?? '')?.[1] ?? '';
    const [x0, y0, scale, magnification] = [ideal.dataset.x0, ideal.dataset.y0, ideal.dataset.scale, ideal.dataset.magnification].map(Number) as [number, number, number, number];
    const reading = figure.querySelector<HTMLElement>('.reading');
    const now = document.createElementNS(namespace, 'g');
    now.setAttribute('class', 'now');
    now.setAttribute('visibility', 'hidden');
    const cross = document.createElementNS(namespace, 'path');
    const dot = document.createElementNS(namespace, 'circle');
    dot.setAttribute('r', String(radius));
    now.append(cross, dot);
    svg.append(now);
    const [least, most] = angles.reduce(([low, high], angle) => [Math.min(low, angle), Math.max(high, angle)] as const, [Infinity, -Infinity] as const);
    let place = 0;

    /** Where a position stands in the picture, in the unit of the table. */
    function drawn(at: number): [number, number] {
      const from = (ideals: number[], own: number[]): number => { const ideal = ideals[at] ?? NaN; return ideal + magnification * ((own[at] ?? NaN) - ideal); };
      return [from(idealXs, xs), from(idealYs, ys)];
    }

    function show(next: number): void {
      place = next;
      const at = (list: number[]): number => list[place] ?? NaN;
      const [x, y] = [at(xs), at(ys)];
      const [drawnX, drawnY] = drawn(place);
      now.setAttribute('visibility', isFinite(x + y) ? 'visible' : 'hidden');
      // Upwards is below zero in a picture.
      now.setAttribute('transform', 'translate(' + (x0 + drawnX * scale).toFixed(2) + ' ' + (y0 - drawnY * scale).toFixed(2) + ') rotate(' + (-at(directions) || 0).toFixed(2) + ')');
      const [far, wide] = [at(along), at(across)].map((reach) => (reach * scale * magnification).toFixed(1));
      if (isFinite(at(along))) cross.setAttribute('d', 'M-' + far + ' 0H' + far + 'M0 -' + wide + 'V' + wide);
      const inTurn = ((at(angles) % 360) + 360) % 360;
      const near = (value: number): string => withUnit(readText(value), unit);
      const strays = at(along) > 0 || at(across) > 0 ? '; play ±' + near(at(along)) + ' along, ±' + near(at(across)) + ' across' : '';
      if (reading) reading.textContent = 'At ' + readText(inTurn) + '°: x ' + near(x) + ', y ' + near(y) + strays + '.';
    }

    function choose(next: number): void {
      show(Math.max(0, Math.min(rows.length - 1, next)));
      pageCursor.set(angles[place] ?? 0, figure, 'chosen');
    }

    svg.addEventListener('pointermove', (event) => {
      const box = svg.getBoundingClientRect();
      const shown = svg.viewBox.baseVal.width / box.width;
      const [x, y] = [((event.clientX - box.left) * shown - x0) / scale, (y0 - (event.clientY - box.top) * shown) / scale];
      const away = (at: number): number => { const [drawnX, drawnY] = drawn(at); return Math.hypot(drawnX - x, drawnY - y); };
      let best = place;
      rows.forEach((_, at) => { if (away(at) < away(best)) best = at; });
      choose(best);
    });
    svg.tabIndex = 0;
    svg.addEventListener('keydown', (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      const stride = event.shiftKey ? 10 : 1;
      if (event.key === 'ArrowRight') choose(place + stride);
      else if (event.key === 'ArrowLeft') choose(place - stride);
      else return;
      event.preventDefault();
    });
    pageCursor.listen((angleDeg, from) => {
      if (from === figure) return;
      // Of several turns that one which the angle names, else the first one, as in the charts.
      const wanted = angleDeg >= least && angleDeg <= most ? angleDeg : least + (((angleDeg - least) % 360) + 360) % 360;
      let best = 0;
      angles.forEach((angle, at) => { if (Math.abs(angle - wanted) < Math.abs((angles[best] ?? NaN) - wanted)) best = at; });
      show(best);
    });
    figure.dataset.drawn = 'true';
  }

  document.querySelectorAll<HTMLElement>('figure.trace').forEach(build);
})();
