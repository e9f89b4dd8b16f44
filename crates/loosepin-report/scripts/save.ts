// Saves figures: the picture as the library drew it (SVG), as pixels (PNG), and its numbers (CSV).

const savedFigures = (() => {
  const widthMm = 160;
  const pixelsPerMm = 12;

  function download(name: string, content: Blob): void {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(content);
    link.download = name;
    link.click();
    window.setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
  }

  const inXml = (markup: string): string => markup.replace(/&nbsp;/g, '\u00a0');

  /** The document that `loosepin report --svg` writes, byte for byte. */
  function svgText(svg: SVGElement, drawn: string): string {
    // The saved picture has a key below, which the page has as buttons.
    const [left = 0, top = 0, width = 1, shown = 1] = (svg.getAttribute('viewBox') ?? '').split(' ').map(Number);
    const height = shown + Number(svg.dataset.below ?? 0);
    const view = [left, top, width, height].join(' ');
    const title = document.createElement('span');
    title.textContent = svg.getAttribute('aria-label');
    const style = document.getElementById('saved-style')?.textContent ?? '';
    return '<svg xmlns="http://www.w3.org/2000/svg" class="' + svg.getAttribute('class') + '" width="' + widthMm.toFixed(1) + 'mm" height="'
      + (widthMm * height / width).toFixed(1) + 'mm" viewBox="' + view + '" role="img"><title>' + inXml(title.innerHTML).replace(/"/g, '&quot;')
      + '</title><style>' + style + '</style>' + inXml(drawn) + '</svg>\n';
  }

  function png(text: string, name: string): void {
    const picture = new Image();
    picture.addEventListener('load', () => {
      const canvas = document.createElement('canvas');
      canvas.width = Math.round(widthMm * pixelsPerMm);
      canvas.height = Math.round(canvas.width * picture.height / picture.width);
      const context = canvas.getContext('2d');
      if (!context) return;
      context.fillStyle = '#ffffff';
      context.fillRect(0, 0, canvas.width, canvas.height);
      context.drawImage(picture, 0, 0, canvas.width, canvas.height);
      canvas.toBlob((blob) => { if (blob) download(name + '.png', blob); });
    });
    picture.src = 'data:image/svg+xml;charset=utf-8,' + encodeURIComponent(text);
  }

  const texts = new Map<string, { svg: string; csv: string | null }>();
  document.querySelectorAll<HTMLElement>('[data-figure]').forEach((figure) => {
    const name = figure.dataset.figure ?? '';
    const svg = figure.querySelector<SVGElement>('svg.figure');
    if (!svg) return;
    const table = figure.querySelector('script[type="text/csv"]');
    const origin = '# figure ' + name + ' of ' + (document.documentElement.dataset.origin ?? '') + '\n';
    const kept = { svg: svgText(svg, svg.innerHTML), csv: table ? origin + (table.textContent ?? '') : null };
    texts.set(name, kept);
    const row = document.createElement('div');
    row.className = 'save';
    const button = (label: string, save: () => void): void => {
      const element = document.createElement('button');
      element.type = 'button';
      element.textContent = label;
      element.setAttribute('aria-label', 'Save ' + name + ' as ' + label);
      element.addEventListener('click', save);
      row.append(element);
    };
    button('SVG', () => download(name + '.svg', new Blob([kept.svg], { type: 'image/svg+xml' })));
    button('PNG', () => png(kept.svg, name));
    if (kept.csv !== null) button('CSV', () => download(name + '.csv', new Blob([kept.csv ?? ''], { type: 'text/csv' })));
    figure.append(row);
  });
  /** A tape archive (ustar) of texts by path: every system unpacks it into folders, which a saved file cannot name. */
  function archive(files: [name: string, text: string][]): Blob {
    const block = 512;
    const encoder = new TextEncoder();
    const parts: Uint8Array<ArrayBuffer>[] = [];
    for (const [name, text] of files) {
      const content = encoder.encode(text);
      const path = encoder.encode(name);
      // A name of more than 100 bytes is parted at a slash.
      const slash = 0x2f;
      const cut = path.length > 100 ? path.indexOf(slash, path.length - 101) : -1;
      const header = new Uint8Array(block);
      const write = (at: number, bytes: Uint8Array): void => header.set(bytes, at);
      const octal = (at: number, digits: number, value: number): void =>
        write(at, encoder.encode(value.toString(8).padStart(digits, '0')));
      write(0, path.subarray(cut + 1, cut + 101));
      octal(100, 7, 0o644);
      octal(108, 7, 0);
      octal(116, 7, 0);
      octal(124, 11, content.length);
      octal(136, 11, 0);
      // The sum counts its own place as spaces; a file; the format.
      write(148, encoder.encode('        0'));
      write(257, encoder.encode('ustar\u000000'));
      write(345, path.subarray(0, Math.max(0, Math.min(cut, 155))));
      octal(148, 6, header.reduce((sum, byte) => sum + byte, 0));
      header[154] = 0;
      const padded = new Uint8Array(Math.ceil(content.length / block) * block);
      padded.set(content);
      parts.push(header, padded);
    }
    parts.push(new Uint8Array(2 * block));
    return new Blob(parts, { type: 'application/x-tar' });
  }

  // The files that the result was computed from.
  function saveButton(label: string, name: string, content: () => Blob, after: HTMLElement): void {
    const button = document.createElement('button');
    button.type = 'button';
    button.textContent = label;
    button.addEventListener('click', () => download(name, content()));
    const row = document.createElement('div');
    row.className = 'save plain';
    row.append(button);
    after.after(row);
  }
  const inputs = [...document.querySelectorAll<HTMLElement>('[data-input]')];
  const files = inputs.map((details): [string, string] => {
    const shown = details.querySelector('pre')?.textContent ?? '';
    const { input = 'input.toml', exact } = details.dataset;
    return [input, exact === undefined ? shown : String(JSON.parse(exact))];
  });
  const last = inputs[inputs.length - 1];
  if (last && files.length > 1) saveButton('Save all', 'inputs.tar', () => archive(files), last);
  files.forEach(([name, text], index) => {
    const details = inputs[index];
    if (!details) return;
    saveButton('Save ' + name, name.split('/').pop() ?? name, () => new Blob([text], { type: 'text/plain' }), details);
  });
  return texts;
})();
