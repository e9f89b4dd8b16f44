// Moves the mechanism through the poses beside its picture: play, pause, choose a pose, magnify the deviation.
(function () {
  'use strict';
  const secondsPerTurn = 4;

  function build(figure) {
    const data = JSON.parse(figure.querySelector('script[data-for]').textContent);
    const bodies = [...figure.querySelectorAll('[data-body]')];
    const ghosts = [...figure.querySelectorAll('[data-ghost]')];
    const rings = [...figure.querySelectorAll('.bearing')];
    const play = figure.querySelector('.play');
    const slider = figure.querySelector('.pose');
    const output = figure.querySelector('.angle');
    const choice = figure.querySelector('.magnification');
    const count = data.angle_deg.length;
    let magnification = data.magnification;
    let pose = data.start;
    let running = false;
    let lastTime = 0;

    function between(list, index, share) {
      if (list.length === 0) return 0;
      const next = Math.min(index + 1, list.length - 1);
      return list[index] + share * (list[next] - list[index]);
    }

    function transform(body, index, share, factor) {
      const at = (list, difference) => between(list, index, share) + factor * between(difference, index, share);
      return 'translate(' + at(body.x, body.dx).toFixed(4) + ' ' + at(body.y, body.dy).toFixed(4) + ') rotate(' + at(body.a, body.da).toFixed(5) + ')';
    }

    function draw() {
      const index = Math.min(Math.floor(pose), count - 1);
      const share = pose - index;
      bodies.forEach((element) => element.setAttribute('transform', transform(data.bodies[element.dataset.body], index, share, magnification)));
      ghosts.forEach((element) => element.setAttribute('transform', transform(data.bodies[element.dataset.ghost], index, share, 0)));
      output.textContent = between(data.angle_deg, index, share).toFixed(0) + '°';
    }

    function drawRings() {
      rings.forEach((ring) => ring.setAttribute('r', (Number(ring.dataset.pin) + magnification * Number(ring.dataset.clearance)).toFixed(4)));
    }

    function frame(time) {
      if (!running) return;
      if (lastTime) {
        const turns = Math.max((data.angle_deg[count - 1] - data.angle_deg[0]) / 360, 0.05);
        pose = (pose + (time - lastTime) / 1000 / secondsPerTurn / Math.abs(turns) * (count - 1)) % (count - 1);
        slider.value = String(Math.round(pose));
        draw();
      }
      lastTime = time;
      requestAnimationFrame(frame);
    }

    function run(start) {
      running = start && count > 1;
      play.textContent = running ? 'Pause' : 'Play';
      play.setAttribute('aria-pressed', String(running));
      lastTime = 0;
      if (running) requestAnimationFrame(frame);
    }

    play.addEventListener('click', () => run(!running));
    slider.addEventListener('input', () => {
      run(false);
      pose = Number(slider.value);
      draw();
    });
    if (choice) {
      choice.addEventListener('change', () => {
        magnification = Number(choice.value);
        drawRings();
        draw();
      });
    }
    draw();
    figure.dataset.drawn = 'true';
    // Begin by itself when first seen, unless the reader asked for less motion.
    if (!matchMedia('(prefers-reduced-motion: reduce)').matches) {
      const observer = new IntersectionObserver((seen) => {
        if (!seen.some((entry) => entry.isIntersecting)) return;
        observer.disconnect();
        run(true);
      }, { threshold: 0.6 });
      observer.observe(figure);
    }
  }

  document.querySelectorAll('[data-mechanism]').forEach(build);
})();
