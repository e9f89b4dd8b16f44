// What if the unknown values were known: a slider over the values that were run, or a map of them, gives the first chart the band of one.
// Members of lists are chosen before: values of different members are never beside each other.
(() => {
  const namespace = 'http://www.w3.org/2000/svg';
  const levels = 9999;
  const side = 220;
  const room = 14;

  interface Point {
    group: number;
    at: number[];
    words: string;
    runs: number;
    lower: number[];
    upper: number[];
  }

  interface WhatIf {
    chart: string;
    entry: number;
    share: string;
    inputs: Array<{ name: string; from: string; to: string }>;
    lists: string;
    groups: string[];
    start: number;
    points: Point[];
    range: [number, number];
  }

  /** What chooses among the values of one group. */
  interface Control {
    element: HTMLElement;
    /** Shows which value is chosen; without one, none. */
    mark: (point?: Point) => void;
    /** The value in its middle. */
    middle: Point;
  }

  function build(holder: HTMLElement): void {
    const data = JSON.parse(holder.querySelector('script')?.textContent ?? '') as WhatIf;
    const figure = document.getElementById(data.chart);
    const chart = figure?.querySelector<HTMLElement>('[data-chart]');
    const legend = figure?.querySelector<HTMLElement>('[data-entry="' + data.entry + '"] .label');
    const caption = figure?.querySelector<HTMLElement>('[data-inner]');
    const choice = holder.querySelector<HTMLElement>('.choice');
    const chosen = holder.querySelector<HTMLElement>('.chosen');
    const back = holder.querySelector<HTMLButtonElement>('.reset');
    if (!chart || !legend || !caption || !choice || !chosen || !back) return;
    const [storedLegend, storedCaption] = [legend.textContent, caption.textContent];
    const value = (level: number): number => level < 0 ? NaN : data.range[0] + level / levels * (data.range[1] - data.range[0]);

    // The studio shows this page in a frame, and can take a value into its model.
    const tell = (place: number | null): void => {
      if (parent !== window) parent.postMessage({ kind: 'loosepin-known', place }, '*');
    };

    function choose(point: Point): void {
      if (!chart || !legend || !caption || !chosen || !back) return;
      const [lower, upper] = [point.lower.map(value), point.upper.map(value)];
      chart.dispatchEvent(new CustomEvent('band', { detail: { entry: data.entry, ends: [lower, upper] } }));
      const finite = (list: number[]): number[] => list.filter((one) => isFinite(one));
      const unit = chart.dataset.yUnit ?? '';
      chosen.textContent = point.words.charAt(0).toUpperCase() + point.words.slice(1) + ': the band lies within '
        + withUnit(readText(Math.min(...finite(lower))) + ' … ' + readText(Math.max(...finite(upper))), unit)
        + ' (counted from ' + point.runs + ' runs).';
      legend.textContent = data.share + ', scatter at ' + point.words;
      caption.textContent = point.words + ' (chosen below)';
      controls.forEach((control) => control.mark(point));
      back.hidden = false;
      tell(data.points.indexOf(point));
    }

    /** A slider over the values of one input, in their order. */
    function slider(points: Point[]): Control {
      const order = [...points].sort((a, b) => (a.at[0] ?? 0) - (b.at[0] ?? 0));
      const middle = Math.floor(order.length / 2);
      const input = data.inputs[0];
      const range = document.createElement('input');
      range.type = 'range';
      range.min = '0';
      range.max = String(order.length - 1);
      range.value = String(middle);
      range.setAttribute('aria-label', input?.name ?? '');
      range.addEventListener('input', () => {
        const point = order[Number(range.value)];
        if (point) choose(point);
      });
      const [from, to] = [document.createElement('span'), document.createElement('span')];
      from.textContent = input?.from ?? '';
      to.textContent = input?.to ?? '';
      const element = document.createElement('div');
      element.className = 'choice';
      element.append(from, range, to);
      const mark = (point?: Point): void => {
        const place = point ? order.indexOf(point) : middle;
        range.value = String(place < 0 ? middle : place);
        range.setAttribute('aria-valuetext', point && place >= 0 ? point.words : 'the middle');
      };
      mark();
      return { element, mark, middle: order[middle] as Point };
    }

    /** A map of the first two inputs: a button for each value that was run. */
    function map(points: Point[]): Control {
      const element = document.createElement('div');
      element.className = 'map';
      const svg = document.createElementNS(namespace, 'svg');
      svg.setAttribute('viewBox', '0 0 ' + (side + 2 * room) + ' ' + (side + 2 * room));
      const nearest = (x: number, y: number): Point => {
        const distance = (point: Point): number => Math.hypot(x - (point.at[0] ?? 0), y - (point.at[1] ?? 0));
        return points.reduce((best, point) => distance(point) < distance(best) ? point : best);
      };
      const dots = points.map((point) => {
        const dot = document.createElementNS(namespace, 'circle');
        dot.setAttribute('cx', String(room + side * (point.at[0] ?? 0)));
        dot.setAttribute('cy', String(room + side * (1 - (point.at[1] ?? 0))));
        dot.setAttribute('r', '5');
        dot.setAttribute('tabindex', '0');
        dot.setAttribute('role', 'button');
        dot.setAttribute('aria-pressed', 'false');
        dot.setAttribute('aria-label', point.words);
        dot.addEventListener('keydown', (event) => {
          if (event.key !== 'Enter' && event.key !== ' ') return;
          event.preventDefault();
          choose(point);
        });
        return dot;
      });
      svg.append(...dots);
      svg.addEventListener('click', (event) => {
        const frame = svg.getBoundingClientRect();
        const scale = (side + 2 * room) / frame.width;
        choose(nearest(((event.clientX - frame.left) * scale - room) / side, (side + room - (event.clientY - frame.top) * scale) / side));
      });
      const label = (index: number): string => {
        const input = data.inputs[index];
        return input ? input.name + ', ' + input.from + ' to ' + input.to : '';
      };
      const [across, up] = [document.createElement('span'), document.createElement('span')];
      across.className = 'across';
      up.className = 'up';
      across.textContent = label(0) + ' →';
      up.textContent = label(1) + ' →';
      element.append(up, svg, across);
      const mark = (point?: Point): void => dots.forEach((dot, place) => dot.setAttribute('aria-pressed', String(points[place] === point)));
      return { element, mark, middle: nearest(0.5, 0.5) };
    }

    const controls = data.groups.map((_, group) => {
      const points = data.points.filter((point) => point.group === group);
      const control = data.inputs.length > 1 ? map(points) : slider(points);
      // One value has nothing to choose from: its list has chosen it.
      if (points.length === 1) control.element = document.createElement('div');
      return control;
    });
    const list = document.createElement('select');
    const show = (group: number): void => controls.forEach(({ element }, own) => { element.hidden = own !== group; });
    if (data.groups.length > 1) {
      list.setAttribute('aria-label', data.lists);
      list.append(...data.groups.map((words) => new Option(words)));
      list.selectedIndex = data.start;
      list.addEventListener('change', () => {
        show(list.selectedIndex);
        const control = controls[list.selectedIndex];
        if (control) choose(control.middle);
      });
      choice.append(list);
    }
    choice.append(...controls.map(({ element }) => element));
    show(data.start);
    back.addEventListener('click', () => {
      chart.dispatchEvent(new CustomEvent('band', { detail: { entry: data.entry } }));
      legend.textContent = storedLegend;
      caption.textContent = storedCaption;
      chosen.textContent = '';
      list.selectedIndex = data.start;
      show(data.start);
      controls.forEach((control) => control.mark());
      back.hidden = true;
      tell(null);
      // The button is gone: whoever used the keyboard goes on from the choice.
      (choice.querySelector<HTMLElement>('select, :not([hidden]) > input') ?? choice.querySelector<SVGElement>('circle'))?.focus();
    });
    holder.hidden = false;
  }

  document.querySelectorAll<HTMLElement>('[data-what-if]').forEach(build);
})();
