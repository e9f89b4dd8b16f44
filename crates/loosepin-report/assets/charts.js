// Draws every chart of the page from the data beside it, with read-out, legend, zoom, keyboard, dark mode and print.
(function () {
  'use strict';
  const root = document.documentElement;
  const colour = (name) => getComputedStyle(root).getPropertyValue('--' + name).trim();
  const charts = [];

  // The number in at most four digits, or to the places of `step` where one is given.
  function text(value, step) {
    if (value === null || value === undefined || !isFinite(value)) return '–';
    const magnitude = Math.abs(value);
    if (magnitude !== 0 && (magnitude < 1e-4 || magnitude >= 1e7)) {
      const [mantissa, exponent] = value.toExponential(2).split('e');
      return (mantissa + ' · 10' + Number(exponent).toString().replace(/[-0-9]/g, (c) => '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'['-0123456789'.indexOf(c)])).replace('-', '−');
    }
    let places = magnitude === 0 ? 0 : Math.max(0, 3 - Math.floor(Math.log10(magnitude)));
    if (step !== undefined) {
      // As many places as the step between ticks has: 0.25 has two.
      places = 0;
      while (places < 10 && Math.abs(step * 10 ** places - Math.round(step * 10 ** places)) > 1e-6) places += 1;
    }
    const [whole, rest] = value.toFixed(Math.min(places, 10)).replace('-', '−').split('.');
    const grouped = whole.length > 4 ? whole.replace(/\B(?=(\d{3})+$)/g, '\u202f') : whole;
    return rest === undefined ? grouped : grouped + '.' + rest;
  }

  const withUnit = (number, symbol) => symbol === '' ? number : symbol === '°' || symbol === '%' ? number + symbol : number + ' ' + symbol;

  function build(holder) {
    const id = holder.dataset.chart;
    const figure = document.getElementById(id);
    const data = JSON.parse(figure.querySelector('script[data-for]').textContent);
    const columns = [data.x];
    const series = [{}];
    const bands = [];
    const entrySeries = [];
    data.entries.forEach((entry) => {
      const lists = entry.kind === 'line' ? [entry.values] : [entry.lower, entry.upper];
      const first = columns.length;
      lists.forEach((list) => {
        columns.push(list);
        series.push({
          stroke: () => colour(entry.role),
          width: entry.kind === 'band' ? 1 : entry.role === 'nominal' || entry.role === 'mean' ? 1.8 : 1.6,
          dash: entry.dashed ? [6, 4] : undefined,
          points: { show: false },
          spanGaps: false,
        });
      });
      if (entry.kind === 'band') bands.push({ series: [first + 1, first], fill: () => colour(entry.role + '-fill') });
      entrySeries.push(lists.map((_, index) => first + index));
    });

    const axis = (label, symbol, extra) => Object.assign({
      stroke: () => colour('quiet'),
      grid: { stroke: () => colour('grid'), width: 1 },
      ticks: { stroke: () => colour('rule'), width: 1 },
      font: '12px system-ui, "DejaVu Sans", sans-serif',
      labelFont: '12px system-ui, "DejaVu Sans", sans-serif',
      label: symbol ? label + ' [' + symbol + ']' : label,
      labelSize: 22,
    }, extra);
    const splitText = (u, splits, axisIndex, space, step) => splits.map((value) => text(value, step));
    const height = () => Math.round(holder.clientWidth < 520 ? Math.min(data.height, 280) : data.height);
    const finite = data.x.filter((value) => value !== null);
    const full = { min: finite[0], max: finite[finite.length - 1] };

    function drawMarks(u) {
      const { ctx, bbox } = u;
      data.marks.forEach((mark) => {
        const x = Math.round(u.valToPos(mark.at, 'x', true));
        if (x < bbox.left || x > bbox.left + bbox.width) return;
        ctx.save();
        ctx.strokeStyle = ctx.fillStyle = colour('limit');
        ctx.lineWidth = 1.5 * devicePixelRatio;
        ctx.setLineDash([4 * devicePixelRatio, 3 * devicePixelRatio]);
        ctx.beginPath();
        ctx.moveTo(x, bbox.top);
        ctx.lineTo(x, bbox.top + bbox.height);
        ctx.stroke();
        ctx.font = 12 * devicePixelRatio + 'px system-ui, "DejaVu Sans", sans-serif';
        ctx.textAlign = 'left';
        ctx.fillText(mark.label, x + 5 * devicePixelRatio, bbox.top + 14 * devicePixelRatio);
        ctx.restore();
      });
    }

    const ends = [columns[0][0], columns[0][columns[0].length - 1]];
    // One turn that does not begin at 0° is still told in angles from 0° to 360°.
    const isOneTurn = data.horizontal === 'angle' && data.x_symbol === '°' && Math.abs(ends[1] - ends[0] - 360) < 1e-3 && ends[0] !== 0;
    const told = (x) => isOneTurn ? ((x % 360) + 360) % 360 : x;
    const plot = new uPlot({
      width: Math.max(holder.clientWidth, 200),
      height: height(),
      pxAlign: 0,
      series: series,
      bands: bands,
      legend: { show: false },
      cursor: { drag: { x: true, y: false, dist: 6 }, points: { show: false }, y: false },
      scales: {
        x: { time: false },
        y: data.y_range ? { range: data.y_range } : {},
      },
      axes: [
        axis(data.x_label, data.x_symbol, {
          values: (u, splits, ...rest) => splitText(u, splits.map(told), ...rest),
          size: 34,
          incrs: data.horizontal === 'angle' ? [0.5, 1, 2, 5, 10, 15, 30, 45, 90, 180, 360, 720] : undefined,
          space: 48,
        }),
        axis(data.y_label, data.y_symbol, {
          values: splitText,
          size: (u, values) => values === null ? 48 : 22 + 7.4 * values.reduce((most, value) => Math.max(most, String(value).length), 3),
        }),
      ],
      hooks: {
        draw: [drawMarks],
        setCursor: [(u) => readOut(u)],
        setScale: [(u, key) => {
          if (key !== 'x') return;
          reset.hidden = u.scales.x.min <= full.min + 1e-9 * Math.abs(full.min) && u.scales.x.max >= full.max - 1e-9 * Math.abs(full.max);
        }],
      },
    }, columns, holder);

    const position = figure.querySelector('.position');
    const values = [...figure.querySelectorAll('[data-value]')];
    const reset = figure.querySelector('.reset');

    function readOut(u) {
      const index = u.cursor.idx;
      if (index === null || index === undefined) {
        position.textContent = 'Move over the chart to read values.';
        values.forEach((element) => { element.textContent = ''; });
        return;
      }
      position.textContent = data.x_label + ': ' + withUnit(text(told(columns[0][index])), data.x_symbol);
      // As many places for all values as a thousandth of the axis needs.
      const range = u.scales.y.max - u.scales.y.min;
      const step = range > 0 && range < 1e7 && range > 1e-3 ? 10 ** Math.floor(Math.log10(range / 1000)) : undefined;
      values.forEach((element, entry) => {
        if (data.entries[entry].role === 'limit') return;
        const numbers = entrySeries[entry].map((column) => text(columns[column][index], step));
        element.textContent = withUnit(numbers.join(' … '), data.y_symbol);
      });
    }
    readOut(plot);

    const zoomTo = (min, max) => plot.setScale('x', { min: Math.max(min, full.min), max: Math.min(max, full.max) });
    reset.addEventListener('click', () => zoomTo(full.min, full.max));
    figure.querySelectorAll('[data-entry]').forEach((button) => {
      button.addEventListener('click', () => {
        const show = button.getAttribute('aria-pressed') !== 'true';
        button.setAttribute('aria-pressed', String(show));
        entrySeries[Number(button.dataset.entry)].forEach((column) => plot.setSeries(column, { show: show }));
      });
    });
    holder.addEventListener('keydown', (event) => {
      const { min, max } = plot.scales.x;
      const current = plot.cursor.idx === null || plot.cursor.idx === undefined ? Math.floor(columns[0].length / 2) : plot.cursor.idx;
      const stride = event.shiftKey ? 10 : 1;
      const show = (index) => {
        const inside = Math.max(0, Math.min(columns[0].length - 1, index));
        plot.setCursor({ left: plot.valToPos(columns[0][inside], 'x'), top: plot.bbox.height / 2 / devicePixelRatio });
      };
      if (event.key === 'ArrowRight') show(current + stride);
      else if (event.key === 'ArrowLeft') show(current - stride);
      else if (event.key === '0') zoomTo(full.min, full.max);
      else if (event.key === '+' || event.key === '-') {
        const centre = columns[0][current];
        const factor = event.key === '+' ? 0.5 : 2;
        zoomTo(centre - (centre - min) * factor, centre + (max - centre) * factor);
      } else return;
      event.preventDefault();
    });

    let width = holder.clientWidth;
    new ResizeObserver(() => {
      if (holder.clientWidth === width || holder.clientWidth === 0) return;
      width = holder.clientWidth;
      plot.setSize({ width: width, height: height() });
    }).observe(holder);
    plot.heightOnScreen = height;
    charts.push(plot);
    holder.dataset.drawn = 'true';
  }

  document.querySelectorAll('[data-chart]').forEach((holder) => {
    try {
      build(holder);
    } catch (error) {
      holder.textContent = 'This chart could not be drawn; its numbers stand in the table below.';
      console.error(error);
    }
  });

  const redraw = () => charts.forEach((plot) => plot.redraw(false, true));
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', redraw);
  // On paper the page is light and as wide as the paper, whatever the screen was.
  const paperWidth = 680;
  let closed = [];
  addEventListener('beforeprint', () => {
    root.classList.add('printing');
    closed = [...document.querySelectorAll('details.glossary:not([open])')];
    closed.forEach((details) => { details.open = true; });
    charts.forEach((plot) => plot.setSize({ width: Math.min(plot.width, paperWidth), height: Math.min(plot.height, 300) }));
    redraw();
  });
  addEventListener('afterprint', () => {
    root.classList.remove('printing');
    closed.forEach((details) => { details.open = false; });
    charts.forEach((plot) => plot.setSize({ width: plot.root.parentElement.clientWidth, height: plot.heightOnScreen() }));
    redraw();
  });
})();
