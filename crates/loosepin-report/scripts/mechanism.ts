// Moves the mechanism through the poses beside its picture: play, pause, choose a pose, magnify the deviation. Follows the cursor of the
// page, and moves it.
(() => {
  const secondsPerTurn = 4;
  const mostPartOfTurn = 359;

  interface BodyMotion {
    x: number[];
    y: number[];
    a: number[];
    dx: number[];
    dy: number[];
    da: number[];
  }

  /** The bent axis of a flexible body, in mm in the frame of its body. */
  interface Bend {
    places: number[][];
    normal: number[];
    shapes: number[][];
    turns: number[][];
    factor: number;
    /** x and y of each place at each pose, in place of shapes. */
    track?: number[][][];
  }

  interface Motion {
    angle_deg: number[];
    magnification: number;
    start: number;
    bodies: BodyMotion[];
    bends?: Bend[];
  }

  function between(list: number[], index: number, share: number): number {
    if (list.length === 0) return 0;
    const first = list[index] ?? 0;
    const second = list[Math.min(index + 1, list.length - 1)] ?? first;
    return first + share * (second - first);
  }

  function bent(bend: Bend | undefined, index: number, share: number): string {
    if (!bend) return '';
    if (bend.track) {
      return bend.track.map(([x = [], y = []], place) =>
        (place ? 'L' : 'M') + between(x, index, share).toFixed(3) + ' ' + between(y, index, share).toFixed(3)).join('');
    }
    const [normalX = 0, normalY = 0] = bend.normal;
    return bend.places.map(([x = 0, y = 0], place) => {
      const drawn = bend.factor * bend.shapes.reduce((sum, shape, k) => sum + (shape[place] ?? 0) * between(bend.turns[k] ?? [], index, share), 0);
      return (place ? 'L' : 'M') + (x + drawn * normalX).toFixed(3) + ' ' + (y + drawn * normalY).toFixed(3);
    }).join('');
  }

  function build(figure: HTMLElement): void {
    const data = JSON.parse(figure.querySelector('script[type="application/json"]')?.textContent ?? '') as Motion;
    const bodies = [...figure.querySelectorAll<SVGElement>('[data-body]')];
    const ghosts = [...figure.querySelectorAll<SVGElement>('[data-ghost]')];
    const rings = [...figure.querySelectorAll<SVGElement>('.bearing')];
    const axes = [...figure.querySelectorAll<SVGElement>('[data-bend]')];
    const riders = [...figure.querySelectorAll<SVGElement>('[data-rides]')];
    const magnified = figure.querySelector<SVGElement>('.magnified');
    const play = figure.querySelector<HTMLButtonElement>('.play');
    const slider = figure.querySelector<HTMLInputElement>('.pose');
    const output = figure.querySelector<HTMLElement>('.angle');
    const choice = figure.querySelector<HTMLSelectElement>('.magnification');
    const count = data.angle_deg.length;
    const angles = data.angle_deg;
    const isTurn = Math.abs((angles[count - 1] ?? 0) - (angles[0] ?? 0)) > mostPartOfTurn;
    /** Less than a turn is told as charts tell it. */
    const told = (angle: number): number => isTurn ? ((angle % 360) + 360) % 360 : angle;
    let magnification = data.magnification;
    let pose = data.start;
    let isRunning = false;
    let lastTime = 0;

    /** x, y in mm and angle in degrees. */
    function placed(body: BodyMotion | undefined, index: number, share: number, factor: number): [number, number, number] {
      if (!body) return [0, 0, 0];
      const at = (list: number[], difference: number[]): number => between(list, index, share) + factor * between(difference, index, share);
      return [at(body.x, body.dx), at(body.y, body.dy), at(body.a, body.da)];
    }

    function transform(body: BodyMotion | undefined, index: number, share: number, factor: number): string {
      const [x, y, a] = placed(body, index, share, factor);
      return 'translate(' + x.toFixed(4) + ' ' + y.toFixed(4) + ') rotate(' + a.toFixed(5) + ')';
    }

    /** Moves with a point of a body, and stays upright. */
    function ride(rider: SVGElement, index: number, share: number): string {
      const [x, y, a] = placed(data.bodies[Number(rider.dataset.rides)], index, share, magnification);
      const [ownX, ownY] = [Number(rider.dataset.x), Number(rider.dataset.y)];
      const [sine, cosine] = [Math.sin(a * Math.PI / 180), Math.cos(a * Math.PI / 180)];
      return 'translate(' + (x + cosine * ownX - sine * ownY).toFixed(4) + ' ' + (y + sine * ownX + cosine * ownY).toFixed(4) + ')';
    }

    function draw(): number {
      const index = Math.min(Math.floor(pose), count - 1);
      const share = pose - index;
      bodies.forEach((body) => body.setAttribute('transform', transform(data.bodies[Number(body.dataset.body)], index, share, magnification)));
      axes.forEach((axis) => axis.setAttribute('d', bent(data.bends?.[Number(axis.dataset.bend)], index, share)));
      riders.forEach((rider) => rider.setAttribute('transform', ride(rider, index, share)));
      ghosts.forEach((ghost) => ghost.setAttribute('transform', transform(data.bodies[Number(ghost.dataset.ghost)], index, share, 0)));
      const angle = between(angles, index, share);
      if (output) output.textContent = told(angle).toFixed(0) + '°';
      if (slider) slider.value = String(Math.round(pose));
      return angle;
    }

    function frame(time: number): void {
      if (!isRunning) return;
      if (lastTime) {
        const turns = Math.max(Math.abs((angles[count - 1] ?? 0) - (angles[0] ?? 0)) / 360, 0.05);
        pose = (pose + (time - lastTime) / 1000 / secondsPerTurn / turns * (count - 1)) % (count - 1);
        pageCursor.set(draw(), figure, 'played');
      }
      lastTime = time;
      requestAnimationFrame(frame);
    }

    function run(isStarted: boolean): void {
      isRunning = isStarted && count > 1;
      if (play) {
        play.textContent = isRunning ? 'Pause' : 'Animate';
        play.setAttribute('aria-pressed', String(isRunning));
      }
      lastTime = 0;
      if (isRunning) requestAnimationFrame(frame);
    }

    play?.addEventListener('click', () => run(!isRunning));
    slider?.addEventListener('input', () => {
      run(false);
      pose = Number(slider.value);
      pageCursor.set(draw(), figure, 'chosen');
    });
    choice?.addEventListener('change', () => {
      magnification = Number(choice.value);
      rings.forEach((ring) => ring.setAttribute('r', (Number(ring.dataset.pin) + magnification * Number(ring.dataset.clearance)).toFixed(4)));
      if (magnified) magnified.textContent = magnification === 1 ? 'play true to scale' : 'play × ' + magnification;
      draw();
    });
    pageCursor.listen((angleDeg, from) => {
      if (from === figure) return;
      run(false);
      // The angle within the turn that is drawn, between its two poses.
      const [first = 0, last = 0] = [angles[0], angles[count - 1]];
      const sign = last < first ? -1 : 1;
      const inTurn = first + sign * ((((angleDeg - first) * sign) % 360) + 360) % 360;
      const above = angles.findIndex((angle) => sign * (angle - inTurn) >= 0);
      if (above <= 0) pose = above < 0 ? count - 1 : 0;
      else {
        const [low = 0, high = 1] = [angles[above - 1], angles[above]];
        pose = above - 1 + (high === low ? 0 : (inTurn - low) / (high - low));
      }
      draw();
    });
    draw();
    figure.dataset.drawn = 'true';
    // Begin by itself when first seen, unless the reader asked for less motion or for an angle.
    if (!matchMedia('(prefers-reduced-motion: reduce)').matches && pageCursor.inAddress() === null) {
      const observer = new IntersectionObserver((seen) => {
        if (!seen.some((entry) => entry.isIntersecting)) return;
        observer.disconnect();
        run(true);
      }, { threshold: 0.6 });
      // On a narrow screen the figure has no box of its own.
      observer.observe(figure.querySelector('svg') ?? figure);
    }
  }

  document.querySelectorAll<HTMLElement>('[data-mechanism]').forEach(build);
})();
